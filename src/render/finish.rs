//! How a finish answers light: diffuse, highlights, metallic colour, thin films
//! (docs/spec/shading.md 9).

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::math::noise::Octaves;
use crate::math::{DVec3, Rgb};
use crate::world::light::power;
use crate::world::object::{Leaf, LeafFlags};
use crate::world::texture::Finish;
use crate::world::texture::Irid;

/// Cosines to a light below this count as facing away.
const FACING: f64 = 1e-10;

/// Phong highlights this sharp end where the cosine is small.
const SHARP_PHONG: f32 = 60.0;
/// The cosine where they end.
const SHARP_PHONG_END: f64 = 0.0008;
/// Minus the logarithm of a share of light that isn't seen.
const UNSEEN: f64 = 30.0;

/// A layer about to be lit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surface<'a> {
    /// The layer's finish.
    pub(super) finish: &'a Finish,
    /// The pigment's colour.
    pub(super) color: Rgb,
    /// How much of itself the layer shows, the factor of own light.
    pub(super) opacity: f32,
    /// The layer's unit normal, bent by its bumps.
    pub(super) normal: &'a DVec3,
    /// Unit direction of the ray that sees it.
    pub(super) direction: &'a DVec3,
}

impl Surface<'_> {
    /// Whether the front of it, of a leaf, is lit from a direction.
    #[inline]
    pub(super) fn faces(&self, leaf: &Leaf, to_light: &DVec3) -> bool {
        leaf.flags.contains(LeafFlags::DOUBLE_ILLUMINATE) || self.normal.dot(*to_light) >= FACING
    }

    /// Whether any of the light from some direction would be seen: what lets all light pass, or is a mirror,
    /// has highlights only, and these are small.
    #[inline]
    pub(super) fn answers(&self, to_light: &DVec3, back: bool) -> bool {
        let Finish { diffuse, diffuse_back, crand, .. } = *self.finish;
        let scatters = if back { diffuse_back > 0.0 } else { diffuse > 0.0 };
        crand != 0.0 || scatters && self.opacity != 0.0 || !back && self.highlight(to_light) != 0.0
    }

    /// What of the light `color` from some direction is scattered towards the eye, from the front or
    /// through from the back.
    #[inline]
    pub(super) fn diffuse(&self, to_light: &DVec3, color: Rgb, back: bool, grain: f32) -> Rgb {
        let share = if back { self.finish.diffuse_back } else { self.finish.diffuse };
        if share <= 0.0 {
            return Rgb::ZERO;
        }
        let cosine = self.normal.dot(*to_light).abs();
        let brilliance = f64::from(self.finish.brilliance);
        let scattered = if brilliance == 1.0 { cosine } else { power(cosine, brilliance) };
        let strength = share * scattered as f32 * self.opacity - self.finish.crand * grain;
        self.color * color * strength
    }

    /// The phong and specular highlights of light from some direction.
    #[inline]
    pub(super) fn highlights(&self, to_light: &DVec3, color: Rgb) -> Rgb {
        let strength = self.highlight(to_light);
        if strength == 0.0 {
            return Rgb::ZERO;
        }
        let tint = match self.finish.metallic {
            0.0 => Rgb::ONE,
            amount => metallic(amount, self.color, self.normal.dot(*to_light)),
        };
        color * tint * strength as f32
    }

    #[inline]
    fn highlight(&self, to_light: &DVec3) -> f64 {
        self.phong(to_light) + self.specular(to_light)
    }

    #[inline]
    fn phong(&self, to_light: &DVec3) -> f64 {
        if self.finish.phong <= 0.0 {
            return 0.0;
        }
        let cosine = self.direction.reflect(*self.normal).dot(*to_light);
        let size = self.finish.phong_size;
        let visible = cosine > 0.0 && (size < SHARP_PHONG || cosine > SHARP_PHONG_END);
        if visible { f64::from(self.finish.phong) * lobe(cosine, f64::from(size)) } else { 0.0 }
    }

    #[inline]
    fn specular(&self, to_light: &DVec3) -> f64 {
        if self.finish.specular <= 0.0 {
            return 0.0;
        }
        let half = *to_light - *self.direction;
        let cosine = half.dot(*self.normal) / half.length();
        if cosine > 0.0 {
            f64::from(self.finish.specular) * lobe(cosine, f64::from(self.finish.specular_exponent))
        } else {
            0.0
        }
    }
}

/// A cosine to a power: how much is left of a highlight at its angle. Nothing where it is less than
/// any single-precision colour shows.
#[inline]
fn lobe(cosine: f64, exponent: f64) -> f64 {
    // The logarithm of a cosine is below the cosine less 1.
    if exponent * (1.0 - cosine) > UNSEEN { 0.0 } else { power(cosine, exponent) }
}

/// How much a colour tints what a metal reflects at `cosine` to the normal.
pub(super) fn metallic(amount: f32, color: Rgb, cosine: f64) -> Rgb {
    let x = cosine.clamp(-1.0, 1.0).acos().abs() / FRAC_PI_2;
    let fresnel = (0.014567225 / (x - 1.12).powi(2) - 0.011612903).clamp(0.0, 1.0);
    Rgb::ONE + (color - Rgb::ONE) * (amount * (1.0 - fresnel as f32))
}

/// The factor of a thin film on light from a direction.
///
/// `position` is the hit point, `eye` the unit direction of the ray, `wavelengths` those of
/// `irid_wavelength`.
pub(super) fn iridescence(
    irid: &Irid,
    wavelengths: Rgb,
    position: DVec3,
    normal: DVec3,
    to_light: DVec3,
    eye: DVec3,
    noise_generator: u8,
) -> Rgb {
    let film = f64::from(irid.thickness) * film_turbulence(irid, position, noise_generator);
    let way = film * (normal.dot(to_light).abs() + normal.dot(eye).abs());
    let wave = |wavelength: f32| (TAU * way / f64::from(wavelength)).cos() as f32;
    let waves = Rgb::new(wave(wavelengths.x), wave(wavelengths.y), wave(wavelengths.z));
    Rgb::ONE + waves * irid.amount
}

fn film_turbulence(irid: &Irid, position: DVec3, noise_generator: u8) -> f64 {
    if irid.turbulence == 0.0 {
        return 1.0;
    }
    let octaves = Octaves { count: 5, omega: 0.5, lambda: 2.0 };
    1.0 + f64::from(irid.turbulence) * (2.0 * octaves.scalar(noise_generator, position) - 1.0)
}
