//! A scene as text: every field that says something, nested as the scene is.
//!
//! The text comes from the types' own `Debug`, so nothing can be forgotten: it is taken apart, freed of
//! what a reader doesn't look for, and laid out in lines.

use super::Scene;

/// Longest line an item may take before its parts get lines of their own.
const COLUMNS: usize = 100;

/// Types that are three numbers.
const VECTORS: [&str; 4] = ["DVec2", "DVec3", "Vec3A", "Vec3"];

impl Scene {
    /// The scene as text, the same on every machine.
    ///
    /// Places in files and fields that say nothing (none, no, empty) are left out.
    pub fn dump(&self) -> String {
        let text = format!("{self:?}");
        let mut rest = text.as_str();
        let mut dump = String::new();
        lay_out(&Item::read(&mut rest), 0, &mut dump);
        dump
    }
}

/// A piece of what `Debug` writes.
#[derive(Debug, PartialEq)]
enum Item<'t> {
    /// A word, number or string.
    Plain(&'t str),
    /// A name, perhaps empty, with parts between brackets; a part may have a name of its own.
    Group { name: &'t str, open: char, close: char, parts: Vec<(Option<&'t str>, Item<'t>)> },
}

impl<'t> Item<'t> {
    /// Reads the item a text begins with.
    fn read(rest: &mut &'t str) -> Self {
        *rest = rest.trim_start();
        let plain = plain_length(rest);
        let (name, after) = rest.split_at(plain);
        let opening = after.trim_start();
        let close = match opening.chars().next() {
            Some('{') => '}',
            Some('(') => ')',
            Some('[') => ']',
            _ => {
                *rest = after;
                return Self::Plain(name.trim_end());
            }
        };
        let open = opening.chars().next().unwrap_or('{');
        *rest = &opening[1..];
        let mut parts = Vec::new();
        loop {
            *rest = rest.trim_start().trim_start_matches(',').trim_start();
            if let Some(after) = rest.strip_prefix(close) {
                *rest = after;
                break;
            }
            if rest.is_empty() {
                break;
            }
            let before = *rest;
            let first = Self::read(rest);
            parts.push(match (first, rest.strip_prefix(':')) {
                (Self::Plain(field), Some(after)) => {
                    *rest = after;
                    (Some(field), Self::read(rest))
                }
                (item, _) => (None, item),
            });
            if rest.len() == before.len() {
                // Nothing `Debug` writes comes here; a text that isn't its own must not hang.
                break;
            }
        }
        Self::Group { name: name.trim_end(), open, close, parts }.tidy()
    }

    /// The item without what says nothing.
    fn tidy(self) -> Self {
        match self {
            Self::Group { name: "Some", mut parts, .. } if parts.len() == 1 => parts.remove(0).1,
            Self::Group { name, parts, .. } if VECTORS.contains(&name) => {
                Self::Group { name: "", open: '<', close: '>', parts }
            }
            Self::Group { name, open, close, mut parts } => {
                parts.retain(|(field, item)| {
                    field.is_none_or(|field| field != "span" && !item.says_nothing())
                });
                Self::Group { name, open, close, parts }
            }
            plain @ Self::Plain(_) => plain,
        }
    }

    /// Whether a field with this value isn't worth a line.
    fn says_nothing(&self) -> bool {
        match self {
            Self::Plain(word) => matches!(*word, "None" | "false"),
            Self::Group { open: '[', parts, .. } => parts.is_empty(),
            Self::Group { .. } => false,
        }
    }

    /// The item in one line.
    fn line(&self) -> String {
        match self {
            Self::Plain(word) => (*word).to_owned(),
            Self::Group { name, open, close, parts } => {
                let parts: Vec<String> =
                    parts.iter().map(|(field, item)| named(*field, &item.line())).collect();
                let (gap, pad) =
                    if *open == '{' { (if name.is_empty() { "" } else { " " }, " ") } else { ("", "") };
                format!("{name}{gap}{open}{pad}{}{pad}{close}", parts.join(", "))
            }
        }
    }

    /// An upper limit of the length of its line.
    fn fits(&self, room: usize) -> Option<usize> {
        match self {
            Self::Plain(word) => room.checked_sub(word.len()),
            Self::Group { name, parts, .. } => {
                let room = room.checked_sub(name.len() + 5)?;
                parts.iter().try_fold(room, |room, (field, item)| {
                    item.fits(room.checked_sub(field.map_or(0, |field| field.len() + 2) + 2)?)
                })
            }
        }
    }
}

/// Where the word, number or string a text begins with ends.
fn plain_length(text: &str) -> usize {
    if text.starts_with('"') {
        let mut escaped = false;
        let end = text.char_indices().skip(1).find(|(_, letter)| {
            let ends = *letter == '"' && !escaped;
            escaped = *letter == '\\' && !escaped;
            ends
        });
        return end.map_or(text.len(), |(at, _)| at + 1);
    }
    // A colon ends the name of a field; two belong to a path.
    let bytes = text.as_bytes();
    let ends = |at: usize| match bytes[at] {
        b'{' | b'}' | b'(' | b')' | b'[' | b']' | b',' => true,
        b':' => bytes.get(at + 1) != Some(&b':') && (at == 0 || bytes[at - 1] != b':'),
        _ => false,
    };
    (0..bytes.len()).find(|at| ends(*at)).unwrap_or(bytes.len())
}

/// A part with its name, if it has one.
fn named(field: Option<&str>, text: &str) -> String {
    field.map_or_else(|| text.to_owned(), |field| format!("{field}: {text}"))
}

/// Writes an item, in one line where it fits and with a line for each part where it doesn't.
fn lay_out(item: &Item<'_>, indent: usize, dump: &mut String) {
    match item {
        Item::Group { name, open, close, parts } if item.fits(COLUMNS.saturating_sub(indent)).is_none() => {
            let gap = if *open == '{' && !name.is_empty() { " " } else { "" };
            dump.push_str(&format!("{name}{gap}{open}\n"));
            for (field, part) in parts {
                dump.push_str(&" ".repeat(indent + 2));
                dump.push_str(&named(*field, ""));
                lay_out(part, indent + 2, dump);
                dump.push('\n');
            }
            dump.push_str(&format!("{}{close}", " ".repeat(indent)));
        }
        _ => dump.push_str(&item.line()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tidy(text: &str) -> String {
        let mut rest = text;
        let mut dump = String::new();
        lay_out(&Item::read(&mut rest), 0, &mut dump);
        dump
    }

    #[test]
    fn places_and_empty_fields_are_left_out() {
        let text = r#"Thing { span: Span { file: FileId(0), start: 1 }, name: "a, {\"b\"}", light: None, hollow: false, parts: [], at: Some(DVec3(0.0, 1.0, -2.5)) }"#;
        assert_eq!(tidy(text), r#"Thing { name: "a, {\"b\"}", at: <0.0, 1.0, -2.5> }"#);
    }

    #[test]
    fn long_items_have_a_line_for_each_part() {
        let part = format!("Part {{ name: \"{}\" }}", "x".repeat(60));
        let text = format!("Thing {{ parts: [{part}, {part}], flags: A | B }}");
        assert_eq!(
            tidy(&text),
            format!("Thing {{\n  parts: [\n    {part}\n    {part}\n  ]\n  flags: A | B\n}}")
        );
    }

    #[test]
    fn text_that_ends_early_is_no_endless_loop() {
        for text in ["", "A {", "A(", "\"", "]", "A { b:", "A {: , }"] {
            tidy(text);
        }
    }
}
