//! What POV-Ray says while it works, for programs that listen (docs/spec/camera-image.md 21).

use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use super::streams::{Stream, Streams};
use crate::cli::Problem;
use crate::cli::animation::{Animation, Frame, Series};
use crate::cli::failure::Failure;
use crate::cli::job::Job;
use crate::cli::output::{Dither, Encoding, Format, Place};
use crate::cli::run::{Report, Stopping, Summary};
use crate::diag::{self, Diagnostic, Severity, Sink};
use crate::options::{AntialiasMethod, RenderOptions};
use crate::render::Progress;
use crate::source::Sources;

/// A line between two parts of the statistics.
const RULE: &str = "----------------------------------------------------------------------------\n";

/// Milliseconds between two tellings of how much is rendered.
const BETWEEN: u64 = 20;

/// The console of a run.
pub(super) struct Console<'w> {
    streams: Mutex<Streams<'w>>,
    verbose: bool,
    /// Percent of the picture last shown.
    shown: AtomicU64,
    /// When the console began, and how many milliseconds later that was.
    start: Instant,
    told: AtomicU64,
    frames: (usize, usize),
}

impl<'w> Console<'w> {
    /// Begins a run of so many frames.
    pub(super) fn new(streams: Streams<'w>, verbose: bool, frames: usize) -> Self {
        Self {
            streams: Mutex::new(streams),
            verbose,
            shown: AtomicU64::new(0),
            start: Instant::now(),
            told: AtomicU64::new(0),
            frames: (0, frames),
        }
    }

    fn write(&mut self, stream: Stream, text: &str) {
        self.lock().write(stream, text);
    }

    fn announce(&mut self, text: &str) {
        self.lock().announce(text);
    }

    /// The streams; a thread that panicked while it held them left nothing half done.
    fn lock(&self) -> std::sync::MutexGuard<'_, Streams<'w>> {
        self.streams.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }

    /// Says a thing about the options.
    pub(super) fn warn(&mut self, warning: &str) {
        self.write(Stream::Warning, &format!("Warning: {warning}.\n"));
    }

    /// Says how the run ended.
    pub(super) fn end(&mut self, result: &Result<(), Failure>) {
        match result {
            Ok(()) => self.announce("POV-Ray finished\n\n"),
            Err(Failure::Scene) => {
                self.announce("Fatal error in parser: Cannot parse input.\nRender failed\n\n")
            }
            Err(Failure::Missing(problem)) => {
                self.write(Stream::Fatal, &format!("Parse Error: {problem}.\n"));
                self.announce("Fatal error in parser: Cannot parse input.\nRender failed\n\n");
            }
            Err(Failure::Problem(problem)) => {
                self.announce(&format!("Fatal error in renderer: {problem}.\nRender failed\n\n"));
            }
            Err(Failure::Halted) => self.announce("Render failed\n\n"),
            Err(Failure::Abandoned) => self.announce("Render aborted by user\n\n"),
        }
    }
}

impl Sink for Console<'_> {
    fn diagnostic(&mut self, diagnostic: Diagnostic, sources: &Sources) {
        let stream = if diagnostic.severity == Severity::Error { Stream::Fatal } else { Stream::Warning };
        self.write(stream, &(diag::line(&diagnostic, sources) + "\n"));
    }

    fn text(&mut self, _: diag::Stream, text: &str) {
        self.write(Stream::Debug, text);
    }
}

impl Progress for Console<'_> {
    fn advance(&self, done: u64, total: u64) {
        if !self.verbose {
            return;
        }
        let percent = done * 100 / total.max(1);
        let now = self.start.elapsed().as_millis() as u64;
        let soon = now < self.told.load(Ordering::Relaxed) + BETWEEN && done < total;
        if !soon && self.shown.load(Ordering::Relaxed) < percent {
            self.told.store(now, Ordering::Relaxed);
            // Another thread may have told more before this one had the stream.
            let mut streams = self.lock();
            if self.shown.fetch_max(percent, Ordering::Relaxed) < percent {
                streams.progress(&format!("Rendered {done} of {total} pixels ({percent}%)"));
            }
        }
    }
}

impl Report for Console<'_> {
    fn begin(&mut self, job: &Job, frame: &Frame, place: Option<&Place>) {
        self.frames.0 += 1;
        let (number, frames) = self.frames;
        if number > 1 {
            self.announce(&format!("\nRendering frame {number} of {frames}\n\n"));
        }
        let options = self.lock().describe();
        self.write(Stream::Render, &(parser_options(job, frame) + &image_options(job, place) + &options));
    }

    fn parsing(&mut self) {
        self.announce("==== [Parsing...] ==========================================================\n");
    }

    fn rendering(&mut self, job: &Job, parse: Duration, compile: Duration) {
        let times = format!(
            "{RULE}Parser Time\n  Parse Time:     {}\n  Bounding Time:  {}\n{RULE}",
            hours(parse),
            hours(compile)
        );
        self.write(Stream::Statistic, &times);
        self.write(Stream::Render, &render_options(&job.render));
        self.announce("==== [Rendering...] ========================================================\n");
        self.shown.store(0, Ordering::Relaxed);
    }

    fn progress(&self) -> &dyn Progress {
        self
    }

    fn skipped(&mut self, _: &Place) {
        self.announce("File already rendered and continue requested; skipping.\n");
    }

    fn say(&mut self, text: &str) {
        self.announce(&format!("{text}\n"));
    }

    fn stopping(&self) -> Stopping {
        Box::new(|err, _| {
            let text = "\nFatal error in renderer: Frontend halted render.\nRender cancelled by user\n\n";
            let _ = err.write_all(text.as_bytes());
        })
    }

    fn finished(&mut self, summary: &Summary) {
        if self.verbose {
            self.announce("\n");
        }
        let mut text = format!(
            "{RULE}Render Statistics\nImage Resolution {} x {}\n{RULE}",
            summary.width, summary.height
        );
        for (name, count) in summary.statistics.rows() {
            text.push_str(&format!("{name:<36}{count:>16}\n"));
        }
        text.push_str(&format!("{RULE}Render Time:\n  Trace Time:     {}\n", hours(summary.render.time)));
        self.write(Stream::Statistic, &text);
    }
}

