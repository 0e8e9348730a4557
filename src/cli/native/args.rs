//! povista's own command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum, ValueHint};

/// Renders POV-Ray scenes: the same picture, faster, with errors people enjoy reading.
#[derive(Debug, Parser)]
#[command(name = "povista", version, long_version = super::LONG_VERSION)]
#[command(arg_required_else_help = true, max_term_width = 100)]
pub(super) struct Arguments {
    #[command(subcommand)]
    pub(super) command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Read a scene and say what is wrong with it, without rendering
    Check(Check),
    /// Show what povista understood of a scene
    Dump(Scene),
    /// Tell how far two pictures are apart
    Diff(Diff),
    /// Print what a shell needs to complete povista's commands
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
}

/// A scene, and what its text can see.
#[derive(Debug, Args)]
pub(super) struct Scene {
    /// The scene; `-` reads standard input
    #[arg(value_name = "SCENE", value_hint = ValueHint::FilePath)]
    pub(super) scene: Option<String>,
    /// Search a folder for included files, images and fonts
    #[arg(short = 'L', long = "library", value_name = "FOLDER", value_hint = ValueHint::DirPath)]
    pub(super) library: Vec<String>,
    /// Declare a constant for the scene, such as `Size=3` or `Name="text"`
    #[arg(long, value_name = "NAME=VALUE")]
    pub(super) declare: Vec<String>,
    /// Set the scene's `clock`
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(super) clock: Option<f32>,
}

/// What to check, and how to tell.
#[derive(Debug, Args)]
pub(super) struct Check {
    #[command(flatten)]
    pub(super) scene: Scene,
    /// How to tell
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    pub(super) format: Telling,
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

/// How diagnostics are told.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Telling {
    /// With colors and frames, as wide as the terminal
    Human,
    /// The same on every machine, for snapshots
    Plain,
    /// One JSON object to a line
    Json,
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Arguments::command().debug_assert();
    }
}
