//! What a run does: the options given, with defaults filled in and limits checked.

use std::path::{Path, PathBuf};

use super::Problem;
use super::animation::{Animation, Frame};
use super::output::{Dither, Encoding, Format, Place};
use super::restrictions::{self, Restrictions};
use super::settings::{Kind, Name, Settings, Value};
use super::shellout::Shellouts;
use crate::math::Gamma;
use crate::options::{Antialias, AntialiasMethod, Clock, LanguageOptions, Region, RenderOptions};
use crate::source::Permissions;

/// Most pixels of a picture: sixteen bytes each fill four gigabytes.
const MOST_PIXELS: u64 = 1 << 28;

/// Most threads that are started, however many are asked for.
const MOST_THREADS: i32 = 512;

/// Smallest edge of a block of pixels.
const SMALLEST_BLOCK: i32 = 4;

/// What a run does.
#[derive(Debug, Clone)]
pub struct Job {
    /// The scene as the user named it.
    pub input: String,
    /// The scene itself where it is no file but comes with the program.
    pub text: Option<&'static str>,
    /// What the interpreter may see; each frame has a clock of its own.
    pub language: LanguageOptions,
    /// How each picture is made.
    pub render: RenderOptions,
    /// How each picture is stored; none where none is.
    pub encoding: Option<Encoding>,
    /// The pictures.
    pub animation: Animation,
    /// Whether a picture that exists is left alone, and one that was begun is finished.
    pub continue_trace: bool,
    /// Programs that run around scene and frames.
    pub shellouts: Shellouts,
    /// Which files the scene may read and write.
    pub permissions: Permissions,
    /// What the user should know about the options.
    pub warnings: Vec<String>,
    /// Whether the output's name is the file's as it is, rather than one that gets an extension.
    pub exact_output: bool,
    output_name: Option<String>,
}

impl Job {
    /// Reads defaults and limits into the options that were given.
    ///
    /// # Errors
    /// There is no scene, no such size, no such part of the picture, or the format cannot do what is asked.
    pub fn new(settings: &Settings, restrictions: Restrictions) -> Result<Self, Problem> {
        let input = settings
            .text(Name::InputFileName)
            .filter(|name| !name.is_empty())
            .ok_or_else(|| Problem::new("no scene to render").help("name one: `povista scene.pov`"))?
            .to_owned();
        let (width, height) = size(settings)?;
        let shellouts = Shellouts::new(settings, restrictions.shellouts);
        let mut warnings = restrictions.warnings;
        warnings.extend(self::warnings(settings));
        if shellouts.are_forbidden() {
            warnings.push(
                "commands are not run: no `povray.conf` allows shell-outs, or one forbids them".to_owned(),
            );
        }
        let encoding = encoding(settings, &mut warnings)?;
        let language = LanguageOptions {
            library_paths: settings.library_paths.clone(),
            include_header: settings.text(Name::IncludeHeader).map(PathBuf::from),
            declares: settings.declares.clone(),
            version: settings.float(Name::Version).map(|version| (version * 100.0).round() as u32),
            input_file_name: Path::new(&input).file_name().unwrap_or_default().to_string_lossy().into_owned(),
            image_width: width,
            image_height: height,
            ..LanguageOptions::default()
        };
        let render = RenderOptions {
            region: region(settings, width, height)?,
            block_size: block_size(settings)?,
            antialias: antialias(settings),
            quality: settings.int(Name::Quality).unwrap_or(9).clamp(0, 9) as u8,
            output_alpha: encoding.as_ref().is_some_and(|encoding| encoding.alpha),
            threads: settings
                .int(Name::WorkThreads)
                .filter(|threads| *threads > 0)
                .map(|threads| threads.min(MOST_THREADS) as usize),
            remove_bounds: settings.bool(Name::RemoveBounds).unwrap_or(true),
            split_unions: settings.bool(Name::SplitUnions).unwrap_or(false),
            high_reproducibility: settings.bool(Name::HighReproducibility).unwrap_or(false),
            ..RenderOptions::new(width, height)
        };
        let mut job = Self {
            language,
            render,
            encoding,
            animation: Animation::new(settings),
            continue_trace: settings.bool(Name::ContinueTrace) == Some(true),
            shellouts,
            permissions: Permissions::default(),
            warnings,
            exact_output: false,
            output_name: settings.text(Name::OutputFileName).map(str::to_owned),
            text: None,
            input,
        };
        // What was found beside a scene says no more than the scene itself where pictures go.
        let found = settings.is_found(Name::OutputFileName);
        job.permissions = restrictions.files.unwrap_or_else(|| job.default_permissions(found));
        Ok(job)
    }

