//! The planes of an intersection, four at a time: of all of them a line keeps one stretch.

use super::object::{Leaf, LeafFlags, Member};
use super::ray::Ray;
use super::shape::plane::Plane;
use super::shape::{Primitive, Shape};
use crate::math::{DVec3, Lanes, Transform, tally};

/// Fewer planes are asked one by one.
const LEAST: usize = 3;

/// Planes in common.
#[derive(Debug)]
pub struct Facets {
    fours: Vec<Four>,
    planes: Vec<Facet>,
    /// The members that are no planes, in the order of the text.
    pub others: Vec<Member>,
}

/// A half-space.
#[derive(Debug)]
struct Facet {
    plane: Plane,
    place: Option<Box<Transform>>,
    /// Whether it is the half in front of the plane.
    inverted: bool,
    leaf: u32,
}

/// Four half-spaces.
#[derive(Debug)]
struct Four {
    /// Pointing out of them.
    normal: [Lanes; 3],
    /// The origins of their spaces, and how far from those they reach, in lengths of the normals.
    center: [Lanes; 3],
    distance: Lanes,
    /// Which of them there are, as bits.
    present: u32,
}

/// Where a line enters the last of some half-spaces, and where it leaves the first: distances and leaves.
#[derive(Clone, Copy, Debug)]
pub struct Common {
    /// Negative infinity if it enters none.
    pub enter: (f64, u32),
    /// Infinity if it leaves none.
    pub leave: (f64, u32),
}

impl Facets {
    /// Of the members of an intersection, where enough are planes.
    pub fn new<'a>(members: &[Member], leaf: impl Fn(u32) -> &'a Leaf) -> Option<Self> {
        let mut facets = Self { fours: Vec::new(), planes: Vec::new(), others: Vec::new() };
        for &member in members {
            match member {
                Member::Leaf(number)
                    if let leaf = leaf(number)
                        && let Primitive::Plane(plane) = leaf.primitive =>
                {
                    let inverted = leaf.flags.contains(LeafFlags::INVERTED);
                    let place = leaf.transform.clone();
                    facets.planes.push(Facet { plane, place, inverted, leaf: number });
                }
                _ => facets.others.push(member),
            }
        }
        facets.fours = facets.planes.chunks(Lanes::COUNT).map(Four::new).collect();
        (facets.planes.len() >= LEAST).then_some(facets)
    }

    /// What a line has in common with all; `None` if nothing. Hands out the distances to the planes, those of four
    /// at a time; no numbers where there are fewer.
    #[inline(always)]
    pub fn common(&self, ray: &Ray, mut met: impl FnMut(Lanes)) -> Option<Common> {
        tally::primitives(self.planes.len());
        let (mut enter, mut leave) = (Lanes::splat(f64::NEG_INFINITY), Lanes::splat(f64::INFINITY));
        let (mut entered, mut left) = (Lanes::ZERO, Lanes::ZERO);
        for (place, four) in self.fours.iter().enumerate() {
            let (height, slope) = four.seen_from(ray);
            let mut parallel = slope.bits(|slope| slope == 0.0) & four.present;
            while parallel != 0 {
                let lane = parallel.trailing_zeros() as usize;
                let facet = self.planes.get(Lanes::COUNT * place + lane)?;
                if facet.holds(ray.origin) == facet.inverted {
                    return None;
                }
                parallel &= parallel - 1;
            }
            let t = -height / slope;
            met(t);
            let number = Lanes::splat(place as f64);
            let later = (t - enter).zip(slope, |later, slope| if slope < 0.0 { later } else { 0.0 });
            let sooner = (leave - t).zip(slope, |sooner, slope| if slope > 0.0 { sooner } else { 0.0 });
            (enter, entered) = (t.where_positive(later, enter), number.where_positive(later, entered));
            (leave, left) = (t.where_positive(sooner, leave), number.where_positive(sooner, left));
        }
        let (mut last, mut first) = (0, 0);
        for lane in 1..Lanes::COUNT {
            last = if enter.0[lane] > enter.0[last] { lane } else { last };
            first = if leave.0[lane] < leave.0[first] { lane } else { first };
        }
        let leaf = |fours: Lanes, lane: usize| {
            self.planes.get(Lanes::COUNT * fours.0[lane] as usize + lane).map_or(0, |facet| facet.leaf)
        };
        Some(Common {
            enter: (enter.0[last], leaf(entered, last)),
            leave: (leave.0[first], leaf(left, first)),
        })
    }
}

impl Facet {
    /// Whether a point is behind the plane.
    fn holds(&self, point: DVec3) -> bool {
        self.plane.inside(self.place.as_ref().map_or(point, |place| place.inverse_point(point)))
    }
}

impl Four {
    fn new(facets: &[Facet]) -> Self {
        let none = [Lanes::ZERO; 3];
        let mut four = Self { normal: none, center: none, distance: Lanes::ZERO, present: 0 };
        for (lane, Facet { plane, place, inverted, .. }) in facets.iter().enumerate() {
            let sign = if *inverted { -1.0 } else { 1.0 };
            let (normal, center) = place.as_ref().map_or((plane.normal, DVec3::ZERO), |place| {
                (place.inverse.matrix3.transpose() * plane.normal, place.forward.translation)
            });
            for axis in 0..3 {
                four.normal[axis].0[lane] = sign * normal[axis];
                four.center[axis].0[lane] = center[axis];
            }
            four.distance.0[lane] = sign * plane.distance;
            four.present |= 1 << lane;
        }
        four
    }

    /// How far a ray starts outside of each, and how fast it goes there.
    #[inline(always)]
    fn seen_from(&self, ray: &Ray) -> (Lanes, Lanes) {
        let ([a, b, c], [x, y, z]) = (&self.center, ray.origin.to_array());
        let from = [Lanes::splat(x) - *a, Lanes::splat(y) - *b, Lanes::splat(z) - *c];
        let [x, y, z] = ray.direction.to_array();
        let along = [Lanes::splat(x), Lanes::splat(y), Lanes::splat(z)];
        (Lanes::dot(&self.normal, &from) - self.distance, Lanes::dot(&self.normal, &along))
    }
}
