//! Transfer curves between light and stored numbers (docs/spec/camera-image.md 11).

/// Exponents this close to 1 count as no curve at all.
const NEUTRAL: f32 = 0.01;

/// How stored numbers relate to light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Gamma {
    /// The piecewise curve of IEC 61966-2-1.
    Srgb,
    /// `light = stored ^ exponent`; the exponent is greater than 0.
    Power(f32),
}

impl Gamma {
    /// Numbers that are light already.
    pub const LINEAR: Self = Self::Power(1.0);

    /// Tells whether the curve leaves numbers as they are.
    pub fn is_linear(self) -> bool {
        matches!(self, Self::Power(exponent) if is_neutral(exponent.recip()))
    }

    /// Light of a stored number; negative numbers of a power law hold none.
    pub fn decode(self, stored: f32) -> f32 {
        match self {
            _ if self.is_linear() => stored,
            Self::Power(exponent) => stored.max(0.0).powf(exponent),
            Self::Srgb if stored < 0.04045 => stored / 12.92,
            Self::Srgb => ((stored + 0.055) / 1.055).powf(2.4),
        }
    }

    /// The number that stands for an amount of light.
    pub fn encode(self, light: f32) -> f32 {
        match self {
            _ if self.is_linear() => light,
            Self::Power(exponent) => light.max(0.0).powf(exponent.recip()),
            Self::Srgb if light <= 0.003_130_8 => light * 12.92,
            Self::Srgb => 1.055 * light.powf(1.0 / 2.4) - 0.055,
        }
    }

    /// A number stored with this curve as it reads with another.
    ///
    /// Two power laws are merged into one exponent and equal curves cancel exactly,
    /// so what the scene wrote comes out unharmed by two roundings.
    pub fn convert(self, stored: f32, to: Self) -> f32 {
        match (self, to) {
            (from, to) if from == to => stored,
            (Self::Power(from), Self::Power(to)) => {
                let exponent = from / to;
                if is_neutral(exponent) { stored } else { stored.max(0.0).powf(exponent) }
            }
            (from, to) => to.encode(from.decode(stored)),
        }
    }
}

/// Tells whether an exponent is so near 1 that it is taken as 1.
fn is_neutral(exponent: f32) -> bool {
    (exponent - 1.0).abs() <= NEUTRAL
}

#[cfg(test)]
mod tests {
    use super::*;

    fn byte(encoded: f32) -> u8 {
        (encoded.clamp(0.0, 1.0) * 255.0 + 0.5).floor() as u8
    }

    /// The byte rows of docs/spec/camera-image.md 11 for `rgb <0.5, 0.25, 0.7>`.
    #[test]
    fn samples_are_encoded_as_the_probes_show() {
        let rows = [
            (Gamma::LINEAR, Gamma::Srgb, [188, 137, 218]),
            (Gamma::Power(2.2), Gamma::Srgb, [128, 61, 180]),
            (Gamma::Power(1.8), Gamma::Srgb, [146, 81, 192]),
            (Gamma::Srgb, Gamma::Srgb, [128, 64, 179]),
            (Gamma::LINEAR, Gamma::LINEAR, [128, 64, 179]),
            (Gamma::LINEAR, Gamma::Power(2.2), [186, 136, 217]),
            (Gamma::LINEAR, Gamma::Power(1.005), [128, 64, 179]),
            (Gamma::Power(2.2), Gamma::Power(2.2), [128, 64, 179]),
        ];
        for (work, file, expected) in rows {
            let stored = [0.5, 0.25, 0.7].map(|channel| byte(work.convert(channel, file)));
            assert_eq!(stored, expected, "{work:?} to {file:?}");
        }
    }

    #[test]
    fn decode_undoes_encode() {
        for gamma in [Gamma::Srgb, Gamma::Power(2.2), Gamma::LINEAR] {
            for step in 0..=100 {
                let light = step as f32 / 100.0;
                assert!((gamma.decode(gamma.encode(light)) - light).abs() < 1e-5, "{gamma:?} {light}");
            }
        }
    }

    #[test]
    fn an_exponent_within_a_hundredth_of_one_is_linear() {
        assert!(Gamma::Power(1.005).is_linear());
        assert!(!Gamma::Power(1.05).is_linear());
        assert!(!Gamma::Srgb.is_linear());
    }
}
