//! POV-Ray's text streams: what reaches the console and what a file (docs/spec/camera-image.md 17 and 21).

use std::fs::File;
use std::io::Write;
use std::path::Path;

use super::wrap::Wrap;
use crate::cli::Problem;
use crate::cli::settings::{Name, Settings};
use crate::source::Permissions;

/// A kind of text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stream {
    /// What the scene says by `#debug`.
    Debug,
    /// Why there is no picture.
    Fatal,
    /// How the picture is made.
    Render,
    /// What it took.
    Statistic,
    /// Doubts about the scene.
    Warning,
}

/// Each stream with its options, the name of its file if none is given, and its name on the console.
const STREAMS: [(Stream, Name, Name, &str, &str); 5] = [
    (Stream::Debug, Name::DebugConsole, Name::DebugFile, "debug.out", "Debug Stream to console........."),
    (Stream::Fatal, Name::FatalConsole, Name::FatalFile, "fatal.out", "Fatal Stream to console........."),
    (Stream::Render, Name::RenderConsole, Name::RenderFile, "render.out", "Render Stream to console........"),
    (
        Stream::Statistic,
        Name::StatisticConsole,
        Name::StatisticFile,
        "stats.out",
        "Statistics Stream to console....",
    ),
    (
        Stream::Warning,
        Name::WarningConsole,
        Name::WarningFile,
        "warning.out",
        "Warning Stream to console.......",
    ),
];

/// File of everything, if no name is given.
const ALL_FILE: &str = "alltext.out";

/// The files of the streams.
#[derive(Default)]
pub(super) struct Files {
    streams: [Option<File>; STREAMS.len()],
    everything: Option<File>,
}

impl Files {
    /// Opens the files that were asked for, beside the picture.
    ///
    /// # Errors
    /// A file's name is a path, or the file cannot be written.
    pub(super) fn open(
        settings: &Settings,
        folder: &Path,
        permissions: &Permissions,
    ) -> Result<Self, Problem> {
        let open = |name, default| open(settings, name, default, folder, permissions);
        let mut files = Self { everything: open(Name::AllFile, ALL_FILE)?, ..Self::default() };
        for (stream, _, file, default, _) in STREAMS {
            files.streams[stream as usize] = open(file, default)?;
        }
        Ok(files)
    }
}

/// Where text goes.
pub(super) struct Streams<'w> {
    console: &'w mut (dyn Write + Send),
    /// A line begun in one stream doesn't mix with another's.
    lines: [Wrap; STREAMS.len()],
    shown: [bool; STREAMS.len()],
    files: Files,
}

impl<'w> Streams<'w> {
    /// Shows on a console what the settings say.
    pub(super) fn new(console: &'w mut (dyn Write + Send), settings: &Settings, files: Files) -> Self {
        let all = settings.bool(Name::AllConsole).unwrap_or(true);
        let shown = STREAMS.map(|(_, shown, ..)| all && settings.bool(shown).unwrap_or(true));
        Self { console, lines: Default::default(), shown, files }
    }

    /// Writes text of a kind; a console that has gone away is no reason to stop.
    pub(super) fn write(&mut self, stream: Stream, text: &str) {
        if self.shown[stream as usize] {
            let lines = self.lines[stream as usize].push(text);
            self.show(&lines);
        }
        for file in
            [&mut self.files.streams[stream as usize], &mut self.files.everything].into_iter().flatten()
        {
            let _ = file.write_all(text.as_bytes());
        }
    }

    /// Writes what is always shown.
    pub(super) fn announce(&mut self, text: &str) {
        let begun: String = self.lines.iter_mut().map(Wrap::finish).collect();
        self.show(&(begun + &Wrap::default().push(text)));
        if let Some(file) = &mut self.files.everything {
            let _ = file.write_all(text.as_bytes());
        }
    }

    /// Shows how far a picture is, on a line that is written over and over.
    pub(super) fn progress(&mut self, text: &str) {
        self.show(&format!("{text}\r"));
    }

    /// The console options, as POV-Ray lists them.
    pub(super) fn describe(&self) -> String {
        let switch = |on: bool| if on { "On " } else { "Off" };
        let all = self.shown.iter().any(|shown| *shown);
        let mut text =
            format!("Information Output Options\n  All Streams to console..........{}\n", switch(all));
        for (stream, _, _, _, label) in STREAMS {
            text.push_str(&format!("  {label}{}\n", switch(self.shown[stream as usize])));
        }
        text
    }

    fn show(&mut self, text: &str) {
        let _ = self.console.write_all(text.as_bytes());
        let _ = self.console.flush();
    }
}

/// Opens the file of a stream, if there is to be one.
fn open(
    settings: &Settings,
    name: Name,
    default: &str,
    folder: &Path,
    permissions: &Permissions,
) -> Result<Option<File>, Problem> {
    let Some(file) = settings.text(name).filter(|file| !file.is_empty()) else { return Ok(None) };
    if file.contains('/') {
        let message = format!("`{}` takes a file name without a folder, not `{file}`", name.as_str());
        return Err(Problem::new(message).help("the file is written beside the picture"));
    }
    let yes = ["on", "true", "yes", "1"].iter().any(|word| word.eq_ignore_ascii_case(file));
    let path = folder.join(if yes { default } else { file });
    let cannot = |error| Problem::io("write", &path, &error);
    let path = match settings.is_found(name) || settings.is_found(Name::OutputFileName) {
        true => permissions.check_write(&path).map_err(cannot)?,
        false => path.clone(),
    };
    let append = settings.bool(Name::AppendFile) == Some(true);
    File::options()
        .create(true)
        .write(true)
        .append(append)
        .truncate(!append)
        .open(&path)
        .map(Some)
        .map_err(cannot)
}
