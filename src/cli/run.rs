//! The way from a job to its pictures, whoever tells about it.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::animation::Frame;
use super::exit;
use super::failure::Failure;
use super::job::Job;
use super::output::{self, Opened, Place};
use super::problem::Problem;
use super::read;
use super::resume::{self, Resume};
use super::shellout::{Action, Moment, Values};
use super::state;
use super::stop;
use crate::compile::{self, Compiled, Reason, Unsupported};
use crate::diag::{Diagnostic, Severity, Sink};
use crate::math::{Gamma, pages};
use crate::render::{self, Progress, Statistics};
use crate::source::{Sources, Span};
use crate::world::World;
use crate::world::shape::Remark;

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
    /// Says something about the run.
    fn say(&mut self, text: &str);
    /// Tells that the user has stopped the run.
    fn stopping(&self) -> Stopping;
}

/// Tells that the user has stopped the run, and in which file the finished part of the picture is kept.
pub type Stopping = Box<dyn FnOnce(&mut dyn Write, Option<&Path>) + Send>;

/// What a picture took.
#[derive(Debug, Clone)]
pub struct Summary {
    /// Where the picture is; none where none is stored.
    pub place: Option<Place>,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Reading the scene.
    pub parse: Stage,
    /// Compiling it.
    pub compile: Stage,
    /// Rendering it.
    pub render: Stage,
    /// Encoding and writing the picture.
    pub write: Stage,
    /// What the renderer did.
    pub statistics: Statistics,
}

/// What a part of the work took.
#[derive(Debug, Clone, Copy)]
pub struct Stage {
    /// Time by the clock.
    pub time: Duration,
    /// Bytes of memory the program held at its end.
    pub memory: u64,
}

impl Stage {
    /// Ends what began at `start`.
    fn ended(start: Instant) -> Self {
        Self { time: start.elapsed(), memory: pages::used() }
    }
}

/// Why no more frames are rendered.
enum Halt {
    /// A program that ran beside asked for it: nothing more is done.
    Quit,
    /// Something went wrong.
    Failure(Failure),
}

impl From<Failure> for Halt {
    fn from(failure: Failure) -> Self {
        Self::Failure(failure)
    }
}

/// Renders all pictures of a job and runs the programs around them (docs/spec/camera-image.md 25).
///
/// # Errors
/// The first picture that cannot be made ends the run.
pub fn run(job: &Job, report: &mut dyn Report) -> Result<(), Failure> {
    if let Some(threads) = job.render.threads {
        // Scenes are compiled with as many. Of several jobs in a process the first tells: that never changes a picture.
        let _: Result<(), _> = rayon::ThreadPoolBuilder::new().num_threads(threads).build_global();
    }
    let mut values = None;
    let mut result = match frames(job, report, &mut values) {
        Err(Halt::Quit) => return Ok(()),
        Err(Halt::Failure(failure)) => Err(failure),
        Ok(()) => Ok(()),
    };
    let Some(values) = values else { return result };
    let mut shell = |moment| job.shellouts.run(moment, &values, &mut |text| report.say(text));
    if matches!(result, Err(Failure::Abandoned)) && shell(Moment::UserAbort) == Action::Fail {
        result = Err(Failure::Halted);
    }
    if matches!(result, Ok(()) | Err(Failure::Abandoned)) {
        match shell(Moment::PostScene) {
            Action::Fail => result = Err(Failure::Halted),
            Action::Abort => {
                shell(Moment::UserAbort);
                result = Err(Failure::Abandoned);
            }
            _ => {}
        }
    }
    if !matches!(result, Ok(()) | Err(Failure::Abandoned)) {
        shell(Moment::FatalError);
    }
    result
}

/// Renders the frames; the values are those of the last one that was begun.
fn frames(job: &Job, report: &mut dyn Report, values: &mut Option<Values>) -> Result<(), Halt> {
    for (number, frame) in job.animation.frames().enumerate() {
        let values = values.insert(Values::of(job, &frame));
        let place = job.place(&frame);
        prepare_stop(job, report, values, None);
        if number == 0 {
            match shell(job, Moment::PreScene, values, report) {
                Action::Skip => return Ok(()),
                action => obey(action)?,
            }
        }
        report.begin(job, &frame, place.as_ref());
        match shell(job, Moment::PreFrame, values, report) {
            Action::Skip => continue,
            Action::SkipAll => return Ok(()),
            action => obey(action)?,
        }
        match &place {
            Some(place) if job.continue_trace && place.is_finished() => {
                report.skipped(place);
                continue;
            }
            _ => picture(job, &frame, place, values, report)?,
        }
        match shell(job, Moment::PostFrame, values, report) {
            Action::Skip | Action::SkipAll => return Ok(()),
            action => obey(action)?,
        }
    }
    Ok(())
}

/// Runs the program of a moment, if there is one.
fn shell(job: &Job, moment: Moment, values: &Values, report: &mut dyn Report) -> Action {
    job.shellouts.run(moment, values, &mut |text| report.say(text))
}

