//! Stage (b): the topology of valid inputs, component by component.
//!
//! Connected compact oriented surfaces are homeomorphic just when their Euler characteristics and numbers of boundary
//! loops are equal, so surfaces are just when the multisets of these pairs over the components are.

use std::collections::BTreeMap;

use super::report::TopologyReport;
use crate::certify::nested::ComponentFacts;

/// Compares the components of both meshes.
#[must_use]
pub(crate) fn compare(a: Vec<ComponentFacts>, b: Vec<ComponentFacts>) -> TopologyReport {
    let difference = difference(&a, &b);
    TopologyReport { same: difference.is_none(), a, b, difference }
}

fn difference(a: &[ComponentFacts], b: &[ComponentFacts]) -> Option<String> {
    let mut surplus: BTreeMap<ComponentFacts, i64> = BTreeMap::new();
    a.iter().for_each(|c| *surplus.entry(*c).or_default() += 1);
    b.iter().for_each(|c| *surplus.entry(*c).or_default() -= 1);
    surplus.retain(|_, n| *n != 0);
    if surplus.is_empty() {
        return None;
    }
    let side = |sign: i64| -> String {
        let parts: Vec<String> = surplus
            .iter()
            .filter(|(_, n)| **n * sign > 0)
            .map(|(c, n)| {
                format!(
                    "{} of Euler characteristic {} (genus {}) with {} boundary loops",
                    n.abs(),
                    c.euler_characteristic,
                    c.genus(),
                    c.boundary_loops
                )
            })
            .collect();
        if parts.is_empty() { "none".to_owned() } else { parts.join(", ") }
    };
    Some(format!("components that only A has: {}; that only B has: {}", side(1), side(-1)))
}
