//! Rays of a bundle that meet a [clear](super::clear) surface go on together, through it and back from it, until they
//! part. What they see is what each of them would see alone.

use super::lamps::Lit;
use super::mirror::{self, Reflectivity};
use super::plain::{Bundle, Room};
use super::refract::{self, Inside, Passage};
use super::trace::{Path, Seen, Tracer};
use crate::math::color::grey;
use crate::math::wide::widest;
use crate::math::{Lanes, Rgb, Rgbft};
use crate::world::object::Leaf;
use crate::world::texture::Finish;
use crate::world::{Intersection, RayKind, Rays};

const FOUR: usize = Lanes::COUNT;

/// Where four rays met a surface, side by side.
struct Sides {
    point: [Lanes; 3],
    /// Unit normals, towards where the rays come from.
    normal: [Lanes; 3],
    /// As [`Intersection::error`].
    error: Lanes,
    /// Where the rays go.
    direction: [Lanes; 3],
}

/// Up to four rays that a surface sends on.
struct Sent {
    rays: Rays,
    /// The bits of those that there are.
    lanes: u32,
    /// The most that each can add to its pixel.
    weights: [f32; FOUR],
    /// What of the light and of the transparency that each sees comes on.
    left: [Rgb; FOUR],
    clear: [f32; FOUR],
    /// Powers of the light come on.
    powers: [f32; FOUR],
}

impl Sides {
    #[inline(always)]
    fn of(surfaces: &[Intersection; FOUR], bundle: &Bundle<FOUR>) -> Self {
        let none = [Lanes::ZERO; 3];
        let mut all = Self { point: none, normal: none, error: Lanes::ZERO, direction: none };
        for (lane, (surface, ray)) in surfaces.iter().zip(&bundle.rays).enumerate() {
            all.error.0[lane] = surface.error;
            for axis in 0..3 {
                all.point[axis].0[lane] = surface.point[axis];
                all.normal[axis].0[lane] = surface.normal[axis];
                all.direction[axis].0[lane] = ray.direction[axis];
            }
        }
        all
    }

    /// Rays in some directions that leave the surface, none of them yet.
    #[inline(always)]
    fn sent(&self, direction: [Lanes; 3]) -> Sent {
        let slope = Lanes::dot(&direction, &self.normal);
        let room = self.error.zip(slope, |error, slope| if slope < 0.0 { -error } else { error });
        let mut origin = self.point;
        for (along, normal) in origin.iter_mut().zip(self.normal) {
            *along = *along + room * normal;
        }
        Sent {
            rays: Rays { origin, direction },
            lanes: 0,
            weights: [0.0; FOUR],
            left: [Rgb::ZERO; FOUR],
            clear: [0.0; FOUR],
            powers: [1.0; FOUR],
        }
    }
}

impl Sent {
    #[inline(always)]
    fn set(&mut self, lane: usize, weight: f32, left: Rgb, clear: f32) {
        self.lanes |= 1 << lane;
        (self.weights[lane], self.left[lane], self.clear[lane]) = (weight, left, clear);
    }

    /// Adds what comes on of what one of them sees.
    #[inline(always)]
    fn add(&self, lane: usize, more: &Seen, seen: &mut Seen) {
        let power = self.powers[lane];
        let color = if power == 1.0 { more.color } else { more.color.powf(power) };
        seen.color += self.left[lane] * color;
        seen.transmit += self.clear[lane] * more.transmit;
    }
}

