//! Pigments: the colour at a sample (docs/spec/patterns-textures.md 3).

use std::sync::Arc;

use super::along;
use super::blend_map::{BlendMap, Pick};
use crate::math::color::{FourColors, grey};
use crate::math::{Band, Lanes, Rgb, Rgbft};
use crate::world::image::ImageMap;
use crate::world::image::along::greyness;
use crate::world::pattern::Pattern;
use crate::world::sample::{Colors, Field, Sample, Samples};
use crate::world::warp::Warps;

/// Where colours come from. Small, as most are of one colour and scenes have millions.
#[derive(Clone, Debug)]
pub enum Pigment {
    /// One colour everywhere.
    Color(Rgbft),
    /// A pattern looked up in a map of colours.
    Colors(Box<Pattern>, BlendMap<Rgbft>),
    /// A pattern looked up in a map of pigments, which are evaluated at the pattern's warped point.
    Pigments(Box<Pattern>, BlendMap<Arc<Pigment>>),
    /// `average`: the map's positions are weights.
    Average(Warps, BlendMap<Arc<Pigment>>),
    /// `image_map`.
    Image(Warps, Box<ImageMap>),
    /// Evaluated at `<u,v,0>`.
    UvMapped(Arc<Pigment>),
}

impl Pigment {
    /// The colour at `sample`; `None` outside a `once` image, where nothing was painted.
    #[inline]
    pub fn color(&self, sample: &Sample) -> Option<Rgbft> {
        match self {
            Self::Color(color) => Some(*color),
            Self::Colors(pattern, map) => Some(map.color(pattern.value(sample))),
            Self::Pigments(pattern, map) => {
                let inner = sample.moved(pattern.warps.point(sample.point));
                match map.pick(pattern.value_at(inner.point, sample)) {
                    Pick::One(pigment) => pigment.color(&inner),
                    Pick::Two { previous, current, t } => {
                        blended(previous.color(&inner), current.color(&inner), t)
                    }
                }
            }
            Self::Average(warps, map) => {
                let inner = sample.moved(warps.point(sample.point));
                let mut sum = [0_f32; 5];
                let mut total = 0_f32;
                for (weight, pigment) in map.entries() {
                    total += weight;
                    if *weight == 0.0 {
                        continue;
                    }
                    let color = or_clear(pigment.color(&inner)).to_array();
                    for (sum, component) in sum.iter_mut().zip(color) {
                        *sum += component * weight;
                    }
                }
                Some(Rgbft::new(sum.map(|component| component / total)))
            }
            Self::Image(warps, map) => map.color(warps.point(sample.point)),
            Self::UvMapped(pigment) => pigment.color(&sample.uv_mapped()),
        }
    }

    /// [`Pigment::color`] where the commonest patterns are compiled together with what is around it.
    #[inline(always)]
    pub fn soon_color(&self, sample: &Sample) -> Option<Rgbft> {
        if let Self::Colors(pattern, map) = self
            && let Some(value) = pattern.soon_value(sample.point)
        {
            return Some(map.color(value));
        }
        self.color(sample)
    }

    /// The colour as a media density takes it.
    #[inline]
    pub fn density(&self, sample: &Sample) -> Rgb {
        or_clear(self.color(sample)).rgb
    }

    /// Whether its colour takes hardly any time to find: one, or a pattern of a few operations.
    #[inline(always)]
    pub fn is_soon_known(&self) -> bool {
        match self {
            Self::Color(_) => true,
            Self::Colors(pattern, _) => pattern.is_soon_known(),
            _ => false,
        }
    }

    /// Whether nothing shines through anywhere (docs/spec/patterns-textures.md 7.3).
    pub fn is_opaque(&self) -> bool {
        let clear = |c: &Rgbft| c.filter.abs() > 1e-10 || c.transmit.abs() > 1e-10;
        match self {
            Self::Color(color) => !clear(color),
            Self::Colors(_, map) => !map.entries().iter().any(|(_, color)| clear(color)),
            Self::Pigments(_, map) | Self::Average(_, map) => {
                map.entries().iter().all(|(_, pigment)| pigment.is_opaque())
            }
            Self::Image(_, map) => !map.once && map.clearness == [0.0; 2] && map.image.is_opaque(),
            Self::UvMapped(pigment) => pigment.is_opaque(),
        }
    }
}

impl BlendMap<Rgbft> {
    /// The colour at a value.
    #[inline(always)]
    fn color(&self, value: f64) -> Rgbft {
        match self.pick(value) {
            Pick::One(color) => *color,
            Pick::Two { previous, current, t } => blend(*previous, *current, t),
        }
    }
}

/// What POV-Ray takes for a colour outside a `once` image.
pub(super) const CLEAR: Rgbft = Rgbft { rgb: Rgb::ONE, filter: 0.0, transmit: 1.0 };

fn or_clear(color: Option<Rgbft>) -> Rgbft {
    color.unwrap_or(CLEAR)
}

/// Every component by itself, the share in double precision (docs/spec/patterns-textures.md 3.2).
#[inline(always)]
pub(super) fn blend(previous: Rgbft, current: Rgbft, t: f64) -> Rgbft {
    let (mut blended, current) = (previous.to_array(), current.to_array());
    // A loop: closures given to arrays become calls.
    for place in 0..5 {
        blended[place] += (t * f64::from(current[place] - blended[place])) as f32;
    }
    Rgbft::new(blended)
}

/// The same where there may be no colour.
pub(super) fn blended(previous: Option<Rgbft>, current: Option<Rgbft>, t: f64) -> Option<Rgbft> {
    let painted = previous.is_some() || current.is_some();
    painted.then(|| blend(or_clear(previous), or_clear(current), t))
}

impl Colors for Pigment {
    fn color(&self, sample: &Sample) -> Rgbft {
        or_clear(self.color(sample))
    }

    fn four_colors(&self, samples: &Samples) -> FourColors {
        self.colors_or_clear(samples)
    }

    fn enclose(&self, point: &[Band; 3], component: u8) -> Band {
        self.along(point, &[point[0], point[1]], &|color| along::component(color, component))
    }

    fn is_known(&self) -> bool {
        self.is_held()
    }
}

/// A pigment seen as grey: `pigment_pattern`.
impl Field for Pigment {
    fn value(&self, sample: &Sample) -> f64 {
        f64::from(grey(or_clear(self.color(sample)).rgb))
    }

    fn four(&self, samples: &Samples) -> Lanes {
        self.colors_or_clear(samples).greys()
    }

    fn enclose(&self, point: &[Band; 3]) -> Band {
        self.enclose_mapped(point, &[point[0], point[1]])
    }

    fn enclose_mapped(&self, point: &[Band; 3], uv: &[Band; 2]) -> Band {
        self.along(point, uv, &greyness)
    }

    fn is_known(&self) -> bool {
        self.is_held()
    }
}
