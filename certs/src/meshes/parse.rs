//! The grammar of certificates about meshes (MESHES section 3).

use crate::line::{Line, Plane, weights};
use crate::pages::Text;
use crate::parse::Parser;
use crate::{Res, malformed};
use num_bigint::BigInt;

/// The claims, and how many inputs each is about.
const CLAIMS: [(&str, usize); 6] = [
    ("manifold", 1),
    ("embedded", 1),
    ("same-topology", 2),
    ("nested", 2),
    ("nested-topology", 2),
    ("pl-homeomorphism", 2),
];

const DEFECTS: [&str; 8] = ["repeated", "twin", "direction", "facet", "vertex", "edge", "link", "flat"];

/// No witness needs more lines.
const MOST_LINES: usize = 1000;

/// What an `input` line states.
#[derive(PartialEq, Eq)]
pub(super) struct Stated {
    pub(super) sha: String,
    pub(super) space: usize,
    pub(super) k: usize,
    pub(super) vertices: usize,
    pub(super) cells: usize,
}

impl Stated {
    pub(super) fn is_full(&self) -> bool {
        self.k == self.space + 1
    }
}

pub(super) struct Cert {
    pub(super) claim: &'static str,
    pub(super) certified: bool,
    pub(super) inputs: Vec<Stated>,
    /// The blocks `a`, `b`, `between`.
    pub(super) planes: Vec<Vec<Sep>>,
    pub(super) rays: Vec<Ray>,
    pub(super) witness: Vec<Fact>,
}

/// A `sep` line. Vertex `v` of `b` is the point `v` plus the number of vertices of `a`.
pub(super) struct Sep {
    pub(super) line: usize,
    pub(super) pair: (usize, usize),
    pub(super) planes: Vec<Plane>,
}

/// A `ray` line; the direction is scaled to entries of up to `2^40`.
pub(super) struct Ray {
    pub(super) line: usize,
    pub(super) input: usize,
    pub(super) vertex: usize,
    pub(super) direction: [i64; 3],
    pub(super) cells: Vec<usize>,
}

/// A line of a witness.
pub(super) struct Fact {
    pub(super) line: usize,
    pub(super) input: usize,
    pub(super) what: What,
}

pub(super) enum What {
    Repeated(usize),
    Flat(usize),
    Link(usize),
    Twin([usize; 2]),
    Direction([usize; 2]),
    Sign([usize; 2]),
    Facet(Vec<usize>, [usize; 3]),
    /// Two cells that are not connected around a vertex or an edge.
    Around(Vec<usize>, [usize; 2]),
    Open([usize; 2]),
    Twice {
        facet: usize,
        cell: usize,
    },
    /// Inputs, cells and weights of the two points.
    Cross([usize; 2], [usize; 2], [Vec<BigInt>; 2]),
    Winding(Ray),
}

/// Reads and judges a certificate file.
pub(super) fn parse(bytes: &[u8]) -> Res<Cert> {
    let mut parser = Parser::open(Text::Memory(bytes), "homeo-meshes 1")?;
    let line = parser.line("claim")?;
    let name = line.next()?;
    let Some(&(claim, many)) = CLAIMS.iter().find(|c| c.0 == name) else { return line.syntax() };
    let verdict = line.next()?;
    line.require(verdict == "certified" || verdict == "refuted")?;
    line.finish()?;
    let certified = verdict == "certified";
    if certified && claim == "nested-topology" {
        return malformed("claims", "nested-topology can only be refuted");
    }
    let inputs = ["a", "b"][..many].iter().map(|x| stated(&mut parser, x)).collect::<Res<Vec<_>>>()?;
    if !fits(claim, &inputs) {
        return malformed("claims", format!("line {}: {claim} is not about such inputs", parser.at));
    }
    let cert = Cert { claim, certified, inputs, planes: vec![], rays: vec![], witness: vec![] };
    cert.blocks(&mut parser)
}

fn stated(parser: &mut Parser<'_>, x: &str) -> Res<Stated> {
    let line = parser.line("input")?;
    line.expect(x)?;
    let sha = line.sha()?;
    let one_of = |words: [&str; 2]| {
        let word = line.next()?;
        line.require(words.contains(&word))?;
        Ok(usize::from(word.as_bytes()[0] - b'0'))
    };
    let (space, k) = (one_of(["2", "3"])?, one_of(["3", "4"])?);
    let (vertices, cells) = (line.id(usize::MAX)?, line.id(usize::MAX)?);
    line.finish()?;
    Ok(Stated { sha, space, k, vertices, cells })
}

