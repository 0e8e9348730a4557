//! The lights that reach an object. Where many are cones, those that miss a point or a line are told apart four at a
//! time: many lights cost only where they reach.

use smallvec::SmallVec;

use super::{Kind, Light};
use crate::math::wide::widest;
use crate::math::{DVec3, Lanes};
use crate::world::Ray;

/// So many cones are worth the room they take side by side.
const MANY: usize = 4;

/// Room for numbers of lights. Nothing is made ready until it is needed: few sets need it, and every hit brings some.
#[derive(Debug, Default)]
pub struct Numbers(Option<SmallVec<[u32; 16]>>);

impl Numbers {
    /// Room that was not in use.
    #[inline]
    pub const fn new() -> Self {
        Self(None)
    }
}

/// The lights that reach an object.
#[derive(Clone, Debug, Default)]
pub struct LightSet {
    /// Their numbers, in the order of the text.
    numbers: Box<[u32]>,
    /// Their cones; empty where these are few.
    cones: Box<[Cones]>,
}

/// The cones of four lights.
#[derive(Clone, Debug)]
struct Cones {
    tip: [Lanes; 3],
    /// Unit vectors.
    axis: [Lanes; 3],
    /// The squared cosine that is [dark](super::Spotlight::dark); below 0 for what is no cone.
    dark: Lanes,
    /// The squared cosine of the cone that [`Light::reach`] tells of; below 0 for what is none, or too wide.
    edge: Lanes,
}

impl LightSet {
    /// The set of these numbers of `lights`.
    pub fn new(numbers: Vec<u32>, lights: &[Light]) -> Self {
        let of_set = |number: &u32| &lights[*number as usize];
        let is_cone = |light: &Light| matches!(light.kind, Kind::Spotlight(_));
        let many = numbers.iter().map(of_set).filter(|light| is_cone(light)).count() >= MANY;
        let cones = if many {
            numbers.chunks(Lanes::COUNT).map(|four| Cones::new(four.iter().map(of_set))).collect()
        } else {
            Box::default()
        };
        Self { numbers: numbers.into(), cones }
    }

    /// All of them.
    pub fn all(&self) -> &[u32] {
        &self.numbers
    }

    /// Those that may light a point, which `room` is for.
    #[inline]
    pub fn lighting<'a>(&'a self, point: DVec3, room: &'a mut Numbers) -> &'a [u32] {
        if self.cones.is_empty() { &self.numbers } else { self.but(room, |cones| cones.missing(point)) }
    }

    /// Those that may light some point of a line, which `room` is for.
    #[inline]
    pub fn beside<'a>(&'a self, ray: &Ray, room: &'a mut Numbers) -> &'a [u32] {
        if self.cones.is_empty() { &self.numbers } else { self.but(room, |cones| cones.passed_by(ray)) }
    }

    /// All but those whose bits are set.
    fn but<'a>(&self, room: &'a mut Numbers, misses: impl Fn(&Cones) -> u32) -> &'a [u32] {
        let room = room.0.get_or_insert_default();
        room.clear();
        for (cones, numbers) in self.cones.iter().zip(self.numbers.chunks(Lanes::COUNT)) {
            let missing = misses(cones);
            for (lane, &number) in numbers.iter().enumerate() {
                if missing & 1 << lane == 0 {
                    room.push(number);
                }
            }
        }
        room
    }
}

