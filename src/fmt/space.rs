//! Which blanks stand between two pieces of a line.

use super::piece::Kind;
use crate::syntax::Punct;

/// What stands between two pieces of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Gap {
    /// Nothing.
    None,
    /// A blank, or more that line things up.
    Blank,
    /// Nothing, a blank or more: as it was written.
    AsWritten,
}

/// What stands between two neighbours.
pub(super) fn gap(left: Kind, right: Kind) -> Gap {
    use Kind::*;
    use Punct::*;
    match (left, right) {
        (_, LineComment) => Gap::Blank,
        (BlockComment, _) | (_, BlockComment) => Gap::AsWritten,
        (Sign, Number) => Gap::None,
        (_, Mark(Comma | Semicolon)) => Gap::None,
        (Mark(OpenBrace), Mark(CloseBrace)) => Gap::AsWritten,
        (Mark(CloseBrace), Mark(CloseParen | CloseBracket)) => Gap::AsWritten,
        (Mark(OpenParen | OpenBracket), Mark(OpenBrace)) => Gap::AsWritten,
        (Mark(Comma | Semicolon | OpenBrace | CloseBrace), _) => Gap::Blank,
        (_, Mark(OpenBrace | CloseBrace)) => Gap::Blank,
        (Directive(_), _) | (_, Directive(_)) => Gap::Blank,
        (Assign, _) | (_, Assign) => Gap::Blank,
        (Word, OpenVector | Text) | (CloseVector | Text, Word) => Gap::Blank,
        _ => Gap::AsWritten,
    }
}
