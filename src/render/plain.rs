//! What most rays meet: a surface of one opaque layer that has no bumps and wears no film. Its colour is what
//! [`Tracer::shade`] would make of it, on a shorter way.
//!
//! Rays that travel together take each step together: while one waits for a square root others go on.

use super::lamps::Lit;
use super::random::Random;
use super::textures;
use super::trace::{Path, Tracer};
use crate::math::color::FourColors;
use crate::math::{Lanes, Rgb, Rgbft};
use crate::world::hit::Hit;
use crate::world::light::Incident;
use crate::world::object::{Leaf, LeafFlags};
use crate::world::sample::{Sample, Samples};
use crate::world::texture::{Finish, Layer, Paint, Pigment};
use crate::world::warp::Warps;
use crate::world::{Intersection, Ray};

/// Rays that travel together, and what they meet first.
#[derive(Debug)]
pub(super) struct Bundle<'a, const N: usize> {
    pub(super) rays: [Ray; N],
    /// The most that each can add to its pixel.
    pub(super) weights: [f32; N],
    /// `None` for those that are of no interest.
    pub(super) hits: [Option<&'a Hit>; N],
    /// Where the random numbers of each start; `None` goes on with those at hand.
    pub(super) randoms: Option<&'a [Random; N]>,
}

/// Room for the surfaces that a bundle meets, and for what a lamp sends there: kept, for clearing it takes time.
#[derive(Debug)]
pub(super) struct Room<const N: usize> {
    pub(super) surfaces: [Intersection; N],
    pub(super) incidents: [Incident; N],
}

impl<const N: usize> Room<N> {
    /// Room for any bundle.
    pub(super) const NEW: Self =
        Self { surfaces: [Intersection::NOWHERE; N], incidents: [Incident::NOTHING; N] };
}

/// A layer that is that simple.
pub(super) struct Plain<'w> {
    pub(super) finish: &'w Finish,
    pub(super) color: Rgb,
    /// The pattern that has yet to say the colour.
    unpainted: Option<Patterned<'w>>,
}

/// A pigment which is not the same everywhere.
#[derive(Clone, Copy)]
struct Patterned<'w> {
    pigment: &'w Pigment,
    /// The way to it from the world, if there is one.
    placement: Option<&'w Warps>,
}

impl Patterned<'_> {
    fn is(&self, other: &Self) -> bool {
        let places = [self.placement, other.placement].map(|placement| placement.map(std::ptr::from_ref));
        std::ptr::eq(self.pigment, other.pigment) && places[0] == places[1]
    }

    #[inline(always)]
    fn color(&self, sample: &Sample) -> Option<Rgbft> {
        match self.placement {
            Some(way) => self.pigment.color(&sample.moved(way.point(sample.point))),
            None => self.pigment.soon_color(sample),
        }
    }

    fn colors(&self, samples: &Samples) -> FourColors {
        match self.placement {
            Some(way) => self.pigment.colors(&samples.moved(way.four(&samples.point))),
            None => self.pigment.colors(samples),
        }
    }
}

impl<'w> Tracer<'w> {
    /// The layer of a leaf which is all there is to it, without bumps and film, and neither grained, and the way to it
    /// from the world.
    #[inline]
    pub(super) fn only_layer(&self, leaf: &Leaf) -> Option<(&'w Layer, Option<&'w Warps>)> {
        let world: &'w _ = self.world;
        let number = leaf.texture.get().filter(|_| !leaf.flags.contains(LeafFlags::SEVERAL))?;
        let texture = &world.textures[number as usize];
        match texture.layers() {
            Some([layer]) if layer.normal.is_none() => {
                let dry = layer.finish.irid.is_none() && layer.finish.crand == 0.0;
                dry.then(|| (layer, texture.placement()))
            }
            _ => None,
        }
    }

