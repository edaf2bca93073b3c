//! The certificate's grammar (FORMAT section 2) and the checks of a certificate file alone (section 3).

use crate::line::{Bounds, Line, Names4, Plane, Value, weights};
use crate::pages::{Lines, Rows, Separations, Text, carrier, cell};
use crate::{Fail, LIMIT, Res, fail, malformed};
use foldhash::fast::RandomState;
use num_bigint::BigInt;
use std::borrow::Cow;
use std::hash::BuildHasher;

pub(crate) const CLAIMS: [&str; 9] = [
    "positivity",
    "section",
    "bijection",
    "section-all-orders",
    "disjoint-mesh",
    "disjoint-bottom",
    "disjoint-top",
    "i2",
    "disjoint-prisms",
];

/// The claims about a shell alone.
const NO_MESH: [&str; 2] = ["positivity", "disjoint-prisms"];

/// What a `shell` or `mesh` line states.
#[derive(Clone, Default)]
pub(crate) struct Stated {
    pub(crate) sha: String,
    pub(crate) vertices: usize,
    pub(crate) faces: usize,
}

#[derive(Default)]
pub(crate) struct Cert<'a> {
    pub(crate) claims: Vec<(&'static str, bool)>,
    pub(crate) shell: Stated,
    pub(crate) mesh: Option<Stated>,
    pub(crate) order: Option<Vec<usize>>,
    pub(crate) pinched: (usize, Vec<usize>),
    pub(crate) blocks: Vec<Block<'a>>,
    /// The claims that have a block, in the order of the blocks.
    pub(crate) owners: Vec<&'static str>,
}

pub(crate) enum Block<'a> {
    Positivity(Vec<TetFact>),
    Overlay(Box<Overlay<'a>>),
    /// The ids of the `first` line (none in `no-section`).
    NoLift(Vec<usize>, Witness),
    Separated(Separations<'a>),
    Crossing(Vec<Crossing>),
    Overlap(Vec<Overlap>),
}

pub(crate) struct TetFact {
    pub(crate) line: usize,
    pub(crate) prism: usize,
    pub(crate) tet: Names4,
    pub(crate) value: Value,
}

pub(crate) struct Overlay<'a> {
    pub(crate) corners: Lines<'a>,
    pub(crate) cells: Lines<'a>,
    /// Line, cell, fan triangle; for the mesh, for the middle complex.
    pub(crate) degree: [Vec<(usize, usize, usize)>; 2],
}

/// A `sep` or `contact-sep` line (`tet` only in the latter).
pub(crate) struct Separation {
    pub(crate) line: usize,
    pub(crate) pair: (usize, usize),
    pub(crate) tet: Option<Names4>,
    pub(crate) planes: Vec<Plane>,
}

/// A `cross` or `contact` line: weights of the first triangle, of the other corners or names.
pub(crate) struct Crossing {
    pub(crate) line: usize,
    pub(crate) pair: (usize, usize),
    pub(crate) first: Vec<BigInt>,
    pub(crate) second: Vec<BigInt>,
    pub(crate) contact: Option<(Names4, Value)>,
}

/// An `overlap` line: two tets, weights on the names of each.
pub(crate) struct Overlap {
    pub(crate) line: usize,
    pub(crate) tets: [Names4; 2],
    pub(crate) weights: [Vec<BigInt>; 2],
}

pub(crate) enum Witness {
    Topology(usize, bool, [i128; 2]),
    Tet(TetFact),
    Roots(Vec<Root>),
}

/// A point on a triangle of `T`.
pub(crate) struct At {
    pub(crate) line: usize,
    pub(crate) triangle: usize,
    pub(crate) weights: Vec<BigInt>,
}

pub(crate) struct Root {
    pub(crate) at: At,
    pub(crate) branches: Vec<Branch>,
}

pub(crate) struct Branch {
    pub(crate) line: usize,
    pub(crate) names: Vec<usize>,
    pub(crate) legs: Vec<Leg>,
    pub(crate) reason: &'static str,
}

pub(crate) struct Leg {
    pub(crate) line: usize,
    pub(crate) start: Names4,
    pub(crate) steps: Vec<(At, Names4)>,
}

pub(crate) struct Parser<'a> {
    text: Text<'a>,
    /// The part of the text that has been read, where it begins, and what of it is done. The next line is in it, if any.
    window: Cow<'a, str>,
    start: usize,
    done: usize,
    /// The number of the last line read.
    pub(crate) at: usize,
    bounds: Bounds,
}

/// As many bytes of a file are read together.
const WINDOW: usize = if cfg!(test) { 7 } else { 1 << 18 };

