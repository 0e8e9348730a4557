//! Pigments at four samples at once.

use std::sync::Arc;

use super::blend_map::{BlendMap, Pick};
use super::pigment::{CLEAR, Pigment, blend, blended};
use crate::math::color::{FourColors, FourRgb};
use crate::math::wide::widest;
use crate::math::{Lanes, Rgbft};
use crate::world::sample::{Field, Samples};

impl Pigment {
    /// [`Pigment::color`] at each of four samples.
    pub fn colors(&self, samples: &Samples) -> FourColors {
        match self {
            Self::Color(color) => FourColors::all(*color),
            Self::Colors(pattern, map) => looked_up(map, pattern.four(samples)),
            Self::Pigments(pattern, map) => {
                let inner = samples.moved(pattern.warps.four(&samples.point));
                mapped(map, pattern.values_at(&inner.point, samples), &inner)
            }
            Self::UvMapped(pigment) => pigment.colors(&samples.uv_mapped()),
            Self::Average(..) | Self::Image(..) => {
                let mut colors = FourColors::NONE;
                for lane in 0..Lanes::COUNT {
                    colors.set(lane, self.color(&samples.get(lane)));
                }
                colors
            }
        }
    }

    /// The colours as a media density takes them.
    pub fn densities(&self, samples: &Samples) -> FourRgb {
        match self {
            Self::Colors(pattern, map) => lights_looked_up(map, pattern.four(samples)),
            Self::Pigments(pattern, map) => {
                let inner = samples.moved(pattern.warps.four(&samples.point));
                densities_mapped(map, pattern.values_at(&inner.point, samples), &inner)
            }
            _ => {
                let [r, g, b, ..] = self.colors_or_clear(samples).components;
                FourRgb([r, g, b])
            }
        }
    }

    /// The same, clear where nothing was painted.
    pub(super) fn colors_or_clear(&self, samples: &Samples) -> FourColors {
        let mut colors = self.colors(samples);
        for lane in 0..Lanes::COUNT {
            if !colors.is_known[lane] {
                colors.set(lane, Some(CLEAR));
            }
        }
        colors
    }
}

/// The entries of a map that show at four values.
#[inline(always)]
fn picks<T>(map: &BlendMap<T>, values: Lanes) -> [Pick<&T>; Lanes::COUNT] {
    let [a, b, c, d] = values.0;
    [map.pick(a), map.pick(b), map.pick(c), map.pick(d)]
}

/// The entries that all four picks blend, with the shares of the second.
#[inline(always)]
fn same_two<'m, T>(picks: &[Pick<&'m T>; Lanes::COUNT]) -> Option<(&'m T, &'m T, Lanes)> {
    let Pick::Two { previous, current, .. } = picks[0] else { return None };
    let mut shares = Lanes::ZERO;
    for (share, pick) in shares.0.iter_mut().zip(picks) {
        match pick {
            Pick::Two { current: other, t, .. } if std::ptr::eq(current, *other) => *share = *t,
            _ => return None,
        }
    }
    Some((previous, current, shares))
}

/// The colours that a map has at four values.
fn looked_up(map: &BlendMap<Rgbft>, values: Lanes) -> FourColors {
    let picks = picks(map, values);
    if let Some((previous, current, shares)) = same_two(&picks) {
        return blend_four(&FourColors::all(*previous), &FourColors::all(*current), shares);
    }
    let mut colors = FourColors::NONE;
    for (lane, pick) in picks.iter().enumerate() {
        let color = match *pick {
            Pick::One(color) => *color,
            Pick::Two { previous, current, t } => blend(*previous, *current, t),
        };
        colors.set(lane, Some(color));
    }
    colors
}

/// [`looked_up`] without what shines through.
fn lights_looked_up(map: &BlendMap<Rgbft>, values: Lanes) -> FourRgb {
    widest(
        #[inline(always)]
        || {
            let mut lights = FourRgb::ZERO;
            for (lane, &value) in values.0.iter().enumerate() {
                let light = match map.pick(value) {
                    Pick::One(color) => color.rgb.to_array(),
                    Pick::Two { previous, current, t } => {
                        let (mut blended, current) = (previous.rgb.to_array(), current.rgb.to_array());
                        for component in 0..3 {
                            let step = current[component] - blended[component];
                            blended[component] += (t * f64::from(step)) as f32;
                        }
                        blended
                    }
                };
                for (component, light) in light.into_iter().enumerate() {
                    lights.0[component][lane] = light;
                }
            }
            lights
        },
    )
}

