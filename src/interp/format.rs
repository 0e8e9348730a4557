//! Numbers and dates as the C library writes them.

use chrono::format::{Item, StrftimeItems};
use chrono::{DateTime, TimeDelta, Utc};

/// What `str` may give before it falls back to the short form.
const LONGEST: usize = 254;

/// `str(value, length, precision)`: fixed notation, padded on the left with spaces, or with zeros
/// to `-length`; six decimals when `precision` is negative.
pub fn format_float(value: f64, length: i32, precision: i32) -> String {
    let precision = if precision < 0 { 6 } else { precision as usize };
    let width = length.unsigned_abs() as usize;
    let digits = if value.is_finite() && value.abs() >= 10.0 { value.abs().log10() as usize + 1 } else { 1 };
    if digits + 2 + precision.min(1000) > LONGEST || width > LONGEST {
        pad(general(value, precision.min(LONGEST)), width.min(LONGEST), length < 0)
    } else {
        pad(fixed(value, precision), width, length < 0)
    }
}

/// A component of `vstr`: what it may give is not limited as that of `str` is.
pub fn format_component(value: f64, length: i32, precision: i32) -> String {
    /// Digits and width that no number needs.
    const SENSELESS: i32 = 1000;
    if precision > SENSELESS || length.abs() > SENSELESS {
        return format_float(value, length, precision);
    }
    let precision = if precision < 0 { 6 } else { precision as usize };
    pad(fixed(value, precision), length.unsigned_abs() as usize, length < 0)
}

/// Appends the same to a text.
pub fn append_float(text: &mut String, value: f64, length: i32, precision: i32) {
    /// What is so near the middle between two results that the exact digits decide.
    const DOUBT: f64 = 1e-3;
    let power = usize::try_from(precision).ok().and_then(|p| [1.0, 10.0, 1e2, 1e3, 1e4, 1e5, 1e6].get(p));
    let scaled = power.map_or(f64::INFINITY, |power| value * power);
    // Below that the product is exact to far less than the doubt.
    let far = scaled.is_nan() || scaled.abs() >= 1e12;
    if length != 0 || far || ((scaled - scaled.floor()) - 0.5).abs() < DOUBT {
        return text.push_str(&format_float(value, length, precision));
    }
    let (power, rounded) = (power.map_or(1, |&power| power as u64), scaled.round().abs() as u64);
    if value.is_sign_negative() {
        text.push('-');
    }
    append_digits(text, rounded / power, 1);
    if precision > 0 {
        text.push('.');
        append_digits(text, rounded % power, precision as usize);
    }
}

/// Appends a whole number with so many digits or more.
fn append_digits(text: &mut String, number: u64, least: usize) {
    let mut digits = [b'0'; 20];
    let (mut first, mut rest) = (digits.len(), number);
    while rest > 0 || digits.len() - first < least {
        first -= 1;
        digits[first] = b'0' + (rest % 10) as u8;
        rest /= 10;
    }
    text.push_str(str::from_utf8(&digits[first..]).unwrap_or_default());
}

fn fixed(value: f64, precision: usize) -> String {
    special(value).unwrap_or_else(|| format!("{value:.precision$}"))
}

/// `%g`.
pub fn general(value: f64, precision: usize) -> String {
    if let Some(text) = special(value) {
        return text;
    }
    let precision = precision.max(1);
    let scientific = format!("{value:.*e}", precision - 1);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let trim = |text: &str| match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text.to_owned(),
    };
    if exponent < -4 || exponent >= precision as i32 {
        let sign = if exponent < 0 { '-' } else { '+' };
        format!("{}e{sign}{:02}", trim(mantissa), exponent.abs())
    } else {
        let decimals = (precision as i32 - 1 - exponent).max(0) as usize;
        trim(&format!("{value:.decimals$}"))
    }
}

fn special(value: f64) -> Option<String> {
    let sign = if value.is_sign_negative() { "-" } else { "" };
    if value.is_nan() {
        Some(format!("{sign}nan"))
    } else if value.is_infinite() {
        Some(format!("{sign}inf"))
    } else {
        None
    }
}

fn pad(text: String, width: usize, zeros: bool) -> String {
    let missing = width.saturating_sub(text.chars().count());
    let finite = text.ends_with(|c: char| c.is_ascii_digit());
    match text.strip_prefix('-') {
        Some(digits) if zeros && finite => format!("-{}{digits}", "0".repeat(missing)),
        None if zeros && finite => "0".repeat(missing) + &text,
        _ => " ".repeat(missing) + &text,
    }
}

/// The date so many days after the start of 2000 (UTC), by a `strftime` format; `None` where the
/// date or the format makes no sense.
pub fn format_date(days: f64, format: &str) -> Option<String> {
    let start: DateTime<Utc> = DateTime::from_timestamp(946_684_800, 0)?;
    let seconds = (days * 86_400.0 + 0.5).floor();
    if seconds.abs() > 1e12 {
        return None;
    }
    let date = start.checked_add_signed(TimeDelta::try_seconds(seconds as i64)?)?;
    let items: Vec<Item> = StrftimeItems::new(format).collect();
    if items.contains(&Item::Error) {
        return None;
    }
    Some(date.format_with_items(items.iter()).to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floats_are_written_as_c_writes_them() {
        assert_eq!(format_float(2.5, 0, 0), "2");
        assert_eq!(format_float(3.5, 0, 0), "4");
        assert_eq!(format_float(3.141_58, -10, 3), "000003.142");
        assert_eq!(format_float(1.0 / 3.0, 0, 20), "0.33333333333333331483");
        assert_eq!(format_float(1e300, 0, 2), "1e+300");
        assert_eq!(format_float(-0.0, 0, 2), "-0.00");
        assert_eq!(format_float(-f64::NAN, 0, 2), "-nan");
    }

    #[test]
    fn the_general_form_is_the_shorter_one() {
        let short = |v| general(v, 6);
        assert_eq!([short(1.0 / 3.0), short(1e10), short(123456789.0)], ["0.333333", "1e+10", "1.23457e+08"]);
        assert_eq!([short(100000.0), short(0.0001), short(0.00001)], ["100000", "0.0001", "1e-05"]);
    }

    #[test]
    fn dates_count_from_the_start_of_2000() {
        assert_eq!(format_date(0.0, "%Y-%m-%d %H:%M:%SZ").as_deref(), Some("2000-01-01 00:00:00Z"));
        assert_eq!(format_date(1.5, "%H:%M:%S").as_deref(), Some("12:00:00"));
    }

    #[test]
    fn what_is_written_fast_is_what_is_written_exactly() {
        let mut state = 3_u64;
        for round in 0..200_000_u64 {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            let whole = (state >> 40) as f64 - 8_000_000.0;
            let value = match round % 4 {
                0 => whole,
                1 => whole / 8.0,
                2 => whole / 1000.0,
                _ => f64::from_bits(state >> 2),
            };
            for precision in -1..=8 {
                let mut text = String::new();
                append_float(&mut text, value, 0, precision);
                assert_eq!(text, format_float(value, 0, precision), "{value:?} with {precision}");
            }
        }
    }
}
