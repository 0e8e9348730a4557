//! Where the tokens of a scene are, as far as a mistake needs it.

use std::ops::Range;

/// The places of the tokens of a text; comments and blanks are none.
pub(crate) fn ranges(text: &str) -> Vec<Range<usize>> {
    let bytes = text.as_bytes();
    let mut ranges = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        let end = end(bytes, at);
        let comment = bytes[at..].starts_with(b"//") || bytes[at..].starts_with(b"/*");
        if !comment && !bytes[at].is_ascii_whitespace() {
            ranges.push(at..end);
        }
        at = end;
    }
    ranges
}

/// The end of what starts at a place.
fn end(bytes: &[u8], start: usize) -> usize {
    let after = |mut at: usize, goes_on: &dyn Fn(u8) -> bool| {
        while at < bytes.len() && goes_on(bytes[at]) {
            at += 1;
        }
        at
    };
    let word = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
    match bytes[start] {
        byte if byte.is_ascii_whitespace() => start + 1,
        b'/' if bytes[start..].starts_with(b"//") => after(start, &|byte| byte != b'\n'),
        b'/' if bytes[start..].starts_with(b"/*") => {
            let (mut at, mut depth) = (start, 0);
            while at < bytes.len() {
                match &bytes[at..(at + 2).min(bytes.len())] {
                    b"/*" => (at, depth) = (at + 2, depth + 1),
                    b"*/" => (at, depth) = (at + 2, depth - 1),
                    _ => at += 1,
                }
                if depth == 0 {
                    break;
                }
            }
            at
        }
        b'"' => {
            let mut at = start + 1;
            while at < bytes.len() && bytes[at] != b'"' {
                at += if bytes[at] == b'\\' { 2 } else { 1 };
            }
            (at + 1).min(bytes.len())
        }
        b'#' => {
            let name = after(start + 1, &|byte| byte == b' ' || byte == b'\t');
            after(name, &|byte| byte.is_ascii_lowercase())
        }
        b'0'..=b'9' | b'.' => {
            let at = after(start, &|byte| byte.is_ascii_digit());
            let at =
                if bytes.get(at) == Some(&b'.') { after(at + 1, &|byte| byte.is_ascii_digit()) } else { at };
            at.max(start + 1)
        }
        byte if word(byte) => after(start, &word),
        b'<' | b'>' | b'!' if bytes.get(start + 1) == Some(&b'=') => start + 2,
        _ => start + 1,
    }
}
