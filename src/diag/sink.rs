//! Where messages go while a scene is read.

use super::{Diagnostic, Severity};
use crate::source::Sources;

/// One of the text streams a scene writes to by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stream {
    /// `#debug`, `#render`, `#statistics`.
    Debug,
}

/// Takes what a run has to say, as soon as it has it.
pub trait Sink {
    /// A warning or an error.
    fn diagnostic(&mut self, diagnostic: Diagnostic, sources: &Sources);
    /// Text the scene itself writes; not necessarily whole lines.
    fn text(&mut self, stream: Stream, text: &str);
}

/// A sink that keeps everything, for tests and for checking.
#[derive(Debug, Default)]
pub struct Collect {
    /// The diagnostics in the order they came.
    pub diagnostics: Vec<Diagnostic>,
    /// The text of the debug stream.
    pub debug: String,
}

impl Collect {
    /// Whether there was an error.
    pub fn failed(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Error)
    }
}

impl Sink for Collect {
    fn diagnostic(&mut self, diagnostic: Diagnostic, _: &Sources) {
        self.diagnostics.push(diagnostic);
    }

    fn text(&mut self, _: Stream, text: &str) {
        self.debug.push_str(text);
    }
}
