//! Rounded points with error bounds, and the signs of linear forms that can be told from them.

use dashu_base::BitTest;
use dashu_int::IBig;

use super::exact::Big3;
use crate::predicate::Sign;

/// Three numbers and how far each may be from the exact one. A number whose bound is zero is exact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    pub(super) values: [f64; 3],
    pub(super) errors: [f64; 3],
}

impl Near {
    /// Weights that are not negative, divided by their sum.
    ///
    /// With `u = 2^-53`: two additions and a division of positive numbers lose less than `4 u`, and
    /// `1e-15 > 9 u`. What underflows is below `1e-290`.
    pub(super) fn normalised(weights: [f64; 3]) -> Self {
        let sum: f64 = weights.iter().sum();
        let values = weights.map(|w| w / sum);
        let error = |i: usize| if weights[i] == 0.0 { 0.0 } else { 1e-15 * values[i] + 1e-290 };
        Self { values, errors: [0, 1, 2].map(error) }
    }

    /// Homogeneous weights that are not negative, divided by their sum. The conversion loses another `u`;
    /// integers beyond the range of doubles are cut to their leading bits, and what vanishes by that is
    /// below `2^-900` of the sum.
    pub(super) fn of_integers(weights: &Big3) -> Self {
        let longest = weights.iter().map(BitTest::bit_len).max().unwrap_or(0);
        let cut = longest.saturating_sub(1000);
        let round = |w: &IBig| if cut == 0 { w.to_f64().value() } else { (w >> cut).to_f64().value() };
        let mut out = Self::normalised(weights.each_ref().map(round));
        for (error, w) in out.errors.iter_mut().zip(weights) {
            // A number cut to nothing is not known to be zero.
            *error = if *w == IBig::ZERO { 0.0 } else { error.max(1e-250) };
        }
        out
    }

    /// The value of a form and the bound for its error; the coefficients are off by at most
    /// `4 u` times their size or `2^-1022`, and the values are below `1e10`.
    ///
    /// # The bound
    ///
    /// Let `r, x` be exact, `R, X` rounded, `S = sum |R_i X_i|`. Products and two additions lose
    /// at most `3.001 u S`; `sum |R X - r x| <= sum |R| dX + sum |R - r| |x|`, with
    /// `|R - r| <= 4.001 u |R|` and `|x| <= |X| + dX`. Together at most
    /// `7.1 u S + (1 + 5 u) sum |R| dX`, and `2e-15 > 18 u` leaves room for the rounding of the bound
    /// itself. Underflows are at most `9 * 2^-1022 * 1e10 < 1e-290`.
    pub(super) fn form(&self, row: &[f64; 3]) -> (f64, f64) {
        let [x, y, z] = [row[0] * self.values[0], row[1] * self.values[1], row[2] * self.values[2]];
        let spread =
            row[0].abs() * self.errors[0] + row[1].abs() * self.errors[1] + row[2].abs() * self.errors[2];
        (x + y + z, 2e-15 * (x.abs() + y.abs() + z.abs()) + 1.001 * spread + 1e-290)
    }

    /// Is the form zero because in every product one factor is?
    fn vanishes(&self, row: &[f64; 3]) -> bool {
        // Stored zeros are exact zeros.
        (0..3).all(|i| row[i] == 0.0 || (self.values[i] == 0.0 && self.errors[i] == 0.0))
    }

    /// The sign of a form, if the rounded numbers tell. Infinities and NaN tell nothing.
    #[inline]
    pub(super) fn sign(&self, row: &[f64; 3]) -> Option<Sign> {
        let (value, error) = self.form(row);
        if value > error {
            Some(Sign::Positive)
        } else if value < -error {
            Some(Sign::Negative)
        } else if self.vanishes(row) {
            Some(Sign::Zero)
        } else {
            None
        }
    }

    /// The values of three forms: weights again.
    pub(super) fn map(&self, rows: &[[f64; 3]; 3]) -> Self {
        let mut out = Self { values: [0.0; 3], errors: [0.0; 3] };
        for (i, row) in rows.iter().enumerate() {
            if !self.vanishes(row) {
                (out.values[i], out.errors[i]) = self.form(row);
            }
        }
        out
    }

    /// The weights of the middle point: tet coordinates (rows `lambda`), those on one pillar added up.
    ///
    /// One addition loses at most `u` times its result; exact zeros stay exact.
    pub(super) fn middle(&self, lambda: &[[f64; 3]; 4], on: [usize; 4]) -> Self {
        let mut out = Self { values: [0.0; 3], errors: [0.0; 3] };
        for (row, j) in lambda.iter().zip(on) {
            if !self.vanishes(row) {
                let (value, error) = self.form(row);
                out.values[j] += value;
                out.errors[j] += error + 2e-16 * out.values[j].abs();
            }
        }
        out
    }

    /// The largest error bound.
    pub(super) fn error(&self) -> f64 {
        self.errors.iter().fold(0.0, |a, &b| if b > a || b.is_nan() { b } else { a })
    }
}