    /// A job whose scene comes with the program, under a name for reports.
    ///
    /// # Errors
    /// Those of [`Job::new`].
    pub fn of_text(
        name: &str,
        text: &'static str,
        settings: &mut Settings,
        restrictions: Restrictions,
    ) -> Result<Self, Problem> {
        settings.set(Name::InputFileName, Value::Text(name.to_owned()));
        Ok(Self { text: Some(text), ..Self::new(settings, restrictions)? })
    }

    /// What scenes may write unless the user has rules: files in the current folder, in the scene's, and in that
    /// of its pictures, unless their name was found beside the scene.
    fn default_permissions(&self, found: bool) -> Permissions {
        let picture = match self.animation.frames().next().and_then(|frame| self.place(&frame)) {
            Some(Place::File(path)) if !found && (!path.exists() || path.is_file()) => Some(path),
            _ => None,
        };
        let files =
            [Some(Path::new("")), Path::new(&self.input).parent(), picture.as_deref().and_then(Path::parent)];
        Permissions { pictures: found, ..restrictions::defaults(files.into_iter().flatten()) }
    }

    /// What the interpreter may see at the moment of the first picture.
    pub fn first_language(&self) -> LanguageOptions {
        let clock = self.animation.frames().next().map(|frame| frame.clock).unwrap_or_default();
        self.language_at(clock)
    }

    /// What the interpreter may see at a moment.
    pub fn language_at(&self, clock: Clock) -> LanguageOptions {
        LanguageOptions { clock, ..self.language.clone() }
    }

    /// Where a frame's picture goes; none where none is stored.
    pub fn place(&self, frame: &Frame) -> Option<Place> {
        let format = self.encoding.as_ref()?.format;
        if let (true, Some(name)) = (self.exact_output, &self.output_name) {
            return Some(Place::exact(name, &frame.digits));
        }
        Some(Place::new(&self.input, self.output_name.as_deref(), format, &frame.digits))
    }
}

/// Width and height in pixels.
fn size(settings: &Settings) -> Result<(u32, u32), Problem> {
    let edge = |name: Name, default: i32| {
        let edge = settings.int(name).unwrap_or(default);
        u32::try_from(edge).ok().filter(|edge| *edge > 0).ok_or_else(|| {
            Problem::new(format!("a picture cannot have a {} of {edge}", name.as_str().to_lowercase()))
        })
    };
    let (width, height) = (edge(Name::Width, 160)?, edge(Name::Height, 120)?);
    if u64::from(width) * u64::from(height) > MOST_PIXELS {
        return Err(Problem::new(format!("a picture of {width} by {height} pixels is too big"))
            .help(format!("povista renders at most {MOST_PIXELS} pixels")));
    }
    Ok((width, height))
}

/// The part of the picture that is rendered.
fn region(settings: &Settings, width: u32, height: u32) -> Result<Region, Problem> {
    let start = |name: Name, size: u32| {
        let first = match settings.float(name) {
            None => 0,
            Some(part) if (0.0..1.0).contains(&part) => (size as f32 * part) as i64,
            Some(number) => number as i64 - 1,
        };
        u32::try_from(first).ok().filter(|first| *first < size).ok_or_else(|| outside(name, size))
    };
    let end = |name: Name, size: u32| {
        let end = match settings.float(name) {
            None => i64::from(size),
            Some(part) if (0.0..=1.0).contains(&part) => (size as f32 * part) as i64,
            Some(number) => number as i64,
        };
        u32::try_from(end).ok().filter(|end| (1..=size).contains(end)).ok_or_else(|| outside(name, size))
    };
    let columns = start(Name::StartColumn, width)?..end(Name::EndColumn, width)?;
    let rows = start(Name::StartRow, height)?..end(Name::EndRow, height)?;
    Ok(Region { columns, rows })
}

/// A first or last row or column that isn't in the picture.
fn outside(name: Name, size: u32) -> Problem {
    Problem::new(format!("`{}` is outside the picture", name.as_str()))
        .help(format!("it counts from 1 to {size}, or is a fraction below 1"))
}

