use homeo::construct::*; use homeo::certify::Silent;
fn main(){ for p in std::env::args().skip(1){ let m=homeo::mesh::read(std::path::Path::new(&p)).unwrap().mesh; let t=std::time::Instant::now();
 match initial(&m,&InitialOptions::default(),&Silent){Ok(i)=>println!("{p} {} faces ok {} rounds {} pinched {} bevel, {:?}",m.faces.len(),i.rounds,i.pinched.iter().filter(|x|**x).count(),i.beveled,t.elapsed()),Err(e)=>println!("{p} {e} {:?}",t.elapsed())}}}
