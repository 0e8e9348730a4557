//! The curves as a picture: a chart for each scene, both axes logarithmic.

use plotters::coord::Shift;
use plotters::prelude::*;

use super::Point;
use crate::cli::problem::Problem;

/// Width and height of one chart.
const CHART: (u32, u32) = (620, 430);

/// Charts beside each other.
const COLUMNS: usize = 2;

/// The least error that is drawn.
const LEAST: f64 = 0.01;

/// Draws all points, each curve in a colour of its own and POV-Ray's in black.
///
/// # Errors
/// The chart can't be drawn.
pub(super) fn svg(points: &[Point]) -> Result<String, Problem> {
    let mut scenes: Vec<&str> = points.iter().map(|point| &*point.scene).collect();
    scenes.dedup();
    let mut text = String::new();
    {
        let rows = scenes.len().div_ceil(COLUMNS).max(1);
        let columns = scenes.len().clamp(1, COLUMNS);
        let size = (CHART.0 * columns as u32, CHART.1 * rows as u32);
        let area = SVGBackend::with_string(&mut text, size).into_drawing_area();
        let problem =
            |error: &dyn std::fmt::Display| Problem::new(format!("cannot draw the curves: {error}"));
        area.fill(&WHITE).map_err(|error| problem(&error))?;
        for (scene, part) in scenes.iter().zip(area.split_evenly((rows, columns))) {
            let points: Vec<&Point> = points.iter().filter(|point| point.scene == *scene).collect();
            chart(scene, &points, &part).map_err(|error| problem(&error))?;
        }
        area.present().map_err(|error| problem(&error))?;
    }
    Ok(text)
}

fn chart<B: DrawingBackend>(
    scene: &str,
    points: &[&Point],
    area: &DrawingArea<B, Shift>,
) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
    let range = |values: &mut dyn Iterator<Item = f64>| {
        let (low, high) = values.fold((f64::INFINITY, 0.0_f64), |(low, high), v| (low.min(v), high.max(v)));
        (low / 1.3).max(1e-6)..(high * 1.3).max(1e-5)
    };
    let seconds = range(&mut points.iter().map(|point| point.seconds.max(1e-4)));
    let errors = range(&mut points.iter().map(|point| point.rmse.max(LEAST)));
    let mut chart = ChartBuilder::on(area)
        .caption(scene, ("sans-serif", 20))
        .margin(10)
        .x_label_area_size(36)
        .y_label_area_size(52)
        .build_cartesian_2d(seconds.log_scale(), errors.log_scale())?;
    chart
        .configure_mesh()
        .light_line_style(WHITE.mix(0.0))
        .x_desc("processor seconds")
        .y_desc("RMSE, steps of 255")
        .draw()?;
    let mut families: Vec<&str> = points.iter().map(|point| point.family).collect();
    families.dedup();
    for (number, family) in families.iter().enumerate() {
        let theirs = family.starts_with("POV-Ray");
        let color = if theirs { BLACK.to_rgba() } else { Palette99::pick(number).to_rgba() };
        let mut curve: Vec<(f64, f64)> = points
            .iter()
            .filter(|point| point.family == *family)
            .map(|point| (point.seconds.max(1e-4), point.rmse.max(LEAST)))
            .collect();
        curve.sort_by(|a, b| a.0.total_cmp(&b.0));
        let style = color.stroke_width(if theirs || *family == "adaptive" { 2 } else { 1 });
        chart
            .draw_series(LineSeries::new(curve.iter().copied(), style))?
            .label(*family)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 14, y)], style));
        let hollow = family.ends_with('2');
        chart.draw_series(curve.iter().map(|&at| {
            let style = if hollow { ShapeStyle::from(&color) } else { color.filled() };
            Circle::new(at, 3, style)
        }))?;
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::LowerLeft)
        .background_style(WHITE.mix(0.8))
        .label_font(("sans-serif", 10))
        .draw()
}
