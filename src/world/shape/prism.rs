//! `prism` (docs/spec/primitives.md 6.3).

use super::curve::{Curve, Segment, sign_changes};
use super::stretch::{End, Stretch};
use super::{Crossing, Shape, uncrossed};
use crate::math::roots::roots_between;
use crate::math::wide::widest;
use crate::math::{Band, Bounds, DVec2, DVec3};
use crate::world::{Range, Ray};

/// An outline in x and z, swept along y or, in a conic one, scaled by y.
///
/// Parts: 0 the lower end, 1 the upper, then the segments of the outline; [`Crossing::at`] holds the
/// place on the segment.
#[derive(Clone, Debug)]
pub struct Prism {
    /// Closed outlines, x and z as their x and y.
    pub outline: Curve,
    /// Lower and upper end.
    pub heights: [f64; 2],
    /// Scaled by y, so that y = 0 is an apex.
    pub conic: bool,
    /// Without ends.
    pub open: bool,
}

/// Room around the part of a ray in which walls are looked for, relative to its coordinates.
const BESIDE: f64 = 1e-9;

/// Parts before the segments.
const ENDS: u32 = 2;

fn flat(p: DVec3) -> DVec2 {
    DVec2::new(p.x, p.z)
}

impl Prism {
    /// How many parts the surface has.
    pub(super) fn parts(&self) -> u32 {
        ENDS + self.outline.segments().len() as u32
    }

    /// Where `p` is in the outline's plane.
    fn place(&self, p: DVec3) -> DVec2 {
        if self.conic { flat(p) / p.y } else { flat(p) }
    }

    /// Calls back with the crossings of the ray with walls: all those between two distances, and others. After a
    /// segment for which that answers that it has enough no other is looked at.
    #[inline(always)]
    fn push_walls(&self, ray: &Ray, between: [f64; 2], found: &mut impl FnMut(f64, u32, f64) -> bool) {
        let (o, d) = (ray.origin, ray.direction);
        // The plane through the ray, along y or through the apex, meets the outline's plane in the line
        // line.x x + line.z z + line.y = 0.
        let line = if self.conic { o.cross(d) } else { d.cross(DVec3::Y) };
        let offset = if self.conic { line.y } else { -line.dot(o) };
        if line.x == 0.0 && line.z == 0.0 {
            return;
        }
        let side = |p: DVec2| p.dot(flat(line)) + offset;
        let along = flat(line);
        let distance = |w: f64, segment: &Segment| {
            let on = segment.point(w);
            if self.conic {
                // Where the ray is parallel to the line from the apex through the outline's point.
                let through = DVec3::new(on.x, 1.0, on.y);
                let across = d.cross(through);
                -o.cross(through).dot(across) / across.length_squared()
            } else {
                (on - flat(o)).dot(flat(d)) / flat(d).length_squared()
            }
        };
        let shadow = self.shadow(ray, between);
        let wall = |number: u32, segment: &Segment| {
            let part = ENDS + number;
            let mut enough = false;
            if segment.is_straight() {
                let (from, to) = (side(segment.point(0.0)), side(segment.point(1.0)));
                if let Some(w) = Segment::straight_change(from, to) {
                    enough = found(distance(w, segment), part, w);
                }
                return enough;
            }
            if segment.is_beside(along, offset) {
                return false;
            }
            let mut cubic = segment.polynomial(|p| p.dot(along));
            cubic[0] += offset;
            let seeds = roots_between::<4>(&cubic, 0.0, 1.0);
            sign_changes(
                seeds.as_slice(),
                [0.0, 1.0],
                |w| side(segment.point(w)),
                |_, _| true,
                |w| enough |= found(distance(w, segment), part, w),
            );
            enough
        };
        self.outline.each_near(
            #[inline(always)]
            |hulls| hulls.touching(shadow) & hulls.met_by(along, offset),
            wall,
        );
    }

