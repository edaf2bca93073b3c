//! Building happens at one size: everything is scaled by a power of two first, which is exact, so that no length, area
//! or volume in floats over- or underflows, and scaled back at the end.

use super::gate::BuildError;
use super::initial::half_box_edge;
use crate::mesh::TriMesh;
use crate::shell::Shell;

/// Multiplication by a power of two.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Scale {
    exponent: i32,
}

impl Scale {
    /// The scale that brings the longest edge of the mesh's bounding box into `[1, 2)`.
    pub(crate) fn of(mesh: &TriMesh) -> Self {
        // An extent can overflow, half an extent cannot.
        let half = half_box_edge(mesh);
        Self { exponent: if half > 0.0 && half.is_finite() { -1 - floor_log2(half) } else { 0 } }
    }

    /// The mesh, scaled.
    pub(crate) fn mesh(self, mesh: &TriMesh) -> Result<TriMesh, BuildError> {
        Ok(TriMesh { vertices: self.points(&mesh.vertices)?, faces: mesh.faces.clone() })
    }

    /// The shell, scaled.
    pub(crate) fn shell(self, shell: &Shell) -> Result<Shell, BuildError> {
        Ok(Shell {
            bottom: self.points(&shell.bottom)?,
            middle: self.points(&shell.middle)?,
            top: self.points(&shell.top)?,
            faces: shell.faces.clone(),
        })
    }

    /// A length, scaled; rounded near the ends of the range.
    pub(crate) fn length(self, length: f64) -> f64 {
        times(length, self.exponent)
    }

    /// The way back.
    pub(crate) fn inverse(self) -> Self {
        Self { exponent: -self.exponent }
    }

    fn points(self, points: &[[f64; 3]]) -> Result<Vec<[f64; 3]>, BuildError> {
        let point = |(v, p): (u32, &[f64; 3])| {
            let scaled = p.map(|x| times(x, self.exponent));
            // Scaled back it is the same exactly when no bit was lost.
            let exact = p.iter().zip(&scaled).all(|(x, y)| same(*x, times(*y, -self.exponent)));
            if exact {
                Ok(scaled)
            } else {
                Err(BuildError::Range { vertex: v, point: *p, exponent: self.exponent })
            }
        };
        (0u32..).zip(points).map(point).collect()
    }
}

/// Equal as numbers.
// An exact statement about stored doubles.
#[allow(clippy::float_cmp)]
fn same(x: f64, y: f64) -> bool {
    x == y
}

/// `x * 2^k` for `|k| <= 2200`, in steps of which each is a double.
fn times(mut x: f64, mut k: i32) -> f64 {
    while k != 0 {
        let step = k.clamp(-1000, 1000);
        x *= 2f64.powi(step);
        k -= step;
    }
    x
}

/// The exponent of the leading bit, subnormals included. Of positive finite numbers.
fn floor_log2(x: f64) -> i32 {
    let exponent = |x: f64| ((x.to_bits() >> 52) & 0x7ff) as i32 - 1023;
    if x < f64::MIN_POSITIVE { exponent(times(x, 100)) - 100 } else { exponent(x) }
}
