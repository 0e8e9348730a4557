//! The way from a job to its pictures, whoever tells about it.

use std::path::Path;
use std::time::{Duration, Instant};

use super::animation::Frame;
use super::failure::Failure;
use super::job::Job;
use super::output::{self, Place};
use super::problem::Problem;
use super::read;
use crate::compile::{self, Compiled, Reason, Unsupported};
use crate::diag::{Diagnostic, Severity, Sink};
use crate::math::Gamma;
use crate::render::{self, Progress, Statistics};
use crate::source::Sources;

/// Tells a user how a run is going.
pub trait Report: Sink {
    /// The next picture is begun.
    fn begin(&mut self, job: &Job, frame: &Frame, place: Option<&Place>);
    /// The scene is read next.
    fn parsing(&mut self);
    /// The picture is rendered next; the scene took so long to read and to compile.
    fn rendering(&mut self, job: &Job, parse: Duration, compile: Duration);
    /// Watches the rendering.
    fn progress(&self) -> &dyn Progress;
    /// A picture that exists is left alone.
    fn skipped(&mut self, place: &Place);
    /// A picture is there.
    fn finished(&mut self, summary: &Summary);
}

/// What a picture took.
#[derive(Debug, Clone)]
pub struct Summary {
    /// Where the picture is; none where none is stored.
    pub place: Option<Place>,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Time to read the scene.
    pub parse: Duration,
    /// Time to compile it.
    pub compile: Duration,
    /// Time to render it.
    pub render: Duration,
    /// Time to encode and write the picture.
    pub write: Duration,
    /// What the renderer did.
    pub statistics: Statistics,
}

/// Renders all pictures of a job.
///
/// # Errors
/// The first picture that cannot be made ends the run.
pub fn run(job: &Job, report: &mut dyn Report) -> Result<(), Failure> {
    for frame in job.animation.frames() {
        let place = job.place(&frame);
        report.begin(job, &frame, place.as_ref());
        match &place {
            Some(place) if job.continue_trace && place.is_taken() => report.skipped(place),
            _ => picture(job, &frame, place, report)?,
        }
    }
    Ok(())
}

/// Renders one picture.
fn picture(job: &Job, frame: &Frame, place: Option<Place>, report: &mut dyn Report) -> Result<(), Failure> {
    report.parsing();
    let start = Instant::now();
    let (scene, sources) = read::scene(job, frame.clock, report)?;
    let parse = start.elapsed();

    let start = Instant::now();
    let Compiled { mut world, unsupported, .. } = compile::compile(scene, &job.render);
    lacking(unsupported, job.language.skip_unsupported, &sources, report)?;
    // `+MV3.7` means light even to a scene that says it is older (docs/spec/camera-image.md 11).
    if job.language.version.is_some_and(|version| version >= 370) {
        world.settings.working_gamma.get_or_insert(Gamma::LINEAR);
    }
    let compile = start.elapsed();

    // Better to know now that the picture can't be stored than after an hour.
    let opened = place.as_ref().map(Place::open).transpose()?;
    report.rendering(job, parse, compile);
    let start = Instant::now();
    let rendered = render::render(&world, &job.render, report.progress());
    let render = start.elapsed();

    let start = Instant::now();
    if let (Some(opened), Some(encoding), Some(place)) = (opened, &job.encoding, &place) {
        let bytes = output::encode(&rendered.image, world.settings.working_gamma, encoding)?;
        opened.finish(&bytes).map_err(|error| match error.kind() {
            std::io::ErrorKind::BrokenPipe => Failure::Abandoned,
            _ => Problem::io("write", Path::new(&place.name()), &error).into(),
        })?;
    }
    report.finished(&Summary {
        place,
        width: job.render.width,
        height: job.render.height,
        parse,
        compile,
        render,
        write: start.elapsed(),
        statistics: rendered.statistics,
    });
    Ok(())
}

/// Tells what of a scene cannot be rendered, each feature once.
///
/// # Errors
/// The picture would lack something that may not be left out.
fn lacking(
    unsupported: Vec<Unsupported>,
    skip: bool,
    sources: &Sources,
    report: &mut dyn Report,
) -> Result<(), Failure> {
    let mut told: Vec<(Unsupported, usize)> = Vec::new();
    for lack in unsupported {
        match told.iter_mut().find(|(first, _)| first.feature == lack.feature) {
            Some((_, others)) => *others += 1,
            None => told.push((lack, 0)),
        }
    }
    let mut failed = false;
    for (lack, others) in told {
        let may_skip = lack.reason == Reason::NotYet;
        let severity = if may_skip && skip { Severity::Warning } else { Severity::Error };
        failed |= severity == Severity::Error;
        let mut diagnostic = Diagnostic::new(severity, lack.span, lack.to_string());
        if may_skip && !skip {
            let more = match others {
                0 => String::new(),
                1 => "it is used in one other place; ".to_owned(),
                _ => format!("it is used in {others} other places; "),
            };
            diagnostic = diagnostic.help(format!("{more}`--skip-unsupported` renders the rest"));
        }
        report.diagnostic(diagnostic, sources);
    }
    if failed { Err(Failure::Scene) } else { Ok(()) }
}