    /// A box in the outline's plane around the part of the ray between two distances, seen along y or from the apex.
    #[inline(always)]
    fn shadow(&self, ray: &Ray, [from, to]: [f64; 2]) -> [DVec2; 2] {
        let everywhere = [DVec2::NEG_INFINITY, DVec2::INFINITY];
        let (from, to) = (ray.at(from), ray.at(to));
        let [low, high] = self.outline.hull();
        let mut room = high - low + low.abs();
        if self.conic {
            // What is seen from the apex is straight unless it goes past it.
            let height = from.y.min(to.y).max(-from.y.max(to.y));
            if height <= 0.0 {
                return everywhere;
            }
            room += ray.origin.abs().max(from.abs()).max(to.abs()).max_element() / height;
        }
        let (one, other) = (self.place(from), self.place(to));
        if !one.is_finite() || !other.is_finite() || !room.is_finite() {
            return everywhere;
        }
        let room = BESIDE * (room + one.abs().max(other.abs()));
        [one.min(other) - room, one.max(other) + room]
    }

    /// Whether the end that a ray meets is there.
    #[inline(always)]
    fn has_end(&self, ray: &Ray, end: End) -> bool {
        !self.open && self.ends_at(ray, end)
    }

    /// Whether the inside ends at the end that a ray meets.
    #[inline(always)]
    fn ends_at(&self, ray: &Ray, end: End) -> bool {
        if !end.t.is_finite() {
            return false;
        }
        let mut point = ray.at(end.t);
        point.y = self.heights[end.part as usize];
        let apex = self.conic && point.y == 0.0;
        !apex && self.outline.encloses(self.place(point))
    }

    /// The nearest crossing in `range`, or just any.
    #[inline(always)]
    pub(super) fn first(&self, ray: &Ray, range: Range, any: bool) -> Option<Crossing> {
        let (shift, ray) = ray.moved_to(self.center());
        let [bottom, top] = self.heights;
        let slab = Stretch::slab((bottom, 0), (top, 1), ray.origin.y, ray.direction.y)?;
        let is_met = |end: End| range.contains(end.t + shift) && self.has_end(&ray, end);
        if is_met(slab.enter) {
            return Some(Crossing::new(slab.enter.t + shift, slab.enter.part));
        }
        let between = [slab.enter.t.max(range.min - shift), slab.leave.t.min(range.max - shift)];
        if between[0] > between[1] {
            return None;
        }
        let mut nearest: Option<Crossing> = None;
        self.push_walls(&ray, between, &mut |t, part, w| {
            let is_nearer = nearest.is_none_or(|nearest| t + shift < nearest.t);
            if slab.enter.t <= t && t <= slab.leave.t && range.contains(t + shift) && is_nearer {
                nearest = Some(Crossing { t: t + shift, part, at: [w, 0.0] });
            }
            any && nearest.is_some()
        });
        nearest.or_else(|| is_met(slab.leave).then(|| Crossing::new(slab.leave.t + shift, slab.leave.part)))
    }

    /// Whether a part of a ray may come into the inside, or leave it, where there is no surface.
    fn leaves_unseen(&self, ray: &Ray, range: Range) -> bool {
        let [from, to] = [ray.at(range.min), ray.at(range.max)];
        let [bottom, top] = self.heights;
        // Beyond the apex everything is turned round.
        let turns = self.conic && from.y.min(to.y) <= 0.0 && from.y.max(to.y) >= 0.0;
        let within = !(from.y.max(to.y) < bottom || from.y.min(to.y) > top);
        if within
            && self.outline.is_open_within(match turns {
                true => [DVec2::NEG_INFINITY, DVec2::INFINITY],
                false => [self.place(from), self.place(to)],
            })
        {
            return true;
        }
        let Some(slab) = Stretch::slab((bottom, 0), (top, 1), ray.origin.y, ray.direction.y) else {
            return false;
        };
        let leaves = |end: End| range.contains(end.t) && self.ends_at(ray, end);
        self.open && (leaves(slab.enter) || leaves(slab.leave))
    }

