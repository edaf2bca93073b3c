//! Projections: homeo's rationals against those of CGAL's exact constructions, and the tets of a prism that hold a point.

use std::collections::BTreeSet;
use std::error::Error;

use homeo::mesh::TriMesh;
use homeo::projection::{Projection, ProjectionError, Rat};
use homeo::shell::{Layer, Shell, VertexOrder, hdf5};
use homeo_benches::cgal::Cgal;
use homeo_benches::generate::{offset_shell, sphere};
use homeo_benches::prism;
use homeo_benches::random::Random;
use homeo_benches::real;
use homeo_benches::subject::Subject;
use homeo_benches::table::Table;

use crate::findings::{Findings, line};

/// Points that are sent at once.
const BATCH: usize = 256;

/// A shell, a vertex order (smallest first), and points to try besides random ones.
struct Input {
    name: String,
    shell: Shell,
    mesh: Option<TriMesh>,
}

/// Integer coordinates: points with dyadic weights have no rounding, so that walls and edges are hit exactly.
fn lattice(random: &mut Random) -> Input {
    let n = 5_u32;
    let mut shell = Shell::default();
    for i in 0..n {
        for j in 0..n {
            let [x, y] = [i, j].map(|k| 32.0 * f64::from(k));
            let mut moved = |z: f64| [x, y, z].map(|c| c + random.below(9) as f64 - 4.0);
            let [b, m, t] = [moved(-16.0), moved(0.0), moved(16.0)];
            let pinched = (i + 2 * j) % 7 == 3;
            shell.bottom.push(if pinched { m } else { b });
            shell.middle.push(m);
            shell.top.push(if pinched { m } else { t });
        }
    }
    for (i, j) in (0..n - 1).flat_map(|i| (0..n - 1).map(move |j| (i, j))) {
        let at = |i: u32, j: u32| i * n + j;
        shell.faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
        shell.faces.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
    Input { name: "lattice".to_owned(), shell, mesh: None }
}

fn inputs(random: &mut Random) -> Result<Vec<Input>, Box<dyn Error>> {
    let ball = sphere(6);
    let round = Input { name: "sphere".to_owned(), shell: offset_shell(&ball, 0.3), mesh: Some(ball) };
    let mut out = vec![lattice(random), round];
    let shells = real::shells();
    if shells.is_empty() {
        eprintln!("SKIPPED: projections along real shells, none in {}", real::data().display());
    }
    for path in shells {
        let file = hdf5::read(&path)?;
        out.push(Input { name: real::name(&path), shell: file.shell, mesh: file.mesh });
    }
    Ok(out)
}

/// Compares `points` projections with EPECK and as many with Gmpq; prints the table.
pub(crate) fn run(
    cgal: &Cgal,
    points: usize,
    seed: u64,
    findings: &mut Findings,
) -> Result<(), Box<dyn Error>> {
    let mut random = Random(seed);
    let inputs = inputs(&mut random)?;
    let mut subjects =
        [Subject::start(&cgal.0, "projection", &[])?, Subject::start(&cgal.0, "projection", &["--gmpq"])?];
    let mut table = Table::new(&["shell", "vertex order", "points", "inside", "in several tets", "disagree"]);
    let mut projections = Vec::new();
    for input in &inputs {
        let count = u32::try_from(input.shell.vertex_count())?;
        let reverse = VertexOrder::List((0..count).rev().collect());
        for (word, order) in [("by id", VertexOrder::Id), ("reversed", reverse)] {
            match Projection::new(&input.shell, &order) {
                Ok(projection) => projections.push((input, word, order, projection)),
                // There is no projection to compare.
                Err(ProjectionError::NotPositive { .. }) => {
                    table.row(vec![input.name.clone(), word.to_owned(), "bad tet".to_owned()]);
                }
                Err(error) => return Err(format!("{}: {error}", input.name).into()),
            }
        }
    }
    let share = points.div_ceil(projections.len().max(1));
    let mut sums = [0; 4];
    for (input, word, order, projection) in &projections {
        let ranks = order.ranks(input.shell.vertex_count());
        let mut job = Job { input, projection, ranks, random: &mut random };
        let counts = job.compare(share, &mut subjects, findings)?;
        let mut row = vec![input.name.clone(), (*word).to_owned()];
        row.extend(counts.iter().map(ToString::to_string));
        table.row(row);
        sums.iter_mut().zip(counts).for_each(|(sum, n)| *sum += n);
    }
    let mut row = vec!["all".to_owned(), String::new()];
    row.extend(sums.iter().map(ToString::to_string));
    table.row(row);
    print!("{}", table.render());
    Ok(())
}

struct Job<'a> {
    input: &'a Input,
    projection: &'a Projection<'a>,
    ranks: Vec<u32>,
    random: &'a mut Random,
}

