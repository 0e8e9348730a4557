//! povista's own command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum, ValueHint};

use crate::diag::Code;

/// Below `--help`.
const EXAMPLES: &str = "\
Examples:
  povista scenes/showcase.pov                 renders scenes/showcase.png
  povista scene.pov -o big.png --size 1920x1080 --aa 0.1
  povista check scene.pov                     says what is wrong with a scene
  povista fmt scene.pov                       indents it, and changes nothing else
  povista compare scene.pov                   renders with POV-Ray too and shows the difference
  povista bench scene.pov                     measures time against error, POV-Ray's too

POV-Ray's own switches, options and INI files work as they do there:
  povista +Iscene.pov +W640 +H480 +A0.3 +Oout.png -D
  povista quick.ini[low] Declare=Size=3 scene.pov
A link named `povray` to this program answers as POV-Ray does.

Without `--size`, pictures are as big as povray.ini says, or 800x600 where there is none.";

/// Renders POV-Ray scenes: the same picture, faster, with errors people enjoy reading.
#[derive(Debug, Parser)]
#[command(name = "povista", version, long_version = super::LONG_VERSION, after_help = EXAMPLES)]
#[command(args_conflicts_with_subcommands = true, arg_required_else_help = true, max_term_width = 100)]
pub(super) struct Arguments {
    #[command(subcommand)]
    pub(super) command: Option<Command>,
    #[command(flatten)]
    pub(super) render: Render,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Render a scene; `povista SCENE` is short for it
    Render(Render),
    /// Read a scene and say what is wrong with it, without rendering
    Check(Check),
    /// Lay out scenes neatly, without changing what they mean
    Fmt(Fmt),
    /// Show what povista understood of a scene
    Dump(Scene),
    /// Tell how far two pictures are apart
    Diff(Diff),
    /// Render a scene with POV-Ray too, and show both pictures, the difference and the times
    Compare(Compare),
    /// Answer an editor over the language server protocol, on standard input and output
    Lsp(Lsp),
    /// Measure time against error for every way to sample a scene, and for POV-Ray's
    Bench(Bench),
    /// Print what a shell needs to complete povista's commands
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
}

/// A scene, and what its text can see.
#[derive(Debug, Default, Args)]
pub(super) struct Scene {
    /// The scene; `-` reads standard input
    #[arg(value_name = "SCENE", value_hint = ValueHint::FilePath)]
    pub(super) scene: Option<String>,
    /// Search a folder for included files, images and fonts
    #[arg(short = 'L', long = "library", value_name = "FOLDER", value_hint = ValueHint::DirPath)]
    pub(super) library: Vec<String>,
    /// Declare a constant for the scene, such as `Size=3` or `Name="text"`
    #[arg(long, value_name = "NAME=VALUE", value_parser = constant)]
    pub(super) declare: Vec<String>,
    /// Stop a scene that runs this many directives and macros without making anything and with no end in sight, or fifty times as many in all [default: 4000000]
    #[arg(long, value_name = "COUNT")]
    pub(super) max_steps: Option<u64>,
    /// Stop a scene that takes more memory than this while it is read [default: 4096]
    #[arg(long, value_name = "MEGABYTES")]
    pub(super) max_memory: Option<u64>,
    /// Let the scene write files in this folder, besides the current one, its own and the picture's
    #[arg(long, value_name = "FOLDER", value_hint = ValueHint::DirPath)]
    pub(super) allow_write: Vec<PathBuf>,
    /// Run the commands INI files name, even where no `povray.conf` allows shell-outs
    #[arg(long)]
    pub(super) allow_shell: bool,
    /// Set the scene's `clock`
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(super) clock: Option<f32>,
}

/// How a picture is made.
#[derive(Debug, Args)]
pub(super) struct Render {
    #[command(flatten)]
    pub(super) scene: Scene,
    /// Write the picture there; the extension says how: png, ppm, tga, bmp, jpg, hdr, exr. `-` is standard output
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(super) output: Option<String>,
    #[command(flatten)]
    pub(super) look: Look,
    #[command(flatten)]
    pub(super) sampling: Sampling,
    /// Store transparency
    #[arg(long)]
    pub(super) alpha: bool,
    /// Bits per channel, 5 to 16, where the format leaves a choice [default: 8]
    #[arg(long, value_name = "BITS", value_parser = clap::value_parser!(u8).range(5..=16))]
    pub(super) bits: Option<u8>,
    /// Go on with a picture that was stopped, and leave alone those that are there
    #[arg(long = "continue")]
    pub(super) resume: bool,
    /// Leave out what povista cannot render yet, with a warning
    #[arg(long)]
    pub(super) skip_unsupported: bool,
    /// How objects near a ray are found; never changes the picture
    #[arg(long, value_name = "STRUCTURE", default_value = "auto")]
    pub(super) accel: Accel,
    /// Show every count the renderer keeps
    #[arg(long)]
    pub(super) stats: bool,
    /// Say nothing but warnings and errors
    #[arg(short, long)]
    pub(super) quiet: bool,
}

