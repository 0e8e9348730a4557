//! Pigments along lines: bounds of their colours, for surfaces that functions of them make.
//!
//! Known are single colours and images, and maps of what is known over patterns of which something is known.

use std::sync::Arc;

use smallvec::SmallVec;

use super::{BlendMap, Pigment};
use crate::math::color::{GREY, grey_of};
use crate::math::{Band, Lanes, Rgbft};
use crate::world::image::along::{Of, ROUNDING};
use crate::world::pattern::Pattern;
use crate::world::sample::Field;

impl Pigment {
    /// Whether [`Pigment::along`] says something.
    pub(super) fn is_held(&self) -> bool {
        match self {
            Self::Color(_) => true,
            Self::Colors(pattern, map) => pattern.is_known() && is_sorted(map),
            Self::Pigments(pattern, map) => {
                pattern.is_known() && is_sorted(map) && map.entries().iter().all(|(_, p)| p.is_held())
            }
            Self::Average(_, map) => map.entries().iter().all(|(weight, p)| *weight >= 0.0 && p.is_held()),
            Self::Image(..) => true,
            Self::UvMapped(pigment) => pigment.is_held(),
        }
    }

    /// What holds a number made of the colours of points that these hold, with these texture coordinates.
    pub(super) fn along(&self, point: &[Band; 3], uv: &[Band; 2], of: Of) -> Band {
        match self {
            Self::Color(color) => Band::constant(of(color)),
            Self::Colors(pattern, map) => {
                let points: SmallVec<[_; 16]> =
                    map.entries().iter().map(|(at, color)| (f64::from(*at), of(color))).collect();
                let most = points.iter().fold(0.0, |most: f64, (_, value)| most.max(value.abs()));
                let room = Band::between(-most * ROUNDING, most * ROUNDING);
                pattern.enclose_mapped(point, uv).broken_line(&points) + room
            }
            Self::Pigments(pattern, map) => blended(pattern, map, point, uv, of),
            Self::Average(warps, map) => {
                let inner = warps.along(*point);
                let (mut sum, mut total) = (Band::constant(0.0), 0.0);
                for (weight, pigment) in map.entries() {
                    total += f64::from(*weight);
                    sum = sum + pigment.along(&inner, uv, of) * f64::from(*weight);
                }
                rounded(sum * (1.0 / total))
            }
            Self::Image(warps, map) => map.colors_along(&warps.along(*point), &super::pigment::CLEAR, of),
            Self::UvMapped(pigment) => pigment.along(&[uv[0], uv[1], Band::constant(0.0)], uv, of),
        }
    }
}

fn is_sorted<T>(map: &BlendMap<T>) -> bool {
    map.entries().is_sorted_by(|a, b| a.0 <= b.0)
}

/// With room for the rounding to single precision.
fn rounded(band: Band) -> Band {
    Band { reach: band.reach + (band.middle.abs() + band.spread()) * ROUNDING, ..band }.loose()
}

/// A map of pigments: between two of them that the pattern tells, or what holds all that it may.
fn blended(
    pattern: &Pattern,
    map: &BlendMap<Arc<Pigment>>,
    point: &[Band; 3],
    uv: &[Band; 2],
    of: Of,
) -> Band {
    let value = pattern.enclose_mapped(point, uv);
    let inner = pattern.warps.along(*point);
    let (low, high) = (value.low(), value.high());
    let entries = map.entries();
    let last = entries.len() - 1;
    let mut all: Option<Band> = None;
    let mut found = Lanes::splat(-1.0);
    let (yes, no) = (Lanes::splat(1.0), Lanes::splat(-1.0));
    for stretch in 0..=entries.len() {
        // From the entry before to this one; level before the first and behind the last.
        let from = stretch.checked_sub(1).map_or(f64::NEG_INFINITY, |i| f64::from(entries[i].0));
        let to = entries.get(stretch).map_or(f64::INFINITY, |entry| f64::from(entry.0));
        // What is no number takes part in all.
        let beside = low.zip(high, |low, high| f64::from(u8::from(low > to || high < from)));
        if beside.all_positive() {
            continue;
        }
        let (before, behind) = (&entries[stretch.saturating_sub(1)].1, &entries[stretch.min(last)].1);
        let color = if stretch == 0 || stretch > last {
            behind.along(&inner, uv, of)
        } else if from == to {
            before.along(&inner, uv, of).hull(behind.along(&inner, uv, of))
        } else {
            let share =
                ((value - from) * (1.0 / (to - from))).max(Band::constant(0.0)).min(Band::constant(1.0));
            let first = before.along(&inner, uv, of);
            first + (behind.along(&inner, uv, of) - first) * share
        };
        let may = no.where_positive(beside, yes);
        let joined = match all {
            None => color,
            Some(all) => all.hull(color).where_positive(found, color),
        };
        all = Some(joined.where_positive(may, all.unwrap_or(Band::UNKNOWN)));
        found = yes.where_positive(may, found);
    }
    rounded(all.unwrap_or(Band::UNKNOWN))
}