fn fits(claim: &str, inputs: &[Stated]) -> bool {
    let numbers = |x: &Stated| (x.k, x.vertices, x.cells);
    inputs.iter().all(|x| match claim {
        "manifold" => x.k <= x.space + 1,
        "same-topology" => x.k == 3,
        "pl-homeomorphism" => x.k <= x.space + 1 && numbers(x) == numbers(&inputs[0]),
        _ => (x.space, x.k) == (3, 3),
    })
}

impl Cert {
    fn blocks(mut self, parser: &mut Parser<'_>) -> Res<Self> {
        let blocks: &[&str] = match (self.claim, self.certified) {
            ("same-topology" | "nested-topology", _) | ("manifold", true) => &[],
            (_, false) => &["witness"],
            ("embedded", _) => &["a"],
            ("nested", _) => &["a", "b", "between", "rays"],
            _ => &["a", "b"],
        };
        let mut counts = Vec::new();
        for name in blocks {
            let line = parser.line("begin")?;
            line.expect(name)?;
            line.finish()?;
            let before = parser.at;
            match *name {
                "rays" => {
                    for input in [0, 1] {
                        let word = ["ray a", "ray b"][input];
                        while self.rays.last().is_none_or(|r| r.input != input) || parser.starts_with(word) {
                            let line = parser.line("ray")?;
                            let x = self.input(&line)?;
                            line.require(x == input)?;
                            self.rays.push(self.ray(&line, x)?);
                        }
                    }
                }
                "witness" => {
                    while self.witness.is_empty() || self.witness.len() < MOST_LINES && self.ahead(parser) {
                        let fact = self.fact(parser)?;
                        self.witness.push(fact);
                    }
                }
                _ => {
                    let block = self.planes.len();
                    let mut lines = Vec::new();
                    while self.inputs.get(block).is_none_or(|x| x.space == 3) && parser.peek("sep") {
                        let last = lines.last().map(|s: &Sep| s.pair);
                        lines.push(self.sep(&parser.line("sep")?, block, last)?);
                    }
                    self.planes.push(lines);
                }
            }
            counts.push(parser.at - before);
        }
        parser.finish(&counts)?;
        Ok(self)
    }

