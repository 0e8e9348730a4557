//! Colours as POV-Ray keeps them: single precision, unclamped, linear in the scene's working space.

use super::Lanes;

/// Red, green, blue in single precision; any value, highlights exceed 1 and negative lights exist.
pub type Rgb = glam::Vec3A;

/// A pigment's colour: rgb, and how light passes through it.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Rgbft {
    /// Red, green, blue.
    pub rgb: Rgb,
    /// Share of light passed and multiplied by `rgb`.
    pub filter: f32,
    /// Share of light passed unchanged.
    pub transmit: f32,
}

/// The index that stands for the grey of a colour among its five components.
pub const GREY: u8 = 5;

/// The grey that `.gray` takes of red, green and blue in functions, in POV-Ray's order.
pub fn grey_of([red, green, blue]: [f64; 3]) -> f64 {
    red * 0.297 + green * 0.589 + blue * 0.114
}

impl Rgbft {
    /// Opaque black.
    pub const BLACK: Self = Self::opaque(Rgb::ZERO);

    /// `rgb` without filter or transmit.
    pub const fn opaque(rgb: Rgb) -> Self {
        Self { rgb, filter: 0.0, transmit: 0.0 }
    }

    /// From the five components in the order red, green, blue, filter, transmit.
    #[inline]
    pub const fn new(components: [f32; 5]) -> Self {
        let [r, g, b, filter, transmit] = components;
        Self { rgb: Rgb::new(r, g, b), filter, transmit }
    }

    /// The five components in the order red, green, blue, filter, transmit.
    #[inline]
    pub fn to_array(self) -> [f32; 5] {
        [self.rgb.x, self.rgb.y, self.rgb.z, self.filter, self.transmit]
    }

    /// What the surface keeps for itself, `1 - filter - transmit` (docs/spec/shading.md 1).
    #[inline]
    pub fn opacity(self) -> f32 {
        1.0 - self.filter - self.transmit
    }

    /// The factor for light passing through, `rgb * filter + transmit` (docs/spec/shading.md 1).
    #[inline]
    pub fn through(self) -> Rgb {
        self.rgb * self.filter + Rgb::splat(self.transmit)
    }

    /// `self + t * (other - self)` in every component, in single precision, never clamped
    /// (docs/spec/patterns-textures.md 3.2).
    pub fn blend(self, other: Self, t: f32) -> Self {
        let mix = |a: f32, b: f32| a + t * (b - a);
        Self {
            rgb: self.rgb + t * (other.rgb - self.rgb),
            filter: mix(self.filter, other.filter),
            transmit: mix(self.transmit, other.transmit),
        }
    }
}

/// Four colours side by side, some of which may not be known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FourColors {
    /// The components in the order of [`Rgbft::to_array`], of all four each.
    pub components: [[f32; 4]; 5],
    /// Which are known.
    pub is_known: [bool; 4],
}

impl FourColors {
    /// No colours.
    pub const NONE: Self = Self { components: [[0.0; 4]; 5], is_known: [false; 4] };

    /// Four times the same.
    #[inline]
    pub fn all(color: Rgbft) -> Self {
        let [r, g, b, filter, transmit] = color.to_array();
        Self { components: [[r; 4], [g; 4], [b; 4], [filter; 4], [transmit; 4]], is_known: [true; 4] }
    }

    /// One of them.
    #[inline]
    pub fn get(&self, lane: usize) -> Option<Rgbft> {
        let [r, g, b, filter, transmit] = &self.components;
        let color = Rgbft::new([r[lane], g[lane], b[lane], filter[lane], transmit[lane]]);
        self.is_known[lane].then_some(color)
    }

    /// Replaces one of them.
    #[inline]
    pub fn set(&mut self, lane: usize, color: Option<Rgbft>) {
        self.is_known[lane] = color.is_some();
        let color = color.unwrap_or_default().to_array();
        for (component, color) in self.components.iter_mut().zip(color) {
            component[lane] = color;
        }
    }

    /// The [`grey`] of each.
    #[inline(always)]
    pub fn greys(&self) -> Lanes {
        let [r, g, b, ..] = &self.components;
        let mut greys = Lanes::ZERO;
        for lane in 0..Lanes::COUNT {
            greys.0[lane] = f64::from(grey_in([r[lane], g[lane], b[lane]]));
        }
        greys
    }
}

/// Red, green and blue of four colours side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FourRgb(pub [[f32; 4]; 3]);

impl FourRgb {
    /// Black.
    pub const ZERO: Self = Self([[0.0; 4]; 3]);

    /// Four times the same.
    #[inline(always)]
    pub fn all(color: Rgb) -> Self {
        Self([[color.x; 4], [color.y; 4], [color.z; 4]])
    }

    /// One of them.
    #[inline(always)]
    pub fn get(&self, lane: usize) -> Rgb {
        let [r, g, b] = &self.0;
        Rgb::new(r[lane], g[lane], b[lane])
    }

    /// Replaces one of them.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, color: Rgb) {
        let [r, g, b] = &mut self.0;
        [r[lane], g[lane], b[lane]] = color.to_array();
    }

    /// Adds others, each multiplied by the same.
    #[inline(always)]
    pub fn add(&mut self, others: &Self, factor: Rgb) {
        for (component, factor) in factor.to_array().into_iter().enumerate() {
            for lane in 0..4 {
                self.0[component][lane] += others.0[component][lane] * factor;
            }
        }
    }

    /// Multiplies each by another.
    #[inline(always)]
    pub fn multiply(&mut self, others: &Self) {
        for component in 0..3 {
            for lane in 0..4 {
                self.0[component][lane] *= others.0[component][lane];
            }
        }
    }
}

/// POV-Ray's grey: `0.297 r + 0.589 g + 0.114 b` (docs/spec/shading.md 1), rounded once: greys stay
/// what they are.
#[inline(always)]
pub fn grey(color: Rgb) -> f32 {
    grey_in(color.to_array())
}

#[inline(always)]
fn grey_in([r, g, b]: [f32; 3]) -> f32 {
    (0.297 * f64::from(r) + 0.589 * f64::from(g) + 0.114 * f64::from(b)) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn filtered_light_takes_the_pigments_colour_and_transmitted_light_does_not() {
        let glass = Rgbft::new([0.8, 0.4, 0.2, 0.5, 0.25]);
        assert!(glass.through().abs_diff_eq(Rgb::new(0.65, 0.45, 0.35), 1e-6));
        assert_eq!(glass.opacity(), 0.25);
    }

    #[test]
    fn blending_reaches_both_ends_and_never_clamps() {
        let (a, b) = (Rgbft::new([0.0, 1.0, 2.0, 0.0, 1.0]), Rgbft::new([1.0, 0.0, 4.0, 0.5, 0.0]));
        assert_eq!(a.blend(b, 0.0), a);
        assert_eq!(a.blend(b, 1.0), b);
        assert_eq!(a.blend(b, 2.0).rgb.z, 6.0);
    }
}
