//! A scene as text: every field that says something, one to a line, nested as the scene is.

use super::Scene;

impl Scene {
    /// The scene as text, the same on every machine.
    ///
    /// Places in files and fields that say nothing (`None`, `false`, empty lists) are left out.
    pub fn dump(&self) -> String {
        tidy(&format!("{self:#?}"))
    }
}

/// What an item of pretty-printed text is left out for.
const NOTHING: [&str; 5] = ["None,", "false,", "[],", "{},", "(empty),"];

/// Leaves out of pretty-printed text what a reader doesn't look for.
fn tidy(text: &str) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let mut tidy = String::new();
    let mut index = 0;
    while let Some(line) = lines.get(index) {
        let content = line.trim_start();
        let indent = line.len() - content.len();
        index += 1;
        let is_span = content.starts_with("span: ") || content.starts_with("Span {");
        if is_span && content.ends_with('{') {
            // The end of an item stands as far to the left as its beginning.
            let end = lines[index..].iter().position(|line| line.len() - line.trim_start().len() <= indent);
            index += end.map_or(0, |end| end + 1);
        } else if !is_span && !content.split_once(": ").is_some_and(|(_, value)| NOTHING.contains(&value)) {
            tidy.push_str(line);
            tidy.push('\n');
        }
    }
    tidy
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_and_empty_fields_are_left_out() {
        let text = "Thing {\n    span: Span {\n        start: 1,\n    },\n    name: \"a\",\n    light: None,\n    hollow: false,\n    parts: [],\n}";
        assert_eq!(tidy(text), "Thing {\n    name: \"a\",\n}\n");
    }
}
