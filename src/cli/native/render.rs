//! `povista render`: a bar while it works, a short summary after.

use std::fmt;
use std::io::Write;
use std::time::Duration;

use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

use super::args::Render;
use super::settings;
use super::teller::Teller;
use crate::cli::animation::{Animation, Frame};
use crate::cli::failure::Failure;
use crate::cli::job::Job;
use crate::cli::output::Place;
use crate::cli::run::{self, Report, Stage, Stopping, Summary};
use crate::diag::{Diagnostic, Sink, Stream};
use crate::render::Progress;
use crate::source::Sources;

/// What the bar looks like.
const BAR: &str = "{msg} {wide_bar:.cyan/blue} {percent:>3} %  {elapsed} elapsed{left}";

/// Longest name of a scene beside the bar.
const NAME: usize = 20;

/// Renders a scene.
///
/// # Errors
/// The scene has errors, or the picture cannot be made or stored.
pub(super) fn render(arguments: &Render, err: &mut (dyn Write + Send)) -> Result<(), Failure> {
    let mut settings = settings::of_scene(&arguments.scene)?;
    settings::add_look(&arguments.look, &mut settings);
    settings::add_output(arguments, &mut settings)?;
    let mut job = settings::job(&arguments.scene, &settings)?;
    job.exact_output = arguments.output.as_ref().is_some_and(|output| settings::has_extension(output));
    job.language.skip_unsupported = arguments.skip_unsupported;
    job.render.accelerator = settings::accelerator(arguments.accel);
    job.render.sampling = settings::sampling(arguments.look.aa, &arguments.sampling);
    watch(&job, Teller::new(err, arguments.quiet), arguments.stats, "--continue")
}

/// Runs a job and tells about it.
///
/// # Errors
/// The scene has errors, or a picture cannot be made or stored.
pub(super) fn watch(
    job: &Job,
    mut teller: Teller<'_>,
    counts: bool,
    resume: &'static str,
) -> Result<(), Failure> {
    for warning in &job.warnings {
        teller.warn(warning);
    }
    run::run(job, &mut Watch::new(teller, counts, resume))
}

/// Tells a person how a picture comes along.
pub(super) struct Watch<'w> {
    teller: Teller<'w>,
    /// Whether every count is shown.
    counts: bool,
    /// The word that continues a picture on the command line in use.
    resume: &'static str,
    bar: Bar,
}

/// A progress bar; silent where nobody watches.
struct Bar(ProgressBar);

impl<'w> Watch<'w> {
    /// Watches for a teller.
    pub(super) fn new(teller: Teller<'w>, counts: bool, resume: &'static str) -> Self {
        let bar = ProgressBar::hidden();
        if let Ok(style) = ProgressStyle::with_template(BAR) {
            bar.set_style(style.with_key("left", left));
        }
        Self { teller, counts, resume, bar: Bar(bar) }
    }
}

impl Sink for Watch<'_> {
    fn diagnostic(&mut self, diagnostic: Diagnostic, sources: &Sources) {
        self.teller.diagnostic(diagnostic, sources);
    }

    fn text(&mut self, stream: Stream, text: &str) {
        self.teller.text(stream, text);
    }
}

impl Progress for Bar {
    fn advance(&self, done: u64, total: u64) {
        self.0.set_length(total);
        // Calls may come out of order; the bar never goes back.
        if done > self.0.position() {
            self.0.set_position(done);
        }
    }
}

impl Report for Watch<'_> {
    fn begin(&mut self, job: &Job, frame: &Frame, _: Option<&Place>) {
        if let (Animation::Series(series), false) = (&job.animation, self.teller.quiet) {
            let text = format!(
                "frame {} of {}, clock {}",
                frame.clock.frames.number, series.last, frame.clock.value
            );
            self.teller.line(&text);
        }
    }

    fn parsing(&mut self) {}

    fn rendering(&mut self, job: &Job, _: Duration, _: Duration) {
        let (name, bar) = (&job.language.input_file_name, &self.bar.0);
        // Drawn only once it is complete.
        bar.set_draw_target(ProgressDrawTarget::hidden());
        bar.reset();
        bar.set_length(job.render.region.area());
        bar.set_message(console::truncate_str(name, NAME, "\u{2026}").into_owned());
        bar.set_draw_target(self.teller.bar_target());
        bar.tick();
    }

    fn progress(&self) -> &dyn Progress {
        &self.bar
    }

    fn skipped(&mut self, place: &Place) {
        if !self.teller.quiet {
            self.teller.line(&format!("{} is there already", place.name()));
        }
    }

    fn say(&mut self, text: &str) {
        if !self.teller.quiet {
            self.teller.line(text);
        }
    }

    fn stopping(&self) -> Stopping {
        let (bar, quiet, resume) = (self.bar.0.clone(), self.teller.quiet, self.resume);
        Box::new(move |err, state| {
            bar.finish_and_clear();
            if quiet {
                return;
            }
            let rest = state.map(|state| {
                format!("; what is done is in {}: the same command with `{resume}` goes on", state.display())
            });
            let _ = writeln!(err, "povista: stopped{}", rest.unwrap_or_default());
        })
    }

    fn finished(&mut self, summary: &Summary) {
        self.bar.0.finish_and_clear();
        if self.teller.quiet {
            return;
        }
        let name = summary.place.as_ref().map_or_else(|| "no picture stored".to_owned(), Place::name);
        let mut text =
            format!("{}  {} x {}\n", self.teller.terminal.bold(&name), summary.width, summary.height);
        let stages = [
            ("read", summary.parse),
            ("compile", summary.compile),
            ("render", summary.render),
            ("write", summary.write),
        ];
        let mut each = |tell: &dyn Fn(&Stage) -> String| {
            let parts: Vec<String> =
                stages.iter().map(|(name, stage)| format!("{name} {}", tell(stage))).collect();
            text.push_str(&format!("  {}\n", parts.join(" \u{b7} ")));
        };
        each(&|stage| seconds(stage.time));
        if self.counts {
            each(&|stage| format!("{:.1} MB", stage.memory as f64 / 1e6));
        }
        let rows = summary.statistics.rows();
        if self.counts {
            for (name, count) in rows {
                text.push_str(&format!("  {:>16}  {name}\n", grouped(count)));
            }
        } else {
            let rays: Vec<String> = rows
                .iter()
                .filter(|(name, count)| name.ends_with(" rays") && *count > 0)
                .map(|(name, count)| format!("{} {}", grouped(*count), name.trim_end_matches(" rays")))
                .collect();
            text.push_str(&format!("  rays: {}\n", rays.join(" \u{b7} ")));
        }
        self.teller.line(text.trim_end());
    }
}

/// The time a picture will still take, once there is something to judge by.
fn left(state: &ProgressState, text: &mut dyn fmt::Write) {
    if state.pos() > 0 {
        let _ = write!(text, ", {:#} left", HumanDuration(state.eta()));
    }
}

/// A time in seconds, to a thousandth.
fn seconds(time: Duration) -> String {
    format!("{:.3} s", time.as_secs_f64())
}

/// A count with its digits in groups of three.
fn grouped(count: u64) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_grouped() {
        assert_eq!(grouped(7), "7");
        assert_eq!(grouped(1_234_567), "1 234 567");
        assert_eq!(grouped(480_000), "480 000");
    }
}
