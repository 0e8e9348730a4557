//! Tells a person how things go.

use std::io::Write;

use indicatif::ProgressDrawTarget;

use super::terminal::Terminal;
use crate::diag::{Diagnostic, Severity, Sink, Stream};
use crate::source::Sources;

/// Tells a person how a run is going.
pub(super) struct Teller<'w> {
    err: &'w mut (dyn Write + Send),
    /// Where it is told.
    pub(super) terminal: Terminal,
    /// Whether only trouble is told.
    pub(super) quiet: bool,
    /// A line of the scene's own text is not ended yet.
    open_line: bool,
}

impl<'w> Teller<'w> {
    /// Tells on standard error.
    pub(super) fn new(err: &'w mut (dyn Write + Send), quiet: bool) -> Self {
        Self { err, terminal: Terminal::of_stderr(), quiet, open_line: false }
    }

    /// Where a progress bar is drawn; nowhere where nobody watches.
    pub(super) fn bar_target(&self) -> ProgressDrawTarget {
        if self.quiet || !self.terminal.is_there() {
            ProgressDrawTarget::hidden()
        } else {
            ProgressDrawTarget::stderr()
        }
    }

    /// Says a thing about the options.
    pub(super) fn warn(&mut self, warning: &str) {
        self.line(&format!("{} {warning}", self.terminal.bold("warning:")));
    }

    /// Writes text; a terminal that has gone away is no reason to stop.
    fn write(&mut self, text: &str) {
        let _ = self.err.write_all(text.as_bytes());
    }

    /// Writes a text of its own lines.
    pub(super) fn line(&mut self, text: &str) {
        let begun = if std::mem::take(&mut self.open_line) { "\n" } else { "" };
        self.write(&format!("{begun}{text}\n"));
    }
}

impl Sink for Teller<'_> {
    fn diagnostic(&mut self, diagnostic: Diagnostic, sources: &Sources) {
        if self.quiet && diagnostic.severity < Severity::Possible {
            return;
        }
        let report = self.terminal.report(&diagnostic, sources);
        self.line(report.trim_end_matches('\n'));
    }

    fn text(&mut self, _: Stream, text: &str) {
        if !self.quiet && !text.is_empty() {
            self.open_line = !text.ends_with('\n');
            self.write(text);
        }
    }
}
