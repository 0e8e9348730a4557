//! Pigments along lines: bounds of their colours, for surfaces that functions of them make.
//!
//! Known are single colours, and maps of colours over patterns of which something is known.

use super::Pigment;
use crate::math::Band;
use crate::math::color::grey;
use crate::math::{Rgb, Rgbft};
use crate::world::sample::Field;

/// More than single precision takes from a colour's components, as a share of the largest.
const ROUNDING: f64 = 4.0 * f32::EPSILON as f64;

impl Pigment {
    /// Whether [`Pigment::along`] says something.
    pub(super) fn is_held(&self) -> bool {
        match self {
            Self::Color(_) => true,
            Self::Colors(pattern, map) => pattern.is_known() && map.entries().is_sorted_by(|a, b| a.0 <= b.0),
            _ => false,
        }
    }

    /// What holds a number made of the colours of points that these hold; `of` has to be linear.
    pub(super) fn along(&self, point: &[Band; 3], of: impl Fn(&Rgbft) -> f64) -> Band {
        match self {
            Self::Color(color) => Band::constant(of(color)),
            Self::Colors(pattern, map) => {
                let points: Vec<_> =
                    map.entries().iter().map(|(at, color)| (f64::from(*at), of(color))).collect();
                let most = points.iter().fold(0.0, |most: f64, (_, value)| most.max(value.abs()));
                let room = Band::between(-most * ROUNDING, most * ROUNDING);
                pattern.enclose(point).broken_line(&points) + room
            }
            _ => Band::UNKNOWN,
        }
    }
}

/// A component, in the order red, green, blue, filter, transmit.
pub(super) fn component(color: &Rgbft, number: u8) -> f64 {
    color.to_array().get(usize::from(number)).copied().map_or(0.0, f64::from)
}

/// The grey of a colour, without its rounding.
pub(super) fn greyness(color: &Rgbft) -> f64 {
    [Rgb::X, Rgb::Y, Rgb::Z].map(|axis| f64::from(grey(axis)) * f64::from(color.rgb.dot(axis))).iter().sum()
}

#[cfg(test)]
mod tests {
    use super::super::BlendMap;
    use super::*;
    use crate::math::{DVec3, Lanes};
    use crate::world::pattern::{Formula, Pattern};
    use crate::world::sample::{Colors, Sample};

    #[test]
    fn bands_of_pigments_hold_their_colours() {
        let entries = [(0.1, 0.3), (0.3, 0.9), (0.3, 0.2), (0.6, 0.25), (0.8, 1.0)];
        let colors = entries.map(|(at, c)| (at, Rgbft::new([c, 1.0 - c, 0.5 * c, 0.0, 0.0])));
        let pigment =
            Pigment::Colors(Box::new(Pattern::plain(Formula::Bozo(2))), BlendMap::new(colors).unwrap());
        assert!(Colors::is_known(&pigment) && Field::is_known(&pigment));
        let mut narrow = 0;
        for n in 0..400 {
            let middle = DVec3::new(0.17, -0.23, 0.19) * f64::from(n);
            let along = DVec3::new(0.6, 0.5, -0.7) * 0.5_f64.powi(n % 16);
            let at = [0, 1, 2].map(|i| Band::line(Lanes::splat(middle[i]), Lanes::splat(along[i])));
            let bands = [
                Colors::enclose(&pigment, &at, 0),
                Colors::enclose(&pigment, &at, 1),
                Field::enclose(&pigment, &at),
            ];
            for step in -8..=8 {
                let s = f64::from(step) / 8.0;
                let sample = Sample::at(middle + s * along);
                let color = Colors::color(&pigment, &sample).to_array().map(f64::from);
                for (band, value) in bands.iter().zip([color[0], color[1], pigment.value(&sample)]) {
                    let line = band.middle.0[3] + band.slope.0[3] * s;
                    assert!((value - line).abs() <= band.reach.0[3], "{middle} {along}: {value} {band:?}");
                }
            }
            narrow += u32::from(bands[0].reach.0[3] < 1e-3);
        }
        assert!(narrow > 100, "{narrow}");
    }
}