/// The colours of the pigments that a map has at four values. Pigments are evaluated side by side where they show at
/// several of the samples.
fn mapped(map: &BlendMap<Arc<Pigment>>, values: Lanes, inner: &Samples) -> FourColors {
    let picks = picks(map, values);
    if let Some((previous, current, shares)) = same_two(&picks) {
        let (previous, current) = (previous.colors(inner), current.colors(inner));
        if previous.is_known == current.is_known {
            return blend_four(&previous, &current, shares);
        }
        let mut colors = FourColors::NONE;
        for lane in 0..Lanes::COUNT {
            colors.set(lane, blended(previous.get(lane), current.get(lane), shares.0[lane]));
        }
        return colors;
    }
    let mut colors = FourColors::NONE;
    let mut done = [false; Lanes::COUNT];
    for first in 0..Lanes::COUNT {
        if done[first] {
            continue;
        }
        let (mut alike, mut count) = ([false; Lanes::COUNT], 0);
        for lane in first..Lanes::COUNT {
            alike[lane] = same_entries(&picks[lane], &picks[first]);
            count += usize::from(alike[lane]);
        }
        let paint = |pigment: &Pigment| {
            if count > 1 {
                return pigment.colors(inner);
            }
            let mut colors = FourColors::NONE;
            colors.set(first, pigment.color(&inner.get(first)));
            colors
        };
        let (previous, current) = match picks[first] {
            Pick::One(pigment) if count == Lanes::COUNT => return pigment.colors(inner),
            Pick::One(pigment) => (paint(pigment), None),
            Pick::Two { previous, current, .. } => (paint(previous), Some(paint(current))),
        };
        for lane in first..Lanes::COUNT {
            if !alike[lane] {
                continue;
            }
            done[lane] = true;
            let color = match (&picks[lane], &current) {
                (Pick::Two { t, .. }, Some(current)) => blended(previous.get(lane), current.get(lane), *t),
                _ => previous.get(lane),
            };
            colors.set(lane, color);
        }
    }
    colors
}

/// [`mapped`] as media densities take it.
fn densities_mapped(map: &BlendMap<Arc<Pigment>>, values: Lanes, inner: &Samples) -> FourRgb {
    let picks = picks(map, values);
    if let Pick::One(pigment) = picks[0]
        && picks[1..].iter().all(|pick| same_entries(pick, &picks[0]))
    {
        return pigment.densities(inner);
    }
    if let Some((previous, current, shares)) = same_two(&picks) {
        let mut lights = previous.densities(inner);
        blend_components(&mut lights.0, &current.densities(inner).0, shares);
        return lights;
    }
    let mut lights = FourRgb::ZERO;
    for (lane, pick) in picks.iter().enumerate() {
        let sample = &inner.get(lane);
        let light = match pick {
            Pick::One(pigment) => pigment.density(sample),
            Pick::Two { previous, current, t } => {
                let [previous, current] = [previous, current].map(|pigment| pigment.density(sample));
                blend(Rgbft::opaque(previous), Rgbft::opaque(current), *t).rgb
            }
        };
        lights.set(lane, light);
    }
    lights
}

fn same_entries(one: &Pick<&Arc<Pigment>>, other: &Pick<&Arc<Pigment>>) -> bool {
    match (one, other) {
        (Pick::One(a), Pick::One(b)) => std::ptr::eq(*a, *b),
        (Pick::Two { current: a, .. }, Pick::Two { current: b, .. }) => std::ptr::eq(*a, *b),
        _ => false,
    }
}

/// [`blend`] of each, where all are known.
fn blend_four(previous: &FourColors, current: &FourColors, shares: Lanes) -> FourColors {
    widest(
        #[inline(always)]
        || {
            let mut blended = *previous;
            blend_components(&mut blended.components, &current.components, shares);
            blended
        },
    )
}

/// Blends component by component. Loops: what is given to adapters is not compiled together with what is around it.
#[inline(always)]
fn blend_components<const N: usize>(
    blended: &mut [[f32; 4]; N],
    current: &[[f32; 4]; N],
    Lanes(shares): Lanes,
) {
    for component in 0..N {
        for lane in 0..Lanes::COUNT {
            let step = current[component][lane] - blended[component][lane];
            blended[component][lane] += (shares[lane] * f64::from(step)) as f32;
        }
    }
}