    /// The layer at a hit of a leaf and its colour, if that is so simple. Writes down where the ray met it. Of `several`
    /// rays that travel together, those that meet a pattern are left unpainted.
    #[inline(always)]
    fn simple(
        &mut self,
        leaf: &Leaf,
        ray: &Ray,
        hit: &Hit,
        surface: &mut Intersection,
        several: bool,
    ) -> Option<Plain<'w>> {
        let world = self.world;
        if !self.plain || !leaf.flags.contains(LeafFlags::OPAQUE) {
            return None;
        }
        let (layer, placement) = self.only_layer(leaf)?;
        let finish: &Finish = &layer.finish;
        *surface = world.geometry.surface(ray, hit);
        let mut unpainted = None;
        let color = match &layer.paint {
            Paint::Even(color) => Rgbft::new(*color),
            Paint::Pigment(pigment) => {
                let patterned = Patterned { pigment, placement };
                if several && !pigment.is_soon_known() {
                    unpainted = Some(patterned);
                    Rgbft::BLACK
                } else {
                    patterned.color(&textures::sample(world, ray, hit, surface))?
                }
            }
        };
        if color.filter != 0.0 || color.transmit != 0.0 {
            return None;
        }
        self.statistics.texture_evaluations += 1;
        Some(Plain { finish, color: color.rgb, unpainted })
    }

    /// Finds the colours of the patterns that rays meet, side by side where several meet the same.
    #[inline(never)]
    fn paint<const N: usize>(
        &mut self,
        bundle: &Bundle<N>,
        surfaces: &[Intersection; N],
        met: &mut [Option<Plain<'w>>; N],
    ) {
        let world = self.world;
        for first in 0..N {
            let Some(pattern) = met[first].as_ref().and_then(|plain| plain.unpainted) else { continue };
            // Where there are fewer than four, the first stands for the others.
            let (mut lanes, mut count) = ([first; Lanes::COUNT], 0);
            for (lane, other) in met.iter().enumerate().skip(first) {
                let other = other.as_ref().and_then(|plain| plain.unpainted);
                if count < Lanes::COUNT && other.is_some_and(|other| pattern.is(&other)) {
                    lanes[count] = lane;
                    count += 1;
                }
            }
            let sample = |lane: usize| {
                let hit = bundle.hits[lane]?;
                Some(textures::sample(world, &bundle.rays[lane], hit, &surfaces[lane]))
            };
            let Some(alone) = sample(first) else { continue };
            let mut colors = FourColors::NONE;
            if count == 1 {
                colors.set(0, pattern.color(&alone));
            } else {
                let mut samples = [alone; Lanes::COUNT];
                for place in 1..count {
                    samples[place] = sample(lanes[place]).unwrap_or(alone);
                }
                colors = pattern.colors(&Samples::of(&samples));
            }
            for (place, &lane) in lanes[..count].iter().enumerate() {
                let color = colors.get(place).filter(|color| color.filter == 0.0 && color.transmit == 0.0);
                match (color, &mut met[lane]) {
                    (Some(color), Some(plain)) => (plain.color, plain.unpainted) = (color.rgb, None),
                    (_, met) => {
                        self.statistics.texture_evaluations -= 1;
                        *met = None;
                    }
                }
            }
        }
    }

    /// The colours of the surfaces that rays met which are that simple. Those from the `EYE` travel on together where
    /// they are mirrored.
    #[inline(always)]
    pub(super) fn plain<const N: usize, const EYE: bool>(
        &mut self,
        path: &mut Path,
        bundle: &Bundle<N>,
        room: &mut Room<N>,
    ) -> [Option<Rgb>; N] {
        let world = self.world;
        let mut met = [const { None }; N];
        let mut unpainted = false;
        for (lane, met) in met.iter_mut().enumerate() {
            let Some(hit) = bundle.hits[lane] else { continue };
            let leaf = world.geometry.parts().leaf(hit.leaf);
            *met = self.simple(leaf, &bundle.rays[lane], hit, &mut room.surfaces[lane], N > 1);
            unpainted |= met.as_ref().is_some_and(|plain| plain.unpainted.is_some());
        }
        if unpainted {
            self.paint(bundle, &room.surfaces, &mut met);
        }
        let direct = self.lit_by_lamps::<N, EYE>(
            &path.inside,
            bundle,
            #[inline(always)]
            |lane| {
                let Plain { finish, color, .. } = met[lane].as_ref()?;
                Some(Lit { finish, color: *color, opacity: 1.0 })
            },
            room,
        );
        let surfaces = &room.surfaces;
        let mirrors =
            |plain: &Option<Plain>| plain.as_ref().is_some_and(|plain| plain.finish.reflection.is_some());
        let mut mirrored = [None; N];
        if EYE && met.iter().any(mirrors) {
            self.reflections(path, bundle, &met, surfaces, &mut mirrored);
        }
        let mut seen = [None; N];
        for lane in 0..N {
            let (Some(Plain { finish, color, .. }), Some(hit)) = (&met[lane], bundle.hits[lane]) else {
                continue;
            };
            let own = finish.ambient * world.settings.ambient_light + finish.emission;
            let mut sum = *color * own + direct[lane];
            if let Some(mirrored) = mirrored[lane] {
                sum += mirrored;
            } else if finish.reflection.is_some() {
                (path.ray, path.weight) = (bundle.rays[lane], bundle.weights[lane]);
                self.random = bundle.randoms.map_or(self.random, |randoms| randoms[lane]);
                sum += self.mirrored_by(path, hit, &surfaces[lane], finish, *color);
            }
            seen[lane] = Some(sum);
        }
        seen
    }
}
