//! `cylinder { base, cap, radius [open] }` (docs/spec/primitives.md 3.4).

use super::stretch::{End, Stretch};
use super::{Crossing, Shape};
use crate::math::{Band, Bounds, DVec3, roots};
use crate::world::{Range, Ray};

/// The cylinder x² + y² = 1 between z = 0 and z = 1; the ends take part unless it is open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// Without end discs.
    pub open: bool,
}

/// Part number of the curved side, here and in a cone.
pub(super) const SIDE: u32 = 0;
/// Part number of the disc at z = 1.
pub(super) const CAP: u32 = 1;
/// Part number of the disc at z = 0.
pub(super) const BASE: u32 = 2;

/// How far an open cylinder swells to decide what is inside, in units of its radius (squared) and
/// length: its surface is inside.
const SWOLLEN: f64 = 1e-10;

/// How far a closed one shrinks: its surface is outside. A few roundings only, for POV-Ray's 1e-10
/// would make a gap between flush solids.
const SHRUNK: f64 = 16.0 * f64::EPSILON;

/// Lines whose squared distance from the axis is greater miss whatever rounding does, and what far
/// origins add to it.
const MISSED: f64 = 1.0 + 1e-9;
const BLUR: f64 = 1e-14;

/// What the border of an open or closed one adds to its radius (squared) and length.
#[inline]
pub(super) fn border(open: bool) -> f64 {
    if open { SWOLLEN } else { -SHRUNK }
}

/// Between the planes of the ends.
#[inline]
pub(super) fn between_ends(ray: &Ray) -> Option<Stretch> {
    Stretch::slab((0.0, BASE), (1.0, CAP), ray.origin.z, ray.direction.z)
}

/// What holds whether points with these heights are between both.
pub(super) fn between_planes(z: Band, border: f64) -> Band {
    Band::constant(-border).less_equal(z).and(z.less_equal(Band::constant(1.0 + border)))
}

impl Cylinder {
    /// Inside the endless cylinder: the discriminant comes from the distance of line and axis.
    #[inline(always)]
    fn between_sides(ray: &Ray) -> Option<Stretch> {
        let (f, d) = (ray.origin.truncate(), ray.direction.truncate());
        let a = d.length_squared();
        if a == 0.0 {
            return (f.length_squared() <= 1.0).then_some(Stretch::LINE);
        }
        // Most lines miss by far: this is the distance from the axis, times that to the next.
        let aside = f.perp_dot(d);
        if aside * aside > a * (MISSED + BLUR * f.length_squared()) {
            return None;
        }
        let b = f.dot(d);
        let discriminant = a * (1.0 - (f - (b / a) * d).length_squared());
        let [enter, leave] = roots::with_discriminant(a, b, f.length_squared() - 1.0, discriminant)?;
        Stretch::new(enter, SIDE, leave, SIDE)
    }

    #[inline(always)]
    pub(super) fn stretch(&self, ray: &Ray) -> Option<Stretch> {
        let (sides, ends) = (Self::between_sides(ray)?, between_ends(ray)?);
        if self.open { ends.meet(sides) } else { sides.meet(ends) }
    }
}

impl Shape for Cylinder {
    fn bounds(&self) -> Bounds {
        Bounds::new(DVec3::new(-1.0, -1.0, 0.0), DVec3::ONE)
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        let from = out.len();
        if let Some(stretch) = self.stretch(ray) {
            stretch.push(range, out);
        }
        if self.open {
            keep_side(from, out);
        }
    }

    #[inline(always)]
    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let stretch = self.stretch(ray)?;
        let counts = |end: &End| range.contains(end.t) && !(self.open && end.part != SIDE);
        [stretch.enter, stretch.leave].into_iter().find(counts).map(Crossing::from)
    }

    fn is_closed(&self) -> bool {
        !self.open
    }

    fn inside(&self, point: DVec3) -> bool {
        let border = border(self.open);
        point.truncate().length_squared() <= 1.0 + border && -border <= point.z && point.z <= 1.0 + border
    }

    fn inside_along(&self, [x, y, z]: &[Band; 3]) -> Band {
        let border = border(self.open);
        between_planes(*z, border).and((x.square() + y.square()).less_equal(Band::constant(1.0 + border)))
    }

    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        match crossing.part {
            CAP => DVec3::Z,
            BASE => -DVec3::Z,
            _ => point.with_z(0.0),
        }
    }

    fn reproject(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        match crossing.part {
            CAP => point.with_z(1.0),
            BASE => point.with_z(0.0),
            _ => (point.truncate() / point.truncate().length()).extend(point.z),
        }
    }
}

/// Drops the crossings of end discs from `from` on.
pub(super) fn keep_side(from: usize, out: &mut Vec<Crossing>) {
    let mut kept = from;
    for i in from..out.len() {
        if out[i].part == SIDE {
            out[kept] = out[i];
            kept += 1;
        }
    }
    out.truncate(kept);
}

#[cfg(test)]
mod tests {
    use super::super::battery::battery;
    use super::*;

    battery! {
        closed: || Cylinder { open: false };
        open: || Cylinder { open: true }, surface;
    }

    #[test]
    fn the_surface_is_outside_a_closed_cylinder_and_inside_an_open_one() {
        let (closed, open) = (Cylinder { open: false }, Cylinder { open: true });
        for on in [DVec3::new(1.0, 0.0, 0.5), DVec3::new(0.0, 0.0, 1.0), DVec3::ZERO] {
            assert!(!closed.inside(on) && open.inside(on), "{on}");
        }
        assert!(closed.inside(DVec3::new(0.999_999_999_9, 0.0, 0.5)));
        assert!(open.inside(DVec3::new(1.000_000_000_01, 0.0, 0.5)));
    }

    #[test]
    fn a_ray_along_the_axis_of_an_open_cylinder_hits_nothing() {
        let ray = Ray::new(DVec3::new(0.3, 0.2, -5.0), DVec3::Z);
        assert!(!Cylinder { open: true }.occludes(&ray, Range::AHEAD));
        assert_eq!(Cylinder { open: false }.nearest(&ray, Range::AHEAD), Some(Crossing::new(5.0, BASE)));
    }
}
