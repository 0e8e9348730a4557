//! What lamps make of the surfaces that rays of a bundle meet, step by step together.

use super::finish::Surface;
use super::plain::{Bundle, Room};
use super::refract::Inside;
use super::shadow::{Target, way};
use super::trace::Tracer;
use crate::math::{Lanes, Rgb};
use crate::world::light::set::Numbers;
use crate::world::light::{Incident, is_dark};
use crate::world::object::Leaf;
use crate::world::texture::Finish;
use crate::world::{Intersection, Rays};

/// What a layer is to lamps.
#[derive(Clone, Copy)]
pub(super) struct Lit<'a> {
    pub(super) finish: &'a Finish,
    pub(super) color: Rgb,
    /// How much of itself it shows.
    pub(super) opacity: f32,
}

impl Lit<'_> {
    /// Whether it answers light.
    #[inline(always)]
    fn is_lit(&self) -> bool {
        let scatters = self.opacity != 0.0 && (self.finish.diffuse > 0.0 || self.finish.diffuse_back > 0.0);
        scatters || self.finish.specular > 0.0 || self.finish.phong > 0.0
    }
}

impl Tracer<'_> {
    /// The light that lamps make layers send to the eye, of the lanes that have `met` one.
    #[inline(always)]
    pub(super) fn lit_by_lamps<'a, const N: usize, const EYE: bool>(
        &mut self,
        inside: &Inside,
        bundle: &Bundle<N>,
        met: impl Fn(usize) -> Option<Lit<'a>>,
        Room { surfaces, incidents }: &mut Room<N>,
    ) -> [Rgb; N] {
        let world = self.world;
        let mut rooms = [const { Numbers::new() }; N];
        let (mut lamps, mut most) = ([&[][..]; N], 0);
        for (lane, room) in rooms.iter_mut().enumerate() {
            let (Some(lit), Some(hit)) = (met(lane), bundle.hits[lane]) else { continue };
            if !lit.is_lit() {
                continue;
            }
            let leaf = world.geometry.parts().leaf(hit.leaf);
            lamps[lane] = self.lamps_near(leaf, surfaces[lane].point, room);
            most = most.max(lamps[lane].len());
        }
        let mut direct = [Rgb::ZERO; N];
        for index in 0..most {
            for lane in 0..N {
                if let Some(&number) = lamps[lane].get(index) {
                    incidents[lane] = world.lights[number as usize].reaching(surfaces[lane].point);
                }
            }
            // Rays from the eye meet what neighbours met, of which it is known what may be in the way.
            let free =
                if N > 1 && !EYE && self.glassy { self.free(index, &lamps, surfaces, incidents) } else { 0 };
            for lane in 0..N {
                let Some(&number) = lamps[lane].get(index) else { continue };
                let (Some(lit), Some(hit)) = (met(lane), bundle.hits[lane]) else { continue };
                let leaf = world.geometry.parts().leaf(hit.leaf);
                let (surface, direction) = (&surfaces[lane], &bundle.rays[lane].direction);
                let Lit { finish, color, opacity } = lit;
                let lit = Surface { finish, color, opacity, normal: &surface.normal, direction };
                let at = Target { surface, hit: Some(hit), inside, among: None };
                let free = free >> lane & 1 == 1;
                direct[lane] += self.plain_light(&at, leaf, &lit, (number, free), &incidents[lane]);
            }
        }
        direct
    }

    /// The bits of the surfaces to which light of a lamp each comes past all objects, as far as that is told at once.
    #[inline(always)]
    fn free<const N: usize>(
        &self,
        index: usize,
        lamps: &[&[u32]; N],
        surfaces: &[Intersection; N],
        incidents: &[Incident; N],
    ) -> u32 {
        let none = [Lanes::ZERO; 3];
        let (mut rays, mut ends) = (Rays { origin: none, direction: none }, Lanes::ZERO);
        let mut asked = 0u32;
        for lane in 0..N.min(Lanes::COUNT) {
            let (surface, incident) = (&surfaces[lane], &incidents[lane]);
            let Some(&number) = lamps[lane].get(index) else { continue };
            let light = &self.world.lights[number as usize];
            let simple = light.projected_through.is_none() && !light.shadowless && self.quality.shadows;
            if !simple || surface.normal.dot(incident.direction) <= 0.0 {
                continue;
            }
            let (way, range) = way(surface.leave(incident.direction), surface.error, incident);
            ends.0[lane] = range.max;
            for axis in 0..3 {
                rays.origin[axis].0[lane] = way.origin[axis];
                rays.direction[axis].0[lane] = way.direction[axis];
            }
            asked |= 1 << lane;
        }
        if asked.count_ones() < 2 { 0 } else { asked & self.world.geometry.free_of_four(&rays, ends) }
    }

    /// The light that a lamp makes a layer send to the eye; the lamp by number, and whether its light is known to be `free`
    /// of shadows.
    #[inline(always)]
    pub(super) fn plain_light(
        &mut self,
        at: &Target,
        leaf: &Leaf,
        lit: &Surface,
        (number, free): (u32, bool),
        incident: &Incident,
    ) -> Rgb {
        let light = &self.world.lights[number as usize];
        if incident.is_dark() {
            self.statistics.lights_dark += 1;
            return Rgb::ZERO;
        }
        let facing = lit.faces(leaf, &incident.direction);
        if !facing && lit.finish.diffuse_back <= 0.0 {
            self.statistics.lights_behind += 1;
            return Rgb::ZERO;
        }
        if !lit.answers(&incident.direction, !facing) {
            self.statistics.lights_unseen += 1;
            return Rgb::ZERO;
        }
        let color = if free {
            self.statistics.shadow_rays += 1;
            incident.color
        } else {
            self.arriving(at, number, incident)
        };
        if is_dark(color) {
            return Rgb::ZERO;
        }
        self.answer(lit, &incident.direction, color, !facing, light.shadowless)
    }
}
