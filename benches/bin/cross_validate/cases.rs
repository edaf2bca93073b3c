//! Cases for predicates: points of several kinds, most of them in or near special position.

use homeo_benches::random::Random;

/// How the points of a case come about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Coordinates of all 53 bits in `[-1, 1)`.
    Uniform,
    /// Small integers.
    Grid,
    /// Later points are affine combinations of earlier ones, exactly.
    Flat,
    /// As `Flat`, then some coordinates moved by one or two ulps.
    NearFlat,
    /// Points on one circle (2D) or sphere, exactly.
    Round,
    /// As `Round`, then some coordinates moved by one or two ulps.
    NearRound,
    /// Some points coincide, some share coordinates.
    Shared,
    /// Later points are weighted means of earlier ones, rounded: inside of things.
    Hull,
    /// Triangles above each other, as in a prism, exactly or moved a little.
    Layers,
    /// Exponents between -60 and 60.
    Mixed,
    /// `Flat` or `NearFlat`, each axis scaled by a power of two between -900 and 900.
    Stretched,
    /// Exponents over the whole range.
    Spread,
    /// `Flat` among subnormal numbers.
    Tiny,
    /// `Flat` where differences and products overflow.
    Huge,
}

impl Kind {
    /// All of them.
    pub(crate) const ALL: [Self; 14] = [
        Self::Uniform,
        Self::Grid,
        Self::Flat,
        Self::NearFlat,
        Self::Round,
        Self::NearRound,
        Self::Shared,
        Self::Hull,
        Self::Layers,
        Self::Mixed,
        Self::Stretched,
        Self::Spread,
        Self::Tiny,
        Self::Huge,
    ];
}

/// `2^exponent` for a normal or subnormal result.
fn power(exponent: i64) -> f64 {
    // In two steps, as 2^-1074 is out of reach of one.
    let half = i32::try_from(exponent / 2).unwrap_or(0);
    let rest = i32::try_from(exponent - i64::from(half)).unwrap_or(0);
    2_f64.powi(half) * 2_f64.powi(rest)
}

/// Makes cases. The same seed makes the same cases.
pub(crate) struct Generator(pub(crate) Random);

impl Generator {
    fn between(&mut self, least: i64, most: i64) -> i64 {
        let span = most.abs_diff(least) + 1;
        least + (self.0.bits() % span).cast_signed()
    }

    /// The coordinates of `points` points of `dimension` coordinates, all finite.
    pub(crate) fn case(&mut self, kind: Kind, points: usize, dimension: usize) -> Vec<f64> {
        loop {
            let case = self.attempt(kind, points, dimension).concat();
            if case.iter().all(|x| x.is_finite()) {
                return case;
            }
        }
    }

    fn attempt(&mut self, kind: Kind, points: usize, dimension: usize) -> Vec<Vec<f64>> {
        match kind {
            Kind::Uniform => self.each(points, dimension, |g| g.0.real()),
            Kind::Grid => self.each(points, dimension, |g| g.between(-4, 4) as f64),
            Kind::Flat => self.flat(points, dimension),
            Kind::NearFlat => {
                let case = self.flat(points, dimension);
                self.nudged(case)
            }
            Kind::Round => self.round(points, dimension),
            Kind::NearRound => {
                let case = self.round(points, dimension);
                self.nudged(case)
            }
            Kind::Shared => self.shared(points, dimension),
            Kind::Hull => self.hull(points, dimension),
            Kind::Layers => self.layers(points, dimension),
            Kind::Mixed => self.each(points, dimension, |g| g.0.real() * power(g.between(-60, 60))),
            Kind::Stretched => self.stretched(points, dimension),
            Kind::Spread => self.each(points, dimension, |g| g.0.real() * power(g.between(-1074, 1024))),
            Kind::Tiny => self.scaled(points, dimension, -1074 + 12),
            Kind::Huge => self.scaled(points, dimension, 995),
        }
    }

