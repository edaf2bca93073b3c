//! Checkpoints: the work between two batches as bytes.
//!
//! A header (magic, version, SHA-256 of mesh, options and payload), then the payload in the postcard format. The payload
//! holds what the rest follows from: stars, boundary and pinched vertices are found again. Whatever the bytes say,
//! resuming does not panic; a payload that breaks a rule of the state is refused.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::batch::Work;
use super::operation::{Key, Operation, Tried};
use super::prism::Pillar;
use super::schedule::{Counts, Pass, Position, REPEATS};
use super::skin::Skin;
use super::state::{GONE, State};
use super::{OptimiseOptions, Optimiser, rules};
use crate::construct::Thickness;
use crate::construct::gate::BuildError;
use crate::construct::scale::Scale;
use crate::mesh::{self, Connectivity, MeshError, TriMesh};
use crate::shell::validate::{self, ShellError};

const MAGIC: &[u8; 16] = b"homeo checkpoint";
/// To be raised with every change of the format, and of the optimisation: a checkpoint leads to the same result as
/// the uninterrupted run only in the program that wrote it.
const VERSION: u32 = 2;
const HASH: usize = 32;
const HEADER: usize = MAGIC.len() + 4 + 3 * HASH;
/// Numbers of changes and operations above this are no result of any run.
const MOST: u64 = 1 << 60;

/// Why a checkpoint is not resumed from.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CheckpointError {
    /// Other bytes.
    #[error("this is no checkpoint; choose another file name")]
    Foreign,
    /// Of another version of the program.
    #[error(
        "the checkpoint has version {found}, this program reads version {VERSION}; remove it to start anew"
    )]
    Version {
        /// Its version.
        found: u32,
    },
    /// The input conditions on the mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// It belongs to another mesh.
    #[error("the checkpoint is of another mesh; give that mesh, or remove the checkpoint to start anew")]
    OtherMesh,
    /// It belongs to other options.
    #[error(
        "the checkpoint is of other options (thickness, energy, angle, polishing, seed or overlaps); give those, or remove it to start anew"
    )]
    OtherOptions,
    /// Not what was written.
    #[error("the checkpoint is damaged: {0}; remove it to start anew")]
    Damaged(&'static str),
    /// Its shell breaks the input conditions.
    #[error("the checkpoint is damaged: {0}; remove it to start anew")]
    Shell(#[from] ShellError),
    /// What prisms track around a mesh that intersects itself is not saved.
    #[error("there are no checkpoints where self-intersections are allowed")]
    Tracked,
    /// The mesh can't be scaled.
    #[error(transparent)]
    Build(#[from] Box<BuildError>),
    /// The work could not be encoded.
    #[error("the checkpoint could not be encoded: {0}")]
    Encode(postcard::Error),
}

/// The payload.
#[derive(Serialize, Deserialize)]
struct Saved {
    faces: Vec<[u32; 3]>,
    pillars: Vec<Pillar>,
    changed: Vec<u64>,
    clock: u64,
    tried: Vec<Vec<(Key, u64)>>,
    counts: Counts,
    position: Position,
}

pub(super) fn save(optimiser: &Optimiser<'_>) -> Result<Vec<u8>, CheckpointError> {
    let Work { state, rules, counts, tried, .. } = &optimiser.work;
    if state.tracked.is_some() {
        return Err(CheckpointError::Tracked);
    }
    let payload = postcard::to_stdvec(&Saved {
        faces: state.faces.clone(),
        pillars: state.pillars.clone(),
        changed: state.changed.clone(),
        clock: state.clock,
        tried: tried.entries(),
        counts: *counts,
        position: optimiser.position.clone(),
    })
    .map_err(CheckpointError::Encode)?;
    let mut out = Vec::with_capacity(HEADER + payload.len());
    out.extend_from_slice(MAGIC);
    out.extend_from_slice(&VERSION.to_le_bytes());
    out.extend_from_slice(&hash_of_mesh(&rules.judge.mesh));
    out.extend_from_slice(&hash_of_options(&optimiser.options.scaled(optimiser.scale)));
    out.extend_from_slice(&Sha256::digest(&payload));
    out.extend_from_slice(&payload);
    Ok(out)
}

/// Of the mesh at the size of the work: what a power of two apart is one mesh here, and is built alike.
fn hash_of_mesh(mesh: &TriMesh) -> [u8; HASH] {
    let mut sha = Sha256::new();
    sha.update((mesh.vertices.len() as u64).to_le_bytes());
    for x in mesh.vertices.iter().flatten() {
        sha.update(x.to_le_bytes());
    }
    for v in mesh.faces.iter().flatten() {
        sha.update(v.to_le_bytes());
    }
    sha.finalize().into()
}

/// Of all options that the result depends on, at the size of the work.
fn hash_of_options(options: &OptimiseOptions) -> [u8; HASH] {
    let OptimiseOptions { thickness, max_energy, max_angle_degrees, polish, time_limit: _, seed, no_overlap } =
        options;
    let mut sha = Sha256::new();
    let (kind, thickness) = match thickness {
        Thickness::Share(share) => (0, share),
        Thickness::Absolute(length) => (1, length),
    };
    sha.update([kind]);
    for x in [thickness, max_energy, max_angle_degrees] {
        sha.update(x.to_le_bytes());
    }
    for n in [*polish as u64, *seed, u64::from(*no_overlap)] {
        sha.update(n.to_le_bytes());
    }
    sha.finalize().into()
}

pub(super) fn resume<'m>(
    mesh: &'m TriMesh,
    options: &OptimiseOptions,
    bytes: &[u8],
) -> Result<Optimiser<'m>, CheckpointError> {
    let scale = Scale::of(mesh);
    let mesh = scale.mesh(mesh).map_err(Box::new)?;
    let payload = payload(&mesh, &options.scaled(scale), bytes)?;
    mesh::check(&mesh)?;
    let (saved, rest): (Saved, &[u8]) = postcard::take_from_bytes(payload)
        .map_err(|_| CheckpointError::Damaged("the payload is malformed"))?;
    if !rest.is_empty() {
        return Err(CheckpointError::Damaged("there are bytes after the end"));
    }
    check(&saved).map_err(CheckpointError::Damaged)?;
    let mut state = state(&saved)?;
    state.skin = options.no_overlap.then(|| Skin::new(&state));
    let rules = rules(mesh, &options.scaled(scale));
    let holds = |f: &[u32; 3]| *f == GONE || rules.judge.holds(&state.prism(*f, None));
    if !state.faces.par_iter().all(holds) {
        return Err(CheckpointError::Damaged("its shell is not valid around the mesh"));
    }
    let tried = Tried::of(saved.tried);
    let work = Work { state, rules, counts: saved.counts, tried, seed: options.seed };
    Ok(Optimiser { work, position: saved.position, options: *options, scale })
}

