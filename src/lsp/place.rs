//! Places as the protocol has them: addresses of files, lines and columns from zero, columns in units of UTF-16.

use crate::source::{Source, Span};
use lsp_types::{Position, Range, Uri};
use std::path::{Path, PathBuf};

/// The file an address names, if it names one.
pub(super) fn path(uri: &str) -> Option<PathBuf> {
    let encoded = uri.strip_prefix("file://")?;
    let bytes = encoded.as_bytes();
    let mut decoded = Vec::with_capacity(bytes.len());
    let mut at = 0;
    while at < bytes.len() {
        let hex = encoded.get(at + 1..at + 3).filter(|_| bytes[at] == b'%');
        let byte = hex.and_then(|hex| u8::from_str_radix(hex, 16).ok());
        decoded.push(byte.unwrap_or(bytes[at]));
        at += if byte.is_some() { 3 } else { 1 };
    }
    let path = String::from_utf8(decoded).ok()?;
    // `/C:/scene.pov` is a file of Windows.
    let drive = path.as_bytes().get(2) == Some(&b':');
    Some(PathBuf::from(if drive { &path[1..] } else { &path[..] }))
}

/// The address of a file.
pub(super) fn uri(path: &Path) -> Option<Uri> {
    let path = std::path::absolute(path).ok()?;
    crate::diag::uri(path.to_str()?).parse().ok()
}

/// Where a byte of a text is.
pub(super) fn position(text: &str, offset: usize) -> Position {
    let before = &text[..text.floor_char_boundary(offset)];
    let line_start = before.rfind('\n').map_or(0, |at| at + 1);
    let line = before.bytes().filter(|&byte| byte == b'\n').count();
    Position::new(line as u32, before[line_start..].encode_utf16().count() as u32)
}

/// The byte at a position; beyond a line's end it is that.
pub(super) fn offset(text: &str, position: Position) -> usize {
    let line_start = match position.line.checked_sub(1) {
        None => 0,
        Some(before) => match text.match_indices('\n').nth(before as usize) {
            Some((at, _)) => at + 1,
            None => return text.len(),
        },
    };
    let line = text[line_start..].split('\n').next().unwrap_or_default().trim_end_matches('\r');
    let mut units = 0;
    for (at, c) in line.char_indices() {
        if units >= position.character {
            return line_start + at;
        }
        units += c.len_utf16() as u32;
    }
    line_start + line.len()
}

/// Where a span of a source is.
pub(super) fn range(source: &Source, span: Span) -> Range {
    Range::new(position(source.text(), span.start as usize), position(source.text(), span.end as usize))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_count_units_of_utf16() {
        let text = "a\r\n𝄞é b\nc";
        for (offset, line, column) in [(0, 0, 0), (3, 1, 0), (7, 1, 2), (9, 1, 3), (12, 2, 0), (13, 2, 1)] {
            assert_eq!(position(text, offset), Position::new(line, column), "{offset}");
            assert_eq!(super::offset(text, Position::new(line, column)), offset, "{offset}");
        }
        assert_eq!(super::offset(text, Position::new(0, 99)), 1);
        assert_eq!(super::offset(text, Position::new(99, 0)), text.len());
    }

    #[test]
    fn addresses_lead_to_files_and_back() {
        let file = path("file:///a%20b/%C3%A9.pov").unwrap();
        assert_eq!(file, PathBuf::from("/a b/é.pov"));
        assert_eq!(uri(&file).unwrap().as_str(), "file:///a%20b/%C3%A9.pov");
        assert_eq!(path("untitled:1"), None);
        assert_eq!(path("file:///a%zz"), Some(PathBuf::from("/a%zz")));
    }
}
