//! `box { corner, corner }` (docs/spec/primitives.md 3.2).

use super::stretch::{End, Stretch, UNSAID};
use super::{Crossing, Shape};
use crate::math::{Band, Bounds, DVec2, DVec3, Lanes};
use crate::world::{Range, Ray, Rays};

/// An axis-aligned box, faces included. Parts: -x, +x, -y, +y, -z, +z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid {
    /// Lowest corner.
    pub min: DVec3,
    /// Highest corner.
    pub max: DVec3,
}

/// The distances of a line to the faces along each axis: where it comes inside of them and where it goes
/// out; infinite ones along axes that it doesn't advance on.
struct Faces {
    near: [f64; 3],
    far: [f64; 3],
}

/// The normals of the faces.
const NORMALS: [DVec3; 6] = [DVec3::NEG_X, DVec3::X, DVec3::NEG_Y, DVec3::Y, DVec3::NEG_Z, DVec3::Z];

/// Rounding that may part the distances of faces which meet in an edge.
const EDGE: f64 = 4.0 * f64::EPSILON;

/// Rays that pass the box by so much of their distances, far more than they are rounded by, surely miss it.
const NEAR: f64 = 1e-9;

impl Faces {
    /// The last of the near ones and the first of the far ones.
    #[inline(always)]
    fn between(&self) -> (f64, f64) {
        let ([a, b, c], [d, e, f]) = (self.near, self.far);
        let (enter, leave) = (if b > a { b } else { a }, if e < d { e } else { d });
        (if c > enter { c } else { enter }, if f < leave { f } else { leave })
    }
}

impl Cuboid {
    /// `None` for lines that miss the slab of an axis, or are none.
    #[inline(always)]
    fn faces(&self, ray: &Ray) -> Option<Faces> {
        let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
        let (min, max) = (self.min.to_array(), self.max.to_array());
        let (mut near, mut far) = ([f64::NEG_INFINITY; 3], [f64::INFINITY; 3]);
        for axis in 0..3 {
            let (o, d) = (origin[axis], direction[axis]);
            let between = if d == 0.0 {
                min[axis] <= o && o <= max[axis]
            } else {
                let (first, last) = if d > 0.0 { (min[axis], max[axis]) } else { (max[axis], min[axis]) };
                near[axis] = (first - o) / d;
                far[axis] = (last - o) / d;
                near[axis] <= far[axis]
            };
            if !between {
                return None;
            }
        }
        Some(Faces { near, far })
    }

    #[inline(always)]
    fn enter(faces: &Faces, ray: &Ray) -> End {
        let axis = outermost(&faces.near, 1.0, ray.direction);
        End { t: faces.near[axis], part: 2 * axis as u32 + u32::from(ray.direction[axis] < 0.0) }
    }

    #[inline(always)]
    fn leave(faces: &Faces, ray: &Ray) -> End {
        let axis = outermost(&faces.far, -1.0, ray.direction);
        End { t: faces.far[axis], part: 2 * axis as u32 + u32::from(ray.direction[axis] > 0.0) }
    }

