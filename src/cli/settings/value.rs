//! Reading option values as POV-Ray reads them (docs/spec/camera-image.md 16).

/// Reads the number at the start of a text; what follows it is ignored.
///
/// Returns none where the text doesn't start with a number in decimal digits.
pub fn float(text: &str) -> Option<f32> {
    let text = text.trim_start();
    let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let sign = usize::from(text.starts_with(['+', '-']));
    let whole = digits(sign);
    let mut end = sign + whole;
    let mut fraction = 0;
    if text[end..].starts_with('.') {
        fraction = digits(end + 1);
        end += 1 + fraction;
    }
    if whole + fraction == 0 {
        return None;
    }
    if text[end..].starts_with(['e', 'E']) {
        let sign = usize::from(text[end + 1..].starts_with(['+', '-']));
        let exponent = digits(end + 1 + sign);
        if exponent > 0 {
            end += 1 + sign + exponent;
        }
    }
    text[..end].parse().ok()
}

/// Reads the whole number at the start of a text: `103.99` is 103.
pub fn int(text: &str) -> Option<i32> {
    let text = text.trim_start();
    let sign = usize::from(text.starts_with(['+', '-']));
    let digits = text[sign..].bytes().take_while(u8::is_ascii_digit).count();
    text[..sign + digits].parse().ok()
}

/// Reads a truth value: what `on`, `true`, `yes` or `1` starts with, or the other way round, is true.
///
/// So `o` and the empty text are true, as POV-Ray has it.
pub fn truth(text: &str) -> bool {
    ["on", "true", "yes", "1"].iter().any(|word| {
        let length = word.len().min(text.len());
        text.as_bytes()[..length].eq_ignore_ascii_case(&word.as_bytes()[..length])
    })
}

/// Takes a text out of its single or double quotes; the closing one may be missing.
///
/// Returns the text and what follows the closing quote; none where the text isn't quoted.
pub fn quoted(text: &str) -> Option<(&str, &str)> {
    let quote = text.chars().next().filter(|first| matches!(first, '"' | '\''))?;
    Some(text[1..].split_once(quote).unwrap_or((&text[1..], "")))
}

/// A number in single precision and to six significant digits, as a scene gets it.
pub fn six_digits(number: f32) -> f64 {
    format!("{number:.5e}").parse().unwrap_or_else(|_| f64::from(number))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_far_as_they_go() {
        assert_eq!(float("0.010000"), Some(0.01));
        assert_eq!(float(".3.4"), Some(0.3));
        assert_eq!(float("-1.5e3x"), Some(-1500.0));
        assert_eq!(float("3e"), Some(3.0));
        assert_eq!(float(" 7"), Some(7.0));
        assert_eq!(float("1e400"), Some(f32::INFINITY));
        for nothing in ["", ".", "-", "abc", "e3", "é"] {
            assert_eq!(float(nothing), None, "{nothing}");
        }
    }

    #[test]
    fn whole_numbers_are_cut_off() {
        assert_eq!(int("103.99"), Some(103));
        assert_eq!(int("640x"), Some(640));
        assert_eq!(int("1e3"), Some(1));
        assert_eq!(int("+5"), Some(5));
        assert_eq!(int(".5"), None);
        assert_eq!(int("99999999999"), None);
    }

    /// The rows of docs/spec/camera-image.md 16.
    #[test]
    fn short_words_are_true() {
        for yes in ["on", "ON", "1", "10", "yes", "y", "o", "t", "tru", "truely", ""] {
            assert!(truth(yes), "{yes}");
        }
        for no in ["off", "0", "2", "false", "n", " on", "é"] {
            assert!(!truth(no), "{no}");
        }
    }

    #[test]
    fn quotes_end_where_they_began() {
        assert_eq!(quoted("'a\"b' c"), Some(("a\"b", " c")));
        assert_eq!(quoted("\"open"), Some(("open", "")));
        assert_eq!(quoted("plain"), None);
    }

    #[test]
    fn declared_numbers_have_six_digits() {
        assert_eq!(six_digits(0.123_456_79), 0.123457);
        assert_eq!(six_digits(12_345_679.0), 12_345_700.0);
        assert_eq!(six_digits(f32::INFINITY), f64::INFINITY);
        assert!(six_digits(f32::NAN).is_nan());
    }
}