/// What is read.
fn parser_options(job: &Job, frame: &Frame) -> String {
    let RenderOptions { remove_bounds, split_unions, .. } = job.render;
    let mut text = format!(
        "Parser Options\n  Input file: {}\n  Remove bounds........{}\n  Split unions.........{}\n  Library paths:\n",
        job.input,
        switch(remove_bounds),
        switch(split_unions).trim_end(),
    );
    for path in &job.language.library_paths {
        text.push_str(&format!("    {}\n", path.display()));
    }
    match &job.animation {
        Animation::Still(_) => {
            text.push_str(&format!("  Clock value: {:8.3}  (Animation off)\n", frame.clock.value));
        }
        Animation::Series(Series { first, last, step, initial_clock, final_clock, .. }) => {
            text.push_str(&format!(
                "Animation Options\n  Initial Frame: {first:8}  Final Frame: {last:8}\n  Frame Step:    {step:8}\n  \
                 Initial Clock: {initial_clock:8.3}  Final Clock: {final_clock:8.3}\n"
            ));
        }
    }
    text
}

/// What is written, and where.
fn image_options(job: &Job, place: Option<&Place>) -> String {
    let RenderOptions { width, height, ref region, .. } = job.render;
    let mut text = format!(
        "Image Output Options\n  Image resolution.....{width} by {height} (rows {} to {}, columns {} to {}).\n",
        region.rows.start + 1,
        region.rows.end,
        region.columns.start + 1,
        region.columns.end,
    );
    match (place, &job.encoding) {
        (Some(place), Some(encoding)) => {
            text.push_str(&format!("  Output file..........{}, {}\n", place.name(), depth(encoding)));
            text.push_str(&format!(
                "  Dithering............{}\n",
                encoding.dither.map_or("Off", Dither::name)
            ));
        }
        _ => text.push_str("  Output file: Disabled\n"),
    }
    text.push_str("  Graphic display......Off\n  Mosaic preview.......Off\n");
    text.push_str(&format!("  Continued trace......{}\n", switch(job.continue_trace).trim_end()));
    text
}

/// The format and what a pixel takes.
fn depth(encoding: &Encoding) -> String {
    let alpha = if encoding.alpha { " with alpha" } else { "" };
    let bits = (3 + usize::from(encoding.alpha)) * if encoding.bits > 8 { 16 } else { 8 };
    let name = encoding.format.name();
    match encoding.format {
        _ if encoding.grey => format!("grayscale{alpha} {name}"),
        Format::Jpeg => format!("{bits} bpp, quality {}%{alpha} {name}", encoding.quality),
        _ => format!("{bits} bpp{alpha} {name}"),
    }
}

/// How the picture is made.
fn render_options(options: &RenderOptions) -> String {
    let mut text = format!("Render Options\n  Quality:  {}\n", options.quality);
    match &options.antialias {
        None => text.push_str("  Antialiasing.........Off\n"),
        Some(antialias) => {
            let method = match antialias.method {
                AntialiasMethod::Neighbours => 1,
                AntialiasMethod::Adaptive => 2,
            };
            text.push_str(&format!(
                "  Antialiasing.........On  (Method {method}, Threshold {:.3}, Depth {}, Jitter {:.2}, Gamma {:.2})\n",
                antialias.threshold, antialias.depth, antialias.jitter, antialias.gamma
            ));
        }
    }
    text
}

fn switch(on: bool) -> &'static str {
    if on { "On " } else { "Off" }
}

/// A time as POV-Ray writes it.
fn hours(time: Duration) -> String {
    let seconds = time.as_secs();
    format!(
        "{:3} hours {:2} minutes {:2} seconds ({:.3} seconds)",
        seconds / 3600,
        seconds / 60 % 60,
        seconds % 60,
        time.as_secs_f64()
    )
}

/// The folder in which the streams' files stand.
pub(super) fn folder(place: Option<&Place>) -> &Path {
    match place {
        Some(Place::File(path)) => path.parent().unwrap_or(Path::new("")),
        _ => Path::new(""),
    }
}

/// What is wrong with the options.
pub(super) fn options_problem(words: &[String], problem: &Problem) -> String {
    let help = problem.help.as_ref().map(|help| format!(" ({help})")).unwrap_or_default();
    format!("\nProblem with option setting\npovray {}\n{}{help}\n", words.join(" "), problem.message)
}