/// What a picture looks like.
#[derive(Debug, Args)]
pub(super) struct Look {
    /// Width and height in pixels
    #[arg(long, value_name = "WIDTHxHEIGHT", value_parser = size)]
    pub(super) size: Option<(u32, u32)>,
    /// Antialias: refine pixels that differ by this much from their neighbours, 0 to 1 [default: 0.3];
    /// `edges` finds out where edges cross pixels, `adaptive` samples each pixel until its error is small, `corners`
    /// shares corners with neighbours
    #[arg(long, value_name = "THRESHOLD", num_args = 0..=1, default_missing_value = "0.3", value_parser = aa)]
    pub(super) aa: Option<Aa>,
    /// Antialias by POV-Ray's method 1 (neighbours) or 2 (adaptive) [default: 1]
    #[arg(long, value_name = "METHOD", value_parser = clap::value_parser!(u8).range(1..=2))]
    pub(super) aa_method: Option<u8>,
    /// Fineness of antialiasing, 1 to 9 [default: 3]
    #[arg(long, value_name = "DEPTH", value_parser = clap::value_parser!(u8).range(1..=9))]
    pub(super) aa_depth: Option<u8>,
    /// Shading from 0 (flat colors) to 9 (everything)
    #[arg(long, value_name = "LEVEL", value_parser = clap::value_parser!(u8).range(0..=9))]
    pub(super) quality: Option<u8>,
    /// Render only these rows, counted from 1: `100-200`, `100-` or `-200`
    #[arg(long, value_name = "FIRST-LAST", value_parser = range, allow_hyphen_values = true)]
    pub(super) rows: Option<(Option<u32>, Option<u32>)>,
    /// Render only these columns
    #[arg(long, value_name = "FIRST-LAST", value_parser = range, allow_hyphen_values = true)]
    pub(super) columns: Option<(Option<u32>, Option<u32>)>,
    /// Use so many threads; never changes the picture [default: all the machine has]
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u32).range(1..))]
    pub(super) threads: Option<u32>,
}

/// povista's own ways to sample.
#[derive(Debug, Args)]
pub(super) struct Sampling {
    /// Take so many samples for each pixel, spread evenly
    #[arg(long, value_name = "COUNT", conflicts_with_all = ["aa", "aa_method"])]
    pub(super) samples: Option<u32>,
    /// Take as many samples as so many seconds allow
    #[arg(long, value_name = "SECONDS", conflicts_with_all = ["aa", "aa_method", "samples"])]
    pub(super) budget: Option<f32>,
    /// Take one sample for each square of so many pixels: a first look
    #[arg(long, value_name = "PIXELS", conflicts_with_all = ["aa", "aa_method", "samples", "budget"])]
    pub(super) every: Option<u32>,
    /// With `--aa edges` or `adaptive`: the error of a pixel, in steps of 255, that is small enough
    #[arg(long, value_name = "STEPS", default_value_t = 2.0)]
    pub(super) error: f32,
    /// With `--aa edges` or `adaptive`: samples of a pixel at most
    #[arg(long, value_name = "COUNT", default_value_t = 256)]
    pub(super) most: u32,
    /// How much samples count for the pixels around them; not for POV-Ray's methods
    #[arg(long, value_name = "FILTER", default_value = "box")]
    pub(super) filter: Filter,
}

/// What `--aa` says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Aa {
    /// POV-Ray's methods with a threshold.
    Threshold(f32),
    /// Samples where the error is.
    Adaptive,
    /// The middle and the corners of a pixel.
    Corners,
    /// These, and what it takes to find edges.
    Edges,
}

impl Aa {
    /// The threshold of POV-Ray's methods.
    pub(super) fn threshold(self) -> Option<f32> {
        match self {
            Self::Threshold(threshold) => Some(threshold),
            Self::Adaptive | Self::Corners | Self::Edges => None,
        }
    }
}

/// How much samples count for the pixels around them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Filter {
    /// Only for the pixel they lie in
    Box,
    /// Less and less up to one pixel away
    Triangle,
    /// A bell half a pixel wide
    Gaussian,
    /// Mitchell's, which sharpens edges
    Mitchell,
}

