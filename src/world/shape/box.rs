//! `box { corner, corner }` (docs/spec/primitives.md 3.2).

use super::stretch::Stretch;
use super::{Crossing, Shape};
use crate::math::{Bounds, DVec2, DVec3};
use crate::world::{Range, Ray};

/// An axis-aligned box, faces included. Parts: -x, +x, -y, +y, -z, +z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid {
    /// Lowest corner.
    pub min: DVec3,
    /// Highest corner.
    pub max: DVec3,
}

impl Cuboid {
    /// Where faces meet, the one that faces the ray most gives the part, as in POV-Ray.
    #[inline]
    pub(super) fn stretch(&self, ray: &Ray) -> Option<Stretch> {
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
        let (mut enter, mut leave) = (0, 0);
        for axis in 1..3 {
            let steeper = |other: usize| direction[axis].abs() > direction[other].abs();
            if takes_over(near[axis], near[enter], 1.0, steeper(enter)) {
                enter = axis;
            }
            if takes_over(far[axis], far[leave], -1.0, steeper(leave)) {
                leave = axis;
            }
        }
        let part = |axis: usize, high: bool| 2 * axis as u32 + u32::from(high);
        let (enters_high, leaves_high) = (direction[enter] < 0.0, direction[leave] > 0.0);
        Stretch::new(near[enter], part(enter, enters_high), far[leave], part(leave, leaves_high))
    }
}

/// Whether `t` lies beyond `other` in the sense of `sign`, or beside it within their rounding and `steeper`.
#[inline]
fn takes_over(t: f64, other: f64, sign: f64, steeper: bool) -> bool {
    let beyond = sign * (t - other);
    if beyond.abs() <= 4.0 * f64::EPSILON * t.abs() { steeper } else { beyond > 0.0 }
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
        self.stretch(ray)?.nearest(range)
    }

    fn inside(&self, point: DVec3) -> bool {
        self.bounds().contains(point)
    }

    fn normal(&self, _point: DVec3, crossing: &Crossing) -> DVec3 {
        let sign = if crossing.part.is_multiple_of(2) { -1.0 } else { 1.0 };
        sign * DVec3::AXES[crossing.part as usize / 2]
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

    fn reproject(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        let axis = crossing.part as usize / 2;
        let mut on = point.clamp(self.min, self.max);
        on[axis] = if crossing.part.is_multiple_of(2) { self.min[axis] } else { self.max[axis] };
        on
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{self, battery, table};
    use super::*;

    battery! {
        uneven: |size, at| Cuboid { min: at - size, max: at + size * DVec3::new(1.0, 0.5, 0.25) };
    }

    fn probed() -> Cuboid {
        Cuboid { min: DVec3::new(-1.0, -1.0, 0.0), max: DVec3::new(3.0, 2.0, 1.0) }
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
