//! What povista has to say about a scene.
//!
//! - A [`Diagnostic`] is everything known about one mistake: where, what, why, how to mend it,
//!   and by which includes and macros one got there.
//! - Nothing here prints. [`graphical`], [`plain`], [`json`] and [`line()`] turn a diagnostic into
//!   text; a [`Sink`] takes diagnostics and the scene's own messages as they come.

mod code;
mod render;
mod sarif;
mod sink;

pub use code::Code;
pub use render::{graphical, json, line, plain};
pub use sarif::{sarif, uri};
pub use sink::{Collect, Sink, Stream};

use crate::source::Span;

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The scene is understood, but perhaps not as it was meant.
    Warning,
    /// Probably a mistake; the scene is still read. POV-Ray calls it a possible error.
    Possible,
    /// No picture.
    Error,
}

/// A second place worth looking at, with what to see there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// Where.
    pub span: Span,
    /// What is there.
    pub text: String,
}

/// One step of the way from the scene file to the place of a diagnostic.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// What was entered: `` macro `Tower` `` or `` include file `colors.inc` ``.
    pub what: String,
    /// Where it was called or included.
    pub span: Span,
}

/// One message about a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// How bad it is.
    pub severity: Severity,
    /// What it is about.
    pub code: Code,
    /// What is wrong: lower case, no full stop, the thing in backticks.
    pub message: String,
    /// Where; `None` when it concerns the scene as a whole.
    pub span: Option<Span>,
    /// What to see at that place, when the message does not say it.
    pub label: String,
    /// Other places that matter.
    pub labels: Vec<Label>,
    /// How to mend it.
    pub help: Option<String>,
    /// The way there, innermost step first.
    pub trace: Vec<Step>,
}

impl Diagnostic {
    /// A diagnostic that says no more than its message.
    pub fn new(severity: Severity, span: impl Into<Option<Span>>, message: impl Into<String>) -> Diagnostic {
        Diagnostic {
            severity,
            code: Code::of(severity),
            message: message.into(),
            span: span.into(),
            label: String::new(),
            labels: Vec::new(),
            help: None,
            trace: Vec::new(),
        }
    }

    /// Says what it is about.
    pub fn code(mut self, code: Code) -> Diagnostic {
        self.code = code;
        self
    }

    /// Says what is to be seen at the place itself.
    pub fn label(mut self, text: impl Into<String>) -> Diagnostic {
        self.label = text.into();
        self
    }

    /// Points at another place.
    pub fn see(mut self, span: Span, text: impl Into<String>) -> Diagnostic {
        self.labels.push(Label { span, text: text.into() });
        self
    }

    /// Says how to mend it.
    pub fn help(mut self, text: impl Into<String>) -> Diagnostic {
        self.help = Some(text.into());
        self
    }
}

/// The word among the known ones that somebody probably meant: close in spelling, or the same in
/// another case.
pub fn closest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    // Of a very short word everything is close to everything.
    let allowed = match word.chars().count() {
        0..=2 => 0,
        length => (length / 3).max(1),
    };
    known
        .into_iter()
        .filter(|other| *other != word)
        .map(|other| {
            let same = other.eq_ignore_ascii_case(word);
            (if same { 0 } else { strsim::damerau_levenshtein(word, other) }, other)
        })
        .filter(|&(distance, _)| distance <= allowed)
        .min_by_key(|&(distance, other)| (distance, other.len().abs_diff(word.len())))
        .map(|(_, other)| other)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_closest_word_forgives_a_slip_but_not_another_word() {
        let known = ["sphere", "spheric", "torus", "x"];
        assert_eq!(closest("shpere", known), Some("sphere"));
        assert_eq!(closest("Torus", known), Some("torus"));
        assert_eq!(closest("banana", known), None);
    }
}