/// What to check, and how to tell.
#[derive(Debug, Args)]
pub(super) struct Check {
    #[command(flatten)]
    pub(super) scene: Scene,
    /// How to tell
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    pub(super) format: Telling,
    #[command(flatten)]
    pub(super) levels: Levels,
}

/// How seriously findings are taken. A code by its name goes before `all`.
#[derive(Debug, Args)]
pub(super) struct Levels {
    /// Don't tell findings of this code, such as `unused`; `all` is every warning
    #[arg(long, value_name = "CODE", value_parser = code)]
    pub(super) allow: Vec<Finding>,
    /// Tell findings of this code as warnings, as is done unless said otherwise
    #[arg(long, value_name = "CODE", value_parser = code)]
    pub(super) warn: Vec<Finding>,
    /// Tell findings of this code as errors
    #[arg(long, value_name = "CODE", value_parser = code)]
    pub(super) deny: Vec<Finding>,
}

/// Whose level is chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Finding {
    /// Every warning.
    All,
    /// Those with this code.
    Of(Code),
}

/// What to lay out.
#[derive(Debug, Args)]
pub(super) struct Fmt {
    /// The scenes and include files; `-` is standard input, laid out on standard output
    #[arg(value_name = "FILE", required = true, value_hint = ValueHint::FilePath)]
    pub(super) files: Vec<String>,
    /// Change nothing; name the files that are not laid out, and fail if there are any
    #[arg(long)]
    pub(super) check: bool,
    /// Change nothing; write the laid out text to standard output
    #[arg(long, conflicts_with = "check")]
    pub(super) stdout: bool,
}

/// What scenes see that an editor has open.
#[derive(Debug, Args)]
pub(super) struct Lsp {
    /// Search a folder for included files, images and fonts
    #[arg(short = 'L', long = "library", value_name = "FOLDER", value_hint = ValueHint::DirPath)]
    pub(super) library: Vec<String>,
    /// Stop a scene that runs this many directives and macros without making anything and with no end in sight, or fifty times as many in all
    #[arg(long, value_name = "COUNT", default_value_t = 400_000)]
    pub(super) max_steps: u64,
    /// Stop a scene that takes more memory than this while it is read
    #[arg(long, value_name = "MEGABYTES", default_value_t = 1024)]
    pub(super) max_memory: u64,
    /// Talk on standard input and output, which is done anyway: editors say so
    #[arg(long, hide = true)]
    pub(super) stdio: bool,
}

/// What to compare.
#[derive(Debug, Args)]
pub(super) struct Diff {
    /// A picture
    #[arg(value_hint = ValueHint::FilePath)]
    pub(super) ours: PathBuf,
    /// Another picture
    #[arg(value_hint = ValueHint::FilePath)]
    pub(super) theirs: PathBuf,
    /// Write a map of the differences
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(super) output: Option<PathBuf>,
    /// Fail if any channel differs by more than this many steps of 255
    #[arg(long, value_name = "STEPS")]
    pub(super) threshold: Option<f32>,
    /// Tell as JSON
    #[arg(long)]
    pub(super) json: bool,
}

/// What to render with both programs.
#[derive(Debug, Args)]
pub(super) struct Compare {
    #[command(flatten)]
    pub(super) scene: Scene,
    #[command(flatten)]
    pub(super) look: Look,
    /// Write ours, theirs and the heat map side by side there [default: SCENE-compare.png]
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(super) output: Option<PathBuf>,
    /// The program to compare with
    #[arg(long, value_name = "PROGRAM", default_value = "povray")]
    pub(super) povray: PathBuf,
    /// Tell as JSON
    #[arg(long)]
    pub(super) json: bool,
}

/// What to measure.
#[derive(Debug, Args)]
pub(super) struct Bench {
    /// The scenes
    #[arg(required = true, value_name = "SCENE", value_hint = ValueHint::FilePath)]
    pub(super) scenes: Vec<String>,
    /// Width and height in pixels
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "120x90", value_parser = size)]
    pub(super) size: (u32, u32),
    /// Use so many threads
    #[arg(long, value_name = "COUNT", default_value_t = 1)]
    pub(super) threads: usize,
    /// Write the curves and the converged pictures to this folder
    #[arg(short, long, value_name = "FOLDER", default_value = "bench", value_hint = ValueHint::DirPath)]
    pub(super) output: PathBuf,
    /// The program to measure beside
    #[arg(long, value_name = "PROGRAM", default_value = "povray")]
    pub(super) povray: PathBuf,
}

impl Bench {
    /// One of the scenes, with nothing declared.
    pub(super) fn of(&self, scene: &str) -> Scene {
        Scene { scene: Some(scene.to_owned()), ..Scene::default() }
    }
}

