//! A certificate's text in parts, without judgement.

use dashu_int::IBig;
use dashu_ratio::RBig;

use super::Flaw;
use crate::oracle::exact::Weights;
use crate::oracle::tets::Code;

/// Lines of words.
pub(super) type Lines<'t> = Vec<Vec<&'t str>>;

/// The parts of a certificate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Text<'t> {
    /// Names and verdicts.
    pub claims: Vec<(&'t str, &'t str)>,
    /// Words after `shell`.
    pub shell: Vec<&'t str>,
    /// Words after `mesh`, where there is such a line.
    pub mesh: Option<Vec<&'t str>>,
    /// Words after `order`.
    pub order: Vec<&'t str>,
    /// Words after `pinched`.
    pub pinched: Vec<&'t str>,
    /// Name and fact lines.
    pub blocks: Vec<(&'t str, Lines<'t>)>,
    /// Words after `counts`.
    pub counts: Vec<&'t str>,
}

/// Lines not read yet.
struct Rest<'t>(std::iter::Peekable<std::str::Lines<'t>>);

impl<'t> Rest<'t> {
    /// The words of the next line, if it passes.
    fn next_if(&mut self, passes: impl Fn(&str) -> bool) -> Option<Vec<&'t str>> {
        self.0.next_if(|line| passes(line.split(' ').next().unwrap_or(""))).map(|l| l.split(' ').collect())
    }

    /// The words after this one, with which the next line begins.
    fn after(&mut self, word: &str) -> Option<Vec<&'t str>> {
        self.next_if(|first| first == word).map(|words| words[1..].to_vec())
    }

    fn must(&mut self, word: &str) -> Result<Vec<&'t str>, Flaw> {
        self.after(word).ok_or(Flaw::Unreadable)
    }
}

impl<'t> Text<'t> {
    /// The parts of a text with all lines in their places.
    ///
    /// # Errors
    /// [`Flaw::Unreadable`] where the frame is broken.
    pub fn read(text: &'t str) -> Result<Self, Flaw> {
        let mut rest = Rest(text.lines().peekable());
        rest.must("homeo-certificate")?;
        let mut claims = Vec::new();
        while let Some(words) = rest.after("claim") {
            let [name, verdict] = words[..] else { return Err(Flaw::Unreadable) };
            claims.push((name, verdict));
        }
        let (shell, mesh) = (rest.must("shell")?, rest.after("mesh"));
        let (order, pinched) = (rest.must("order")?, rest.must("pinched")?);
        let mut blocks = Vec::new();
        while let Some(words) = rest.after("begin") {
            let [name] = words[..] else { return Err(Flaw::Unreadable) };
            let facts = std::iter::from_fn(|| rest.next_if(|word| word != "begin" && word != "counts"));
            blocks.push((name, facts.collect()));
        }
        let counts = rest.must("counts")?;
        rest.must("end")?;
        Ok(Self { claims, shell, mesh, order, pinched, blocks, counts })
    }

    /// The fact lines of a block.
    #[must_use]
    pub fn block(&self, name: &str) -> Option<&Lines<'t>> {
        self.blocks.iter().find(|b| b.0 == name).map(|b| &b.1)
    }

    /// As it is written.
    #[must_use]
    pub fn write(&self) -> String {
        let mut out = vec!["homeo-certificate 1".to_owned()];
        out.extend(self.claims.iter().map(|(name, verdict)| format!("claim {name} {verdict}")));
        out.push(format!("shell {}", self.shell.join(" ")));
        out.extend(self.mesh.iter().map(|words| format!("mesh {}", words.join(" "))));
        out.push(format!("order {}", self.order.join(" ")));
        out.push(format!("pinched {}", self.pinched.join(" ")));
        for (name, facts) in &self.blocks {
            out.push(format!("begin {name}"));
            out.extend(facts.iter().map(|words| words.join(" ")));
        }
        out.push(["counts"].iter().chain(&self.counts).copied().collect::<Vec<_>>().join(" "));
        out.push("end\n".to_owned());
        out.join("\n")
    }
}

/// A number, where the word is one.
pub(super) fn number<T: std::str::FromStr>(word: &str) -> Result<T, Flaw> {
    word.parse().map_err(|_| Flaw::Unreadable)
}

/// `m0,m1,t2`, ascending.
pub(super) fn names(word: &str) -> Result<Vec<Code>, Flaw> {
    let code = |name: &str| {
        let layer = name.chars().next().and_then(|c| "bmt".find(c)).ok_or(Flaw::Unreadable)?;
        let vertex: Code = number(&name[1..])?;
        vertex.checked_mul(3).map(|v| v + Code::try_from(layer).unwrap()).ok_or(Flaw::Unreadable)
    };
    ascending(word.split(',').map(code).collect::<Result<_, _>>()?)
}

/// `0,1,2`, ascending.
pub(super) fn ids(word: &str) -> Result<Vec<u32>, Flaw> {
    ascending(word.split(',').map(number).collect::<Result<_, _>>()?)
}

fn ascending(list: Vec<u32>) -> Result<Vec<u32>, Flaw> {
    if list.is_sorted_by(|a, b| a < b) { Ok(list) } else { Err(Flaw::Unreadable) }
}

/// Weights, not all zero.
pub(super) fn weights(words: &[&str]) -> Result<Weights, Flaw> {
    let one = |word: &&str| number::<IBig>(word).ok().filter(|w| *w >= IBig::ZERO).ok_or(Flaw::Unreadable);
    let out: Weights = words.iter().map(one).collect::<Result<_, _>>()?;
    if out.iter().any(|w| *w != IBig::ZERO) { Ok(out) } else { Err(Flaw::Unreadable) }
}

/// `ODD*2^EXP`.
pub(super) fn value(word: &str) -> Result<RBig, Flaw> {
    let (odd, exponent) = word.split_once("*2^").unwrap_or((word, "0"));
    let (odd, exponent): (IBig, i64) = (number(odd)?, number(exponent)?);
    let power = IBig::ONE << usize::try_from(exponent.unsigned_abs()).map_err(|_| Flaw::Unreadable)?;
    let power = RBig::from(power);
    Ok(if exponent < 0 { RBig::from(odd) / power } else { RBig::from(odd) * power })
}
