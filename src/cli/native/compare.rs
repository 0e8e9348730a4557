//! `povista compare`: the same scene by both programs.

use std::env;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

use super::args::{Aa, Compare, Look, Scene};
use crate::cli::failure::Failure;
use crate::cli::picture;
use crate::cli::problem::Problem;

/// What the last lines of a program's complaint are worth showing.
const LAST_LINES: usize = 12;

/// Renders a scene with both programs and tells how far the pictures are apart.
///
/// Both run as a user runs them, one after the other, so that their times can be compared.
///
/// # Errors
/// Either program cannot be started or gives no picture.
pub(super) fn compare(arguments: &Compare, out: &mut dyn Write) -> Result<(), Failure> {
    let scene =
        arguments.scene.scene.as_deref().filter(|scene| *scene != "-").ok_or_else(|| {
            Problem::new("no scene to compare").help("name one: `povista compare scene.pov`")
        })?;
    let scene = &existing(scene)?;
    if arguments.look.aa.is_some_and(|aa| aa.threshold().is_none()) {
        return Err(Problem::new("POV-Ray has no such antialiasing")
            .help("give `--aa` a threshold, such as 0.3")
            .into());
    }
    let absent = |error| {
        Problem::new(format!("cannot run `{}`: {error}", name_of(&arguments.povray))).help(
            "install POV-Ray (Debian: `apt install povray povray-includes`), or name it with `--povray`",
        )
    };
    // Better to know now that there is no POV-Ray than after an hour.
    try_to_run(&arguments.povray).map_err(absent)?;
    let folder = tempfile::tempdir()
        .map_err(|error| Problem::new(format!("cannot make a temporary folder: {error}")))?;
    let povista =
        env::current_exe().map_err(|error| Problem::new(format!("cannot find this program: {error}")))?;
    let words = words(&arguments.scene, &arguments.look);
    let render = |program: &Path, name: &str| {
        let path = folder.path().join(name);
        time(program, scene, &words, &path).map(|time| (path, time))
    };
    let (ours_path, ours_time) = render(&povista, "ours.png")?;
    let (theirs_path, theirs_time) = render(&arguments.povray, "theirs.png")?;

    let (ours, theirs) = (picture::read(&ours_path)?, picture::read(&theirs_path)?);
    let difference = picture::compare(&ours, &theirs)?;
    let map = picture::heat_map(&ours, &theirs);
    let sheet = picture::side_by_side(&[ours.to_rgb8(), theirs.to_rgb8(), map]);
    let path = arguments.output.clone().unwrap_or_else(|| sheet_path(scene));
    picture::write(&sheet, &path)?;

    if arguments.json {
        let json = serde_json::json!({
            "scene": scene,
            "picture": path,
            "difference": difference,
            "ours_seconds": ours_time.as_secs_f64(),
            "theirs_seconds": theirs_time.as_secs_f64(),
        });
        writeln!(out, "{json}")?;
    } else {
        writeln!(out, "{difference}")?;
        writeln!(out, "povista              {:.2} s", ours_time.as_secs_f64())?;
        writeln!(out, "{:<20} {:.2} s", name_of(&arguments.povray), theirs_time.as_secs_f64())?;
        writeln!(out, "ours, theirs and the heat map side by side: {}", path.display())?;
    }
    Ok(())
}

/// Whether there is a program that can be asked for its version, whatever it answers.
///
/// # Errors
/// It cannot be started.
pub(super) fn try_to_run(program: &Path) -> io::Result<()> {
    let mut command = Command::new(program);
    command.arg("--version").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().map(|_| ())
}

/// The options both programs get, in POV-Ray's words.
fn words(scene: &Scene, look: &Look) -> Vec<String> {
    let mut words: Vec<String> = scene.library.iter().map(|folder| format!("+L\"{folder}\"")).collect();
    words.extend(scene.declare.iter().map(|constant| format!("Declare={constant}")));
    let mut add = |word: Option<String>| words.extend(word);
    add(scene.clock.map(|clock| format!("+K{clock}")));
    add(look.size.map(|size| format!("+W{}", size.0)));
    add(look.size.map(|size| format!("+H{}", size.1)));
    // `+A0.3` takes no number of 1 or more, and none without a nought.
    let threshold = look.aa.and_then(Aa::threshold);
    add(threshold.map(|_| "+A".to_owned()));
    add(threshold.map(|threshold| format!("Antialias_Threshold={threshold}")));
    add(look.aa_method.map(|method| format!("+AM{method}")));
    add(look.aa_depth.map(|depth| format!("+R{depth}")));
    add(look.quality.map(|quality| format!("+Q{quality}")));
    add(look.threads.map(|threads| format!("+WT{threads}")));
    for (range, start, end) in [(look.rows, "+SR", "+ER"), (look.columns, "+SC", "+EC")] {
        let (first, last) = range.unwrap_or_default();
        add(first.map(|first| format!("{start}{first}")));
        add(last.map(|last| format!("{end}{last}.5")));
    }
    words
}

/// Runs a program by POV-Ray's command line and takes its time.
fn time(program: &Path, scene: &str, words: &[String], picture: &Path) -> Result<Duration, Problem> {
    let name = name_of(program);
    let start = Instant::now();
    let Output { status, stderr, .. } = Command::new(program)
        .arg(format!("+I\"{scene}\""))
        .args(words)
        .args(["+FN8", "-D", "-P", "-C", "-V", "-GR", "-GS"])
        .arg(format!("+O\"{}\"", picture.display()))
        .stdin(Stdio::null())
        .output()
        .map_err(|error| Problem::new(format!("cannot run `{name}`: {error}")))?;
    let time = start.elapsed();
    if status.success() {
        return Ok(time);
    }
    let text = String::from_utf8_lossy(&stderr);
    let lines: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty()).collect();
    // What comes before the scene is read is about the program.
    let parsing = lines.iter().position(|line| line.contains("[Parsing...]")).map_or(0, |at| at + 1);
    let said = &lines[parsing.max(lines.len().saturating_sub(LAST_LINES))..];
    let said = if said.is_empty() { "nothing".to_owned() } else { format!("\n{}", said.join("\n")) };
    Err(Problem::new(format!("`{name}` gave no picture ({status}); it said {said}")))
}

/// The scene, if it is there as it is named or with the extension left out.
fn existing(scene: &str) -> Result<String, Problem> {
    let names = [scene.to_owned(), format!("{scene}.pov")];
    names
        .into_iter()
        .find(|name| Path::new(name).is_file())
        .ok_or_else(|| Problem::new(format!("cannot find the scene `{scene}`")))
}

/// A program's name without its folder.
fn name_of(program: &Path) -> String {
    program.file_name().unwrap_or(program.as_os_str()).to_string_lossy().into_owned()
}

/// Where the pictures go side by side: beside the scene.
fn sheet_path(scene: &str) -> PathBuf {
    let scene = Path::new(scene);
    let mut name = scene.file_stem().unwrap_or_default().to_owned();
    name.push("-compare.png");
    scene.with_file_name(name)
}