    /// The nearest crossings ahead of four rays, as [`Shape::nearest`] finds them, and the numbers of their faces;
    /// no number for none. Crossings beyond `ends` need not be found.
    #[inline(always)]
    pub(super) fn nearest_of_four(&self, rays: &Rays, ends: Lanes) -> Option<[Lanes; 2]> {
        let (min, max) = (self.min.to_array(), self.max.to_array());
        let (mut near, mut far) = ([Lanes::ZERO; 3], [Lanes::ZERO; 3]);
        let (mut enter, mut leave) = (Lanes::splat(f64::NEG_INFINITY), ends);
        // The face that is entered last, and where the one before it is.
        let (mut part, mut before) = (Lanes::ZERO, enter);
        let mut steep = Lanes::splat(1.0);
        for axis in 0..3 {
            let (o, d) = (rays.origin[axis], rays.direction[axis]);
            let low = (-o + min[axis]) / d;
            let high = (-o + max[axis]) / d;
            near[axis] = low.where_positive(d, high);
            far[axis] = high.where_positive(d, low);
            let face = d.map(|d| (2 * axis) as f64 + if d < 0.0 { 1.0 } else { 0.0 });
            let less = enter.zip(near[axis], |enter, near| if near < enter { near } else { enter });
            before = before.zip(less, |before, less| if less > before { less } else { before });
            part = face.where_positive(near[axis] - enter, part);
            enter = enter.zip(near[axis], |enter, near| if near > enter { near } else { enter });
            leave = leave.zip(far[axis], |leave, far| if far < leave { far } else { leave });
            steep = steep * d;
        }
        // Where faces meet, the one that gives the crossing may be a little nearer than the other.
        let gap = enter - leave - enter.abs() * (4.0 * EDGE);
        let may = gap.zip(leave, |gap, leave| if gap > 0.0 || leave <= 0.0 { 0.0 } else { 1.0 });
        let odd = steep.bits(|steep| steep == 0.0);
        let mut asked = may.bits(|may| may > 0.0) | odd;
        if asked == 0 {
            return None;
        }
        // Where all else is farther off than rounding, that face is met.
        let room = enter * (2.0 * EDGE);
        let first = (enter - before).zip(room, |apart, room| if apart > room { 1.0 } else { 0.0 });
        let solid = (leave - enter).zip(room, |apart, room| if apart > room { 1.0 } else { 0.0 });
        let ahead = enter.zip(steep, |enter, steep| if enter > 0.0 && steep != 0.0 { 1.0 } else { 0.0 });
        let clear = first * solid * ahead;
        asked &= !clear.bits(|clear| clear > 0.0);
        let mut nearest = enter.where_positive(clear, Lanes::splat(f64::NAN));
        let mut parts = part;
        while asked != 0 {
            let lane = asked.trailing_zeros() as usize % Lanes::COUNT;
            asked &= asked - 1;
            let ray = rays.ray(lane);
            let of =
                |distances: &[Lanes; 3]| [distances[0].0[lane], distances[1].0[lane], distances[2].0[lane]];
            let faces = if odd >> lane & 1 == 0 {
                Faces { near: of(&near), far: of(&far) }
            } else if let Some(faces) = self.faces(&ray) {
                faces
            } else {
                continue;
            };
            if let Some(End { t, part }) = Self::first(&faces, &ray, Range::AHEAD) {
                nearest.0[lane] = t;
                parts.0[lane] = f64::from(part);
            }
        }
        Some([nearest, parts])
    }

    /// The bits of the rays that start inside or meet the box, or nearly so.
    #[inline(always)]
    pub(super) fn near_of_four(&self, rays: &Rays) -> u32 {
        let (min, max) = (self.min.to_array(), self.max.to_array());
        let (mut enter, mut leave) = (Lanes::splat(f64::NEG_INFINITY), Lanes::splat(f64::INFINITY));
        for axis in 0..3 {
            let per = Lanes::splat(1.0) / rays.direction[axis];
            let low = (-rays.origin[axis] + min[axis]) * per;
            let high = (-rays.origin[axis] + max[axis]) * per;
            // What is no number stays so, and is left out.
            let near = low.zip(high, |low, high| if low < high || low.is_nan() { low } else { high });
            let far = low.zip(high, |low, high| if low < high || high.is_nan() { high } else { low });
            enter = enter.zip(near, |enter, near| if near > enter { near } else { enter });
            leave = leave.zip(far, |leave, far| if far < leave { far } else { leave });
        }
        let missed = enter - leave - (enter.abs() + leave.abs()) * NEAR;
        let behind = -leave - enter.abs() * NEAR;
        15 & !(missed.bits(|missed| missed > 0.0) | behind.bits(|behind| behind > 0.0))
    }

    /// The nearer end in `range` of the stretch between faces.
    #[inline(always)]
    fn first(faces: &Faces, ray: &Ray, range: Range) -> Option<End> {
        let (enter, leave) = faces.between();
        let room = EDGE * enter.abs();
        if enter - leave > room || leave <= range.min && range.min - leave > EDGE * leave.abs() {
            return None;
        }
        let (first, last) = (Self::enter(faces, ray), || Self::leave(faces, ray));
        // Rounding can only spoil the order of the ends where the line grazes an edge.
        if leave - enter <= room && first.t > last().t {
            return None;
        }
        if range.contains(first.t) {
            return Some(first);
        }
        Some(last()).filter(|end| range.contains(end.t))
    }

