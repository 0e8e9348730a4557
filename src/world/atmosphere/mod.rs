//! What surrounds the objects: sky, fog, rainbows, media (docs/spec/atmosphere-gi.md 1).

pub mod fog;
pub mod rainbow;
pub mod sky_sphere;

pub use fog::Fog;
pub use rainbow::Rainbow;
pub use sky_sphere::SkySphere;

use super::{Media, Ray};
use crate::math::color::grey;
use crate::math::{DVec3, Rgb, Rgbft};

/// Length of the way to where a ray hits nothing.
pub const FAR: f64 = 2e10;

/// Everything around the objects.
#[derive(Debug, Default)]
pub struct Atmosphere {
    /// Behind everything.
    pub background: Rgbft,
    /// Before the background.
    pub sky_sphere: Option<SkySphere>,
    /// All fogs; none of them sees the others.
    pub fogs: Vec<Fog>,
    /// All rainbows.
    pub rainbows: Vec<Rainbow>,
    /// Media in the air.
    pub media: Vec<Media>,
}

/// What a stretch of a ray does to the light that comes along it: `added + factor * light`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Veil {
    /// Light of its own.
    pub added: Rgb,
    /// What it leaves of the light from behind.
    pub factor: Rgb,
    /// What it leaves of the transparency of what is behind.
    pub transmit: f32,
}

impl Veil {
    /// Clear air.
    pub const NONE: Self = Self { added: Rgb::ZERO, factor: Rgb::ONE, transmit: 1.0 };

    /// Both, this one behind `front`.
    #[must_use]
    pub fn behind(self, front: Self) -> Self {
        Self {
            added: front.added + front.factor * self.added,
            factor: front.factor * self.factor,
            transmit: front.transmit * self.transmit,
        }
    }
}

/// Whether the picture has an alpha channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Alpha {
    /// It has: the background counts for what was written.
    Stored,
    /// It hasn't: everything is opaque.
    None,
}

/// What is seen where nothing is hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sky {
    /// Its colour, multiplied by its opacity.
    pub color: Rgb,
    /// How transparent the picture is there.
    pub transmit: f32,
}

impl Atmosphere {
    /// The sky in the unit direction `direction`, by the rules of the language version in hundredths.
    ///
    /// `picture` says whether the picture has an alpha channel, `eye` whether the ray comes from the
    /// camera unreflected: only then it may see a transparent sky.
    pub fn sky(&self, direction: DVec3, picture: Alpha, eye: bool, version: u32) -> Sky {
        let transparent = picture == Alpha::Stored && eye;
        let sphere = self.sky_sphere.as_ref();
        if version < 370 {
            if transparent {
                return Sky { color: Rgb::ZERO, transmit: 1.0 };
            }
            let background = self.background.rgb;
            let color = sphere.map_or(background, |sky| sky.before_37(direction, background));
            return Sky { color, transmit: 0.0 };
        }
        let background = match picture {
            Alpha::None => Rgbft::opaque(self.background.rgb * (1.0 - self.background.transmit)),
            Alpha::Stored if eye => self.background,
            Alpha::Stored => Rgbft::opaque(self.background.rgb),
        };
        let (mut color, mut through) = sphere.map_or((Rgb::ZERO, Rgb::ONE), |sky| sky.color(direction));
        color += background.rgb * background.opacity() * through;
        through *= background.through();
        Sky { color, transmit: grey(through).abs().min(1.0) }
    }

    /// Whether the sky is of one colour.
    pub fn is_even(&self) -> bool {
        self.sky_sphere.as_ref().is_none_or(SkySphere::is_even)
    }

    /// What rainbows do to light that comes `distance` along the ray.
    /// `random` gives numbers uniform in 0 … 1.
    pub fn rainbow(&self, ray: &Ray, distance: f64, random: &mut dyn FnMut() -> f64) -> Veil {
        rainbow::veil(&self.rainbows, ray, distance, random)
    }

    /// What fog does to light that comes `distance` along the ray.
    pub fn fog(&self, ray: &Ray, distance: f64) -> Veil {
        fog::veil(&self.fogs, ray, distance)
    }

    /// Whether the air is clear.
    pub fn is_clear(&self) -> bool {
        self.fogs.is_empty() && self.rainbows.is_empty() && self.media.is_empty()
    }
}
