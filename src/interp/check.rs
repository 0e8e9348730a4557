//! Checking a scene without rendering it.

use super::interpret;
use crate::diag::{Collect, Diagnostic, Severity, plain};
use crate::options::LanguageOptions;
use crate::source::{Library, Permissions, Source, Sources};
use std::fmt;

/// What there is to say about a scene.
///
/// Its `Display` is the plain report: the same on every machine, made for snapshot tests.
#[derive(Debug)]
pub struct Checked {
    /// Errors and warnings in the order they were found.
    pub diagnostics: Vec<Diagnostic>,
    /// What the scene wrote to the debug stream.
    pub debug: String,
    /// The files the spans of the diagnostics point into.
    pub sources: Sources,
}

impl Checked {
    /// Whether the scene has errors.
    pub fn failed(&self) -> bool {
        self.diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error)
    }
}

impl fmt::Display for Checked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for diagnostic in &self.diagnostics {
            write!(f, "{}", plain(diagnostic, &self.sources))?;
        }
        Ok(())
    }
}

/// Reads a scene given as text, and says what is wrong with it. The scene can write no files.
///
/// ```
/// let checked = povista::check("#version 3.7;\n#declare Size = 2\nsphere { 0, Size }");
/// assert!(checked.failed());
/// insta::assert_snapshot!(checked.to_string().lines().next().unwrap_or(""), @"  × this declaration needs a `;` at its end, found `sphere`");
/// ```
pub fn check(text: &str) -> Checked {
    let permissions = Permissions::write_only_in(Vec::new());
    let library = Library { permissions, ..Library::default() };
    check_with(Source::new("scene.pov", "", text.into()), library, &LanguageOptions::default())
}

/// The same with files to include, and options.
pub fn check_with(scene: Source, library: Library, options: &LanguageOptions) -> Checked {
    let mut sources = Sources::new(library);
    let main = sources.add(scene);
    let mut sink = Collect::default();
    // Whether there is a scene is of no interest here: errors say that there is none.
    drop(interpret(main, &mut sources, options, &mut sink));
    Checked { diagnostics: sink.diagnostics, debug: sink.debug, sources }
}
