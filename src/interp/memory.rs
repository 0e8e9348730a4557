//! Keeps a run within the memory it may use.

use super::{Result, Vm};
use crate::math::pages;
use crate::source::Span;

/// How much may be added before it is looked at how much there is.
const UNNOTICED: usize = 16 << 20;

/// Bytes that are made in the time of a step.
const BYTES_A_STEP: u64 = 64;

impl Vm<'_> {
    /// Makes sure that so many bytes more are allowed.
    pub(super) fn reserve(&mut self, bytes: usize, span: Span) -> Result<()> {
        self.work(bytes as u64 / BYTES_A_STEP, span)?;
        self.added = self.added.saturating_add(bytes);
        if self.added < UNNOTICED { Ok(()) } else { self.check_memory(bytes, span) }
    }

    /// The same, but `None`, and nothing counted, when it is time to look.
    pub(super) fn reserve_unnoticed(&mut self, bytes: usize) -> Option<()> {
        let added = self.added.saturating_add(bytes);
        (added < UNNOTICED).then(|| self.added = added)
    }

    /// The same, whenever it is time to look.
    pub(super) fn check_memory(&mut self, bytes: usize, span: Span) -> Result<()> {
        self.added = 0;
        let used = pages::used().saturating_sub(self.memory_before);
        if used >= pages::MANY as u64 {
            pages::huge();
        }
        if used.saturating_add(bytes as u64) <= self.options.max_memory {
            return Ok(());
        }
        let message = format!("the scene needs more than {} MB of memory", self.options.max_memory >> 20);
        let help = "does a loop make more and more here? otherwise allow more with `--max-memory`";
        Err(self.fatal(span, message).help(help))
    }
}