    /// The distances between which a line is inside.
    #[inline(always)]
    pub(super) fn span(&self, ray: &Ray) -> Option<Stretch> {
        let (enter, leave) = self.faces(ray)?.between();
        Stretch::new(enter, UNSAID, leave, UNSAID)
    }

    /// Where faces meet, the one that faces the ray most gives the part, as in POV-Ray.
    #[inline]
    pub(super) fn stretch(&self, ray: &Ray) -> Option<Stretch> {
        let faces = self.faces(ray)?;
        let (enter, leave) = faces.between();
        if enter - leave > EDGE * enter.abs() {
            return None;
        }
        let (enter, leave) = (Self::enter(&faces, ray), Self::leave(&faces, ray));
        (enter.t <= leave.t).then_some(Stretch { enter, leave })
    }
}

/// The axis on which a line comes last inside of the faces, or for a `sign` of -1 goes first out of them.
#[inline(always)]
fn outermost(distances: &[f64; 3], sign: f64, direction: DVec3) -> usize {
    let direction = direction.to_array();
    let mut found = 0;
    for axis in 1..3 {
        let steeper = direction[axis].abs() > direction[found].abs();
        if takes_over(distances[axis], distances[found], sign, steeper) {
            found = axis;
        }
    }
    found
}

/// Whether `t` lies beyond `other` in the sense of `sign`, or beside it within their rounding and `steeper`.
#[inline]
fn takes_over(t: f64, other: f64, sign: f64, steeper: bool) -> bool {
    let beyond = sign * (t - other);
    if beyond.abs() <= EDGE * t.abs() { steeper } else { beyond > 0.0 }
}

impl Shape for Cuboid {
    fn bounds(&self) -> Bounds {
        Bounds { min: self.min, max: self.max }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        if let Some(stretch) = self.stretch(ray) {
            stretch.push(range, out);
        }
    }

