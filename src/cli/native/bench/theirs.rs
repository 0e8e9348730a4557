//! Measurements of POV-Ray.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use image::Rgb32FImage;

use super::likeness::Shown;
use super::ours::{Ours, keep};
use super::ways::Way;
use super::{Point, point};
use crate::cli::failure::Failure;
use crate::cli::native::compare::try_to_run;
use crate::cli::problem::Problem;
use crate::options::AntialiasMethod;

/// Samples along each side of a pixel of a converged picture: 1024 in all.
const CONVERGED: u32 = 32;

/// POV-Ray's program.
pub(super) struct Theirs {
    program: PathBuf,
}

impl Theirs {
    /// The program, if it runs.
    pub(super) fn find(program: &Path) -> Option<Self> {
        try_to_run(program).is_ok().then(|| Self { program: program.to_owned() })
    }

    /// Renders a picture of a size and gives its colours and the processor seconds of tracing.
    fn render(
        &self,
        scene: &str,
        size: (u32, u32),
        threads: usize,
        words: &[String],
    ) -> Result<(Rgb32FImage, f64), Problem> {
        let failed = |what: String| Problem::new(format!("`{}` {what}", self.program.display()));
        let folder =
            tempfile::tempdir().map_err(|error| failed(format!("has no place to write: {error}")))?;
        let picture = folder.path().join("picture.exr");
        let output = Command::new(&self.program)
            .arg(format!("+I\"{scene}\""))
            .arg(format!("+O\"{}\"", picture.display()))
            .args([format!("+W{}", size.0), format!("+H{}", size.1), format!("+WT{threads}")])
            .args(["+FE", "-D", "-P", "-C", "-J"])
            .args(words)
            .stdin(Stdio::null())
            .output()
            .map_err(|error| failed(format!("cannot be run: {error}")))?;
        let said = String::from_utf8_lossy(&output.stderr);
        let seconds = trace_seconds(&said).ok_or_else(|| failed(format!("rendered nothing of `{scene}`")))?;
        let picture = image::open(&picture).map_err(|error| failed(format!("left no picture: {error}")))?;
        Ok((picture.to_rgb32f(), seconds))
    }

    /// Measures a way.
    ///
    /// # Errors
    /// POV-Ray renders nothing.
    pub(super) fn measure(
        &self,
        ours: &Ours,
        scene: &str,
        way: &Way,
        reference: &Shown,
    ) -> Result<Point, Failure> {
        let words = way.antialias.map_or_else(
            || vec!["-A".to_owned()],
            |antialias| {
                let method = match antialias.method {
                    AntialiasMethod::Neighbours => 1,
                    AntialiasMethod::Adaptive => 2,
                };
                let threshold = format!("Antialias_Threshold={}", antialias.threshold);
                vec!["+A".to_owned(), threshold, format!("+AM{method}"), format!("+R{}", antialias.depth)]
            },
        );
        let size = (ours.options.width, ours.options.height);
        let (picture, seconds) = self.render(scene, size, threads(ours), &words)?;
        Ok(point(&ours.name, way, (seconds, None), &ours.show(&picture), reference))
    }

    /// The converged picture, kept in a folder: the means of a far larger one.
    ///
    /// # Errors
    /// POV-Ray renders nothing, or the folder can't be written.
    pub(super) fn reference(&self, ours: &Ours, scene: &str, folder: &Path) -> Result<Shown, Failure> {
        let path = ours.kept("povray", folder);
        if let Ok(kept) = image::open(&path) {
            return Ok(ours.show(&kept.to_rgb32f()));
        }
        let (width, height) = (ours.options.width, ours.options.height);
        let large = (width * CONVERGED, height * CONVERGED);
        let (picture, _) = self.render(scene, large, threads(ours), &["-A".to_owned()])?;
        let share = 1.0 / (CONVERGED * CONVERGED) as f32;
        let mut flat = vec![0.0; (3 * width * height) as usize];
        for (x, y, pixel) in picture.enumerate_pixels() {
            let at = 3 * ((y / CONVERGED) * width + x / CONVERGED) as usize;
            flat[at..at + 3].iter_mut().zip(pixel.0).for_each(|(sum, component)| *sum += share * component);
        }
        Ok(ours.show(&keep(&path, (width, height), flat)?))
    }
}

fn threads(ours: &Ours) -> usize {
    ours.options.threads.unwrap_or(1)
}

/// The processor seconds in the lines `Trace Time: …` and the one below.
fn trace_seconds(said: &str) -> Option<f64> {
    let (_, rest) = said.split_once("Trace Time:")?;
    let (before, _) = rest.split_once(" CPU-seconds")?;
    before.rsplit(' ').next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn processor_seconds_are_found() {
        let said = "  Parse Time:  0 hours (0.1 seconds)\n    using 1 thread(s) with 0.099 CPU-seconds total\n\
            \x20 Trace Time:       0 hours  0 minutes  0 seconds (0.036 seconds)\n\
            \x20             using 1 thread(s) with 0.015 CPU-seconds total\n";
        assert_eq!(trace_seconds(said), Some(0.015));
        assert_eq!(trace_seconds("nothing"), None);
    }
}