/// A component, in the order red, green, blue, filter, transmit, or their grey.
pub(super) fn component(color: &Rgbft, number: u8) -> f64 {
    let [red, green, blue, filter, transmit] = color.to_array();
    match number {
        0 => red.into(),
        1 => green.into(),
        2 => blue.into(),
        3 => filter.into(),
        4 => transmit.into(),
        GREY => grey_of([red.into(), green.into(), blue.into()]),
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{DVec2, DVec3, Transform};
    use crate::world::image::{self, Image, ImageMap, Pixels};
    use crate::world::pattern::Formula;
    use crate::world::sample::{Colors, Sample};
    use crate::world::warp::{Warp, Warps};

    /// Checks that bands along lines long and short hold a pigment's colours, and that short ones are narrow.
    #[track_caller]
    fn holds(pigment: &Pigment) {
        assert!(Colors::is_known(pigment) && Field::is_known(pigment), "{pigment:?}");
        let mut narrow = 0;
        for n in 0..400 {
            let middle = DVec3::new(0.17, -0.23, 0.19) * f64::from(n);
            let along = DVec3::new(0.6, 0.5, -0.7) * 0.5_f64.powi(n % 16);
            let at = [0, 1, 2].map(|i| Band::line(Lanes::splat(middle[i]), Lanes::splat(along[i])));
            let bands = [
                Colors::enclose(pigment, &at, 0),
                Colors::enclose(pigment, &at, 1),
                Field::enclose(pigment, &at),
            ];
            for step in -8..=8 {
                let s = f64::from(step) / 8.0;
                let sample = Sample::at(middle + s * along);
                let color = Colors::color(pigment, &sample).to_array().map(f64::from);
                for (band, value) in bands.iter().zip([color[0], color[1], pigment.value(&sample)]) {
                    let line = band.middle.0[3] + band.slope.0[3] * s;
                    assert!((value - line).abs() <= band.reach.0[3], "{middle} {along}: {value} {band:?}");
                }
            }
            narrow += u32::from(bands[0].reach.0[3] < 1e-3);
        }
        assert!(narrow > 60, "{pigment:?}: {narrow}");
    }

    fn colors(generator: u8) -> Pigment {
        let entries = [(0.1, 0.3), (0.3, 0.9), (0.3, 0.2), (0.6, 0.25), (0.8, 1.0)];
        let colors = entries.map(|(at, c)| (at, Rgbft::new([c, 1.0 - c, 0.5 * c, 0.0, 0.0])));
        let pattern = Pattern::plain(Formula::Bozo(generator));
        Pigment::Colors(Box::new(pattern), BlendMap::new(colors).unwrap())
    }

    fn image() -> Pigment {
        image_of(3, image::Interpolation::Bilinear)
    }

    /// Of four channels: multiplied by alpha.
    fn image_of(channels: usize, interpolation: image::Interpolation) -> Pigment {
        let data = (0..6 * 5 * channels as u32).map(|n| (n * n * 31 % 251) as u8).collect();
        let curve = (0..256).map(|v| v as f32 / 255.0).collect();
        let pixels = Pixels::Bytes { channels, data, curve };
        let has_alpha = channels == 4;
        let image = Image { width: 6, height: 5, pixels, premultiplied: has_alpha, has_alpha };
        let map = ImageMap {
            image: Arc::new(image),
            projection: image::Projection::Planar,
            interpolation,
            once: false,
            scale: DVec2::new(6.0, 5.0),
            offset: DVec2::ZERO,
            clearness: [0.0, 0.1],
            use_index: false,
            use_alpha: false,
        };
        let larger = Warp::Transform(Box::new(Transform::scale(DVec3::splat(3.0))));
        Pigment::Image(Warps::new([larger]), Box::new(map))
    }

    #[test]
    fn bands_of_pigments_hold_their_colours() {
        holds(&colors(2));
        holds(&image());
        for interpolation in [
            image::Interpolation::None,
            image::Interpolation::Bilinear,
            image::Interpolation::Bicubic,
            image::Interpolation::NormalizedDistance,
        ] {
            holds(&image_of(4, interpolation));
        }
    }

    #[test]
    fn bands_of_maps_of_pigments_hold_their_colours() {
        let plain = |c: f32| Arc::new(Pigment::Color(Rgbft::new([c, 0.5 * c, 1.0 - c, 0.0, 0.0])));
        let all = |at: [f32; 4]| {
            let pigments = [plain(0.1), Arc::new(colors(1)), Arc::new(image()), plain(0.8)];
            BlendMap::new(at.into_iter().zip(pigments)).unwrap()
        };
        let moved = Warp::Transform(Box::new(Transform::scale(DVec3::new(0.7, 1.3, 0.9))));
        let pattern = Pattern { warps: Warps::new([moved.clone()]), ..Pattern::plain(Formula::Bozo(3)) };
        holds(&Pigment::Pigments(Box::new(pattern.clone()), all([0.1, 0.4, 0.4, 0.8])));
        holds(&Pigment::Pigments(Box::new(pattern), all([0.3, 0.5, 0.6, 0.9])));
        holds(&Pigment::Average(Warps::new([moved]), all([1.0, 0.5, 2.0, 0.3])));
        holds(&Pigment::UvMapped(Arc::new(colors(2))));
    }

    #[test]
    fn texture_coordinates_stay_those_of_the_place_that_was_asked_for() {
        let mapped = Arc::new(Pigment::UvMapped(Arc::new(colors(2))));
        let turned = Warp::Transform(Box::new(Transform::rotate(DVec3::new(20.0, 30.0, 40.0))));
        let map = BlendMap::new([(0.2, Arc::new(colors(1))), (0.7, mapped.clone())]).unwrap();
        let pattern = Pattern { warps: Warps::new([turned.clone()]), ..Pattern::plain(Formula::Bozo(3)) };
        let mixed = Pigment::Pigments(Box::new(pattern), map);
        holds(&mixed);
        let grey = Pattern {
            warps: Warps::new([turned]),
            ..Pattern::plain(Formula::Pigment(Arc::new(Pigment::UvMapped(mapped))))
        };
        let map = BlendMap::new([(0.0, Rgbft::new([0.0; 5])), (1.0, Rgbft::new([1.0; 5]))]).unwrap();
        holds(&Pigment::Colors(Box::new(grey), map));
    }
}
