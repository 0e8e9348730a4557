//! Strings and the functions that give them, docs/spec/language.md 1.6, 3.5 and 3.10.

use super::arguments;
use crate::interp::format::{format_component, format_float};
use crate::interp::limits::MOST_CHARACTERS;
use crate::interp::stream::TokenKind;
use crate::interp::value::Value;
use crate::interp::{Charset, Fault, Result, Vm, Word};
use crate::source::Span;
use crate::syntax::Punct;
use std::rc::Rc;
use std::time::{SystemTime, UNIX_EPOCH};

/// Whether a word is a function that gives a string.
pub fn is_function(word: Word) -> bool {
    use Word::*;
    matches!(word, Chr | Concat | Datetime | Str | Strlwr | Strupr | Substr | Vstr)
}

/// The difference of the first code units in which two strings differ; the end counts as 0.
pub fn compare(a: &str, b: &str) -> f64 {
    let unit = |c: Option<char>| c.map_or(0.0, |c| f64::from(u32::from(c)));
    let (mut a, mut b) = (a.chars(), b.chars());
    loop {
        let (left, right) = (a.next(), b.next());
        if left != right || left.is_none() {
            return unit(left) - unit(right);
        }
    }
}

impl Vm<'_> {
    /// Whether the next token starts a string.
    pub fn at_string(&mut self) -> Result<bool> {
        Ok(match self.peek()?.kind {
            TokenKind::Text => true,
            TokenKind::Word(word) => is_function(word),
            TokenKind::Name(_) => self
                .place
                .as_ref()
                .and_then(|place| place.look())
                .is_some_and(|value| matches!(*value, Value::Text(_))),
            _ => false,
        })
    }

    /// Reads a STRING: a literal, a variable or a function.
    pub fn read_string(&mut self) -> Result<Rc<str>> {
        let token = self.peek()?;
        match token.kind {
            TokenKind::Text => {
                self.take(token);
                self.literal(token.span)
            }
            TokenKind::Word(word) if is_function(word) => {
                self.take(token);
                let text = self.inside(|vm| call(vm, word, token.span))?;
                if text.len() > MOST_CHARACTERS {
                    return Err(self.error(token.span, "this string grows too long for memory"));
                }
                self.reserve(text.len(), token.span)?;
                Ok(text)
            }
            _ => {
                let text = self.accept_value(|value| match value {
                    Value::Text(text) => Some(Rc::clone(text)),
                    _ => None,
                })?;
                match text {
                    Some(text) => Ok(text),
                    None if self.at_number()? => {
                        let fault = self.expected("a string");
                        Err(fault.help("`str` makes a string of a number: `str(X, 0, 3)`"))
                    }
                    None => Err(self.expected("a string")),
                }
            }
        }
    }

    /// Reads a STRING that names a file: in a literal, backslashes are ordinary.
    pub fn read_file_name(&mut self) -> Result<String> {
        let token = self.peek()?;
        if token.kind == TokenKind::Text {
            self.take(token);
            let text = self.sources.text(token.span);
            return Ok(text[1..text.len() - 1].replace("\\\"", "\""));
        }
        Ok(self.read_string()?.to_string())
    }

    /// The value of a literal.
    pub(in crate::interp) fn literal(&mut self, span: Span) -> Result<Rc<str>> {
        let text = self.sources.text(span);
        let inner = &text[1..text.len() - 1];
        let plain = inner.is_ascii();
        if plain && !inner.contains('\\') {
            return Ok(inner.into());
        }
        let mut bad = 0;
        let inner = if plain {
            inner.to_owned()
        } else {
            let bytes = self.sources.get(span.file).bytes(inner);
            match self.charset {
                Charset::Utf8 => {
                    let text = String::from_utf8_lossy(&bytes);
                    text.chars().map(|c| if u32::from(c) > 0xffff { '\u{fffd}' } else { c }).collect()
                }
                _ if self.version < 350 => bytes.iter().map(|&b| char::from(b)).collect(),
                _ => {
                    bad = bytes.iter().filter(|b| !b.is_ascii()).count();
                    bytes.iter().map(|&b| if b.is_ascii() { char::from(b) } else { ' ' }).collect()
                }
            }
        };
        if bad > 0 {
            self.possible(
                span,
                "this string is not plain ASCII",
                "say `global_settings { charset utf8 }` first; each other byte is read as a space",
            );
        }
        unescape(&inner).map(Rc::from).map_err(|(at, message)| {
            let start = span.start + 1 + at as u32;
            let place = if plain { Span { start, end: start + 2, ..span } } else { span };
            let help = match message.contains("hexadecimal") {
                true => "such as `\\u0041`",
                false => "write `\\\\` for a backslash",
            };
            self.error(place, message).help(help)
        })
    }
}

/// Replaces escapes; the error says where a bad one is.
fn unescape(text: &str) -> Result<String, (usize, String)> {
    let mut result = String::with_capacity(text.len());
    let mut chars = text.char_indices();
    while let Some((at, c)) = chars.next() {
        if c != '\\' {
            result.push(c);
            continue;
        }
        let Some((_, escape)) = chars.next() else { break };
        result.push(match escape {
            'a' => '\u{7}',
            'b' => '\u{8}',
            't' => '\t',
            'n' => '\n',
            'v' => '\u{b}',
            'f' => '\u{c}',
            'r' => '\r',
            '\'' | '\\' | '"' => escape,
            'u' => {
                let digits =
                    chars.as_str().get(..4).ok_or((at, "`\\u` needs four hexadecimal digits".to_owned()))?;
                chars.nth(3);
                let code = u32::from_str_radix(digits, 16)
                    .map_err(|_| (at, format!("`\\u{digits}` is no hexadecimal number")))?;
                char::from_u32(code).unwrap_or('\u{fffd}')
            }
            _ => return Err((at, format!("there is no escape `\\{escape}`"))),
        });
    }
    Ok(result)
}