    fn center(&self) -> DVec3 {
        let [low, high] = self.outline.hull();
        let [bottom, top] = self.heights;
        let middle = 0.5 * (low + high);
        let center = DVec3::new(middle.x, 0.5 * (bottom + top), middle.y);
        let center = if self.conic { self.bounds().center() } else { center };
        if center.is_finite() { center } else { DVec3::ZERO }
    }
}

impl Shape for Prism {
    fn bounds(&self) -> Bounds {
        let [low, high] = self.outline.hull();
        let at = |y: f64, p: DVec2| {
            let p = if self.conic { p * y } else { p };
            DVec3::new(p.x, y, p.y)
        };
        let [bottom, top] = self.heights;
        Bounds::of([at(bottom, low), at(bottom, high), at(top, low), at(top, high)])
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        let from = out.len();
        let (shift, ray) = ray.moved_to(self.center());
        let [bottom, top] = self.heights;
        let Some(slab) = Stretch::slab((bottom, 0), (top, 1), ray.origin.y, ray.direction.y) else {
            return;
        };
        let ends = [slab.enter, slab.leave];
        let mut push = |t, part, w| {
            if slab.enter.t <= t && t <= slab.leave.t && range.contains(t + shift) {
                out.push(Crossing { t: t + shift, part, at: [w, 0.0] });
            }
            false
        };
        widest(
            #[inline(always)]
            || self.push_walls(&ray, [slab.enter.t, slab.leave.t], &mut push),
        );
        for end in ends {
            if range.contains(end.t + shift) && self.has_end(&ray, end) {
                out.push(Crossing::new(end.t + shift, end.part));
            }
        }
        out[from..].sort_by(|a, b| a.t.total_cmp(&b.t));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        widest(
            #[inline(always)]
            || self.first(ray, range, false),
        )
    }

    fn occludes(&self, ray: &Ray, range: Range) -> bool {
        widest(
            #[inline(always)]
            || self.first(ray, range, true).is_some(),
        )
    }

    fn is_closed(&self) -> bool {
        !self.open && !self.outline.is_open_within([DVec2::NEG_INFINITY, DVec2::INFINITY])
    }

    fn inside(&self, point: DVec3) -> bool {
        let [bottom, top] = self.heights;
        bottom <= point.y && point.y < top && self.outline.encloses(self.place(point))
    }

    fn inside_along(&self, point: &[Band; 3]) -> Band {
        let passes = |ray: &Ray, range| self.occludes(ray, range) || self.leaves_unseen(ray, range);
        uncrossed::inside_unless(self, passes, point)
    }

