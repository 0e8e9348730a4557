//! `#debug`, `#warning`, `#error`, docs/spec/language.md 2.12.

use crate::diag::Stream;
use crate::interp::{Result, Vm};
use crate::source::Span;
use crate::syntax::Directive;

/// What showing a text costs.
const STEPS_A_MESSAGE: u64 = 64;

impl Vm<'_> {
    /// `#debug`, or `#render` and `#statistics`, which have no stream of their own.
    pub(super) fn debug(&mut self, directive: Directive, span: Span) -> Result<()> {
        if directive != Directive::Debug {
            let message = format!("`#{}` writes to the debug stream", directive.text());
            self.deprecated(span, message, "write `#debug`");
        }
        let text = self.read_message(directive)?;
        self.work(STEPS_A_MESSAGE, span)?;
        self.sink.text(Stream::Debug, &cut(&text, 200, 156));
        Ok(())
    }

    /// `#warning`.
    pub(super) fn user_warning(&mut self, span: Span) -> Result<()> {
        let text = self.read_message(Directive::Warning)?;
        self.work(STEPS_A_MESSAGE, span)?;
        self.warn(span.to(self.last), cut(&text, 160, 124).trim_end().replace('\n', " "), "");
        Ok(())
    }

    /// `#error`: the end of the scene.
    pub(super) fn user_error(&mut self, span: Span) -> Result<()> {
        let text = self.read_message(Directive::Error)?;
        let text = cut(&text, 160, 124).trim_end().replace('\n', " ");
        Err(self.fatal(span.to(self.last), text).label("the scene stops itself here"))
    }

    fn read_message(&mut self, directive: Directive) -> Result<std::rc::Rc<str>> {
        if self.at_string()? {
            return self.read_string();
        }
        if self.at_number()? {
            return self.read_string();
        }
        Err(self.expected(&format!("a string after `#{}`", directive.text())))
    }
}

/// The first `shown` characters of a text of more than `most`.
fn cut(text: &str, most: usize, shown: usize) -> String {
    if text.chars().count() > most {
        text.chars().take(shown).chain("...".chars()).collect()
    } else {
        text.to_owned()
    }
}