    /// The words that a line of the witness may start with.
    fn words(&self) -> impl Iterator<Item = &'static str> {
        let tets = self.inputs[0].k == 4;
        let defects = DEFECTS.into_iter().filter(move |w| tets || !["edge", "link"].contains(w));
        let own: &[&str] = match self.claim {
            "embedded" => &["cross"],
            "nested" => &["open", "cross", "winding"],
            "pl-homeomorphism" => &["sign", "twice", "cross"],
            _ => &[],
        };
        defects.chain(own.iter().copied())
    }

    fn ahead(&self, parser: &Parser<'_>) -> bool {
        self.words().any(|word| parser.peek(word))
    }

    fn input(&self, line: &Line<'_>) -> Res<usize> {
        match line.next()? {
            "a" => Ok(0),
            "b" if self.inputs.len() == 2 => Ok(1),
            _ => line.syntax(),
        }
    }

    /// `n` cells of an input, ascending.
    fn cells<const N: usize>(&self, line: &Line<'_>, input: usize) -> Res<[usize; N]> {
        let mut ids = [0; N];
        for id in &mut ids {
            *id = line.id(self.inputs[input].cells)?;
        }
        line.require(ids.is_sorted_by(|a, b| a < b))?;
        Ok(ids)
    }

    fn ray(&self, line: &Line<'_>, input: usize) -> Res<Ray> {
        let vertex = line.id(self.inputs[input].vertices)?;
        let mut direction = [0; 3];
        for x in &mut direction {
            // The grammar allows ten digits.
            *x = i64::try_from(line.signed(true)?).unwrap_or(0);
        }
        let longest = direction.iter().map(|x| x.unsigned_abs()).max().unwrap_or(0);
        line.require(longest > 0)?;
        let shift = (longest.leading_zeros()).saturating_sub(25);
        let mut cells = Vec::new();
        while line.more() {
            cells.push(line.id(self.inputs[1 - input].cells)?);
        }
        line.require(cells.is_sorted_by(|a, b| a < b))?;
        line.finish()?;
        Ok(Ray { line: line.at, input, vertex, direction: direction.map(|x| x << shift), cells })
    }

    /// A line of block 0 (`a`), 1 (`b`) or 2 (`between`).
    fn sep(&self, line: &Line<'_>, block: usize, last: Option<(usize, usize)>) -> Res<Sep> {
        let faces = |input: usize| match &self.inputs[input] {
            x if x.is_full() => x.cells * x.k,
            x => x.cells,
        };
        let (left, right) = if block == 2 { (0, 1) } else { (block, block) };
        let pair = (line.id(faces(left))?, line.id(faces(right))?);
        line.require(block == 2 || pair.0 < pair.1)?;
        line.require(last < Some(pair))?;
        let mut planes = vec![self.plane(line, block)?];
        while line.more() {
            planes.push(self.plane(line, block)?);
        }
        line.finish()?;
        Ok(Sep { line: line.at, pair, planes })
    }

    fn plane(&self, line: &Line<'_>, block: usize) -> Res<Plane> {
        let token = line.next()?;
        let Some((kind, points)) = token.split_once(':') else { return line.syntax() };
        let mut ids = Vec::with_capacity(3);
        for point in points.split(',') {
            let input = match point.as_bytes().first() {
                Some(b'a') if block != 1 => 0,
                Some(b'b') if block != 0 => 1,
                _ => return line.syntax(),
            };
            let id = line.id_in(&point[1..], self.inputs[input].vertices)?;
            ids.push(if input == 1 { self.inputs[0].vertices + id } else { id });
        }
        match (kind, ids.as_slice()) {
            ("p", &[a, b, c]) => Ok(Plane::Through([a, b, c])),
            ("l", &[a, b]) => Ok(Plane::Line([a, b])),
            ("n", &[a, b]) => Ok(Plane::Normal([a, b])),
            _ => line.syntax(),
        }
    }

    /// `n` vertices, ascending, joined by commas.
    fn joined(&self, line: &Line<'_>, input: usize, n: usize) -> Res<Vec<usize>> {
        let bound = self.inputs[input].vertices;
        let ids = line.next()?.split(',').map(|t| line.id_in(t, bound)).collect::<Res<Vec<_>>>()?;
        line.require(ids.len() == n && ids.is_sorted_by(|a, b| a < b))?;
        Ok(ids)
    }

    fn fact(&self, parser: &mut Parser<'_>) -> Res<Fact> {
        let line = &parser.any_line()?;
        let word = line.next()?;
        line.require(self.words().any(|w| w == word))?;
        if word == "cross" {
            return self.cross(line);
        }
        let input = self.input(line)?;
        let x = &self.inputs[input];
        let what = match word {
            "repeated" => What::Repeated(line.id(x.cells)?),
            "flat" => What::Flat(line.id(x.cells)?),
            "link" => What::Link(line.id(x.vertices)?),
            "twin" => What::Twin(self.cells(line, input)?),
            "direction" => What::Direction(self.cells(line, input)?),
            "facet" => What::Facet(self.joined(line, input, x.k - 1)?, self.cells(line, input)?),
            "vertex" => What::Around(vec![line.id(x.vertices)?], self.cells(line, input)?),
            "edge" => What::Around(self.joined(line, input, 2)?, self.cells(line, input)?),
            "open" => What::Open([line.id(x.vertices)?, line.id(x.vertices)?]),
            "winding" => What::Winding(self.ray(line, input)?),
            "sign" => {
                let cells = [line.id(x.cells)?, line.id(x.cells)?];
                line.require(x.is_full() && cells[0] <= cells[1])?;
                What::Sign(cells)
            }
            _ => {
                line.require(x.is_full())?;
                What::Twice { facet: line.id(x.cells * x.k)?, cell: line.id(x.cells)? }
            }
        };
        line.finish()?;
        Ok(Fact { line: line.at, input, what })
    }

    fn cross(&self, line: &Line<'_>) -> Res<Fact> {
        let inputs = match line.next()? {
            "a" => [0, 0],
            "b" if self.inputs.len() == 2 => [1, 1],
            "ab" if self.claim == "nested" => [0, 1],
            _ => return line.syntax(),
        };
        let cells = [line.id(self.inputs[inputs[0]].cells)?, line.id(self.inputs[inputs[1]].cells)?];
        line.require(inputs == [0, 1] || cells[0] < cells[1])?;
        let k = self.inputs[0].k;
        let both = [weights(line, k)?, weights(line, k)?];
        line.finish()?;
        Ok(Fact { line: line.at, input: inputs[0], what: What::Cross(inputs, cells, both) })
    }
}
