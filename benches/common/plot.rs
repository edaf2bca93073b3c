//! Plots with two logarithmic axes as SVG, and the power law through their points.

use std::error::Error;
use std::path::Path;

use plotters::prelude::*;

/// Points of one kind: sizes and what was measured, both positive.
#[derive(Clone, Debug)]
pub struct Series {
    /// The label.
    pub name: String,
    /// Sizes and values.
    pub points: Vec<[f64; 2]>,
    /// The factor and the exponent of a line through them, if it is to be drawn.
    pub fit: Option<PowerLaw>,
}

/// `value = factor * size^exponent`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerLaw {
    /// The exponent.
    pub exponent: f64,
    /// The factor.
    pub factor: f64,
}

impl PowerLaw {
    /// Least squares in logarithms; `None` for fewer than two different sizes.
    #[must_use]
    pub fn fit(points: &[[f64; 2]]) -> Option<Self> {
        let logs: Vec<[f64; 2]> =
            points.iter().filter(|p| p[0] > 0.0 && p[1] > 0.0).map(|p| p.map(f64::ln)).collect();
        let mean = |i: usize| logs.iter().map(|p| p[i]).sum::<f64>() / logs.len() as f64;
        let [x, y] = [mean(0), mean(1)];
        let spread: f64 = logs.iter().map(|p| (p[0] - x).powi(2)).sum();
        let exponent = logs.iter().map(|p| (p[0] - x) * (p[1] - y)).sum::<f64>() / spread;
        exponent.is_finite().then(|| Self { exponent, factor: (y - exponent * x).exp() })
    }
}

/// Draws the series, with a legend.
///
/// # Errors
/// There is nothing to draw, or the file cannot be written.
pub fn log_log(path: &Path, caption: &str, axes: [&str; 2], series: &[Series]) -> Result<(), Box<dyn Error>> {
    let root = SVGBackend::new(path, (800, 500)).into_drawing_area();
    root.fill(&WHITE)?;
    let range = |axis: usize| {
        let all = || series.iter().flat_map(|s| &s.points).map(|p| p[axis]).filter(|x| *x > 0.0);
        all().fold(f64::INFINITY, f64::min) / 1.5..all().fold(0.0, f64::max) * 1.5
    };
    let (xs, ys) = (range(0), range(1));
    if xs.is_empty() || ys.is_empty() {
        return Err("nothing to draw".into());
    }
    let mut chart = ChartBuilder::on(&root)
        .caption(caption, ("sans-serif", 20))
        .margin(12)
        .x_label_area_size(40)
        .y_label_area_size(60)
        .build_cartesian_2d(xs.clone().log_scale(), ys.log_scale())?;
    chart.configure_mesh().x_desc(axes[0]).y_desc(axes[1]).draw()?;
    for (one, colour) in series.iter().zip([BLUE, RED, GREEN, MAGENTA, BLACK].into_iter().cycle()) {
        let dots = one.points.iter().filter(|p| p[0] > 0.0 && p[1] > 0.0);
        let dots = dots.map(|p| Circle::new((p[0], p[1]), 4, colour.filled()));
        chart
            .draw_series(dots)?
            .label(&one.name)
            .legend(move |(x, y)| Circle::new((x + 10, y), 4, colour.filled()));
        if let Some(PowerLaw { exponent, factor }) = one.fit {
            let line = [xs.start, xs.end].map(|x| (x, factor * x.powf(exponent)));
            chart
                .draw_series(LineSeries::new(line, colour))?
                .label(format!("{}: power {exponent:.2}", one.name))
                .legend(move |(x, y)| PathElement::new(vec![(x, y), (x + 20, y)], colour));
        }
    }
    chart
        .configure_series_labels()
        .border_style(BLACK)
        .background_style(WHITE)
        .position(SeriesLabelPosition::UpperLeft)
        .draw()?;
    root.present()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::PowerLaw;

    #[test]
    fn a_power_law_is_found_again() {
        let points = [1.0, 10.0, 1000.0].map(|x: f64| [x, 3.0 * x * x.sqrt()]);
        let found =
            PowerLaw::fit(&points).map(|law| [law.exponent, law.factor].map(|x| (x * 1e9).round() / 1e9));
        assert_eq!(found, Some([1.5, 3.0]));
        assert_eq!(PowerLaw::fit(&points[..1]), None);
    }
}
