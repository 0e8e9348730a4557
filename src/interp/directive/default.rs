//! `#default`, docs/spec/language.md 2.10: what it changes is up to the readers of statements.

use crate::interp::{Result, Vm, statement};
use crate::source::Span;

impl Vm<'_> {
    /// `#default`, just read.
    pub(in crate::interp) fn set_default(&mut self, span: Span) -> Result<()> {
        statement::read_default(self, span)
    }
}
