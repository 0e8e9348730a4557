//! `cone { base, base_radius, cap, cap_radius [open] }` (docs/spec/primitives.md 3.5).

use super::cylinder::{BASE, CAP, SIDE, between_ends, between_planes, border, keep_side};
use super::stretch::{End, Stretch};
use super::{Crossing, Shape};
use crate::math::roots::{self, difference_of_products};
use crate::math::wide::widest;
use crate::math::{Band, Bounds, DVec3};
use crate::world::{Range, Ray};

/// The cone whose radius grows from `tip` at z = 0 to 1 at z = 1; a negative `tip` gives the two
/// nappes of a double cone. Parts as in a cylinder.
///
/// Unlike the cone x² + y² = z² this stays exact as it becomes a cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// Signed radius at z = 0, in -1 … 1.
    pub tip: f64,
    /// Without end discs.
    pub open: bool,
}

impl Cone {
    /// Signed radius at height `z`.
    fn radius(&self, z: f64) -> f64 {
        self.tip + self.slope() * z
    }

    fn slope(&self) -> f64 {
        1.0 - self.tip
    }

    /// The stretches inside the endless double cone.
    #[inline(always)]
    fn between_sides(&self, ray: &Ray) -> [Option<Stretch>; 2] {
        let (f, d) = (
            ray.origin.with_z(self.radius(ray.origin.z)),
            ray.direction * DVec3::new(1.0, 1.0, self.slope()),
        );
        // In the coordinates (x, y, radius) each coefficient is a difference of squares, and Lagrange's
        // identity for their form gives the discriminant without its great cancellation.
        let squares = |x: f64, y: f64, z: f64| {
            let (side, z) = ((x * x + y * y).sqrt(), z.abs());
            (side - z) * (side + z)
        };
        let (a, c) = (squares(d.x, d.y, d.z), squares(f.x, f.y, f.z));
        let b = f.x * d.x + f.y * d.y - f.z * d.z;
        let mut discriminant = squares(
            difference_of_products(f.x, d.z, f.z, d.x),
            difference_of_products(f.y, d.z, f.z, d.y),
            difference_of_products(f.x, d.y, f.y, d.x),
        );
        if a < 0.0 {
            // A line this steep meets the cone always, if only in the apex.
            discriminant = discriminant.max(0.0);
        }
        let Some([low, high]) = roots::with_discriminant(a, b, c, discriminant) else {
            let along = a == 0.0 && b == 0.0 && c <= 0.0;
            return [along.then_some(Stretch::LINE), None];
        };
        if a >= 0.0 {
            // For a linear equation one of the roots is infinite, on the side that is inside.
            return [Stretch::new(low, SIDE, high, SIDE), None];
        }
        [Stretch::new(f64::NEG_INFINITY, SIDE, low, SIDE), Stretch::new(high, SIDE, f64::INFINITY, SIDE)]
    }

    /// The stretches inside, in order.
    fn stretches(&self, ray: &Ray) -> [Option<Stretch>; 2] {
        // Fused multiplications are calls elsewhere.
        widest(
            #[inline(always)]
            || self.find(ray),
        )
    }

    #[inline(always)]
    fn find(&self, ray: &Ray) -> [Option<Stretch>; 2] {
        let (shift, ray) = ray.moved_to(DVec3::new(0.0, 0.0, 0.5));
        let Some(ends) = between_ends(&ray) else {
            return [None, None];
        };
        let inside = |sides: Option<Stretch>| {
            let sides = sides?;
            let inside = if self.open { ends.meet(sides)? } else { sides.meet(ends)? };
            Some(inside.shifted(shift))
        };
        let [one, other] = self.between_sides(&ray);
        [inside(one), inside(other)]
    }

    /// Whether it has a single nappe, and its ends.
    pub(super) fn is_convex(&self) -> bool {
        self.tip >= 0.0 && !self.open
    }

    /// The stretch inside, where it is convex.
    pub(super) fn stretch(&self, ray: &Ray) -> Option<Stretch> {
        match self.stretches(ray) {
            // Through the apex, where the other nappe begins.
            [Some(one), Some(other)] => Some(Stretch { enter: one.enter, leave: other.leave }),
            [one, other] => one.or(other),
        }
    }
}

impl Shape for Cone {
    fn bounds(&self) -> Bounds {
        Bounds::new(DVec3::new(-1.0, -1.0, 0.0), DVec3::ONE)
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        let from = out.len();
        for stretch in self.stretches(ray).into_iter().flatten() {
            stretch.push(range, out);
        }
        if self.open {
            keep_side(from, out);
        }
    }

    #[inline]
    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let counts = |end: &End| range.contains(end.t) && !(self.open && end.part != SIDE);
        self.stretches(ray)
            .into_iter()
            .flatten()
            .flat_map(|s| [s.enter, s.leave])
            .find(counts)
            .map(Crossing::from)
    }

    fn is_closed(&self) -> bool {
        !self.open
    }

    fn inside(&self, point: DVec3) -> bool {
        let border = border(self.open);
        let radius = self.radius(point.z);
        point.truncate().length_squared() <= radius * radius + border
            && -border <= point.z
            && point.z <= 1.0 + border
    }

    fn inside_along(&self, [x, y, z]: &[Band; 3]) -> Band {
        let border = border(self.open);
        let radius = *z * self.slope() + self.tip;
        between_planes(*z, border).and((x.square() + y.square()).less_equal(radius.square() + border))
    }

    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        match crossing.part {
            CAP => DVec3::Z,
            BASE => -DVec3::Z,
            _ => {
                let slope = -self.radius(point.z) * self.slope();
                let normal = point.with_z(slope);
                if normal == DVec3::ZERO { -DVec3::Z } else { normal }
            }
        }
    }

    fn reproject(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        match crossing.part {
            CAP => point.with_z(1.0),
            BASE => point.with_z(0.0),
            _ => {
                let length = point.truncate().length();
                if length == 0.0 {
                    return point;
                }
                (point.truncate() * (self.radius(point.z).abs() / length)).extend(point.z)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::battery;
    use super::*;

    battery! {
        truncated: || Cone { tip: 0.25, open: false };
        pointed: || Cone { tip: 0.0, open: false };
        nearly_cylinder: || Cone { tip: 1.0 - 1e-12, open: false };
        double: || Cone { tip: -0.7, open: false };
        open: || Cone { tip: 0.25, open: true }, surface;
    }

    #[test]
    fn the_apex_of_an_open_cone_is_no_hole() {
        // POV-Ray misses the apex of an open cone seen along its axis.
        let cone = Cone { tip: 0.0, open: true };
        let hit = cone.nearest(&Ray::new(-5.0 * DVec3::Z, DVec3::Z), Range::AHEAD);
        assert_eq!(hit.map(|hit| hit.t), Some(5.0));
    }
}
