//! The crossings of a ray with a small piece of a parametric surface.
//!
//! Seen along the ray the piece is a crooked quadrangle, nearly bilinear. Where all of it is turned the same way it
//! has one crossing at most, and Newton's method finds it. Where it folds over, or nearly, it is
//! halved: towards the fold both sheets become thin, so few parts are left of it, and each sheet comes apart.

use super::{Crossing, Parametric};
use crate::math::{DMat3, DVec2, DVec3};
use crate::world::Ray;
use crate::world::shape::triangle::{Sheared, blend};

/// Steps of Newton's method before it is given up.
const TRIES: usize = 12;

/// By how much of its size a crossing may be beside the piece it was looked for in.
const BESIDE: f64 = 1e-6;

/// Times a piece is halved along both parameters, at most.
const HALVINGS: u32 = 28;

/// Parts that are looked at in all: poles have many.
const PARTS: usize = 400;

/// How evenly a part is turned towards the ray that is taken to have no fold: the least over the greatest of what
/// its quarters show, in whose middles the change is half of that between its sides.
const EVEN: f64 = 0.5;

/// A surface and a ray.
pub(super) struct Piece<'a> {
    surface: &'a Parametric,
    ray: &'a Ray,
    sheared: Sheared,
}

/// A rectangle of parameters with the points at its corners by u and v, and how far it may be from bilinear.
#[derive(Clone, Copy)]
struct Part {
    from: DVec2,
    to: DVec2,
    corners: [[DVec3; 2]; 2],
    bent: DVec3,
    depth: u32,
}

impl Part {
    /// How much it is turned towards the ray, at each corner.
    fn turns(&self, direction: DVec3) -> [f64; 4] {
        let [[near, up], [right, far]] = self.corners;
        let turn = |along: DVec3, across: DVec3| along.cross(across).dot(direction);
        [
            turn(right - near, up - near),
            turn(right - near, far - right),
            turn(far - up, up - near),
            turn(far - up, far - right),
        ]
    }

    /// Whether a ray may meet it: seen along the ray, all of it may be on one side.
    fn may_meet(&self, ray: &Ray) -> bool {
        let [[near, up], [right, far]] = self.corners;
        // Across the piece first, where it is thin if it is seen from the side.
        let normal = (far - near).cross(up - right);
        let across = normal - ray.direction * (normal.dot(ray.direction) / ray.direction.length_squared());
        let along = ray.direction.cross(across);
        [across, along].into_iter().all(|axis| {
            let room = self.bent.dot(axis.abs()) * 2.0;
            let offsets = [near, up, right, far].map(|corner| (corner - ray.origin).dot(axis));
            let (low, high) = offsets.iter().fold((f64::MAX, f64::MIN), |(a, b), t| (a.min(*t), b.max(*t)));
            // What is no number rules nothing out.
            !(low > room || high < -room)
        })
    }
}

/// Whether the quarters of a part are turned towards the ray alike.
fn are_even(quarters: &[Part; 4], direction: DVec3) -> bool {
    let turns = quarters.iter().flat_map(|part| part.turns(direction));
    let (least, most) = turns.fold((f64::MAX, f64::MIN), |(a, b), t| (a.min(t), b.max(t)));
    if least > 0.0 { least >= EVEN * most } else { most < 0.0 && most <= EVEN * least }
}

impl<'a> Piece<'a> {
    pub(super) fn new(surface: &'a Parametric, ray: &'a Ray) -> Self {
        Self { surface, ray, sheared: Sheared::new(ray) }
    }

    /// Calls back with the crossings in a rectangle of parameters whose corners are known.
    pub(super) fn meet(
        &self,
        from: DVec2,
        to: DVec2,
        corners: [[DVec3; 2]; 2],
        found: &mut dyn FnMut(Crossing),
    ) {
        let mut waiting = vec![Part { from, to, corners, bent: DVec3::INFINITY, depth: 0 }];
        let mut parts = 0;
        while let Some(part) = waiting.pop() {
            parts += 1;
            if part.depth > 0 && !part.may_meet(self.ray) {
                continue;
            }
            let quarters = self.quarters(&part);
            if are_even(&quarters, self.ray.direction)
                && let Some(hit) = self.refine(&part)
            {
                hit.into_iter().for_each(&mut *found);
            } else if part.depth < HALVINGS && parts < PARTS {
                waiting.extend(quarters);
            } else {
                self.flat(&part).into_iter().for_each(&mut *found);
            }
        }
    }