/// Reads and judges a certificate file.
pub(crate) fn parse(text: Text<'_>) -> Res<Cert<'_>> {
    Parser::open(text, "homeo-certificate 1")?.cert()
}

impl<'a> Parser<'a> {
    /// A file with this first line, judged as a whole.
    pub(crate) fn open(text: Text<'a>, magic: &str) -> Res<Self> {
        let len = text.len();
        if len > LIMIT {
            return fail(3, "size", "the certificate is larger than 2^30 bytes");
        }
        for start in (0..len).step_by(WINDOW) {
            let part = text.read(start..len.min(start + WINDOW))?;
            if let Some(at) = part.iter().position(|b| !matches!(b, b'\n' | 0x20..=0x7e)) {
                return malformed("bytes", format!("byte {} is not allowed", start + at));
            }
        }
        let end = text.read(len.saturating_sub(5)..len)?;
        if !matches!(&*end, b"end\n" | b"\nend\n") {
            return malformed("truncated", "the last line is not `end`");
        }
        let mut parser =
            Parser { text, window: Cow::Borrowed(""), start: 0, done: 0, at: 0, bounds: Bounds::default() };
        parser.fill()?;
        if parser.raw()?.as_deref() != Some(magic) {
            return malformed("magic", format!("line 1 is not `{magic}`"));
        }
        Ok(parser)
    }

    /// Reads on until the next line is in the window.
    fn fill(&mut self) -> Res {
        let mut end = self.start + self.window.len();
        while end < self.text.len() && !self.ahead().contains('\n') {
            let all = matches!(self.text, Text::Memory(_));
            // More for a long line, so that it is not copied many times.
            let more = if all { self.text.len() } else { WINDOW.max(self.ahead().len()) };
            let until = self.text.len().min(end + more);
            let text = match self.text.read(end..until)? {
                Cow::Borrowed(bytes) => std::str::from_utf8(bytes).ok().map(Cow::Borrowed),
                Cow::Owned(bytes) => {
                    String::from_utf8(bytes).ok().map(|more| Cow::Owned(self.ahead().to_owned() + &more))
                }
            };
            let Some(text) = text else { return malformed("bytes", "") };
            (self.window, self.start, self.done, end) = (text, self.position(), 0, until);
        }
        Ok(())
    }

    /// The part of the window that is not done.
    fn ahead(&self) -> &str {
        self.window.get(self.done..).unwrap_or("")
    }

    /// Where in the text the next line begins.
    fn position(&self) -> usize {
        self.start + self.done
    }

    /// The `counts` line, which must state these, and the last one.
    pub(crate) fn finish(&mut self, counts: &[usize]) -> Res {
        let line = self.line("counts")?;
        let mut stated = Vec::new();
        while line.more() {
            stated.push(line.id(usize::MAX)?);
        }
        line.finish()?;
        if stated != counts {
            return malformed("counts", format!("line {}: the counts are {counts:?}", self.at));
        }
        self.line("end")?.finish()?;
        if self.position() == self.text.len() {
            Ok(())
        } else {
            Line::new("", self.at + 1, self.bounds).syntax()
        }
    }

    pub(crate) fn starts_with(&self, text: &str) -> bool {
        self.ahead().starts_with(text)
    }

    /// The next line, whatever it starts with.
    pub(crate) fn any_line(&mut self) -> Res<Line<'a>> {
        Ok(Line::new(self.raw()?.unwrap_or_default(), self.at, self.bounds))
    }

    fn raw(&mut self) -> Res<Option<Cow<'a, str>>> {
        let line = match &self.window {
            Cow::Borrowed(text) => text[self.done..].split_once('\n').map(|x| Cow::Borrowed(x.0)),
            Cow::Owned(_) => self.ahead().split_once('\n').map(|x| Cow::Owned(x.0.to_owned())),
        };
        let Some(line) = line else { return Ok(None) };
        self.done += line.len() + 1;
        self.at += 1;
        self.fill()?;
        Ok(Some(line))
    }

    /// The next line, which must start with `word`.
    pub(crate) fn line(&mut self, word: &str) -> Res<Line<'a>> {
        let line = self.any_line()?;
        line.expect(word)?;
        Ok(line)
    }

    pub(crate) fn peek(&self, word: &str) -> bool {
        let line = self.ahead().split('\n').next().unwrap_or("");
        line.split(' ').next() == Some(word)
    }

    /// Lines that start with `word`, one or more (zero or more if `optional`), which are read again later. If one fails,
    /// those before it.
    fn pages(
        &mut self,
        word: &str,
        optional: bool,
        mut read: impl FnMut(&Line<'_>) -> Res,
    ) -> (Lines<'a>, Res) {
        let mut lines = Lines::new(self.text, self.bounds, self.at + 1, self.position());
        let mut result = Ok(());
        while result.is_ok() && (self.peek(word) || (lines.len() == 0 && !optional)) {
            result = self.any_line().and_then(|line| {
                read(&line)?;
                lines.push(&line.text, self.position());
                Ok(())
            });
        }
        lines.close();
        (lines, result)
    }

    /// One or more lines (zero or more if `optional`) that start with `word`.
    fn list<T>(
        &mut self,
        word: &str,
        optional: bool,
        mut read: impl FnMut(&Line<'a>) -> Res<T>,
    ) -> Res<Vec<T>> {
        let mut out = Vec::new();
        while self.peek(word) || (out.is_empty() && !optional) {
            out.push(read(&self.line(word)?)?);
        }
        Ok(out)
    }

    fn cert(&mut self) -> Res<Cert<'a>> {
        let mut cert = Cert::default();
        let mut from = 0;
        cert.claims = self.list("claim", false, |line| {
            let name = line.next()?;
            let Some(at) = CLAIMS[from..].iter().position(|c| *c == name) else { return line.syntax() };
            from += at + 1;
            let verdict = line.next()?;
            if verdict != "certified" && verdict != "refuted" {
                return line.syntax();
            }
            line.finish()?;
            Ok((CLAIMS[from - 1], verdict == "certified"))
        })?;
        let claim = |name: &str| cert.claims.iter().find(|c| c.0 == name).map(|c| c.1);
        let plan = plan(claim)?;
        cert.shell = self.stated("shell")?;
        (self.bounds.shell, self.bounds.prisms) = (cert.shell.vertices, cert.shell.faces);
        if cert.claims.iter().any(|(name, _)| !NO_MESH.contains(name)) {
            let mesh = self.stated("mesh")?;
            (self.bounds.mesh, self.bounds.triangles) = (mesh.vertices, mesh.faces);
            cert.mesh = Some(mesh);
        }
        cert.order = self.order()?;
        let line = self.line("pinched")?;
        let count = line.id(usize::MAX)?;
        let mut ids = Vec::new();
        while line.more() {
            ids.push(line.id(self.bounds.shell)?);
        }
        line.require(ids.is_sorted_by(|a, b| a < b))?;
        line.finish()?;
        cert.pinched = (count, ids);
        let mut counts = Vec::new();
        for (name, verdict, owner) in plan {
            let line = self.line("begin")?;
            line.expect(name)?;
            line.finish()?;
            let before = self.at;
            cert.blocks.push(self.block(name, verdict)?);
            counts.push(self.at - before);
            cert.owners.push(owner);
        }
        self.finish(&counts)?;
        Ok(cert)
    }

    fn stated(&mut self, word: &str) -> Res<Stated> {
        let line = self.line(word)?;
        let sha = line.sha()?;
        let (vertices, faces) = (line.id(usize::MAX)?, line.id(usize::MAX)?);
        line.finish()?;
        Ok(Stated { sha, vertices, faces })
    }

    fn order(&mut self) -> Res<Option<Vec<usize>>> {
        let line = self.line("order")?;
        let kind = line.next()?;
        if kind == "id" {
            line.finish()?;
            return Ok(None);
        }
        line.require(kind == "list")?;
        let mut ids = Vec::new();
        line.distinct_ids(self.bounds.shell, &mut ids)?;
        let identity = ids.iter().enumerate().all(|(i, &id)| i == id);
        line.require(ids.len() == self.bounds.shell && !identity)?;
        line.finish()?;
        Ok(Some(ids))
    }

    fn block(&mut self, name: &'static str, certified: bool) -> Res<Block<'a>> {
        Ok(match name {
            "positivity" => Block::Positivity(self.list("tet", false, tet_fact)?),
            "overlay" => Block::Overlay(Box::new(self.overlay()?)),
            "no-section" => Block::NoLift(Vec::new(), self.witness()?),
            "no-order" => {
                let line = self.line("first")?;
                let mut ids = Vec::new();
                line.distinct_ids(self.bounds.shell, &mut ids)?;
                line.finish()?;
                Block::NoLift(ids, self.witness()?)
            }
            _ if certified => {
                return self.separations(name).map(Block::Separated);
            }
            "i2" => Block::Crossing(self.list("contact", false, |line| {
                let pair = (line.id(line.bounds.triangles)?, line.id(line.bounds.prisms)?);
                let tet = line.tet()?;
                let (first, second) = (weights(line, 3)?, weights(line, 4)?);
                let contact = Some((tet, line.value()?));
                line.finish()?;
                Ok(Crossing { line: line.at, pair, first, second, contact })
            })?),
            "disjoint-prisms" if self.peek("tet") => Block::NoLift(Vec::new(), self.witness()?),
            "disjoint-prisms" => Block::Overlap(self.list("overlap", false, |line| {
                let (first, u) = (line.tet()?, weights(line, 4)?);
                let (second, v) = (line.tet()?, weights(line, 4)?);
                line.finish()?;
                Ok(Overlap { line: line.at, tets: [first, second], weights: [u, v] })
            })?),
            _ => Block::Crossing(self.list("cross", false, |line| {
                let pair = pair(line, name)?;
                let (first, second) = (weights(line, 3)?, weights(line, 3)?);
                line.finish()?;
                Ok(Crossing { line: line.at, pair, first, second, contact: None })
            })?),
        })
    }

    fn separations(&mut self, name: &'static str) -> Res<Separations<'a>> {
        let (mut last, mut firsts, mut greatest) = (None, Vec::new(), None);
        let (lines, result) = self.pages(separator(name), true, |line| {
            let found = separation(line, name, last)?;
            last = Some((found.pair, found.tet));
            // Triangles are fewer than 2^32.
            firsts.push(u32::try_from(found.pair.0).unwrap_or(u32::MAX));
            greatest = greatest.max(Some(found.pair.1));
            Ok(())
        });
        result?;
        Ok(Separations { lines, block: name, firsts, greatest })
    }

    fn overlay(&mut self) -> Res<Overlay<'a>> {
        let (hasher, mut hashes, mut rows) = (RandomState::default(), Vec::new(), <[Rows; 2]>::default());
        let (corners, result) = self.pages("v", false, |line| {
            rows.iter_mut().for_each(Rows::clear);
            carrier(line, &mut rows)?;
            hashes.push(hasher.hash_one(&*line.text));
            Ok(())
        });
        // A repetition comes before what is wrong in a later line.
        corners.different(|text| hasher.hash_one(text), hashes)?;
        result?;
        self.bounds.corners = corners.len();
        // How many fan triangles each cell has.
        let mut sizes = Vec::new();
        let (cells, result) = self.pages("c", false, |line| {
            rows[0].clear();
            cell(line, &mut rows[0])?;
            sizes.push(rows[0].items().len() as u32 - 2);
            Ok(())
        });
        result?;
        let mut degree = [Vec::new(), Vec::new()];
        for (kind, list) in ["mesh", "middle"].iter().zip(&mut degree) {
            while list.is_empty()
                || (*kind == "mesh" && self.starts_with("d mesh "))
                || *kind == "middle" && self.peek("d")
            {
                let line = self.line("d")?;
                line.expect(kind)?;
                let cell = line.id(cells.len())?;
                let fans = sizes.get(cell).map_or(usize::MAX, |&size| size as usize);
                let fan = line.id(fans)?;
                line.finish()?;
                list.push((line.at, cell, fan));
            }
        }
        Ok(Overlay { corners, cells, degree })
    }

    fn witness(&mut self) -> Res<Witness> {
        if self.peek("topology") {
            let line = self.line("topology")?;
            let kind = line.next()?;
            line.require(kind == "components" || kind == "euler")?;
            let both = [line.signed(kind == "euler")?, line.signed(kind == "euler")?];
            line.finish()?;
            return Ok(Witness::Topology(line.at, kind == "euler", both));
        }
        if self.peek("tet") {
            return Ok(Witness::Tet(tet_fact(&self.line("tet")?)?));
        }
        let mut roots = Vec::new();
        while roots.is_empty() || self.peek("root") {
            let line = self.line("root")?;
            let at = at(&line)?;
            line.finish()?;
            let mut branches: Vec<Branch> = Vec::new();
            while self.peek("branch") {
                let branch = self.branch(branches.last())?;
                branches.push(branch);
            }
            roots.push(Root { at, branches });
        }
        Ok(Witness::Roots(roots))
    }

    fn branch(&mut self, last: Option<&Branch>) -> Res<Branch> {
        let line = self.line("branch")?;
        let names = line.names()?;
        line.require(last.is_none_or(|b| b.names < names))?;
        line.finish()?;
        let mut legs = vec![self.leg()?];
        if self.peek("start") {
            legs.push(self.leg()?);
        }
        let allowed: &[&'static str] = if legs.len() == 1 {
            &["cap", "wall", "boundary", "fold", "lands"]
        } else {
            &["twice", "monodromy"]
        };
        let last = self.any_line()?;
        let word = last.next()?;
        let Some(reason) = allowed.iter().find(|r| **r == word) else { return last.syntax() };
        last.finish()?;
        Ok(Branch { line: line.at, names, legs, reason })
    }

    fn leg(&mut self) -> Res<Leg> {
        let line = self.line("start")?;
        let start = line.tet()?;
        line.finish()?;
        let steps = self.list("step", true, |line| {
            let at = at(line)?;
            let tet = line.tet()?;
            line.finish()?;
            Ok((at, tet))
        })?;
        Ok(Leg { line: line.at, start, steps })
    }
}

/// The blocks that the claims need, the verdict that each is about, the claim that has it; or `malformed claims`.
fn plan(claim: impl Fn(&str) -> Option<bool>) -> Res<Vec<(&'static str, bool, &'static str)>> {
    let section = claim("section");
    let fits = |name: &str, needs: &[&str]| {
        let all = needs.iter().try_fold(true, |all, need| claim(need).map(|yes| all && yes));
        claim(name).is_none_or(|verdict| all.is_some_and(|all| all || !verdict))
    };
    if section != claim("bijection")
        || !fits("section-all-orders", &["positivity", "section"])
        || !fits("i2", &["section-all-orders", "disjoint-bottom", "disjoint-top"])
    {
        return malformed("claims", "the claims do not fit together");
    }
    let yes = |names: &[&str]| names.iter().all(|n| claim(n) == Some(true));
    let mut plan = Vec::new();
    let mut add =
        |name, present: bool, verdict, owner| plan.extend(present.then_some((name, verdict, owner)));
    add("positivity", claim("positivity") == Some(false), false, "positivity");
    add("overlay", section == Some(true), true, "section");
    add("no-section", section == Some(false), false, "section");
    let no_order = claim("section-all-orders") == Some(false) && yes(&["positivity", "section"]);
    add("no-order", no_order, false, "section-all-orders");
    for name in ["disjoint-mesh", "disjoint-bottom", "disjoint-top"] {
        add(name, claim(name).is_some(), claim(name) == Some(true), name);
    }
    let i2 = claim("i2");
    let own =
        i2.is_some() && (i2 == Some(true) || yes(&["section-all-orders", "disjoint-bottom", "disjoint-top"]));
    add("i2", own, i2 == Some(true), "i2");
    let prisms = claim("disjoint-prisms");
    add("disjoint-prisms", prisms.is_some(), prisms == Some(true), "disjoint-prisms");
    Ok(plan)
}

fn tet_fact(line: &Line<'_>) -> Res<TetFact> {
    let (prism, tet, value) = (line.id(line.bounds.prisms)?, line.tet()?, line.value()?);
    line.finish()?;
    Ok(TetFact { line: line.at, prism, tet, value })
}

fn at(line: &Line<'_>) -> Res<At> {
    Ok(At { line: line.at, triangle: line.id(line.bounds.triangles)?, weights: weights(line, 3)? })
}

/// The `(i, j)` of a `sep` or `cross` line of the block `name`.
fn pair(line: &Line<'_>, name: &str) -> Result<(usize, usize), Fail> {
    let Bounds { triangles, prisms, .. } = line.bounds;
    let (first, second, itself) = match name {
        "disjoint-mesh" => (triangles, triangles, true),
        // How many triangles the skin has is known later.
        "disjoint-prisms" => (usize::MAX, usize::MAX, true),
        _ => (triangles, prisms, false),
    };
    let (i, j) = (line.id(first)?, line.id(second)?);
    line.require(!itself || i < j)?;
    Ok((i, j))
}

/// The word that lines of a block of separations start with.
fn separator(block: &str) -> &'static str {
    if block == "i2" { "contact-sep" } else { "sep" }
}

/// What such lines are ascending by.
type Key = ((usize, usize), Option<Names4>);

/// A line of such a block, and the key of the one before it, if that is to be compared.
pub(crate) fn separation(line: &Line<'_>, block: &str, last: Option<Key>) -> Res<Separation> {
    line.expect(separator(block))?;
    let (pair, tet) = if block == "i2" {
        ((line.id(line.bounds.triangles)?, line.id(line.bounds.prisms)?), Some(line.tet()?))
    } else {
        (pair(line, block)?, None)
    };
    line.require(last < Some((pair, tet)))?;
    let mut planes = vec![line.plane()?];
    while line.more() {
        planes.push(line.plane()?);
    }
    line.finish()?;
    Ok(Separation { line: line.at, pair, tet, planes })
}
