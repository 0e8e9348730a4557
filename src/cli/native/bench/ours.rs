//! povista's own measurements.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Duration;

use super::likeness::Shown;
use super::ways::Way;
use super::{Point, point};
use crate::cli::failure::Failure;
use crate::cli::native::args::Bench;
use crate::cli::native::{settings, teller::Teller};
use crate::cli::problem::Problem;
use crate::cli::{read, state};
use crate::compile;
use crate::options::{Filter, RenderOptions, Sampling};
use crate::render::{self, Rendered};
use crate::world::World;

/// Samples for each pixel of a converged picture.
const CONVERGED: u32 = 1024;

/// What takes less than this many seconds is measured more than once.
const SHORT: f64 = 0.5;

/// A scene that is rendered again and again.
pub(super) struct Ours {
    pub name: String,
    pub options: RenderOptions,
    world: World,
    /// Of the scene and the size of its picture.
    fingerprint: u64,
}

impl Ours {
    /// Reads a scene.
    ///
    /// # Errors
    /// The scene has errors, or uses what can't be rendered.
    pub(super) fn read(
        scene: &str,
        arguments: &Bench,
        err: &mut (dyn Write + Send),
    ) -> Result<Self, Failure> {
        let mut job = settings::job(&arguments.of(scene), &settings::of_scene(&arguments.of(scene))?)?;
        let (width, height) = arguments.size;
        let options = RenderOptions { threads: Some(arguments.threads), ..RenderOptions::new(width, height) };
        job.render = options.clone();
        // The scene's own picture is asked for, so `image_width` is that of the measurement.
        (job.language.image_width, job.language.image_height) = (width, height);
        let (read, _, sources) = read::scene(&job, &job.first_language(), &mut Teller::new(err, true))?;
        let fingerprint = state::fingerprint(&sources, &job.language, &options);
        let compiled = compile::compile(read, &options);
        if let Some(lack) = compiled.unsupported.first() {
            return Err(Problem::new(format!("{scene}: {lack}")).into());
        }
        let name = Path::new(scene).file_stem().unwrap_or_default().to_string_lossy().into_owned();
        Ok(Self { name, options, world: compiled.world, fingerprint })
    }

    /// Renders and takes the processor time.
    fn render(&self, way: &Way) -> (Rendered, f64) {
        let options =
            RenderOptions { antialias: way.antialias, sampling: way.sampling, ..self.options.clone() };
        let start = processor_time();
        let rendered = render::render(&self.world, &options, &());
        (rendered, (processor_time() - start).as_secs_f64())
    }

    /// Measures a way; the least time of three if it is short.
    pub(super) fn measure(&self, way: &Way, reference: &Shown) -> Point {
        let (rendered, mut seconds) = self.render(way);
        let rounds =
            if seconds < SHORT && !matches!(way.sampling, Some(Sampling::Budget { .. })) { 2 } else { 0 };
        for _ in 0..rounds {
            seconds = seconds.min(self.render(way).1);
        }
        let pixels = f64::from(self.options.width) * f64::from(self.options.height);
        let samples = rendered.statistics.samples as f64 / pixels;
        point(&self.name, way, (seconds, Some(samples)), &self.shown(&rendered), reference)
    }

    fn shown(&self, rendered: &Rendered) -> Shown {
        let pixels = rendered.image.pixels.iter().map(|&[r, g, b, _]| [r, g, b]);
        Shown::new((self.options.width, self.options.height), self.world.settings.working_gamma, pixels)
    }

    /// The converged picture under a filter, kept in a folder.
    ///
    /// # Errors
    /// The folder can't be written.
    pub(super) fn reference(&self, filter: Filter, folder: &Path) -> Result<Shown, Failure> {
        let path = self.kept(&format!("povista-{filter:?}"), folder);
        let colors = match image::open(&path) {
            Ok(kept) => kept.to_rgb32f(),
            Err(_) => {
                let way = Way {
                    family: "converged",
                    setting: String::new(),
                    antialias: None,
                    sampling: Some(Sampling::Even { samples: CONVERGED, filter }),
                };
                let pixels = self.render(&way).0.image.pixels;
                let flat = pixels.iter().flat_map(|&[r, g, b, _]| [r, g, b]).collect();
                keep(&path, (self.options.width, self.options.height), flat)?
            }
        };
        Ok(self.show(&colors))
    }

    /// Colours in the scene's working space as they are seen.
    pub(super) fn show(&self, colors: &image::Rgb32FImage) -> Shown {
        let pixels = colors.pixels().map(|pixel| pixel.0);
        Shown::new(colors.dimensions(), self.world.settings.working_gamma, pixels)
    }

    /// Where a converged picture is kept.
    pub(super) fn kept(&self, by: &str, folder: &Path) -> PathBuf {
        let RenderOptions { width, height, .. } = self.options;
        folder.join(format!("{}-{by}-{width}x{height}-{:016x}.exr", self.name, self.fingerprint))
    }
}

/// Stores colours and gives them back.
///
/// # Errors
/// The file can't be written.
pub(super) fn keep(
    path: &Path,
    (width, height): (u32, u32),
    flat: Vec<f32>,
) -> Result<image::Rgb32FImage, Problem> {
    let problem = || Problem::new(format!("cannot write `{}`", path.display()));
    let colors = image::Rgb32FImage::from_raw(width, height, flat).ok_or_else(problem)?;
    colors.save(path).map_err(|error| problem().help(error.to_string()))?;
    Ok(colors)
}

/// Processor time this program has taken so far, of all threads together.
#[cfg(unix)]
fn processor_time() -> Duration {
    use nix::time::{ClockId, clock_gettime};
    clock_gettime(ClockId::CLOCK_PROCESS_CPUTIME_ID).map_or(Duration::ZERO, Duration::from)
}

/// The time by the clock, where no other is known.
#[cfg(not(unix))]
fn processor_time() -> Duration {
    static START: std::sync::LazyLock<std::time::Instant> = std::sync::LazyLock::new(std::time::Instant::now);
    START.elapsed()
}
