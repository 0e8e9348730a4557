//! Errors on their way from where they are found to where reading goes on.

use super::Vm;
use crate::diag::{Code, Diagnostic, Severity, Step};
use crate::source::Span;

/// Why reading a statement stopped: an error, or one that was reported before.
///
/// It travels up by `?` to the statement that recovers from it, which reports it.
#[derive(Debug)]
pub struct Fault(pub(super) Option<Box<Diagnostic>>);

/// What readers return.
pub type Result<T, E = Fault> = std::result::Result<T, E>;

impl Fault {
    /// An error that somebody has heard of already.
    pub fn reported() -> Fault {
        Fault(None)
    }

    /// The error a diagnostic tells of.
    pub fn from_diagnostic(diagnostic: Diagnostic) -> Fault {
        Fault(Some(Box::new(diagnostic)))
    }

    /// Says how to mend it.
    pub fn help(mut self, text: impl Into<String>) -> Fault {
        if let Some(diagnostic) = &mut self.0 {
            diagnostic.help = Some(text.into());
        }
        self
    }

    /// Whether it says how to mend it.
    pub fn has_help(&self) -> bool {
        self.0.as_ref().is_none_or(|diagnostic| diagnostic.help.is_some())
    }

    /// Says what is to be seen at the place itself.
    pub fn label(mut self, text: impl Into<String>) -> Fault {
        if let Some(diagnostic) = &mut self.0 {
            diagnostic.label = text.into();
        }
        self
    }

    /// Points at another place.
    pub fn see(mut self, span: Span, text: impl Into<String>) -> Fault {
        self.0 = self.0.map(|diagnostic| Box::new(diagnostic.see(span, text)));
        self
    }
}

impl Vm<'_> {
    /// An error at a place: return it, perhaps with [`Fault::help`].
    pub fn error(&self, span: Span, message: impl Into<String>) -> Fault {
        let mut diagnostic = Diagnostic::new(Severity::Error, span, message);
        diagnostic.trace = self.trace();
        Fault(Some(Box::new(diagnostic)))
    }

    /// An error after which nothing else can be read.
    pub fn fatal(&mut self, span: Span, message: impl Into<String>) -> Fault {
        let fault = self.error(span, message);
        self.stop();
        fault
    }

    /// Warns about a place, and says how to mend it.
    pub fn warn(&mut self, span: Span, message: impl Into<String>, help: &str) {
        self.say(Severity::Warning, span, message.into(), help);
    }

    /// Warns about what POV-Ray calls a possible error.
    pub fn possible(&mut self, span: Span, message: impl Into<String>, help: &str) {
        self.say(Severity::Possible, span, message.into(), help);
    }

    /// Warns about an old spelling, or about a name its author wants to be rid of.
    pub fn deprecated(&mut self, span: Span, message: impl Into<String>, help: &str) {
        self.say_as(Code::Deprecated, Severity::Warning, span, message.into(), help);
    }

    /// Warns about a `;` that is missing, but not needed in the scene's version of the language.
    pub(super) fn missing_semicolon(&mut self, message: &str) {
        self.say_as(
            Code::MissingSemicolon,
            Severity::Possible,
            self.last.after(),
            message.into(),
            "add a `;` here",
        );
    }

    fn say(&mut self, severity: Severity, span: Span, message: String, help: &str) {
        let diagnostic = Diagnostic::new(severity, span, message);
        self.say_diagnostic(diagnostic, help);
    }

    fn say_as(&mut self, code: Code, severity: Severity, span: Span, message: String, help: &str) {
        let diagnostic = Diagnostic::new(severity, span, message).code(code);
        self.say_diagnostic(diagnostic, help);
    }

    fn say_diagnostic(&mut self, mut diagnostic: Diagnostic, help: &str) {
        diagnostic.help = (!help.is_empty()).then(|| help.to_owned());
        diagnostic.trace = self.trace();
        self.report(diagnostic);
    }

    /// Reports the error behind a fault, unless that has happened.
    pub(super) fn settle(&mut self, fault: Fault) {
        if std::mem::replace(&mut self.ended, self.stopped) {
            // What comes after the error that stopped everything only follows from it.
            return;
        }
        self.faults += 1;
        self.confused = true;
        if let Some(diagnostic) = fault.0 {
            self.report(*diagnostic);
        }
        if self.faults >= super::limits::MOST_FAULTS {
            self.stop();
            self.ended = true;
        }
    }

    /// Hands a diagnostic to the sink. The same message at the same place is heard once.
    pub(super) fn report(&mut self, diagnostic: Diagnostic) {
        let error = diagnostic.severity == Severity::Error;
        self.failed |= error;
        if self.said.insert((diagnostic.span, diagnostic.message.clone())) {
            self.errors += usize::from(error);
            if self.errors >= super::limits::MOST_ERRORS {
                self.stop();
                self.ended = true;
            }
            self.sink.diagnostic(diagnostic, self.sources);
        }
    }

    /// The macros and include files being read, innermost first.
    fn trace(&self) -> Vec<Step> {
        let mut steps: Vec<Step> = std::iter::once(&self.frame)
            .chain(self.frames.iter().rev())
            .filter_map(|frame| frame.entered.map(|entered| (frame, entered)))
            .take(super::limits::MOST_STEPS)
            .map(|(frame, entered)| {
                let what = match entered.name {
                    Some(name) => format!("macro `{}`", self.symbols.name(name)),
                    None => format!("include file `{}`", self.sources.get(frame.tree.file).name),
                };
                Step { what, span: entered.span }
            })
            .collect();
        steps.dedup();
        steps
    }
}
