//! Colors, docs/spec/language.md 3.4.

use crate::interp::stream::{Token, TokenKind};
use crate::interp::tuple::Tuple;
use crate::interp::value::Value;
use crate::interp::{Result, Vm, Word};
use crate::math::gamma::Gamma;
use crate::source::Span;

/// Whether a word starts a color.
pub fn is_keyword(word: Word) -> bool {
    matches!(word, Word::Color | Word::Colour) || form(word).is_some() || component(word).is_some()
}

/// How many components follow `rgb` and its kin, and whether they are in sRGB encoding.
fn form(word: Word) -> Option<(u8, bool)> {
    Some(match word {
        Word::Rgb => (3, false),
        Word::Rgbf | Word::Rgbt => (4, false),
        Word::Rgbft => (5, false),
        Word::Srgb => (3, true),
        Word::Srgbf | Word::Srgbt => (4, true),
        Word::Srgbft => (5, true),
        _ => return None,
    })
}

/// Which component `red` and its kin set.
fn component(word: Word) -> Option<usize> {
    Some(match word {
        Word::Red => 0,
        Word::Green => 1,
        Word::Blue => 2,
        Word::Filter | Word::Alpha => 3,
        Word::Transmit => 4,
        _ => return None,
    })
}

impl Vm<'_> {
    /// Whether the next token starts a color: a keyword, or a variable with five components.
    pub fn at_color(&mut self) -> Result<bool> {
        Ok(match self.peek()?.kind {
            TokenKind::Word(word) => is_keyword(word),
            TokenKind::Name(_) => self
                .place
                .as_ref()
                .and_then(|place| place.look())
                .is_some_and(|value| matches!(*value, Value::Color(_))),
            _ => false,
        })
    }

    /// Reads a COLOUR: red, green, blue, filter, transmit. A scalar without keyword is repeated
    /// in all five.
    pub fn read_color(&mut self) -> Result<[f64; 5]> {
        Ok(self.read_color_sized(5)?.c)
    }

    /// Reads a color where filter and transmit mean nothing.
    pub fn read_rgb(&mut self) -> Result<[f64; 3]> {
        let start = self.peek()?.span;
        let [r, g, b, filter, transmit] = self.read_color_sized(3)?.c;
        if filter != 0.0 || transmit != 0.0 {
            self.warn(
                start.to(self.last),
                "filter and transmit mean nothing here",
                "write the color with `rgb`",
            );
        }
        Ok([r, g, b])
    }

    fn read_color_sized(&mut self, n: u8) -> Result<Tuple> {
        let mut c = [0.0; 5];
        let start = self.peek()?;
        let mut parts = 0;
        if matches!(start.kind, TokenKind::Word(Word::Color | Word::Colour)) {
            self.take(start);
        }
        loop {
            let token = if parts > 0 && self.blocked { self.peek_raw() } else { self.peek()? };
            let word = match token.kind {
                TokenKind::Word(word) if parts > 0 || is_keyword(word) => word,
                // Nothing is black.
                _ if parts == 0 && !self.at_number()? => break,
                _ if parts == 0 => {
                    c = self.full(n)?.padded(n).c;
                    parts = 1;
                    continue;
                }
                _ => break,
            };
            if let Some((wanted, encoded)) = form(word).filter(|_| parts == 0) {
                self.take(token);
                c = self.read_form(token, word, wanted, encoded)?;
            } else if let Some(index) = component(word) {
                self.take(token);
                if word == Word::Alpha {
                    self.deprecated(
                        token.span,
                        "`alpha` is an old word for `filter`",
                        "write `filter`, or `transmit` if that was meant",
                    );
                }
                // Where operators are not looked for, they are not after a component either.
                let start = self.peek()?.span;
                let value = self.arith(1)?;
                c[index] = self.fit(value, 1, "a float", start)?.c[0];
            } else {
                break;
            }
            parts += 1;
        }
        Ok(Tuple { n: 5, c: c.map(|c| f64::from(c as f32)) })
    }

    fn read_form(&mut self, keyword: Token, word: Word, wanted: u8, encoded: bool) -> Result<[f64; 5]> {
        let value = self.full(wanted)?;
        if value.n > wanted {
            let message = format!("`{}` has {wanted} components, but {} are given", word.text(), value.n);
            self.warn(keyword.span.to(self.last), message, "the rest sets filter and transmit");
        }
        let mut c = value.padded(wanted).c;
        if matches!(word, Word::Rgbt | Word::Srgbt) && value.n <= 4 {
            c.swap(3, 4);
        }
        if encoded {
            let gamma = self.working_gamma(keyword.span)?;
            for c in &mut c[..3] {
                // In single precision, as POV-Ray's colours are.
                *c = f64::from(Gamma::Srgb.convert(*c as f32, gamma));
            }
        }
        Ok(c)
    }

    /// The gamma colors are calculated in, for `srgb`.
    fn working_gamma(&mut self, span: Span) -> Result<Gamma> {
        self.gamma.ok_or_else(|| {
            let fault = self.error(span, "`srgb` colors need to know `assumed_gamma`");
            fault.help("write `global_settings { assumed_gamma 1 }` before the first of them")
        })
    }
}