/// Ends the run if a program asked for that.
fn obey(action: Action) -> Result<(), Halt> {
    match action {
        Action::Ignore | Action::Skip => Ok(()),
        Action::SkipAll | Action::Quit => Err(Halt::Quit),
        Action::Abort => Err(Failure::Abandoned.into()),
        Action::Fail => Err(Failure::Halted.into()),
    }
}

/// Says what is to be done when the user stops the run from now on.
fn prepare_stop(job: &Job, report: &dyn Report, values: &Values, state: Option<PathBuf>) {
    let (tell, shellouts, values) = (report.stopping(), job.shellouts.clone(), values.clone());
    stop::prepare(Box::new(move |err| {
        tell(err, state.as_deref());
        let mut say = |text: &str| {
            let _ = writeln!(err, "{text}");
        };
        if shellouts.run(Moment::UserAbort, &values, &mut say) != Action::Fail {
            return exit::ABANDONED;
        }
        shellouts.run(Moment::FatalError, &values, &mut say);
        exit::FAILURE
    }));
}

/// Renders one picture.
fn picture(
    job: &Job,
    frame: &Frame,
    place: Option<Place>,
    values: &Values,
    report: &mut dyn Report,
) -> Result<(), Failure> {
    report.parsing();
    let start = Instant::now();
    let language = job.language_at(frame.clock);
    let (scene, known, sources) = read::scene(job, &language, report)?;
    let parse = Stage::ended(start);

    let start = Instant::now();
    let Compiled { mut world, unsupported, spans } = compile::compile_knowing(scene, &job.render, known);
    lacking(unsupported, job.language.skip_unsupported, &sources, report)?;
    // `+MV3.7` means light even to a scene that says it is older (docs/spec/camera-image.md 11).
    if job.language.version.is_some_and(|version| version >= 370) {
        world.settings.working_gamma.get_or_insert(Gamma::LINEAR);
    }
    let compile = Stage::ended(start);

    // Better to know now that the picture can't be stored than after an hour.
    let opened = place.as_ref().map(|place| place.open(&job.permissions)).transpose()?;
    let state = match (&place, &opened) {
        (Some(Place::File(path)), Some(Opened::File(_))) => {
            let fingerprint = state::fingerprint(&sources, &language, &job.render);
            resume::begin(job, state::path_beside(path), fingerprint, &mut |text| report.say(text))
        }
        _ => None,
    };
    prepare_stop(job, report, values, state.as_ref().map(|state| state.path().to_owned()));
    report.rendering(job, parse.time, compile.time);
    let start = Instant::now();
    let watch = Resume::new(report.progress(), state.as_ref());
    let rendered = render::render(&world, &job.render, &watch);
    let render = Stage::ended(start);
    for (span, remark) in remarks(&world, &spans) {
        report.diagnostic(remarked(remark, span), &sources);
    }

    let start = Instant::now();
    if let (Some(opened), Some(encoding), Some(place)) = (opened, &job.encoding, &place) {
        let bytes = output::encode(&rendered.image, world.settings.working_gamma, encoding)?;
        opened.finish(&bytes).map_err(|error| match error.kind() {
            std::io::ErrorKind::BrokenPipe => Failure::Abandoned,
            _ => Problem::io("write", Path::new(&place.name()), &error).into(),
        })?;
    }
    if let Some(state) = state {
        state.finish();
    }
    report.finished(&Summary {
        place,
        width: job.render.width,
        height: job.render.height,
        parse,
        compile,
        render,
        write: Stage::ended(start),
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

/// What rays have found out about shapes, once for each place in the text, the worst of it.
fn remarks(world: &World, spans: &[Span]) -> Vec<(Span, Remark)> {
    let mut told: Vec<(Span, Remark)> = Vec::new();
    for (leaf, remark) in world.geometry.remarks() {
        let span = spans.get(leaf.origin as usize).copied().unwrap_or_default();
        let Remark::TooSteep { found, .. } = remark;
        match told.iter_mut().find(|(place, _)| *place == span) {
            Some((_, Remark::TooSteep { found: most, .. })) if *most >= found => {}
            Some((_, worst)) => *worst = remark,
            None => told.push((span, remark)),
        }
    }
    told
}

/// What to say of it.
fn remarked(remark: Remark, span: Span) -> Diagnostic {
    let Remark::TooSteep { found, said, holes } = remark;
    let message = format!("`max_gradient` is {said:.3}, but a gradient of {found:.3} was found");
    let help = match holes {
        true => format!("the surface may have holes: try `max_gradient {found:.3}`"),
        false => format!(
            "the picture is right nevertheless; POV-Ray's may have holes without `max_gradient {found:.3}`"
        ),
    };
    Diagnostic::new(Severity::Warning, span, message).help(help)
}

#[cfg(test)]
mod tests;
