//! Tiny shells with certificates written by hand.
#![allow(dead_code, clippy::expect_used)] // each test file uses a part

use homeo_certs::{Outcome, check};
use sha2::{Digest, Sha256};

pub(crate) type P = [f64; 3];

#[derive(Clone)]
pub(crate) struct Case {
    pub(crate) layers: [Vec<P>; 3],
    pub(crate) prisms: Vec<[u32; 3]>,
    pub(crate) points: Vec<P>,
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) order: String,
    pub(crate) pinched: String,
    pub(crate) claims: Vec<(&'static str, bool)>,
    pub(crate) blocks: Vec<(&'static str, Vec<String>)>,
}

pub(crate) const ALL: [&str; 8] = [
    "positivity",
    "section",
    "bijection",
    "section-all-orders",
    "disjoint-mesh",
    "disjoint-bottom",
    "disjoint-top",
    "i2",
];

pub(crate) fn lines(text: &str) -> Vec<String> {
    text.lines().map(|l| l.trim().to_owned()).filter(|l| !l.is_empty()).collect()
}

/// One straight prism over the unit triangle; the mesh is its middle; all eight claims hold.
pub(crate) fn one_prism() -> Case {
    let layer = |z: f64| vec![[0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]];
    Case {
        layers: [layer(-1.0), layer(0.0), layer(1.0)],
        prisms: vec![[0, 1, 2]],
        points: layer(0.0),
        triangles: vec![[0, 1, 2]],
        order: "order id".into(),
        pinched: "pinched 0".into(),
        claims: ALL.map(|name| (name, true)).to_vec(),
        blocks: vec![
            ("overlay", lines("v 0 m0\nv 1 m1\nv 2 m2\nc 0 1 2\nd mesh 0 0\nd middle 0 0")),
            ("disjoint-mesh", vec![]),
            ("disjoint-bottom", vec![]),
            ("disjoint-top", vec![]),
            ("i2", vec![]),
        ],
    }
}

/// Four prisms over a regular tetrahedron; the mesh is the middle; all claims but `i2` hold (THEORY section 2).
pub(crate) fn tetrahedron() -> Case {
    let layer = |s: f64| [[s, s, s], [s, -s, -s], [-s, s, -s], [-s, -s, s]].to_vec();
    let faces = vec![[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
    let mut case = one_prism();
    case.layers = [layer(3.0), layer(4.0), layer(5.0)];
    case.points = layer(4.0);
    (case.prisms, case.triangles) = (faces.clone(), faces);
    let overlay =
        "v 0 m0\nv 1 m1\nv 2 m2\nv 3 m3\nc 0 1 2\nc 0 3 1\nc 0 2 3\nc 1 3 2\nd mesh 0 0\nd middle 0 0";
    case.set("overlay", overlay);
    case.claims[7].1 = false;
    case.set("i2", "contact 0 1 m0,m1,m3,t3 1 0 0 1 0 0 0 -3*2^6");
    case
}

pub(crate) fn sha(layers: &[&[P]], triangles: &[[u32; 3]]) -> String {
    let mut bytes = Vec::new();
    layers.iter().for_each(|l| l.iter().flatten().for_each(|x| bytes.extend(x.to_le_bytes())));
    triangles.iter().flatten().for_each(|x| bytes.extend(x.to_le_bytes()));
    Sha256::digest(&bytes).iter().map(|b| format!("{b:02x}")).collect()
}

pub(crate) fn off(points: &[P], triangles: &[[u32; 3]]) -> Vec<u8> {
    let mut text = format!("OFF\n{} {} 0\n", points.len(), triangles.len());
    points.iter().for_each(|p| text += &format!("{:?} {:?} {:?}\n", p[0], p[1], p[2]));
    triangles.iter().for_each(|t| text += &format!("3 {} {} {}\n", t[0], t[1], t[2]));
    text.into_bytes()
}

impl Case {
    pub(crate) fn set(&mut self, block: &str, text: &str) {
        let found = self.blocks.iter_mut().find(|b| b.0 == block).expect("the case has this block");
        found.1 = lines(text);
    }

    /// Only these claims and blocks.
    pub(crate) fn only(mut self, claims: &[(&'static str, bool)], blocks: &[(&'static str, &str)]) -> Self {
        self.claims = claims.to_vec();
        self.blocks = blocks.iter().map(|b| (b.0, lines(b.1))).collect();
        self
    }

    pub(crate) fn text(&self) -> String {
        let mut text = String::from("homeo-certificate 1\n");
        for (name, yes) in &self.claims {
            text += &format!("claim {name} {}\n", if *yes { "certified" } else { "refuted" });
        }
        let layers = [&self.layers[0][..], &self.layers[1], &self.layers[2]];
        text += &format!("shell {} {} {}\n", sha(&layers, &self.prisms), layers[0].len(), self.prisms.len());
        if self.claims.iter().any(|c| c.0 != "positivity" && c.0 != "disjoint-prisms") {
            let sha = sha(&[&self.points], &self.triangles);
            text += &format!("mesh {sha} {} {}\n", self.points.len(), self.triangles.len());
        }
        text += &format!("{}\n{}\n", self.order, self.pinched);
        for (name, lines) in &self.blocks {
            text += &format!("begin {name}\n");
            lines.iter().for_each(|l| text += &format!("{l}\n"));
        }
        text += "counts";
        self.blocks.iter().for_each(|b| text += &format!(" {}", b.1.len()));
        text + "\nend\n"
    }

    pub(crate) fn inputs(&self) -> Vec<Vec<u8>> {
        let mut files: Vec<_> = self.layers.iter().map(|l| off(l, &self.prisms)).collect();
        files.push(off(&self.points, &self.triangles));
        files
    }

    pub(crate) fn check(&self) -> Outcome {
        check(self.text().as_bytes(), &self.inputs())
    }

    /// Must be valid.
    pub(crate) fn accept(&self) {
        let got = self.check();
        assert_eq!((got.exit, got.code), (0, ""), "{}\n{}", got.message, self.text());
    }

    /// Must fail with this code, and with the exit code of its kind.
    pub(crate) fn reject(&self, code: &str) {
        let got = self.check();
        assert_eq!((got.exit, got.code), (1, code), "{}\n{}", got.message, self.text());
    }

    /// The case with one block's text replaced must fail.
    pub(crate) fn mutant(&self, block: &str, from: &str, to: &str, code: &str) {
        let mut case = self.clone();
        let old = case.blocks.iter().find(|b| b.0 == block).expect("the case has this block").1.join("\n");
        assert!(old.contains(from), "the block has {from}");
        case.set(block, &old.replacen(from, to, 1));
        case.reject(code);
    }
}
