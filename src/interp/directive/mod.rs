//! Directives: what stands behind a `#`, docs/spec/language.md 2. One kind to a file.

mod branch;
mod declare;
mod default;
mod endless;
mod file_io;
mod include;
mod macros;
mod message;
mod repeat;
mod version;

pub(super) use branch::BlockKind;
pub(super) use endless::PATIENCE;

use super::{Result, Vm};
use crate::source::Span;
use crate::syntax::Directive;

/// A directive that waits for its `#end`.
#[derive(Debug)]
pub(super) struct Open {
    /// What it is.
    pub kind: BlockKind,
    /// Where it was opened.
    pub span: Span,
    /// The step at which that was.
    pub since: u64,
}

impl Vm<'_> {
    /// Runs a directive that was just read; `link` leads to the next one of its block.
    pub(super) fn run(&mut self, directive: Directive, link: u32, span: Span) -> Result<()> {
        self.work(1, span)?;
        let blocked = std::mem::replace(&mut self.blocked, false);
        let result = self.nested(span, |vm| vm.dispatch(directive, link, span));
        self.blocked = blocked;
        result
    }

    fn dispatch(&mut self, directive: Directive, link: u32, span: Span) -> Result<()> {
        match directive {
            Directive::Declare => self.declare(false),
            Directive::Local => self.declare(true),
            Directive::Undef => self.undef(),
            Directive::If | Directive::Ifdef | Directive::Ifndef => self.branch(directive, link, span),
            Directive::Elseif | Directive::Else | Directive::Case | Directive::Range => {
                self.next_arm(directive, link, span)
            }
            Directive::End => self.end(span),
            Directive::While => self.repeat_while(link, span),
            Directive::For => self.repeat_for(link, span),
            Directive::Switch => self.switch(link, span),
            Directive::Break => self.break_out(span),
            Directive::Macro => self.define_macro(link, span),
            Directive::Include => self.include(span),
            Directive::Default => self.set_default(span),
            Directive::Version => self.set_version(span),
            Directive::Debug | Directive::Render | Directive::Statistics => self.debug(directive, span),
            Directive::Warning => self.user_warning(span),
            Directive::Error => self.user_error(span),
            Directive::Fopen => self.open_file(),
            Directive::Fclose => self.close_file(),
            Directive::Read => self.read_file(span),
            Directive::Write => self.write_file(span),
        }
    }
}