    fn each(
        &mut self,
        points: usize,
        dimension: usize,
        coordinate: impl Fn(&mut Self) -> f64,
    ) -> Vec<Vec<f64>> {
        (0..points).map(|_| (0..dimension).map(|_| coordinate(self)).collect()).collect()
    }

    /// Some free points of 12 bits, then combinations with weights in eighths of at most four generations: no rounding.
    fn flat(&mut self, points: usize, dimension: usize) -> Vec<Vec<f64>> {
        let free = 1 + self.0.below(points);
        let mut out = self.each(free, dimension, |g| g.between(-4096, 4096) as f64);
        while out.len() < points {
            let from = out.len().min(free + 3);
            let [a, b, c] = [0; 3].map(|_| self.0.below(from));
            let [s, t] = [0; 2].map(|_| match self.0.below(3) {
                0 => self.between(0, 2) as f64 / 2.0,
                _ => self.between(-8, 16) as f64 / 8.0,
            });
            let point = (0..dimension).map(|i| {
                let x = |k: usize| out.get(k).and_then(|p| p.get(i)).copied().unwrap_or(0.0);
                x(a) + s * (x(b) - x(a)) + t * (x(c) - x(a))
            });
            let point = point.collect();
            out.push(point);
        }
        self.shuffle(&mut out);
        out
    }

    fn shuffle(&mut self, points: &mut [Vec<f64>]) {
        for i in (1..points.len()).rev() {
            let j = self.0.below(i + 1);
            points.swap(i, j);
        }
    }

    /// Every fourth coordinate by one or two ulps.
    fn nudged(&mut self, mut points: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
        for x in points.iter_mut().flatten() {
            let steps = self.0.below(16);
            *x = match steps {
                0 => x.next_up(),
                1 => x.next_down(),
                2 => x.next_up().next_up(),
                3 => x.next_down().next_down(),
                _ => *x,
            };
        }
        points
    }

    /// Permutations and reflections of one point about a centre.
    fn round(&mut self, points: usize, dimension: usize) -> Vec<Vec<f64>> {
        let centre: Vec<i64> = (0..dimension).map(|_| self.between(-512, 512)).collect();
        let radius: Vec<i64> = (0..dimension).map(|_| self.between(0, 300)).collect();
        let shrink = power(self.between(-30, 0));
        let mut point = || {
            let mut offset = radius.clone();
            for i in (1..offset.len()).rev() {
                let j = self.0.below(i + 1);
                offset.swap(i, j);
            }
            let signed = |x: i64, plus: bool| if plus { x } else { -x };
            let sum = offset.iter().zip(&centre).map(|(x, c)| c + signed(*x, self.0.below(2) == 0));
            sum.map(|x| x as f64 * shrink).collect()
        };
        (0..points).map(|_| point()).collect()
    }

    fn shared(&mut self, points: usize, dimension: usize) -> Vec<Vec<f64>> {
        let coarse = self.0.below(2) == 0;
        let mut out =
            self.each(points, dimension, |g| if coarse { g.between(-2, 2) as f64 } else { g.0.real() });
        for i in 1..points {
            let source = self.0.below(i);
            match self.0.below(3) {
                0 => out[i] = out[source].clone(),
                1 => {
                    let axis = self.0.below(dimension);
                    out[i][axis] = out[source][axis];
                }
                _ => {}
            }
        }
        out
    }

    fn hull(&mut self, points: usize, dimension: usize) -> Vec<Vec<f64>> {
        let free = points.saturating_sub(1 + self.0.below(2)).max(1);
        let mut out = self.each(free, dimension, |g| g.0.real());
        while out.len() < points {
            let weights: Vec<f64> = out.iter().map(|_| self.0.below(8) as f64).collect();
            let sum = weights.iter().sum::<f64>().max(1.0);
            let mean = |i: usize| out.iter().zip(&weights).map(|(p, w)| w * p[i]).sum::<f64>() / sum;
            let point = (0..dimension).map(mean).collect();
            out.push(point);
        }
        out
    }