impl Cones {
    fn new<'a>(lights: impl Iterator<Item = &'a Light>) -> Self {
        let nothing = Lanes::splat(-1.0);
        let mut cones = Self { tip: [Lanes::ZERO; 3], axis: [Lanes::ZERO; 3], dark: nothing, edge: nothing };
        for (lane, light) in lights.enumerate() {
            for axis in 0..3 {
                cones.tip[axis].0[lane] = light.location[axis];
                cones.axis[axis].0[lane] = light.axis[axis];
            }
            if let Some(spot) = light.cone() {
                cones.dark.0[lane] = spot.dark();
            }
            if let Kind::Spotlight(spot) = &light.kind
                && spot.cos_falloff() > 0.0
            {
                cones.edge.0[lane] = spot.cos_falloff() * spot.cos_falloff();
            }
        }
        cones
    }

    /// The bits of those that surely miss a point: what [`Spotlight::misses`](super::Spotlight::misses) tells of one.
    fn missing(&self, point: DVec3) -> u32 {
        widest(
            #[inline(always)]
            || {
                let way = self.ways_to(point);
                let along = Lanes::dot(&way, &self.axis);
                let outside = self.dark * Lanes::dot(&way, &way) - along * along;
                let cone = self.dark.bits(|dark| dark > 0.0);
                (along.bits(|along| along < 0.0) | outside.bits(|outside| outside > 0.0)) & cone
            },
        )
    }

    /// The bits of those whose double cone no point of a line is in: there [`Light::reach`] finds nothing.
    fn passed_by(&self, ray: &Ray) -> u32 {
        widest(
            #[inline(always)]
            || {
                let direction = ray.direction.to_array().map(Lanes::splat);
                let from = self.ways_to(ray.origin);
                let middle = -Lanes::dot(&from, &direction);
                let [x, y, z] = direction;
                let near = [from[0] + middle * x, from[1] + middle * y, from[2] + middle * z];
                let (along, slope) = (Lanes::dot(&near, &self.axis), Lanes::dot(&direction, &self.axis));
                let a = slope * slope - self.edge;
                let b = along * slope;
                let c = along * along - self.edge * Lanes::dot(&near, &near);
                a.bits(|a| a < 0.0) & (b * b - a * c).bits(|root| root <= 0.0)
            },
        )
    }

    #[inline(always)]
    fn ways_to(&self, point: DVec3) -> [Lanes; 3] {
        let [x, y, z] = &self.tip;
        [Lanes::splat(point.x) - *x, Lanes::splat(point.y) - *y, Lanes::splat(point.z) - *z]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dice::numbers;
    use crate::world::light::{Cylinder, Spotlight};

    #[test]
    fn only_lights_that_do_not_reach_are_passed_over() {
        let mut number = numbers(31);
        let mut point = || DVec3::new(number(), number(), number());
        let mut lights = Vec::new();
        for turn in 0..22 {
            let angle = [3.0, 25.0, 60.0, 90.0, 130.0][turn % 5];
            let kind = match turn % 7 {
                0 => Kind::Point,
                1 => Kind::Cylinder(Cylinder { radius: 1.0, falloff: 1.0, tightness: 0.0 }),
                _ => Kind::Spotlight(Spotlight::new(angle, angle * [0.8, 1.3][turn % 2], 1.0)),
            };
            let axis = point().normalize_or(DVec3::X);
            let light = super::super::tests::light(kind);
            lights.push(Light { location: 4.0 * point(), axis, parallel: turn % 11 == 4, ..light });
        }
        let set = LightSet::new((0..22).rev().step_by(2).chain([4, 6]).collect(), &lights);
        let (mut passed, mut room) = (0, Numbers::new());
        for _ in 0..2000 {
            let place = 5.0 * point();
            let near = set.lighting(place, &mut room).to_vec();
            let lit = |number: &u32| {
                let light = &lights[*number as usize];
                !light.reaching_from(place, light.location, light.axis).is_dark()
            };
            let ray = Ray::new(place, point().normalize_or(DVec3::X));
            let beside = set.beside(&ray, &mut room).to_vec();
            let reached = |number: &u32| lights[*number as usize].reach(&ray, 100.0).is_some();
            for number in set.all() {
                assert!(near.contains(number) || !lit(number), "{place}: {:?}", lights[*number as usize]);
                assert!(beside.contains(number) || !reached(number), "{ray:?}: {number}");
            }
            assert!(near.iter().is_sorted_by_key(|near| set.all().iter().position(|all| all == near)));
            passed += 2 * set.all().len() - near.len() - beside.len();
        }
        assert!(passed > 8000, "{passed}");
    }
}
