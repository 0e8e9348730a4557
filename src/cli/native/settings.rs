//! povista's arguments as POV-Ray's options, so that both command lines mean the same.

use std::path::Path;

use super::args::{self, Aa, Accel, Look, Render, Scene};
use crate::cli::Problem;
use crate::cli::job::Job;
use crate::cli::output::Format;
use crate::cli::povray::Environment;
use crate::cli::restrictions::Restrictions;
use crate::cli::settings::{Name, Settings, Value};
use crate::options::{Accelerator, Filter, Sampling};

/// Reads INI files, then what a scene's text can see.
///
/// # Errors
/// An INI file cannot be read, or a declaration has no name.
pub(super) fn of_scene(scene: &Scene) -> Result<Settings, Problem> {
    let environment = Environment::of_process();
    let mut settings = Settings::default();
    // What is declared first stays.
    for constant in &scene.declare {
        settings.declare(constant)?;
    }
    environment.read(&mut settings)?;
    if let Some(scene) = &scene.scene {
        settings.set(Name::InputFileName, Value::Text(scene.clone()));
    }
    for folder in &scene.library {
        settings.add_library_path(folder);
    }
    environment.add_last_path(&mut settings);
    if let Some(clock) = scene.clock {
        settings.set(Name::Clock, Value::Float(clock));
    }
    Ok(settings)
}

/// What there is to do with a scene.
///
/// # Errors
/// The settings ask for what cannot be.
pub(super) fn job(scene: &Scene, settings: &Settings) -> Result<Job, Problem> {
    let mut restrictions = Restrictions::read(Environment::of_process().home.as_deref());
    restrictions.shellouts |= scene.allow_shell;
    let mut job = Job::new(settings, restrictions)?;
    for folder in &scene.allow_write {
        job.permissions.allow_write(folder);
    }
    if let Some(steps) = scene.max_steps {
        job.language.max_steps = steps;
    }
    if let Some(megabytes) = scene.max_memory {
        job.language.max_memory = megabytes.saturating_mul(1 << 20);
    }
    Ok(job)
}

/// Adds how a picture looks.
pub(super) fn add_look(look: &Look, settings: &mut Settings) {
    let int = |number: u32| Value::Int(i32::try_from(number).unwrap_or(i32::MAX));
    let byte = |number: u8| Value::Int(i32::from(number));
    let mut set = |name: Name, value: Option<Value>| {
        if let Some(value) = value {
            settings.set(name, value);
        }
    };
    set(Name::Width, look.size.map(|size| int(size.0)));
    set(Name::Height, look.size.map(|size| int(size.1)));
    let threshold = look.aa.and_then(Aa::threshold);
    set(Name::Antialias, threshold.map(|_| Value::Bool(true)));
    set(Name::AntialiasThreshold, threshold.map(Value::Float));
    set(Name::SamplingMethod, look.aa_method.map(byte));
    set(Name::AntialiasDepth, look.aa_depth.map(byte));
    set(Name::Quality, look.quality.map(byte));
    set(Name::WorkThreads, look.threads.map(int));
    let ranges =
        [(look.rows, Name::StartRow, Name::EndRow), (look.columns, Name::StartColumn, Name::EndColumn)];
    for (range, start, end) in ranges {
        let (first, last) = range.unwrap_or_default();
        set(start, first.map(|first| Value::Float(first as f32)));
        // A last row of 1 would be read as the whole, as POV-Ray reads it.
        set(end, last.map(|last| Value::Float(if last == 1 { 1.5 } else { last as f32 })));
    }
}

/// Adds how a picture is stored.
///
/// # Errors
/// The output's extension is of no format povista writes.
pub(super) fn add_output(render: &Render, settings: &mut Settings) -> Result<(), Problem> {
    if render.alpha {
        settings.set(Name::OutputAlpha, Value::Bool(true));
    }
    if render.resume {
        settings.set(Name::ContinueTrace, Value::Bool(true));
    }
    if let Some(bits) = render.bits {
        settings.set(Name::BitsPerColor, Value::Int(i32::from(bits)));
    }
    let Some(output) = &render.output else { return Ok(()) };
    settings.set(Name::OutputToFile, Value::Bool(true));
    settings.set(Name::OutputFileName, Value::Text(output.clone()));
    if let Some(extension) = extension(output) {
        let letter = Format::letter_of_extension(extension).ok_or_else(|| {
            Problem::new(format!("povista writes no `.{extension}` files"))
                .help("it writes png, ppm, tga, bmp, jpg, hdr and exr")
        })?;
        settings.read(Name::OutputFileType, letter)?;
    }
    Ok(())
}

/// Whether an output's name says its format, so that nothing is to be added.
pub(super) fn has_extension(output: &str) -> bool {
    extension(output).is_some()
}

/// The extension of an output that isn't a stream.
fn extension(output: &str) -> Option<&str> {
    Path::new(output).extension().and_then(|extension| extension.to_str())
}

/// povista's own way to sample, where one was asked for.
pub(super) fn sampling(aa: Option<Aa>, own: &args::Sampling) -> Option<Sampling> {
    let filter = match own.filter {
        args::Filter::Box => Filter::Box,
        args::Filter::Triangle => Filter::Triangle,
        args::Filter::Gaussian => Filter::Gaussian,
        args::Filter::Mitchell => Filter::Mitchell,
    };
    match (aa, own.samples, own.budget, own.every) {
        (Some(Aa::Adaptive), ..) => Some(Sampling::Adaptive { error: own.error, most: own.most, filter }),
        (Some(Aa::Corners), ..) => Some(Sampling::Corners),
        (Some(Aa::Edges), ..) => Some(Sampling::Edges { error: own.error, most: own.most }),
        (_, Some(samples), ..) => Some(Sampling::Even { samples, filter }),
        (_, _, Some(seconds), _) => Some(Sampling::Budget { seconds, filter }),
        (.., Some(step)) => Some(Sampling::Every(step)),
        _ => None,
    }
}

/// The structure that was asked for.
pub(super) fn accelerator(accel: Accel) -> Accelerator {
    match accel {
        Accel::Auto => Accelerator::Auto,
        Accel::Linear => Accelerator::Linear,
        Accel::Octree => Accelerator::Octree,
        Accel::Bvh => Accelerator::Bvh,
    }
}