    /// Point `i` is corner `i % 3` of a triangle, moved up by `i / 3` and then by up to `reach`.
    fn layers(&mut self, points: usize, dimension: usize) -> Vec<Vec<f64>> {
        let up: Vec<f64> = (0..dimension).map(|axis| if axis + 1 == dimension { 4.0 } else { 0.0 }).collect();
        let corners = [[0.0, 0.0], [8.0, 0.0], [0.0, 8.0]];
        let reach = [0.0, 1.0, 3.0, 6.0][self.0.below(4)];
        let coarse = self.0.below(2) == 0;
        let point = |i: usize, g: &mut Self| {
            let at = |axis: usize| corners[i % 3].get(axis).copied().unwrap_or(0.0);
            let mut moved =
                |x: f64| x + reach * if coarse { g.between(-4, 4) as f64 / 8.0 } else { g.0.real() };
            (0..dimension).map(|axis| moved(at(axis) + (i / 3) as f64 * up[axis])).collect()
        };
        (0..points).map(|i| point(i, self)).collect()
    }

    fn stretched(&mut self, points: usize, dimension: usize) -> Vec<Vec<f64>> {
        let flat = self.flat(points, dimension);
        let case = if self.0.below(2) == 0 { flat } else { self.nudged(flat) };
        let factors: Vec<f64> = (0..dimension).map(|_| power(self.between(-900, 900))).collect();
        case.into_iter().map(|p| p.iter().zip(&factors).map(|(x, f)| x * f).collect()).collect()
    }

    fn scaled(&mut self, points: usize, dimension: usize, exponent: i64) -> Vec<Vec<f64>> {
        let factor = power(exponent);
        let case = self.flat(points, dimension);
        case.into_iter().map(|p| p.into_iter().map(|x| x * factor).collect()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{Generator, Kind};
    use homeo::predicate::orient3d_exact;
    use homeo_benches::random::Random;

    /// How many of 1000 tets are flat.
    fn flat(kind: Kind) -> usize {
        let mut generator = Generator(Random(7));
        let is_flat = |case: &[f64]| match case.as_chunks().0 {
            [a, b, c, d] => orient3d_exact(a, b, c, d).is_zero(),
            _ => panic!("not four points"),
        };
        (0..1000).filter(|_| is_flat(&generator.case(kind, 4, 3))).count()
    }

    #[test]
    fn special_positions_are_exact_and_are_missed_by_ulps() {
        for kind in [Kind::Flat, Kind::Tiny, Kind::Huge] {
            assert!(flat(kind) > 500, "{kind:?}: {}", flat(kind));
        }
        assert!(flat(Kind::NearFlat) < flat(Kind::Flat) / 2);
        assert_eq!(flat(Kind::Uniform), 0);
    }

    #[test]
    fn round_points_are_equally_far_from_a_centre() {
        let mut generator = Generator(Random(8));
        for _ in 0..100 {
            let case = generator.case(Kind::Round, 4, 2);
            // Four points on a circle: the determinant with rows (x, y, x^2 + y^2), from the last point on, in integers.
            let scale = (0..=40).map(|k| 2_f64.powi(k)).find(|s| case.iter().all(|x| (x * s).fract() == 0.0));
            let x: Vec<i128> = case.iter().map(|x| (x * scale.unwrap()) as i128).collect();
            let row = |i: usize| {
                let (u, v) = (x[2 * i] - x[6], x[2 * i + 1] - x[7]);
                [u, v, u * u + v * v]
            };
            let [p, q, r] = [row(0), row(1), row(2)];
            let minor = |i: usize, j: usize| q[i] * r[j] - q[j] * r[i];
            assert_eq!(p[0] * minor(1, 2) + p[1] * minor(2, 0) + p[2] * minor(0, 1), 0, "{case:?}");
        }
    }
}
