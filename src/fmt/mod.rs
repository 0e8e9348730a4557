//! Source in, the same scene neatly laid out.
//!
//! - [`format`](format()) moves blanks and nothing else: the tokens of the text and its comments stay what they are, which is
//!   checked before the text is handed out, and what was laid out once is not changed again.
//! - Lines stay lines. They are indented by the braces, brackets and directives around them, two columns each.
//! - In a line, blanks are set where everybody wants them; wherever two or more stand, somebody lined things up
//!   in columns, and the columns stay.
//! - A text with a mistake in a token is not touched: where its strings and comments end is anybody's guess.

mod indent;
mod layout;
mod piece;
mod same;
mod space;

use crate::diag::Diagnostic;
use crate::source::{FileId, Source};
use crate::syntax::{self, Symbols};

/// Why a text is not laid out.
#[derive(Debug)]
pub enum Refusal {
    /// These mistakes are in its tokens. The spans are in the file given to [`format`](format()).
    Mistakes(Vec<Diagnostic>),
    /// It would mean something else afterwards: a mistake of this module.
    Changed,
}

/// Lays out the text of a file. A text without tokens and comments is empty afterwards, any other ends with a line end.
///
/// ```
/// use povista::{fmt, source};
///
/// let source = source::Source::new("a.pov", "", "sphere{<0,1,0>,2\npigment{rgb<1,0,0>}}".into());
/// let text = fmt::format(source::FileId(0), &source).expect("no mistake in its tokens");
/// assert_eq!(text, "sphere { <0, 1, 0>, 2\n  pigment { rgb <1, 0, 0> } }\n");
/// ```
///
/// # Errors
/// There are mistakes in its tokens.
pub fn format(id: FileId, source: &Source) -> Result<String, Refusal> {
    let mut symbols = Symbols::new([]);
    let tree = syntax::parse(id, source, &mut symbols);
    if !tree.errors.is_empty() {
        return Err(Refusal::Mistakes(tree.errors));
    }
    let pieces = piece::pieces(&tree, source.text());
    let text = layout::lay_out(&pieces, piece::is_guarded(&tree));
    let laid_out = source.with_text(&text);
    let again = syntax::parse(id, &laid_out, &mut symbols);
    if same::is_same((&tree, source.text()), (&again, &text)) { Ok(text) } else { Err(Refusal::Changed) }
}

#[cfg(test)]
mod tests;
