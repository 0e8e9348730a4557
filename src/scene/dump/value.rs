//! Numbers, vectors, colours and transforms as text.

use crate::math::{DAffine3, DMat3, DVec2, DVec3, DVec4, Gamma, Rgb, Rgbft, Transform};

/// A transfer curve.
pub(super) fn gamma(gamma: Gamma) -> String {
    match gamma {
        Gamma::Srgb => "srgb".to_owned(),
        Gamma::Power(exponent) => number(exponent),
    }
}

/// A number with six significant digits; what is nearly zero is zero.
pub(super) fn number(value: impl Into<f64>) -> String {
    /// Smaller numbers are what is left of rounding.
    const NEARLY_ZERO: f64 = 1e-12;
    let value = value.into();
    if !value.is_finite() {
        return value.to_string();
    }
    if value.abs() < NEARLY_ZERO {
        return "0".to_owned();
    }
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    if (1e-5..1e9).contains(&rounded.abs()) { format!("{rounded}") } else { format!("{rounded:e}") }
}

/// `<a, b, …>`.
pub(super) fn vector(components: &[f64]) -> String {
    let numbers: Vec<_> = components.iter().map(|&c| number(c)).collect();
    format!("<{}>", numbers.join(", "))
}

/// Two components.
pub(super) fn vec2(v: DVec2) -> String {
    vector(&v.to_array())
}

/// Three components.
pub(super) fn vec3(v: DVec3) -> String {
    vector(&v.to_array())
}

/// Four components.
pub(super) fn vec4(v: DVec4) -> String {
    vector(&v.to_array())
}

/// `rgb <r, g, b>`.
pub(super) fn rgb(color: Rgb) -> String {
    format!("rgb {}", vector(&color.to_array().map(f64::from)))
}

/// A colour in the shortest of its forms.
pub(super) fn color(color: Rgbft) -> String {
    let [r, g, b, filter, transmit] = color.to_array().map(f64::from);
    match (filter == 0.0, transmit == 0.0) {
        (true, true) => format!("rgb {}", vector(&[r, g, b])),
        (false, true) => format!("rgbf {}", vector(&[r, g, b, filter])),
        (true, false) => format!("rgbt {}", vector(&[r, g, b, transmit])),
        (false, false) => format!("rgbft {}", vector(&[r, g, b, filter, transmit])),
    }
}

/// `on` or `off`.
pub(super) fn switch(on: bool) -> &'static str {
    if on { "on" } else { "off" }
}

/// A transform as the simplest statement that makes it.
pub(super) fn transform(transform: &Transform) -> String {
    let DAffine3 { matrix3, translation } = transform.forward;
    if matrix3 == DMat3::IDENTITY {
        return format!("translate {}", vec3(translation));
    }
    let diagonal = DVec3::new(matrix3.x_axis.x, matrix3.y_axis.y, matrix3.z_axis.z);
    if translation == DVec3::ZERO && matrix3 == DMat3::from_diagonal(diagonal) {
        return format!("scale {}", vec3(diagonal));
    }
    format!("matrix {}", vector(&transform.forward.to_cols_array()))
}

/// Items with commas between them; of long lists only the first.
pub(super) fn list(items: impl ExactSizeIterator<Item = String>) -> String {
    const MOST: usize = 40;
    let count = items.len();
    let mut text = items.take(MOST).collect::<Vec<_>>().join(", ");
    if count > MOST {
        text.push_str(&format!(" … {} more", count - MOST));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_without_the_rests_of_rounding() {
        assert_eq!(number(0.1f32), "0.1");
        assert_eq!(number(-6.1e-17), "0");
        assert_eq!(number(1.0 / 3.0), "0.333333");
        assert_eq!(number(1e7), "10000000");
        assert_eq!(number(1e10), "1e10");
        assert_eq!(
            transform(&Transform::rotate(DVec3::Z * 90.0)),
            "matrix <0, 1, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0>"
        );
    }

    #[test]
    fn long_lists_are_cut() {
        assert_eq!(list(["a".to_owned(), "b".to_owned()].into_iter()), "a, b");
        assert!(list(vec!["a".to_owned(); 50].into_iter()).ends_with("… 10 more"));
    }
}
