//! POV-Ray's console is eighty columns wide (docs/spec/camera-image.md 21).

/// Columns of the console.
const COLUMNS: usize = 80;

/// Breaks text into lines as the console does; a break before a word leaves the blank in front of it.
#[derive(Debug, Default)]
pub(super) struct Wrap {
    /// The line so far.
    line: String,
}

impl Wrap {
    /// Takes text and returns the lines that are complete, each ending in a line feed.
    ///
    /// What isn't ASCII becomes `?`, so that no program that reads the console stumbles.
    pub(super) fn push(&mut self, text: &str) -> String {
        let mut lines = String::new();
        for letter in text.chars() {
            match letter {
                '\n' => {
                    lines.push_str(&std::mem::take(&mut self.line));
                    lines.push('\n');
                }
                '\r' => {}
                _ => {
                    if self.line.len() == COLUMNS {
                        // A word longer than half a line is cut instead.
                        let blank =
                            self.line.rfind(' ').filter(|_| letter != ' ').filter(|at| *at > COLUMNS / 2);
                        let rest = self.line.split_off(blank.unwrap_or(COLUMNS));
                        lines.push_str(&std::mem::replace(&mut self.line, rest));
                        lines.push('\n');
                    }
                    self.line.push(if letter.is_ascii() { letter } else { '?' });
                }
            }
        }
        lines
    }

    /// Returns the line that was begun, complete, or nothing.
    pub(super) fn finish(&mut self) -> String {
        if self.line.is_empty() { String::new() } else { std::mem::take(&mut self.line) + "\n" }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wrapped(text: &str) -> String {
        let mut wrap = Wrap::default();
        wrap.push(text) + &wrap.finish()
    }

    /// As POV-Ray prints these.
    #[test]
    fn long_lines_break_before_a_word_and_long_words_anywhere() {
        let words = "0123456789 ".repeat(9);
        assert_eq!(
            wrapped(&format!("{words}end\n")),
            format!("{}\n {}end\n", "0123456789 ".repeat(7).trim_end(), "0123456789 ".repeat(2))
        );
        assert_eq!(wrapped(&"x".repeat(90)), format!("{}\n{}\n", "x".repeat(80), "x".repeat(10)));
        let error = "File 'bad.pov' line 1: Parse Error: Expected 'numeric expression', undeclared identifier 'foo' found instead\n";
        assert_eq!(
            wrapped(error),
            "File 'bad.pov' line 1: Parse Error: Expected 'numeric expression', undeclared\n identifier 'foo' found instead\n"
        );
    }

    #[test]
    fn text_that_comes_in_pieces_is_one_line() {
        let mut wrap = Wrap::default();
        assert_eq!(wrap.push("no newline"), "");
        assert_eq!(wrap.push(" again\n"), "no newline again\n");
        assert_eq!(wrap.finish(), "");
    }

    #[test]
    fn only_ascii_is_printed() {
        assert_eq!(wrapped("\u{201c}na\u{ef}ve\u{201d}\r\n"), "?na?ve?\n");
    }
}
