//! `positivity` certified and refuted; numbers of every size.
mod common;
use common::{Case, one_prism};

fn yes() -> Case {
    one_prism().only(&[("positivity", true)], &[])
}

fn no(text: &str) -> Case {
    let mut case = one_prism().only(&[("positivity", false)], &[("positivity", text)]);
    case.layers.swap(0, 2);
    case
}

#[test]
fn certified() {
    yes().accept();
    let mut flat = yes();
    flat.layers[2][1] = flat.layers[1][1];
    flat.reject("not-positive");
    let mut reversed = yes();
    reversed.prisms[0] = [0, 2, 1];
    reversed.reject("not-positive");
}

#[test]
fn huge_and_tiny_coordinates() {
    let mut case = yes();
    for (layer, z) in case.layers.iter_mut().zip([-1e308, f64::from_bits(1), 1e308]) {
        layer.iter_mut().for_each(|p| p[2] = z);
    }
    case.accept();
    case.layers[0][1][2] = f64::from_bits(2);
    case.reject("not-positive");
    // Exactly flat by one unit in the last place.
    case.layers[0].iter_mut().for_each(|p| p[2] = 0.0);
    case.accept();
    case.layers[0].iter_mut().for_each(|p| p[2] = f64::from_bits(1));
    case.reject("not-positive");
}

#[test]
fn all_widths_agree() {
    // A volume of the last bit: 256, 512 and unlimited bits give the same verdict.
    for shift in [0, 40, 60, 100, 300, 1000] {
        let tiny = 2f64.powi(-shift);
        let mut case = yes();
        case.layers[0].iter_mut().for_each(|p| p[2] = -tiny);
        case.accept();
        case.layers[0][2][2] = tiny;
        case.reject("not-positive");
        let value = if shift == 0 { "-1".to_owned() } else { format!("-1*2^-{shift}") };
        let fact = format!("tet 0 m0,m1,b2,m2 {value}");
        case.clone().only(&[("positivity", false)], &[("positivity", &fact)]).accept();
    }
}

#[test]
fn refuted() {
    no("tet 0 b0,b1,b2,m2 -1").accept();
    no("tet 0 b0,b1,b2,m2 -1\ntet 0 m0,m1,t1,t2 -1").accept();
    no("tet 0 b0,b1,b2,m2 1").reject("wrong-value");
    no("tet 0 b0,b1,b2,m2 -1*2^1").reject("wrong-value");
    no("tet 0 b0,b1,b2,t2 -1").reject("unknown-tet");
    no("tet 0 b0,m0,b1,m1 -1").reject("unknown-tet");
    let mut good = no("tet 0 b0,b1,b2,m2 1");
    good.layers.swap(0, 2);
    good.reject("not-refuted");
}

#[test]
fn pinched() {
    let mut case = yes();
    case.layers[0][0] = case.layers[1][0];
    case.layers[2][0] = [-0.0, 0.0, -0.0];
    case.pinched = "pinched 8 0".into();
    case.accept();
    case.layers.swap(0, 2);
    let refuted = |fact| case.clone().only(&[("positivity", false)], &[("positivity", fact)]);
    refuted("tet 0 m0,b1,b2,m2 -1").accept();
    refuted("tet 0 b0,b1,b2,m2 -1").reject("unknown-tet");
}