/// The edge of the blocks the picture is cut into.
fn block_size(settings: &Settings) -> Result<u32, Problem> {
    let size = settings.int(Name::RenderBlockSize).unwrap_or(32);
    u32::try_from(size).ok().filter(|_| size >= SMALLEST_BLOCK).ok_or_else(|| {
        Problem::new(format!("a block of pixels needs an edge of at least {SMALLEST_BLOCK}, not {size}"))
    })
}

/// Antialiasing, if it is on.
fn antialias(settings: &Settings) -> Option<Antialias> {
    let method = match settings.int(Name::SamplingMethod).unwrap_or(1) {
        ..=0 => return None,
        1 => AntialiasMethod::Neighbours,
        2.. => AntialiasMethod::Adaptive,
    };
    let defaults = Antialias::default();
    let jitter = settings.float(Name::JitterAmount).unwrap_or(defaults.jitter).clamp(0.0, 1.0);
    settings.bool(Name::Antialias).filter(|on| *on).map(|_| Antialias {
        method,
        threshold: settings.float(Name::AntialiasThreshold).unwrap_or(defaults.threshold).clamp(0.0, 1.0),
        depth: settings.int(Name::AntialiasDepth).map_or(defaults.depth, |depth| depth.clamp(1, 9) as u32),
        jitter: if settings.bool(Name::Jitter) == Some(false) { 0.0 } else { jitter },
        gamma: settings.float(Name::AntialiasGamma).unwrap_or(defaults.gamma),
    })
}

/// How a picture is stored, if it is.
fn encoding(settings: &Settings, warnings: &mut Vec<String>) -> Result<Option<Encoding>, Problem> {
    if settings.bool(Name::OutputToFile) == Some(false)
        || settings.bool(Name::RealTimeRaytracing) == Some(true)
    {
        return Ok(None);
    }
    let format = settings.text(Name::OutputFileType).and_then(Format::of_letter).unwrap_or(Format::Png);
    let grey = settings.bool(Name::GrayscaleOutput) == Some(true);
    if grey && !format.has_grey() {
        let message = format!("{} files cannot be greyscale", format.name());
        return Err(Problem::new(message).help("PNG and PPM files can"));
    }
    if matches!(settings.text(Name::OutputFileName), Some("-" | "stdout" | "stderr")) && !format.streams() {
        let message = format!("{} cannot be written to a stream", format.name());
        return Err(Problem::new(message).help("PNG, PPM, TGA, BMP and HDR can"));
    }
    let asked = settings.bool(Name::OutputAlpha) == Some(true);
    if asked && !format.has_alpha() {
        warnings.push(format!("{} files hold no alpha; it is left out", format.name()));
    }
    let dither =
        settings.bool(Name::Dither).filter(|on| *on && !matches!(format, Format::Jpeg | Format::Exr));
    Ok(Some(Encoding {
        format,
        bits: settings.int(Name::BitsPerColor).unwrap_or(8).clamp(5, 16) as u8,
        grey,
        alpha: asked && format.has_alpha(),
        dither: dither.map(|_| {
            settings.text(Name::DitherMethod).and_then(Dither::of_name).unwrap_or(Dither::FloydSteinberg)
        }),
        quality: match settings.int(Name::Compression).unwrap_or(0) {
            ..=1 => 85,
            quality => quality.min(100) as u8,
        },
        file_gamma: settings.gamma(Name::FileGamma).unwrap_or(Gamma::Srgb),
        display_gamma: settings.gamma(Name::DisplayGamma).unwrap_or(Gamma::Srgb),
    }))
}

/// Options that do not do what they say.
fn warnings(settings: &Settings) -> Vec<String> {
    let on = |name: Name| settings.bool(name) == Some(true);
    let mut warnings = Vec::new();
    for name in Name::of_kind(Kind::Obsolete).filter(|name| settings.text(*name).is_some()) {
        warnings.push(format!("`{}` is no longer used", name.as_str()));
    }
    if on(Name::RealTimeRaytracing) {
        warnings
            .push("real-time raytracing is not done; the picture is rendered once and not stored".to_owned());
    }
    for name in [Name::ClocklessAnimation, Name::FieldRender, Name::OddField] {
        if on(name) {
            warnings.push(format!("`{}` has no effect", name.as_str()));
        }
    }
    if on(Name::RadiosityFromFile) || on(Name::RadiosityToFile) {
        warnings.push("radiosity samples are neither loaded nor saved".to_owned());
    }
    warnings
}

#[cfg(test)]
mod tests;
