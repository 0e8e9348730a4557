//! What names held where they stand, for those who look at a scene while it is written.

use super::value::{Array, Value};
use super::{Vm, format};
use crate::source::Span;
use rustc_hash::FxHashMap;

/// Characters of a text that are shown.
const MOST_CHARACTERS: usize = 200;
/// Elements of an array that are shown.
const MOST_ELEMENTS: usize = 8;
/// Significant digits of numbers, as many as `float` shows without noise.
const DIGITS: usize = 10;
/// Times that an array is looked at at one place: it may be big, and change with every turn of a loop.
const MOST_LOOKS: u32 = 32;

/// What names held when they were last read or declared, by where they stand.
#[derive(Debug, Default)]
pub struct Notes {
    notes: FxHashMap<Span, Note>,
}

#[derive(Debug)]
struct Note {
    held: Held,
    looks: u32,
}

#[derive(Debug)]
enum Held {
    Value(Value),
    /// An array is described at once: to keep it would make the scene copy it.
    Described(String),
}

impl Notes {
    /// What the name at a place held last, in the words of the language as far as it has any.
    pub fn at(&self, span: Span) -> Option<String> {
        self.notes.get(&span).map(|note| match &note.held {
            Held::Value(value) => describe(value),
            Held::Described(text) => text.clone(),
        })
    }

    fn take(&mut self, span: Span, value: &Value) {
        let looks = self.notes.get(&span).map_or(0, |note| note.looks);
        let held = match value {
            Value::Array(_) if looks >= MOST_LOOKS => return,
            Value::Array(array) => Held::Described(describe_array(array)),
            value => Held::Value(value.clone()),
        };
        self.notes.insert(span, Note { held, looks: looks + 1 });
    }
}

impl Vm<'_> {
    /// Notes what the name at hand holds, if anybody wants to know.
    #[inline]
    pub(super) fn note_place(&mut self, span: Span) {
        if let (Some(notes), Some(place)) = (&mut self.notes, &self.place)
            && let Some(value) = place.look()
        {
            notes.take(span, &value);
        }
    }

    /// Notes what is declared.
    pub(super) fn note_declared(&mut self, span: Span, value: &Value) {
        if let Some(notes) = &mut self.notes {
            notes.take(span, value);
        }
    }
}

/// A value in the words of the language, or what it is.
pub fn describe(value: &Value) -> String {
    match value {
        Value::Float(number) => float(*number),
        Value::Vector2(v) => vector(v),
        Value::Vector3(v) => vector(v),
        Value::Vector4(v) => vector(&v[..]),
        Value::Color(c) => color(c),
        Value::Text(text) => quoted(text),
        Value::Array(array) => describe_array(array),
        Value::Function(function) => format!("a function of {} parameters", function.parameters),
        value => value.kind().to_owned(),
    }
}

fn float(number: f64) -> String {
    format::general(number, DIGITS)
}

fn vector(components: &[f64]) -> String {
    let components: Vec<String> = components.iter().map(|&c| float(c)).collect();
    format!("<{}>", components.join(", "))
}

/// Single precision has fewer digits.
fn color(&[r, g, b, filter, transmit]: &[f32; 5]) -> String {
    let (keyword, parts) = match (filter == 0.0, transmit == 0.0) {
        (true, true) => ("rgb", vec![r, g, b]),
        (false, true) => ("rgbf", vec![r, g, b, filter]),
        (true, false) => ("rgbt", vec![r, g, b, transmit]),
        (false, false) => ("rgbft", vec![r, g, b, filter, transmit]),
    };
    let parts: Vec<String> = parts.into_iter().map(|c| c.to_string()).collect();
    format!("{keyword} <{}>", parts.join(", "))
}

fn quoted(text: &str) -> String {
    let shown: String = text.chars().take(MOST_CHARACTERS).collect();
    let more = if shown.len() < text.len() { "…" } else { "" };
    format!("\"{}{more}\"", shown.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\n"))
}

fn describe_array(array: &Array) -> String {
    let sizes: String = array.sizes.iter().map(|size| format!("[{size}]")).collect();
    let elements: Vec<String> = (0..array.len().min(MOST_ELEMENTS))
        .map(|index| match array.get(index) {
            Some(Value::Array(inner)) => inner.sizes.iter().map(|size| format!("[{size}]")).collect(),
            Some(value) => describe(value),
            None => "not set".to_owned(),
        })
        .collect();
    let more = if array.len() > MOST_ELEMENTS { ", …" } else { "" };
    format!("array{sizes} {{ {}{more} }}", elements.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::Collect;
    use crate::interp::interpret_noting;
    use crate::options::LanguageOptions;
    use crate::source::{Library, Source, Sources};

    /// What the name at each place of a text held.
    fn held(text: &str, place: &str, length: u32) -> Option<String> {
        let mut sources = Sources::new(Library::default());
        let main = sources.add(Source::new("a.pov", "", text.into()));
        let mut sink = Collect::default();
        let (_, notes) = interpret_noting(main, &mut sources, &LanguageOptions::default(), &mut sink);
        let start = text.find(place).unwrap() as u32;
        notes.at(Span { file: main, start, end: start + length })
    }

    #[test]
    fn a_name_holds_what_it_held_last_at_its_place() {
        let text =
            "#declare A = 1; #declare B = A + 0.5; #for (I, 1, 5) #declare A = A + I; #end #declare C = A;";
        assert_eq!(held(text, "A = 1", 1).as_deref(), Some("1"));
        assert_eq!(held(text, "B", 1).as_deref(), Some("1.5"));
        assert_eq!(held(text, "A + I", 1).as_deref(), Some("11"));
        assert_eq!(held(text, "A;", 1).as_deref(), Some("16"));
        assert_eq!(held(text, "or", 2), None);
    }

    #[test]
    fn values_are_told_in_the_words_of_the_language() {
        let rows = [
            ("<1, 2.5, -3>", "<1, 2.5, -3>"),
            ("rgbt <1, 0, 0.5, 0.1>", "rgbt <1, 0, 0.5, 0.1>"),
            ("\"say \\\"x\\\"\"", "\"say \\\"x\\\"\""),
            ("array[2][2] { { 1, 2 }, { 3, 4 } }", "array[2][2] { 1, 2, 3, 4 }"),
            ("function(a, b) { a*b }", "a function of 2 parameters"),
            ("sphere { 0, 1 }", "an object"),
        ];
        for (written, expected) in rows {
            let text = format!("#declare Name = {written};");
            assert_eq!(held(&text, "Name", 4).as_deref(), Some(expected));
        }
    }
}
