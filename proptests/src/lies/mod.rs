//! Lies: certificates with one statement made false, and a judge that shows from the definitions that it is false.
//!
//! The judge shares no code with the certifier and asks no checker. It reads one certificate against the input by means
//! of [`crate::oracle`]: carriers are the supports of corners of all intersections of triangles and tets, an overlay is a
//! tiling of both surfaces, determinants and points are computed again. What it cannot disprove it calls true; what it
//! calls false is false.

pub mod campaign;
pub mod change;
mod overlay;
mod pairs;
mod places;
mod text;
mod witness;

use std::collections::BTreeMap;

use dashu_ratio::RBig;

use crate::oracle::exact::positive;
use crate::oracle::lift::{Section, section};
use crate::oracle::tets::Code;
use crate::oracle::{World, boundary};
use crate::recipe::Case;
use overlay::Carriers;
pub use text::Text;

/// Why a certificate's text is not called true.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Flaw {
    /// A statement in it is false, and this is why.
    False(&'static str),
    /// It does not read as a certificate, or it speaks of nothing that exists: no statement at all.
    Unreadable,
}

/// Nothing was found wrong, or what is wrong.
pub type Judged = Result<(), Flaw>;

/// False unless the condition holds.
fn holds(condition: bool, otherwise: &'static str) -> Judged {
    if condition { Ok(()) } else { Err(Flaw::False(otherwise)) }
}

/// The input and the honest certificate about it.
pub struct Judge<'a> {
    world: World<'a>,
    case: &'a Case,
    /// Verdicts that the oracle has confirmed.
    claims: BTreeMap<String, bool>,
    /// Coordinates on the grid of `world` are true ones times this.
    unit: RBig,
    edges: [std::collections::HashSet<[u32; 2]>; 2],
}

/// What a vertex order makes of the shell.
struct Ordered {
    /// Its tets, by number.
    selected: Vec<usize>,
    /// By place in the order.
    order: Vec<u32>,
}

impl<'a> Judge<'a> {
    /// A judge of certificates about a case; `claims` are true verdicts by their names in certificates.
    #[must_use]
    pub fn new(case: &'a Case, claims: BTreeMap<String, bool>) -> Self {
        let world = World::new(&case.shell, &case.mesh);
        let unit = unit(case, &world);
        let edges = [boundary(&case.mesh.faces), boundary(&case.shell.faces)];
        Self { world, case, claims, unit, edges }
    }

    fn ordered(&self, order: &[u32]) -> Ordered {
        let rank = Case { order: order.to_vec(), ..self.case.clone() }.rank();
        Ordered { selected: self.world.selected(&rank), order: order.to_vec() }
    }

    /// Is a statement of `text` false, where it differs from `honest`? With `honest` absent, anywhere.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn judge(&mut self, text: &Text<'_>, honest: Option<&Text<'_>>) -> Judged {
        let same = |of: fn(&Text<'_>) -> String| honest.is_some_and(|h| of(h) == of(text));
        if let Some(honest) = honest {
            holds(text.shell == honest.shell, "hash or size of the shell")?;
            holds(text.mesh == honest.mesh, "hash or size of the mesh")?;
            holds(text.pinched == honest.pinched, "pinched vertices")?;
        }
        let order = self.order(text)?;
        let ordered = self.ordered(&order);
        let same_order = order == self.case.order;
        let honest_tets = self.ordered(&self.case.order.clone()).selected;
        for &(name, verdict) in &text.claims {
            let truth = *self.claims.get(name).ok_or(Flaw::Unreadable)?;
            let certified = verdict == "certified";
            if ordered.selected == honest_tets || !depends_on_order(name) {
                holds(certified == truth, "verdict")?;
            } else {
                self.verdict_of_order(name, certified, &ordered)?;
            }
        }
        let counts: Vec<String> = text.blocks.iter().map(|(_, lines)| lines.len().to_string()).collect();
        holds(text.counts == counts, "counts")?;
        let claims_stay = same(|t| format!("{:?}", t.claims));
        for (name, lines) in &text.blocks {
            let before = honest.and_then(|h| h.block(name));
            if !(same_order && claims_stay && before == Some(lines)) {
                self.block(name, lines, before, text, &ordered)?;
            }
        }
        Ok(())
    }

    fn order(&self, text: &Text<'_>) -> Result<Vec<u32>, Flaw> {
        let n = u32::try_from(self.case.shell.middle.len()).unwrap();
        let out: Vec<u32> = match text.order[..] {
            ["id"] => (0..n).collect(),
            ["list", ref ids @ ..] => {
                ids.iter().map(|id| id.parse().map_err(|_| Flaw::Unreadable)).collect::<Result<_, _>>()?
            }
            _ => return Err(Flaw::Unreadable),
        };
        let mut sorted = out.clone();
        sorted.sort_unstable();
        if sorted.into_iter().eq(0..n) { Ok(out) } else { Err(Flaw::Unreadable) }
    }