impl Tracer<'_> {
    /// What those rays of a bundle see whose bits are `open` and that meet the same clear surface, where they are several;
    /// answers with their bits. Nobody takes random numbers here.
    #[inline(never)]
    pub(super) fn clear_together(
        &mut self,
        path: &Path,
        bundle: &Bundle<FOUR>,
        open: u32,
        room: &mut Room<FOUR>,
        seen: &mut [Seen; FOUR],
    ) -> u32 {
        let first = bundle.hits[open.trailing_zeros() as usize % FOUR];
        let Some(number) = first.map(|hit| hit.leaf) else { return 0 };
        let mut met = 0;
        for lane in 0..FOUR {
            let same = bundle.hits[lane].is_some_and(|hit| hit.leaf == number);
            met |= (u32::from(same) << lane) & open;
        }
        let leaf = self.world.geometry.parts().leaf(number);
        if met.count_ones() < 2 || !leaf.meets_four() {
            return 0;
        }
        let Some(layer) = self.clear_layer(leaf) else { return 0 };
        let passage = path.inside.pass(leaf.interior, &self.world.interiors);
        if passage.is_straight() {
            return 0;
        }
        self.statistics.texture_evaluations += u64::from(met.count_ones());
        widest(
            #[inline(always)]
            || {
                self.surfaces_of_four(bundle, met, room);
                let (finish, color) = layer;
                let lit = Lit { finish, color: color.rgb, opacity: self.opacity(&color) };
                let direct = self.lit_by_lamps::<FOUR, false>(
                    &path.inside,
                    bundle,
                    #[inline(always)]
                    |lane| (met >> lane & 1 == 1).then_some(lit),
                    room,
                );
                let own = finish.ambient * self.world.settings.ambient_light + finish.emission;
                for lane in 0..FOUR {
                    let color = color.rgb * own * lit.opacity + direct[lane];
                    seen[lane] = Seen { color, transmit: 0.0 };
                }
                // Used where they are made: copies of what was only just written would wait for it.
                let (through, back) = self.parted((path, bundle, met), leaf, layer, &passage, room);
                self.statistics.refracted_rays += u64::from(through.lanes.count_ones());
                self.statistics.reflected_rays += u64::from(back.lanes.count_ones());
                self.add_seen((path.level, path.kind, &passage.inside), &through, seen);
                self.add_seen((path.level, RayKind::REFLECTION, &path.inside), &back, seen);
            },
        );
        met
    }

    /// The surfaces that the rays of some lanes met; the other lanes have one of theirs.
    #[inline(always)]
    fn surfaces_of_four(&self, bundle: &Bundle<FOUR>, met: u32, room: &mut Room<FOUR>) {
        let first = met.trailing_zeros() as usize % FOUR;
        for lane in 0..FOUR {
            let lane_met = if met >> lane & 1 == 1 { lane } else { first };
            if let Some(hit) = bundle.hits[lane_met] {
                room.surfaces[lane] = self.world.geometry.surface(&bundle.rays[lane_met], hit);
            }
        }
    }

    /// The rays that go through a surface and those that it sends back, as `Tracer::clear` has it for one.
    #[inline(always)]
    fn parted(
        &mut self,
        (path, bundle, met): (&Path, &Bundle<FOUR>, u32),
        leaf: &Leaf,
        (finish, color): (&Finish, Rgbft),
        passage: &Passage,
        room: &Room<FOUR>,
    ) -> (Sent, Sent) {
        let settings = &self.world.settings;
        let sides = Sides::of(&room.surfaces, bundle);
        let reflection = finish.reflection.as_ref().filter(|_| self.quality.reflection);
        let mut shares = [None::<Reflectivity>; FOUR];
        if let Some(reflection) = reflection {
            let cosine = -Lanes::dot(&sides.direction, &sides.normal);
            let index = || path.inside.fresnel_index(leaf.interior, &self.world.interiors);
            let fresnel = reflection.fresnel.then(|| mirror::fresnel_of_four(index(), cosine));
            for (lane, known) in shares.iter_mut().enumerate() {
                let share = match fresnel {
                    Some(fresnel) => fresnel.0[lane] as f32,
                    None => mirror::share(reflection, cosine.0[lane], 1.0),
                };
                *known = Some(mirror::of_share(reflection, cosine.0[lane], share, color.rgb));
            }
        }
        let (onward, bends) = refract::refracted_of_four(&sides.direction, &sides.normal, passage.ratio);
        let mut through = sides.sent(onward);
        let mut back = sides.sent(mirror::mirrored_of_four(&sides.direction, &sides.normal));
        for (lane, share) in shares.iter().enumerate() {
            let Some(hit) = bundle.hits[lane].filter(|_| met >> lane & 1 == 1) else { continue };
            let weight = bundle.weights[lane];
            let mut passing = color.through();
            if let Some(share) = share.filter(|_| finish.conserve_energy) {
                passing *= (Rgb::ONE - share.color).min(Rgb::ONE);
            }
            let clear = grey(passing).abs().min(1.0);
            let mut mirrors = true;
            if self.quality.transmission && clear > settings.adc_bailout {
                let weight = weight * passing.abs().max_element();
                let attenuation = self.attenuation(path, hit, leaf);
                if bends >> lane & 1 == 1 {
                    through.set(lane, weight, attenuation * passing, grey(attenuation) * clear);
                } else {
                    // All that is mirrored is seen by total reflection already.
                    mirrors = false;
                    self.set_back(&mut back, lane, weight, (attenuation, 1.0));
                }
            }
            if let (true, Some(reflection), Some(share)) = (mirrors, reflection, share)
                && share.color != Rgb::ZERO
            {
                let power = reflection.exponent.recip();
                self.set_back(&mut back, lane, weight * share.weight, (share.color, power));
            }
        }
        (through, back)
    }

    /// Sends a ray back, if it adds anything: a share of a power of what it sees.
    #[inline(always)]
    fn set_back(&mut self, back: &mut Sent, lane: usize, weight: f32, (left, power): (Rgb, f32)) {
        if weight < self.world.settings.adc_bailout {
            self.statistics.bailed_out += 1;
            return;
        }
        back.set(lane, weight, left, 0.0);
        back.powers[lane] = power;
    }

    /// Adds what rays see that are sent on at a level, of a kind, inside of something.
    fn add_seen(
        &mut self,
        (level, kind, inside): (u32, RayKind, &Inside),
        sent: &Sent,
        seen: &mut [Seen; FOUR],
    ) {
        let mut asked = 0;
        for lane in 0..FOUR {
            let there = sent.lanes >> lane & 1 == 1;
            asked |= u32::from(there && self.is_allowed(level, sent.weights[lane])) << lane;
        }
        if asked == 0 {
            return;
        }
        let first = asked.trailing_zeros() as usize % FOUR;
        let (ray, weight, inside) = (sent.rays.ray(first), sent.weights[first], inside.clone());
        let mut path = Path { ray, level, weight, kind, wavelength: None, inside };
        if asked.count_ones() == 1 {
            sent.add(first, &self.trace(&mut path), &mut seen[first]);
            return;
        }
        widest(
            #[inline(always)]
            || {
                let mut hits = [None; FOUR];
                self.world.geometry.hits_of_four(&sent.rays, asked, kind, &mut hits);
                let mut room = Room::NEW;
                let mut bundle = Bundle {
                    rays: [ray; FOUR],
                    weights: sent.weights,
                    hits: [hits[0].as_ref(), hits[1].as_ref(), hits[2].as_ref(), hits[3].as_ref()],
                    randoms: None,
                };
                for lane in 0..FOUR {
                    bundle.rays[lane] = sent.rays.ray(lane);
                }
                self.trace_bundle::<false>(
                    &mut path,
                    &bundle,
                    &mut room,
                    asked,
                    #[inline(always)]
                    |lane, more| sent.add(lane, &more, &mut seen[lane]),
                );
            },
        );
    }
}