/// Reads the arguments of a string function whose name was just taken, and computes it.
fn call(vm: &mut Vm, word: Word, span: Span) -> Result<Rc<str>> {
    let text = match word {
        Word::Chr => {
            let code = arguments(vm, Vm::read_float)?;
            match u16::try_from(code as i64) {
                Ok(code) => char::from_u32(code.into()).unwrap_or('\u{fffd}').to_string(),
                Err(_) => {
                    return Err(vm.error(span.to(vm.last), format!("`chr` takes 0 to 65535, not {code}")));
                }
            }
        }
        Word::Concat => arguments(vm, |vm| {
            let mut text = vm.read_string()?.to_string();
            loop {
                vm.comma()?;
                if vm.peek()?.kind == TokenKind::Punct(Punct::CloseParen) {
                    return Ok(text);
                }
                text.push_str(&vm.read_string()?);
            }
        })?,
        Word::Str => arguments(vm, |vm| {
            let value = vm.read_float()?;
            let (length, precision) = layout(vm)?;
            Ok(format_float(value, length, precision))
        })?,
        Word::Vstr => arguments(vm, |vm| {
            let n = vm.read_int()?.clamp(2, 5);
            vm.comma()?;
            let value = vm.arith(1)?;
            vm.comma()?;
            let separator = vm.read_string()?;
            let (length, precision) = layout(vm)?;
            let parts: Vec<String> =
                value.c[..n as usize].iter().map(|&c| format_component(c, length, precision)).collect();
            Ok(parts.join(&separator))
        })?,
        Word::Substr => {
            let (text, start, count) = arguments(vm, |vm| {
                let text = vm.read_string()?;
                vm.comma()?;
                let start = vm.read_int()?;
                vm.comma()?;
                Ok((text, i64::from(start), i64::from(vm.read_int()?)))
            })?;
            let length = text.chars().count() as i64;
            if start < 0 || count < 0 || start + count - 1 > length {
                let message =
                    format!("`substr` from {start}, {count} long, reaches outside a string of {length}");
                return Err(vm.error(span.to(vm.last), message).help("positions count from 1"));
            }
            text.chars().skip((start - 1).max(0) as usize).take(count as usize).collect()
        }
        Word::Strupr | Word::Strlwr => {
            let text = arguments(vm, Vm::read_string)?;
            if !text.is_ascii() {
                vm.warn(span.to(vm.last), format!("`{}` changes ASCII letters only", word.text()), "");
            }
            if word == Word::Strupr { text.to_ascii_uppercase() } else { text.to_ascii_lowercase() }
        }
        _ => datetime(vm, span)?,
    };
    Ok(text.into())
}

fn layout(vm: &mut Vm) -> Result<(i32, i32)> {
    vm.comma()?;
    let length = vm.read_int()?;
    vm.comma()?;
    Ok((length, vm.read_int()?))
}

fn datetime(vm: &mut Vm, span: Span) -> Result<String> {
    let (days, format) = arguments(vm, |vm| {
        let days = vm.read_float()?;
        vm.comma()?;
        let format = if vm.at_string()? { vm.read_string()? } else { "%Y-%m-%d %H:%M:%SZ".into() };
        Ok((days, format))
    })?;
    let fail = |vm: &mut Vm, message: &str| -> Fault { vm.error(span.to(vm.last), message) };
    match crate::interp::format::format_date(days, &format) {
        Some(text) if text.is_empty() || text.len() > 200 => {
            Err(fail(vm, "`datetime` has to give 1 to 200 characters"))
        }
        Some(text) => Ok(text),
        None => Err(fail(vm, "`datetime` cannot be written this way")),
    }
}

/// Days since the start of 2000, UTC.
pub fn days_now() -> f64 {
    const SECONDS_TO_2000: f64 = 946_684_800.0;
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0.0, |d| d.as_secs_f64());
    (seconds - SECONDS_TO_2000) / 86_400.0
}

/// The number a string starts with, as the C library reads it; 0 where there is none.
pub fn leading_number(text: &str) -> f64 {
    let text = text.trim_start();
    let (sign, digits) = match text.strip_prefix(['-', '+']) {
        Some(rest) => (if text.starts_with('-') { -1.0 } else { 1.0 }, rest),
        None => (1.0, text),
    };
    let lower = digits.to_ascii_lowercase();
    if let Some(hex) = lower.strip_prefix("0x") {
        let end = hex.find(|c: char| !c.is_ascii_hexdigit()).unwrap_or(hex.len());
        return sign
            * hex[..end]
                .bytes()
                .fold(0.0, |n, b| n * 16.0 + f64::from(char::from(b).to_digit(16).unwrap_or(0)));
    }
    if lower.starts_with("inf") {
        return sign * f64::INFINITY;
    }
    if lower.starts_with("nan") {
        return f64::NAN;
    }
    // The longest start that is a number: at most sign, digits, point, digits, exponent.
    let end =
        digits.find(|c: char| !matches!(c, '0'..='9' | '.' | 'e' | 'E' | '+' | '-')).unwrap_or(digits.len());
    let number = (1..=end).rev().find_map(|end| digits[..end].parse::<f64>().ok());
    number.map_or(0.0, |number| sign * number)
}