impl Job<'_> {
    /// Points compared, inside, in more than one tet; disagreements.
    fn compare(
        &mut self,
        total: usize,
        subjects: &mut [Subject],
        findings: &mut Findings,
    ) -> Result<[u64; 4], Box<dyn Error>> {
        let mut counts = [0; 4];
        let mut left = total;
        while left > 0 {
            let n = BATCH.min(left);
            left -= n;
            let cases: Vec<(u32, [f64; 3])> = (0..n).map(|_| self.case()).collect();
            let numbers: Vec<Vec<f64>> = cases.iter().map(|(id, p)| self.numbers(*id, p)).collect();
            for subject in subjects.iter_mut() {
                subject.send("projection", n, &numbers.concat())?;
            }
            let ours = cases.iter().map(|(id, p)| self.answer(*id, p));
            for ((mask, images), numbers) in ours.collect::<Result<Vec<_>, _>>()?.iter().zip(&numbers) {
                counts[0] += 1;
                counts[1] += u64::from(*mask != 0);
                counts[2] += u64::from(mask.count_ones() > 1);
                for subject in subjects.iter_mut() {
                    let text = subject.line()?;
                    if prism::parse(&text) != Some((*mask, images.clone())) {
                        counts[3] += 1;
                        let case = line("projection", numbers);
                        let name = subject.name();
                        findings.add(&format!("homeo {mask} {images:?}, {name}: {text}: {case}"));
                    }
                }
            }
        }
        Ok(counts)
    }

    fn numbers(&self, id: u32, p: &[f64; 3]) -> Vec<f64> {
        let corners = prism::corners(&self.input.shell, &self.ranks, id);
        prism::numbers(&self.input.shell, corners, p)
    }

    /// A prism and a point in or near it.
    fn case(&mut self) -> (u32, [f64; 3]) {
        let tets = self.projection.tets();
        let tet = tets[self.random.below(tets.len())];
        let corners = tet.names.map(|name| *self.input.shell.position(name));
        let kind = self.random.below(8);
        if let (0, Some(mesh)) = (kind, &self.input.mesh) {
            let p = mesh.vertices[self.random.below(mesh.vertices.len())];
            let found = self.projection.locate_f64(&p);
            let prism = found.first().map_or(tet.prism, |l| tets[l.tet as usize].prism);
            return (prism, p);
        }
        let weights: [f64; 4] = match kind {
            // A vertex; then points on faces and edges, where coordinates are short; then anywhere.
            1 => [1.0, 0.0, 0.0, 0.0],
            2..=4 => {
                let [i, j, k] = [0; 3].map(|_| self.random.below(5) as f64);
                let scale = [1.0, 2.0, 4.0, 8.0][self.random.below(4)] * 8.0;
                [i, j, k, scale - i - j - k].map(|w| w / scale)
            }
            5 => [0; 4].map(|_| self.random.real()),
            _ => {
                let parts = [0; 4].map(|_| self.random.real().abs());
                let sum: f64 = parts.iter().sum();
                parts.map(|w| w / sum)
            }
        };
        let turn = self.random.below(4);
        let p = [0, 1, 2].map(|axis| {
            let terms = (0..4).map(|k| weights[(k + turn) % 4] * corners[k][axis]);
            terms.sum::<f64>()
        });
        (tet.prism, p)
    }

    /// The mask of the prism's tets that hold the point, and the different images in this prism.
    fn answer(&self, id: u32, p: &[f64; 3]) -> Result<(u8, BTreeSet<String>), Box<dyn Error>> {
        let corners = prism::corners(&self.input.shell, &self.ranks, id);
        let mut mask = 0;
        for location in self.projection.locate_f64(p) {
            let tet = self.projection.tets()[location.tet as usize];
            if tet.prism == id {
                let place = corners.iter().position(|&v| v == tet.pillar).ok_or("a tet without a pillar")?;
                let slab = usize::from(tet.slab.hi() == Layer::Top);
                mask |= 1 << (3 * slab + 2 - place);
            }
        }
        let [x, y, z] = p.map(Rat::try_from);
        let exact = [x, y, z].map(|x| x.map_err(|_| "a point that is not finite"));
        let [x, y, z] = exact;
        let images = self.projection.project_all(&[x?, y?, z?]);
        let written = |image| prism::written(&self.input.shell, image, corners);
        Ok((mask, images.iter().filter_map(written).collect()))
    }
}
