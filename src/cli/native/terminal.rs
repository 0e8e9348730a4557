//! What a terminal can show.

use std::env;
use std::io::{self, IsTerminal};

use crate::diag::{self, Diagnostic};
use crate::source::Sources;

/// Wider reports are hard to read.
const WIDEST: usize = 140;

/// Where text goes that people read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Terminal {
    /// Columns; none where there is no terminal.
    columns: Option<usize>,
    /// Whether colors are welcome.
    colors: bool,
}

impl Terminal {
    /// The terminal behind standard output, if any.
    pub(super) fn of_stdout() -> Self {
        Self::new(io::stdout().is_terminal(), console::Term::stdout())
    }

    /// The terminal behind standard error, if any.
    pub(super) fn of_stderr() -> Self {
        Self::new(io::stderr().is_terminal(), console::Term::stderr())
    }

    fn new(present: bool, terminal: console::Term) -> Self {
        let plain = env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty())
            || env::var_os("TERM").is_some_and(|term| term == "dumb");
        let columns = present.then(|| usize::from(terminal.size().1).min(WIDEST));
        Self { columns, colors: present && !plain }
    }

    /// Whether somebody watches.
    pub(super) fn is_there(self) -> bool {
        self.columns.is_some()
    }

    /// A diagnostic as it is best read here.
    pub(super) fn report(self, diagnostic: &Diagnostic, sources: &Sources) -> String {
        match self.columns {
            Some(columns) if self.colors => diag::graphical(diagnostic, sources, columns),
            _ => diag::plain(diagnostic, sources),
        }
    }

    /// Text in bold, where that can be.
    pub(super) fn bold(self, text: &str) -> String {
        if self.colors { format!("\u{1b}[1m{text}\u{1b}[0m") } else { text.to_owned() }
    }
}