    #[inline]
    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        Self::first(&self.faces(ray)?, ray, range).map(Crossing::from)
    }

    #[inline]
    fn occludes(&self, ray: &Ray, range: Range) -> bool {
        let Some((enter, leave)) = self.faces(ray).map(|faces| faces.between()) else {
            return false;
        };
        enter <= leave && (range.contains(enter) || range.contains(leave))
    }

    fn is_closed(&self) -> bool {
        true
    }

    fn inside(&self, point: DVec3) -> bool {
        self.bounds().contains(point)
    }

    fn inside_along(&self, p: &[Band; 3]) -> Band {
        let between = |i: usize| {
            Band::constant(self.min[i]).less_equal(p[i]).and(p[i].less_equal(Band::constant(self.max[i])))
        };
        between(0).and(between(1)).and(between(2))
    }

    #[inline]
    fn normal(&self, _point: DVec3, crossing: &Crossing) -> DVec3 {
        NORMALS[(crossing.part as usize).min(NORMALS.len() - 1)]
    }

    /// The faces of a cube folded out as a cross.
    fn uv(&self, point: DVec3, crossing: &Crossing) -> Option<DVec2> {
        let p = (point - self.min) / (self.max - self.min);
        let side = 1.0 / 3.0 + p.y / 3.0;
        Some(match crossing.part {
            0 => DVec2::new(p.z / 4.0, side),
            1 => DVec2::new(0.75 - p.z / 4.0, side),
            2 => DVec2::new(0.25 + p.x / 4.0, p.z / 3.0),
            3 => DVec2::new(0.25 + p.x / 4.0, 1.0 - p.z / 3.0),
            4 => DVec2::new(1.0 - p.x / 4.0, side),
            _ => DVec2::new(0.25 + p.x / 4.0, side),
        })
    }

    #[inline]
    fn reproject(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        let on = point.max(self.min).min(self.max);
        let face = if crossing.part.is_multiple_of(2) { self.min } else { self.max };
        // The component across the face is the face's.
        let across = |axis: u32, face: f64, on: f64| if crossing.part / 2 == axis { face } else { on };
        DVec3::new(across(0, face.x, on.x), across(1, face.y, on.y), across(2, face.z, on.z))
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{self, battery, table};
    use super::*;
    use crate::math::dice::numbers;

    battery! {
        uneven: |size, at| Cuboid { min: at - size, max: at + size * DVec3::new(1.0, 0.5, 0.25) };
    }

    fn probed() -> Cuboid {
        Cuboid { min: DVec3::new(-1.0, -1.0, 0.0), max: DVec3::new(3.0, 2.0, 1.0) }
    }

    #[test]
    fn every_ray_that_meets_the_box_is_near() {
        let mut number = numbers(31);
        let (mut met, mut far) = (0, 0);
        for round in 0..10_000 {
            let mut point = || DVec3::new(number(), number(), number());
            let mut ray = Ray::new(8.0 * point(), point());
            if round % 4 == 0 {
                // Along a face.
                (ray.origin.y, ray.direction.y) = (2.0, 0.0);
            }
            let [origin, direction] = [ray.origin, ray.direction].map(|v| v.to_array().map(Lanes::splat));
            let near = probed().near_of_four(&Rays { origin, direction });
            let meets = probed().inside(ray.origin) || probed().occludes(&ray, Range::AHEAD);
            assert!(near == 0 || near == 15);
            assert!(!meets || near == 15, "{ray:?}");
            (met, far) = (met + u32::from(meets), far + u32::from(near == 0));
        }
        assert!(met > 300 && far > 5000, "{met} {far}");
    }

    #[test]
    fn probes_agree_with_povray() {
        table(
            &probed(),
            "from <0,0,-5> dir <0.1,0.1,1> | P <0.5, 0.5, 0> N <0, 0, -1>
            from <0.5,0.5,0.5> dir <1,0.2,0.1> | P <3, 1, 0.75> N <1, 0, 0>
            from <5,5,5> dir <-2,-3,-4> | P <3, 2, 1> N <0, 0, 1>
            from <5,4,3> dir <-2,-2,-2> | P <3, 2, 1> N <1, 0, 0>
            from <3,2,-1> dir <0,0,1> | P <3, 2, 0> N <0, 0, -1>
            from <3.0000001,2,-1> dir <0,0,1> | miss
            inside <3,2,1> | 1
            inside <3,2,1.0000001> | 0
            extent | <-1, -1, 0> .. <3, 2, 1>
            from <3.5,2.5,0.5> dir <-1,-1,0> | P <3, 2, 0.5> N <1, 0, 0>
            from <3.6,2.5,0.5> dir <-1.2,-1,0> | P <3, 2, 0.5> N <1, 0, 0>",
        );
    }

    #[test]
    fn a_box_without_thickness_is_hit_on_both_faces() {
        let flat = Cuboid { min: DVec3::ZERO, max: DVec3::new(0.0, 1.0, 1.0) };
        let mut found = Vec::new();
        flat.crossings(&Ray::new(DVec3::new(-5.0, 0.5, 0.5), DVec3::X), Range::AHEAD, &mut found);
        assert_eq!(found, [Crossing::new(5.0, 0), Crossing::new(5.0, 1)]);
    }

    #[test]
    fn uv_agrees_with_povray() {
        battery::uv(&probed(), [0.0, 0.0, -5.0], [0.0, 0.0, 1.0], [0.9375, 0.44445]);
        battery::uv(&probed(), [0.0, 0.0, 5.0], [0.0, 0.0, -1.0], [0.3125, 0.44445]);
        battery::uv(&probed(), [-5.0, 0.2, 0.3], [1.0, 0.0, 0.0], [0.075, 0.46667]);
        battery::uv(&probed(), [5.0, 0.2, 0.3], [-1.0, 0.0, 0.0], [0.675, 0.46667]);
        battery::uv(&probed(), [1.0, 5.0, 0.3], [0.0, -1.0, 0.0], [0.37501, 0.90001]);
        battery::uv(&probed(), [1.0, -5.0, 0.3], [0.0, 1.0, 0.0], [0.37501, 0.10001]);
    }
}