/// How diagnostics are told.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Telling {
    /// With colors and frames, as wide as the terminal
    Human,
    /// The same on every machine, for snapshots
    Plain,
    /// One JSON object to a line
    Json,
    /// A SARIF 2.1.0 log, for editors and the reviews of code hosts
    Sarif,
}

/// How objects near a ray are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Accel {
    /// What suits the scene
    Auto,
    /// Every object in turn
    Linear,
    /// An octree
    Octree,
    /// A tree of boxes
    Bvh,
}

/// Reads `all`, or the name of a code.
fn code(text: &str) -> Result<Finding, String> {
    if text == "all" {
        return Ok(Finding::All);
    }
    Code::find(text).filter(|code| *code != Code::Error).map(Finding::Of).ok_or_else(|| {
        let names: Vec<&str> = Code::all()
            .filter(|code| code.is_lint())
            .map(|code| code.name().trim_start_matches("lint::"))
            .collect();
        format!("the codes are `all`, `warning`, `possible_error` and the lints: {}", names.join(", "))
    })
}

/// Reads `640x480`.
fn size(text: &str) -> Result<(u32, u32), String> {
    text.split_once(['x', 'X'])
        .and_then(|(width, height)| Some((width.parse().ok()?, height.parse().ok()?)))
        .ok_or_else(|| "a size is WIDTHxHEIGHT, such as 640x480".to_owned())
}

/// Reads `Size=3` or `Name="text"`.
fn constant(text: &str) -> Result<String, String> {
    let (name, value) = text.split_once('=').unwrap_or((text, ""));
    let number = value.trim().parse().is_ok_and(f64::is_finite);
    let quoted = value.len() > 1
        && ['"', '\''].iter().any(|quote| value.starts_with(*quote) && value.ends_with(*quote));
    if !name.is_empty() && (number || quoted) {
        return Ok(text.to_owned());
    }
    Err("a constant is NAME=NUMBER or NAME=\"text\"; the quotes belong to it: 'Name=\"text\"'".to_owned())
}

/// Reads `0.3`, `adaptive`, `corners` or `edges`.
fn aa(text: &str) -> Result<Aa, String> {
    match text {
        "adaptive" => Ok(Aa::Adaptive),
        "corners" => Ok(Aa::Corners),
        "edges" => Ok(Aa::Edges),
        _ => {
            let threshold = text.parse().ok().filter(|number| (0.0..=1.0).contains(number));
            let help = "antialiasing is a threshold from 0 to 1, `adaptive`, `corners` or `edges`";
            threshold.map(Aa::Threshold).ok_or_else(|| help.to_owned())
        }
    }
}

/// Reads `10-20`, `10-` or `-20`.
fn range(text: &str) -> Result<(Option<u32>, Option<u32>), String> {
    let end = |text: &str| match text {
        "" => Some(None),
        _ => text.parse().ok().filter(|number| *number > 0).map(Some),
    };
    text.split_once('-')
        .and_then(|(first, last)| Some((end(first)?, end(last)?)))
        .ok_or_else(|| "a range is FIRST-LAST, such as 100-200, 100- or -200".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn sizes_and_ranges_are_read() {
        assert_eq!(size("640x480"), Ok((640, 480)));
        assert!(size("640").is_err());
        assert_eq!(range("10-20"), Ok((Some(10), Some(20))));
        assert_eq!(range("-20"), Ok((None, Some(20))));
        assert_eq!((aa("0.3"), aa("corners")), (Ok(Aa::Threshold(0.3)), Ok(Aa::Corners)));
        assert!(aa("much").is_err());
        assert!(range("10").is_err() && range("a-b").is_err() && range("0-3").is_err());
    }

    #[test]
    fn constants_are_numbers_or_quoted() {
        for good in ["Size=3", "a=-1.5e3", "b = .5", "Name=\"some text\"", "n=\"\""] {
            assert_eq!(constant(good).as_deref(), Ok(good));
        }
        for bad in ["Size", "Size=", "=3", "Name=text", "Name=\"", "n=nan"] {
            assert!(constant(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn numbers_out_of_range_are_refused() {
        for bad in ["--aa=3", "--aa=-1", "--aa=x", "--aa-depth=0", "--quality=10", "--bits=3", "--threads=0"]
        {
            assert!(Arguments::try_parse_from(["povista", "a.pov", bad]).is_err(), "{bad}");
        }
        assert!(Arguments::try_parse_from(["povista", "a.pov", "--aa", "--bits=16", "--aa-depth=9"]).is_ok());
    }
}