    fn verdict_of_order(&mut self, name: &str, certified: bool, ordered: &Ordered) -> Judged {
        let rank = Case { order: ordered.order.clone(), ..self.case.clone() }.rank();
        let truth = if name == "disjoint-prisms" {
            self.world.injective(&rank)
        } else {
            match section(&mut self.world, &rank) {
                Section::Ambiguous => return Ok(()),
                found => found == Section::Exists,
            }
        };
        holds(certified == truth, "verdict for another order")
    }

    fn block(
        &mut self,
        name: &str,
        lines: &[Vec<&str>],
        before: Option<&Vec<Vec<&str>>>,
        text: &Text<'_>,
        ordered: &Ordered,
    ) -> Judged {
        let certified = text.claims.iter().any(|c| c.0 == name && c.1 == "certified");
        match name {
            "positivity" => {
                holds(!lines.is_empty(), "no tet is named")?;
                let all: Vec<usize> = (0..self.world.tets.all.len()).collect();
                lines.iter().try_for_each(|line| self.bad_tet(line, &all))
            }
            "overlay" => overlay::judge(self, &Carriers::new(&self.world, &ordered.selected), lines),
            "no-section" => witness::judge(self, ordered, lines),
            "no-order" => {
                let Some((["first", first @ ..], rest)) = lines.split_first().map(|(l, r)| (&l[..], r))
                else {
                    return Err(Flaw::Unreadable);
                };
                let first: Vec<u32> = first
                    .iter()
                    .map(|v| v.parse().map_err(|_| Flaw::Unreadable))
                    .collect::<Result<_, _>>()?;
                if first.iter().any(|v| !ordered.order.contains(v)) {
                    return Err(Flaw::Unreadable);
                }
                let others = ordered.order.iter().filter(|v| !first.contains(v));
                let order: Vec<u32> = first.iter().chain(others).copied().collect();
                if order.len() != ordered.order.len() {
                    return Err(Flaw::Unreadable);
                }
                let ordered = self.ordered(&order);
                witness::judge(self, &ordered, rest)
            }
            _ => pairs::judge(self, name, certified, lines, before, ordered),
        }
    }

    /// `tet P TET VALUE`: a tet of the prism among `allowed` with this determinant, which is not positive.
    fn bad_tet(&self, line: &[&str], allowed: &[usize]) -> Judged {
        let ["tet", prism, names, value] = line[..] else { return Err(Flaw::Unreadable) };
        let prism: usize = prism.parse().map_err(|_| Flaw::Unreadable)?;
        let tet = self.tet(names, allowed, Some(prism))?;
        let determinant = &self.world.determinants[tet];
        let stated = text::value(value)?;
        let unit = &self.unit * &self.unit * &self.unit;
        holds(RBig::from(determinant.clone()) == stated * unit, "another determinant")?;
        holds(!positive(determinant), "a positive tet")
    }

    /// The tet of these names, among those that are allowed; without a prism any prism's.
    fn tet(&self, names: &str, allowed: &[usize], prism: Option<usize>) -> Result<usize, Flaw> {
        let names = text::names(names)?;
        let found = allowed.iter().copied().find(|&t| {
            let tet = &self.world.tets.all[t];
            prism.is_none_or(|p| p == tet.prism) && sorted(tet.names) == names
        });
        found.ok_or(Flaw::False("no such tet"))
    }

    /// Are the names only `t` or pinched, or only `b` or pinched, a pinched one alone excepted?
    fn cap(&self, names: &[Code]) -> bool {
        let pinched = |c: Code| self.world.pinched[(c / 3) as usize];
        let of = |layer: Code| names.iter().all(|&c| c % 3 == layer || pinched(c));
        !(names.len() == 1 && pinched(names[0])) && (of(0) || of(2))
    }

    /// Do the ids lie in one boundary edge of the mesh (0) or of the middle complex (1)?
    fn on_boundary(&self, which: usize, ids: &[u32]) -> bool {
        self.edges[which].iter().any(|edge| ids.iter().all(|v| edge.contains(v)))
    }
}

fn sorted(mut names: [Code; 4]) -> Vec<Code> {
    names.sort_unstable();
    names.to_vec()
}

fn depends_on_order(claim: &str) -> bool {
    ["section", "bijection", "disjoint-prisms"].contains(&claim)
}

/// What the grid multiplies by: seen at any coordinate that is not zero.
fn unit(case: &Case, world: &World<'_>) -> RBig {
    let layers = [&case.shell.bottom, &case.shell.middle, &case.shell.top];
    let points = (0..3 * case.shell.middle.len()).map(|code| layers[code % 3][code / 3]);
    let ratio = points.zip(0..).find_map(|(p, code)| {
        let k = (0..3).find(|&k| p[k] != 0.0)?;
        Some(RBig::from(world.at(code)[k].clone()) / RBig::try_from(p[k]).unwrap())
    });
    ratio.unwrap_or(RBig::ONE)
}
