//! Writes pieces line by line.

use super::indent::Nesting;
use super::piece::{Kind, Piece, is_blank};
use super::space::{Gap, gap};

/// Line ends that stay between two lines: two empty lines at most.
const MOST_LINE_ENDS: usize = 3;

/// The text of a file, given its pieces and whether an `#ifndef` is around all of it.
pub(super) fn lay_out(pieces: &[Piece<'_>], guarded: bool) -> String {
    let mut text = String::new();
    let mut nesting = Nesting::new(guarded);
    let mut before = None;
    for (index, line) in pieces.chunk_by(|_, next| next.lines == 0).enumerate() {
        if index > 0 {
            text.extend(std::iter::repeat_n('\n', line[0].lines.min(MOST_LINE_ENDS)));
        }
        nesting.start_line();
        let indentation = nesting.indentation(line, before);
        text.extend(std::iter::repeat_n(' ', indentation));
        write_line(&mut text, line, indentation, &mut nesting);
        before = line.iter().map(|piece| piece.kind).rfind(|kind| !kind.is_comment()).or(before);
    }
    if !text.is_empty() {
        text.push('\n');
    }
    text
}

fn write_line(text: &mut String, line: &[Piece<'_>], indentation: usize, nesting: &mut Nesting) {
    let mut column = indentation;
    // How far right of its old place everything stands that is lined up.
    let mut moved = indentation as isize - line[0].column as isize;
    for (index, piece) in line.iter().enumerate() {
        let is_comment = piece.kind == Kind::BlockComment;
        write_piece(text, piece, if index == 0 && is_comment { moved } else { 0 }, is_comment);
        let next = line.get(index + 1);
        if let Some(line_end) = piece.text.contains('\n').then(|| text.rfind('\n')).flatten() {
            column = text[line_end + 1..].chars().count();
            moved = next.map_or(0, |next| column as isize - (next.column - next.blanks) as isize);
        } else {
            column += piece.text.chars().count();
        }
        if let Some(next) = next {
            let blanks = blanks(piece, next, column, moved);
            column += blanks;
            text.extend(std::iter::repeat_n(' ', blanks));
        }
        nesting.take(piece.kind, indentation, next.map(|next| (next, column)));
    }
}

/// The blanks between two pieces, the first of which ends at a column.
fn blanks(left: &Piece<'_>, right: &Piece<'_>, column: usize, moved: isize) -> usize {
    let least = match gap(left.kind, right.kind) {
        Gap::None => return 0,
        Gap::Blank => 1,
        Gap::AsWritten => right.blanks.min(1),
    };
    if right.blanks < 2 {
        return least;
    }
    let place = right.column as isize + moved;
    usize::try_from(place - column as isize).unwrap_or(0).max(least)
}

/// Writes a piece; the further lines of a comment go with its first.
fn write_piece(text: &mut String, piece: &Piece<'_>, moved: isize, is_comment: bool) {
    if !is_comment || !piece.text.contains('\n') {
        text.push_str(&piece.text);
        return;
    }
    for (index, line) in piece.text.split('\n').enumerate() {
        let line = line.trim_end_matches(is_blank);
        if index == 0 {
            text.push_str(line);
            continue;
        }
        text.push('\n');
        let inner = line.trim_start_matches(' ');
        if !inner.is_empty() {
            let blanks = (line.len() - inner.len()) as isize + moved;
            text.extend(std::iter::repeat_n(' ', usize::try_from(blanks).unwrap_or(0)));
            text.push_str(inner);
        }
    }
}