    fn quarters(&self, part: &Part) -> [Part; 4] {
        let Part { from, to, corners: [[near, up], [right, far]], .. } = *part;
        let middle = 0.5 * (from + to);
        let point = |u: f64, v: f64| self.surface.point(DVec2::new(u, v));
        let (left, bottom) = (point(from.x, middle.y), point(middle.x, from.y));
        let (east, top) = (point(to.x, middle.y), point(middle.x, to.y));
        let center = point(middle.x, middle.y);
        // What a half of it bends is about a quarter.
        let off = |p: DVec3, a: DVec3, b: DVec3| (p - a.midpoint(b)).abs();
        let bends = [off(left, near, up), off(bottom, near, right), off(east, right, far), off(top, up, far)];
        let bent = bends.into_iter().fold(off(center, left, east).max(off(center, bottom, top)), DVec3::max);
        let depth = part.depth + 1;
        let part = |from: DVec2, to: DVec2, corners: [[DVec3; 2]; 2]| Part { from, to, corners, bent, depth };
        [
            part(from, middle, [[near, left], [bottom, center]]),
            part(DVec2::new(from.x, middle.y), DVec2::new(middle.x, to.y), [[left, up], [center, top]]),
            part(DVec2::new(middle.x, from.y), DVec2::new(to.x, middle.y), [[bottom, center], [right, east]]),
            part(middle, to, [[center, top], [east, far]]),
        ]
    }

    /// The crossing in a part that has one at most; `None` where Newton's method leads nowhere.
    fn refine(&self, part: &Part) -> Option<Option<Crossing>> {
        let (size, ray) = (part.to - part.from, self.ray);
        let mut at = 0.5 * (part.from + part.to);
        let [[a, b], [c, d]] = part.corners;
        let mut t = (0.25 * (a + b + c + d) - ray.origin).dot(ray.direction) / ray.direction.length_squared();
        let (start, reach) = (at, 8.0 * size);
        let mut last = f64::INFINITY;
        for _ in 0..TRIES {
            let [along_u, along_v] = self.surface.slopes(at);
            let matrix = DMat3::from_cols(along_u, along_v, -ray.direction);
            let step = matrix.inverse() * (ray.at(t) - self.surface.point(at));
            if !step.is_finite() {
                return None;
            }
            (at, t) = (at + step.truncate(), t + step.z);
            let length = (step.truncate() / size).length();
            // Rounding alone moves it any more.
            if length < BESIDE && length >= 0.5 * last || length == 0.0 {
                last = length;
                break;
            }
            if (at - start).abs().cmpgt(reach).any() {
                return None;
            }
            last = length;
        }
        if last >= BESIDE {
            return None;
        }
        let room = BESIDE * size;
        let within = at.cmpge(part.from - room).all() && at.cmple(part.to + room).all();
        let all = &self.surface.description;
        let at = at.clamp(all.from, all.to).to_array();
        Some(within.then_some(Crossing { t, part: 0, at }))
    }

    /// The crossing with a part that is as small as it gets, or beside a kink or a pole.
    fn flat(&self, part: &Part) -> Option<Crossing> {
        let [[near, up], [right, far]] = part.corners;
        let size = part.to - part.from;
        let (along_u, along_v) = (size * DVec2::X, size * DVec2::Y);
        let triangles = [
            ([near, right, up], [part.from, part.from + along_u, part.from + along_v]),
            ([far, up, right], [part.to, part.to - along_u, part.to - along_v]),
        ];
        triangles.into_iter().find_map(|(corners, parameters)| {
            let hit = self.sheared.meet(corners)?;
            Some(Crossing { t: hit.t, part: 0, at: blend(parameters, hit.at).to_array() })
        })
    }
}
