//! `povista bench`: time against error, for every way to sample and for POV-Ray's.
//!
//! Each program is held against its own converged picture, so that what is measured is sampling
//! alone; how far the two converged pictures are apart is told beside.

mod likeness;
mod ours;
mod plot;
mod theirs;
mod ways;

use std::fmt::Write as _;
use std::io::Write;
use std::path::Path;

use super::args::Bench;
use crate::cli::failure::Failure;
use crate::cli::problem::Problem;
use likeness::{Shown, likeness, rmse};
use ours::Ours;
use theirs::Theirs;
use ways::Way;

/// What one way to sample took and reached in one scene.
struct Point {
    scene: String,
    /// Which curve it lies on.
    family: &'static str,
    /// The setting on the curve.
    setting: String,
    /// Processor seconds of the rendering.
    seconds: f64,
    /// Samples for each pixel; unknown of POV-Ray.
    samples: Option<f64>,
    /// Root of the mean squared error as it is seen, in steps of 255.
    rmse: f64,
    /// Likeness of structure and colour, up to 1.
    likeness: f64,
}

/// Measures scenes, tells in a table and writes `time_vs_error.csv` and `time_vs_error.svg`.
///
/// # Errors
/// A scene cannot be rendered, or a file not written.
pub(super) fn bench(
    arguments: &Bench,
    out: &mut dyn Write,
    err: &mut (dyn Write + Send),
) -> Result<(), Failure> {
    let folder = &arguments.output;
    let references = folder.join("references");
    std::fs::create_dir_all(&references)
        .map_err(|error| Problem::io("make the folder", &references, &error))?;
    let theirs = Theirs::find(&arguments.povray);
    if theirs.is_none() {
        writeln!(err, "povista: `{}` cannot be run: its curves are left out", arguments.povray.display())?;
    }
    let mut points = Vec::new();
    for scene in &arguments.scenes {
        let ours = Ours::read(scene, arguments, err)?;
        writeln!(out, "{}", ours.name)?;
        let box_reference = ours.reference(crate::options::Filter::Box, &references)?;
        let begin = points.len();
        let mut add = |point: Point| -> Result<(), Failure> {
            writeln!(out, "  {}", row(&point))?;
            points.push(point);
            Ok(())
        };
        let mut centres = None;
        for way in ways::ours() {
            let way = way.within(centres.unwrap_or(0.1));
            let reference = match way.filter() {
                Some(filter) => &ours.reference(filter, &references)?,
                None => &box_reference,
            };
            let point = ours.measure(&way, reference);
            centres.get_or_insert(point.seconds);
            add(point)?;
        }
        if let Some(theirs) = &theirs {
            let reference = theirs.reference(&ours, scene, &references)?;
            for way in ways::theirs() {
                add(theirs.measure(&ours, scene, &way, &reference)?)?;
            }
            let apart = rmse(&box_reference, &reference);
            writeln!(out, "  converged pictures of both programs: RMSE {apart:.3}")?;
        }
        tell_best(&points[begin..], out)?;
    }
    store(&folder.join("time_vs_error.csv"), csv(&points).as_bytes())?;
    store(&folder.join("time_vs_error.svg"), plot::svg(&points)?.as_bytes())?;
    writeln!(out, "see {}", folder.join("time_vs_error.svg").display())?;
    Ok(())
}

/// How much sooner one of povista's ways reaches the error of POV-Ray's best antialiasing.
fn tell_best(points: &[Point], out: &mut dyn Write) -> std::io::Result<()> {
    let theirs = points.iter().filter(|point| point.family.starts_with("POV-Ray"));
    let Some(best) = theirs.min_by(|a, b| a.rmse.total_cmp(&b.rmse)) else { return Ok(()) };
    let as_good = points
        .iter()
        .filter(|point| !point.family.starts_with("POV-Ray") && point.rmse <= best.rmse)
        .min_by(|a, b| a.seconds.total_cmp(&b.seconds));
    match as_good {
        Some(point) => writeln!(
            out,
            "  POV-Ray's least error, {:.3}, took it {:.3} s; povista ({} {}) {:.3} s: {:.1} times as fast",
            best.rmse,
            best.seconds,
            point.family,
            point.setting,
            point.seconds,
            best.seconds / point.seconds
        ),
        None => writeln!(out, "  POV-Ray's least error, {:.3}, was not reached", best.rmse),
    }
}

fn row(point: &Point) -> String {
    let samples = point.samples.map_or_else(|| "-".to_owned(), |samples| format!("{samples:.1}"));
    format!(
        "{:<18} {:<14} {:>9.4} s {:>8} samples {:>9.3} RMSE {:>8.5} likeness",
        point.family, point.setting, point.seconds, samples, point.rmse, point.likeness
    )
}

fn csv(points: &[Point]) -> String {
    let mut text = "scene,way,setting,cpu_seconds,samples_per_pixel,rmse_255,likeness\n".to_owned();
    for point in points {
        let samples = point.samples.map_or_else(String::new, |samples| format!("{samples:.2}"));
        let Point { scene, family, setting, seconds, rmse, likeness, .. } = point;
        let _ = writeln!(text, "{scene},{family},{setting},{seconds:.4},{samples},{rmse:.4},{likeness:.6}");
    }
    text
}

fn store(path: &Path, bytes: &[u8]) -> Result<(), Problem> {
    std::fs::write(path, bytes).map_err(|error| Problem::io("write", path, &error))
}

/// A measured picture beside the converged one.
fn point(scene: &str, way: &Way, took: (f64, Option<f64>), shown: &Shown, reference: &Shown) -> Point {
    Point {
        scene: scene.to_owned(),
        family: way.family,
        setting: way.setting.clone(),
        seconds: took.0,
        samples: took.1,
        rmse: rmse(shown, reference),
        likeness: likeness(shown, reference),
    }
}
