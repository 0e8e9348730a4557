//! What a run found, told three ways: a table for the terminal, JSON for programs, a page for people.

mod html;
mod table;

use std::fs;
use std::io;
use std::path::Path;

use serde::Serialize;

pub use html::page;
pub use table::{cases, features, reading_times, readings};

use crate::suite::Case;
use crate::verdict::Verdict;

/// A finished run.
#[derive(Debug, Serialize)]
pub struct Report<'a> {
    /// POV-Ray's version.
    pub povray: &'a str,
    /// povista's version.
    pub povista: &'a str,
    /// What was compared, in order.
    pub cases: &'a [Case],
}

impl Report<'_> {
    /// How many cases have a verdict.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.cases.iter().filter(|case| case.verdict == verdict).count()
    }

    /// Writes `report.json` and `report.html` into `folder`, made where it isn't.
    pub fn write(&self, folder: &Path, reason: impl Fn(&str) -> Option<String>) -> io::Result<()> {
        fs::create_dir_all(folder)?;
        fs::write(folder.join("report.json"), serde_json::to_string_pretty(self)?)?;
        fs::write(folder.join("report.html"), page(self, reason))
    }
}
