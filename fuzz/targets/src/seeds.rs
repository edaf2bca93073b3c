//! Where the targets start: files of every format, the corpora of `certs/`, bytes without meaning.

use std::fs;
use std::path::Path;

use homeo::mesh::{self, Format};
use homeo::shell::{hdf5, three};

use crate::corpus::{MESHES, SHELLS};

/// A small generator: the same bytes on every machine.
pub struct Random(pub u64);

impl Random {
    /// Below `bound`; 0 where that is 0.
    pub fn next(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap_or(0) % bound.max(1)
    }
}

fn patch(file: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../certs/corpus/patch").join(file);
    fs::read(path).expect("the corpus has this control")
}

fn part(file: &str) -> mesh::TriMesh {
    mesh::parse(&patch(file), Format::Off, file).expect("a mesh of the corpus").mesh
}

fn meshes() -> Vec<Vec<u8>> {
    let mesh = part("mesh.off");
    let encoded =
        Format::ALL.iter().map(|format| mesh::encode(&mesh, *format, "seed").expect("a sound mesh"));
    encoded.chain([patch("mesh.off")]).collect()
}

fn shells() -> Vec<Vec<u8>> {
    let shell = three::from_meshes(part("bottom.off"), part("middle.off"), part("top.off")).expect("a shell");
    let mesh = Some(part("mesh.off"));
    let file =
        hdf5::ShellFile { shell, mesh, tracks: None, meta_edges: None, metadata: None, notes: Vec::new() };
    vec![hdf5::to_bytes(&file).expect("a sound shell")]
}

fn cells() -> Vec<Vec<u8>> {
    let texts = [
        "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 double\n0 0 0 1 0 0 0 1 0 0 0 1 1 1 1\n\
         CELLS 2 10\n4 0 1 2 3\n4 1 2 3 4\nCELL_TYPES 2\n10 10\n",
        "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nTetrahedra 1\n1 2 3 4 0\nEnd\n",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n1\n\
         1 4 2 1 1 1 2 3 4\n$EndElements\n",
        "OVM ASCII\nVertices\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\nEdges\n6\n0 1\n1 2\n2 0\n0 3\n1 3\n2 3\nFaces\n4\n3 0 2 4\n\
         3 6 9 1\n3 8 11 3\n3 10 7 5\nPolyhedra\n1\n4 0 2 4 6\n",
        "<?xml version=\"1.0\"?><GIFTI><DataArray Intent=\"NIFTI_INTENT_POINTSET\" DataType=\"NIFTI_TYPE_FLOAT32\" \
         Dimensionality=\"2\" Dim0=\"3\" Dim1=\"3\" Encoding=\"ASCII\"><Data>0 0 0 1 0 0 0 1 0</Data></DataArray><DataArray \
         Intent=\"NIFTI_INTENT_TRIANGLE\" DataType=\"NIFTI_TYPE_INT32\" Dimensionality=\"2\" Dim0=\"1\" Dim1=\"3\" \
         Encoding=\"ASCII\"><Data>0 1 2</Data></DataArray></GIFTI>",
    ];
    texts.iter().map(|t| t.as_bytes().to_vec()).collect()
}

fn checkers() -> Vec<Vec<u8>> {
    let corpora = [(0, &*SHELLS), (1, &*MESHES)];
    let marked = |(i, corpus): (u8, &crate::Corpus)| {
        corpus.seeds().into_iter().map(move |seed| [&[i][..], &seed].concat()).collect::<Vec<_>>()
    };
    corpora.into_iter().flat_map(marked).collect()
}

/// Bytes without any meaning yet, for targets that make values of them.
fn noise(count: usize, length: usize) -> Vec<Vec<u8>> {
    let mut random = Random(1);
    (0..count).map(|_| (0..length).map(|_| random.next(256).to_le_bytes()[0]).collect()).collect()
}

/// The seeds of a target; none for a name that is none.
///
/// # Panics
/// If the corpora of `certs/` are not there.
#[must_use]
pub fn seeds(target: &str) -> Vec<Vec<u8>> {
    match target {
        "mesh" => meshes(),
        "complex" => cells(),
        "shell" => shells(),
        "certificate" => SHELLS.seeds(),
        "document" => MESHES.seeds(),
        "checkers" => checkers(),
        "signs" => noise(200, 80),
        "verdict" | "projection" => noise(100, 45),
        _ => Vec::new(),
    }
}