/// The payload, if the header says that it is that of this mesh and these options, whole.
fn payload<'b>(
    mesh: &TriMesh,
    options: &OptimiseOptions,
    bytes: &'b [u8],
) -> Result<&'b [u8], CheckpointError> {
    let rest = bytes.strip_prefix(MAGIC).ok_or(CheckpointError::Foreign)?;
    let cut = CheckpointError::Damaged("it ends early");
    let Some((version, rest)) = rest.split_first_chunk::<4>() else { return Err(cut) };
    let found = u32::from_le_bytes(*version);
    if found != VERSION {
        return Err(CheckpointError::Version { found });
    }
    let Some((hashes, payload)) = rest.split_first_chunk::<{ 3 * HASH }>() else { return Err(cut) };
    if hashes[..HASH] != hash_of_mesh(mesh) {
        return Err(CheckpointError::OtherMesh);
    }
    if hashes[HASH..2 * HASH] != hash_of_options(options) {
        return Err(CheckpointError::OtherOptions);
    }
    if hashes[2 * HASH..] != *Sha256::digest(payload) {
        return Err(CheckpointError::Damaged("its bytes have changed, or it ends early"));
    }
    Ok(payload)
}

/// The rules about numbers and ids.
fn check(saved: &Saved) -> Result<(), &'static str> {
    let n = saved.pillars.len();
    let is_vertex = |v: &u32| (*v as usize) < n;
    let are_vertices = |key: &Key| key.iter().all(is_vertex);
    if saved.changed.len() != n || saved.clock > MOST || saved.changed.iter().any(|c| *c > saved.clock) {
        return Err("a vertex was changed in the future");
    }
    if !saved.faces.iter().all(|f| *f == GONE || f.iter().all(is_vertex)) {
        return Err("a prism has a vertex that does not exist");
    }
    let mut tried = saved.tried.iter().flatten();
    if saved.tried.len() != Operation::COUNT
        || !tried.all(|(key, at)| are_vertices(key) && *at <= saved.clock)
    {
        return Err("a vertex that does not exist was tried");
    }
    let Position { repeat, pass, before_repeat, before_round, .. } = &saved.position;
    // One vertex is no edge: an operation on edges might take it for one.
    let is_key = |operation: Operation, key: &Key| {
        are_vertices(key) && if operation == Operation::Smooth { key[0] == key[1] } else { key[0] < key[1] }
    };
    let keys_exist = match pass {
        Pass::List { operation, keys, .. } => keys.iter().all(|key| is_key(*operation, key)),
        Pass::Queue { operation, queue } => queue.iter().all(|entry| is_key(*operation, &entry.0.2)),
    };
    let sound = |count: &usize| *count as u64 <= MOST;
    if !keys_exist || *repeat > REPEATS || !sound(before_repeat) || !sound(before_round) {
        return Err("the position does not exist");
    }
    Ok(())
}

/// The state, if its shell meets the input conditions.
fn state(saved: &Saved) -> Result<State, CheckpointError> {
    let n = saved.pillars.len();
    let new = |boundary| {
        let (faces, pillars) = (saved.faces.clone(), saved.pillars.clone());
        State::of(faces, pillars, boundary, saved.changed.clone(), saved.clock)
    };
    let state = new(vec![false; n]);
    validate::validate(&state.shell())?;
    let live: Vec<[u32; 3]> = state.faces.iter().copied().filter(|f| *f != GONE).collect();
    let connectivity = Connectivity::new(n, &live)?;
    let mut boundary = vec![false; n];
    for v in connectivity.boundary().flat_map(|side| connectivity.ends(side)) {
        boundary[v as usize] = true;
    }
    Ok(new(boundary))
}