    /// Walls point to the right of the direction in which their outline runs, seen with z upward.
    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        let Some(segment) = crossing.part.checked_sub(ENDS) else {
            return if crossing.part == 0 { DVec3::NEG_Y } else { DVec3::Y };
        };
        let slope = self.outline.segments()[segment as usize].slope(crossing.at[0]);
        let across = DVec3::new(slope.y, 0.0, -slope.x);
        if self.conic && point.y != 0.0 {
            let tilted = across.with_y(-across.dot(point) / point.y);
            return if point.y < 0.0 { -tilted } else { tilted };
        }
        across
    }

    fn reproject(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        let Some(segment) = crossing.part.checked_sub(ENDS) else {
            return point.with_y(self.heights[crossing.part as usize]);
        };
        let on = self.outline.segments()[segment as usize].point(crossing.at[0]);
        let on = if self.conic { on * point.y } else { on };
        DVec3::new(on.x, point.y, on.y)
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{battery, table};
    use super::*;

    fn points(all: &[[f64; 2]]) -> Vec<DVec2> {
        all.iter().map(|p| DVec2::from(*p)).collect()
    }

    fn linear(heights: [f64; 2], outlines: &[&[[f64; 2]]]) -> Prism {
        let segments = outlines.iter().flat_map(|outline| {
            points(outline).windows(2).map(|p| Segment::linear(p[0], p[1])).collect::<Vec<_>>()
        });
        Prism { outline: Curve::new(segments.collect()), heights, conic: false, open: false }
    }

    fn cubic(heights: [f64; 2], all: &[[f64; 2]]) -> Prism {
        let segments = points(all).windows(4).map(|p| Segment::cubic(p[0], p[1], p[2], p[3])).collect();
        Prism { outline: Curve::new(segments), heights, conic: false, open: false }
    }

    const BENT: [[f64; 2]; 7] =
        [[-0.3, 1.], [0., 0.], [1., -0.2], [1.2, 1.], [0.2, 1.1], [0., 0.], [1., -0.2]];
    const SLANTED: [[f64; 2]; 5] = [[0., 0.], [2., 0.], [1.5, 1.], [0.2, 1.2], [0., 0.]];
    const SQUARE: [[f64; 2]; 5] = [[-1., -1.], [1., -1.], [1., 1.], [-1., 1.], [-1., -1.]];

    battery! {
        polygonal: |size, at| {
            let corners = SLANTED.map(|[x, z]| [at.x + size * (x - 1.0), at.z + size * (z - 0.5)]);
            linear([at.y - 0.4 * size, at.y + 0.5 * size], &[&corners])
        };
        smooth: |size| cubic([-0.4 * size, 0.5 * size], &BENT.map(|[x, z]| [size * (x - 0.5), size * (z - 0.5)]));
        cone_like: || Prism { conic: true, ..linear([0.3, 1.0], &[&SQUARE]) };
    }

    #[test]
    fn straight_outlines_agree_with_povray() {
        let slanted = linear([0.2, 1.3], &[&SLANTED]);
        table(
            &slanted,
            "from <0.5,5,0.3> dir <0.01,-1,0.02> | P <0.537, 1.3, 0.374> N <0, 1, 0>
            from <-5,0.7,0.6> dir <1,0.01,0> | P <0.1, 0.751, 0.6> N <-0.986393923832144, 0, 0.164398987305357>
            from <0.5,0.7,-5> dir <0,0,1> | P <0.5, 0.7, 0> N <0, 0, -1>
            from <0.5,1.3,0.3> dir <1,0,0> | P <1.85, 1.3, 0.3> N <0.894427190999916, 0, 0.447213595499958>
            inside <0.5,0.2,0.3> | 1
            inside <0.5,1.3,0.3> | 0
            inside <0.5,1.2999,0.3> | 1
            inside <0.5,0.7,0> | 1
            inside <0.5,0.7,1.15> | 1
            extent | <0, 0.200000002980232, 0> .. <2, 1.300000071525574, 1.200000047683716>",
        );
        table(
            &Prism { open: true, ..slanted },
            "from <0.5,5,0.3> dir <0,-1,0> | miss
            from <0.5,5,0.3> dir <0.3,-1,0.1> | P <1.657142857142857, 1.142857142857143, 0.685714285714286> N <0.894427190999916, 0, 0.447213595499958>",
        );
        let outer = [[0., 0.], [4., 0.], [4., 4.], [0., 4.], [0., 0.]];
        let hole = [[1., 1.], [3., 1.], [3., 3.], [1., 3.], [1., 1.]];
        table(
            &linear([0.0, 1.0], &[&outer, &hole]),
            "from <2,5,2> dir <0,-1,0> | miss
            from <0.5,5,2> dir <0,-1,0> | P <0.5, 1, 2> N <0, 1, 0>
            from <2,0.5,2> dir <1,0,0> | P <3, 0.5, 2> N <1, 0, 0>
            inside <2,0.5,2> | 0",
        );
    }

    #[test]
    fn the_lower_end_faces_down() {
        // POV-Ray has <0, 1, 0>, into the solid.
        table(
            &linear([0.2, 1.3], &[&SLANTED]),
            "from <0.5,-5,0.3> dir <0,1,0> | P <0.5, 0.2, 0.3> N <0, -1, 0>",
        );
    }

    #[test]
    fn splines_agree_with_povray() {
        let quadratic = [[-0.5, 0.5], [0., 0.], [1., -0.2], [1.2, 1.], [0.2, 1.1], [0., 0.]];
        let segments = points(&quadratic).windows(3).map(|p| Segment::quadratic(p[0], p[1], p[2])).collect();
        table(
            &Prism { outline: Curve::new(segments), heights: [0.0, 1.0], conic: false, open: false },
            "from <0.5,5,0.5> dir <0,-1,0> | P <0.5, 1, 0.5> N <0, 1, 0>
            from <0.5,0.5,-5> dir <0,0,1> | P <0.5, 0.5, -0.149242250247064> N <-0.173444746202651, 0, -0.984843601804214>
            from <5,0.5,0.4> dir <-1,0,0> | P <1.21972604831213, 0.5, 0.4> N <0.997821048527478, 0, -0.065978444324822>
            extent | <-0.025000000372529, 0, -0.200000002980232> .. <1.225000023841858, 1, 1.192045450210571>",
        );
        table(
            &cubic([0.0, 1.0], &BENT),
            "from <0.5,0.5,-5> dir <0,0,1> | P <0.5, 0.5, -0.236037577718673> N <-0.230052399914289, 0, -0.973178243331444>
            from <5,0.5,0.4> dir <-1,0.01,0.02> | P <1.238556622150557, 0.537614433778494, 0.475228867556989> N <0.992509205019141, 0, -0.122169873341476>
            inside <0.5,0.5,-0.2> | 1
            extent | <-0.053670763969421, 0, -0.268222987651825> .. <1.253670811653137, 1, 1.199206829071045>",
        );
    }

    #[test]
    fn conic_sweeps_agree_with_povray() {
        table(
            &Prism { conic: true, ..linear([0.3, 1.0], &[&SQUARE]) },
            "from <0.1,0.6,-5> dir <0,0,1> | P <0.1, 0.6, -0.6> N <0, -0.707106781186547, -0.707106781186548>
            from <0.1,5,0.2> dir <0,-1,0> | P <0.1, 1, 0.2> N <0, 1, 0>
            inside <0.5,0.4,0> | 0
            inside <0.5,0.6,0> | 1
            extent | <-1, 0.300000011920929, -1> .. <1, 1, 1>",
        );
        let outline = [[-1., 0.8], [-0.8, -0.8], [1., -1.], [0.9, 1.], [-1., 0.8], [-0.8, -0.8], [1., -1.]];
        table(
            &Prism { conic: true, ..cubic([0.0, 1.0], &outline) },
            "from <0.1,0.6,-5> dir <0,0,1> | P <0.1, 0.6, -0.678608357740245> N <-0.077933880407928, -0.741159632692129, -0.666789853816201>
            extent | <-1.149214506149292, 0, -1.148402094841003> .. <1.184659481048584, 1, 1.148402094841003>",
        );
    }

    #[test]
    fn a_ray_through_two_corners_is_not_lost() {
        // POV-Ray has no pixel of this row, and says 0.
        let hexagon =
            [[1., 0.], [0.5, 0.875], [-0.5, 0.875], [-1., 0.], [-0.5, -0.875], [0.5, -0.875], [1., 0.]];
        table(
            &linear([0.0, 1.0], &[&hexagon]),
            "from <0.2,5,0> dir <0,-1,0> | P <0.2, 1, 0> N <0, 1, 0>
            inside <0,0.5,0> | 1
            inside <0,0.5,1e-12> | 1",
        );
    }
}
