//! `lathe` (docs/spec/primitives.md 6.1).

use std::cell::Cell;
use std::f64::consts::TAU;

use smallvec::SmallVec;

use super::curve::{Curve, Hulls, Segment, sign_changes};
use super::{Crossing, Shape, uncrossed};
use crate::math::roots::{quadratic, roots_between};
use crate::math::wide::widest;
use crate::math::{Band, Bounds, DVec2, DVec3, Lanes};
use crate::world::{Range, Ray};

/// A profile of radius and height, turned about the y axis.
///
/// Parts are the profile's segments; [`Crossing::at`] holds the place on the segment.
#[derive(Clone, Debug)]
pub struct Lathe {
    /// Radius as x, height as y.
    pub profile: Curve,
}

/// Rays that rise less than this for each unit of their way about the axis are flat.
const FLAT: f64 = 1.0 / 16.0;

/// Crossings are surely no farther than this from the distances between which they are, in parts of these.
const FAR: f64 = 1e-9;

/// Places on a segment near which something changes its sign.
type Seeds = SmallVec<[f64; 11]>;

/// A ray as a lathe sees it: where it passes the axis, in units of its own length.
struct Passing {
    /// Distance from the axis, squared.
    nearest: f64,
    /// Height there.
    height: f64,
    /// How fast it moves away from the axis' nearest point, and up; the squares add to 1.
    out: f64,
    up: f64,
}

impl Passing {
    /// The difference of the squared radii of surface and ray at the surface's height, times `up²`.
    fn gap(&self, p: DVec2) -> f64 {
        let rise = self.out * (p.y - self.height);
        self.up * self.up * (p.x * p.x - self.nearest) - rise * rise
    }

    /// Height of the surface above the ray where the ray, before or after its nearest point, has the
    /// surface's radius. For flat rays this has simple roots where [`Passing::gap`] has a double one.
    fn above(&self, p: DVec2, branch: f64) -> f64 {
        self.out * (p.y - self.height) - branch * self.up * self.along(p)
    }

    /// Half the chord that the surface's circle cuts out of the ray, seen from above.
    fn along(&self, p: DVec2) -> f64 {
        (p.x * p.x - self.nearest).max(0.0).sqrt()
    }

    /// Where on a segment [`Passing::gap`] is zero.
    fn seeds(&self, segment: &Segment) -> Seeds {
        let (up, out) = (self.up * self.up, self.out * self.out);
        let radius = segment.polynomial(|p| p.x);
        let mut height = segment.polynomial(|p| p.y);
        height[0] -= self.height;
        if segment.is_straight() {
            let term = |i: usize, j: usize| up * (radius[i] * radius[j]) - out * (height[i] * height[j]);
            let roots = quadratic(term(1, 1), term(0, 1), term(0, 0) - up * self.nearest);
            let mut seeds = Seeds::new();
            for w in roots.unwrap_or_default() {
                if (0.0..=1.0).contains(&w) {
                    seeds.push(w);
                }
            }
            return seeds;
        }
        Seeds::from_slice(roots_between::<7>(&self.gaps(radius, height), 0.0, 1.0).as_slice())
    }

    /// [`Passing::gap`] along a segment, of which radius and height above the ray are given.
    fn gaps(&self, radius: [f64; 4], height: [f64; 4]) -> [f64; 7] {
        let (radii, heights) = (square(radius), square(height));
        let (up, out) = (self.up * self.up, self.out * self.out);
        let mut gap = [0.0; 7];
        for i in 0..7 {
            gap[i] = up * radii[i] - out * heights[i];
        }
        gap[0] -= up * self.nearest;
        gap
    }

    /// Adds where [`Passing::gap`] is zero near a place on a segment that is, or nearly, at the ray's own height.
    /// There a flat ray has all its crossings, so close together that only a polynomial about that place, in
    /// which nothing cancels, parts them.
    fn seeds_near(&self, segment: &Segment, level: f64, seeds: &mut Seeds) {
        let [low, high] = segment.hull();
        // Twice as far as the ray rises on its way through the whole.
        let rise = 2.0 * self.up * low.x.abs().max(high.x.abs()) / self.out;
        let about = segment.about(level);
        let mut height = about.map(|p| p.y);
        height[0] -= self.height;
        let reach = (rise / height[1].abs()).min((rise / height[2].abs()).sqrt());
        if height[0].abs() > rise || !reach.is_finite() {
            return;
        }
        let gap = self.gaps(about.map(|p| p.x), height);
        let roots = roots_between::<7>(&gap, -reach.min(level), reach.min(1.0 - level));
        seeds.extend(roots.as_slice().iter().map(|beside| level + beside));
    }

    /// Whether a crossing between two places of a segment may be `near`, where the ray passes these at a `distance`.
    #[inline(always)]
    fn may_be_near(
        segment: &Segment,
        [from, to]: [f64; 2],
        distance: impl Fn(DVec2) -> f64,
        near: impl Fn([f64; 2]) -> bool,
    ) -> bool {
        let (start, end) = (segment.point(from), segment.point(to));
        // Elsewhere distances rise and fall between the two.
        let steady = segment.is_straight() && start.x * end.x >= 0.0;
        !steady || near([distance(start), distance(end)])
    }

    /// Whether a ray may meet a segment, before and after it passes the axis, between distances that are `near`.
    #[inline(always)]
    fn comes_near(&self, segment: &Segment, near: impl Fn([f64; 2]) -> bool) -> [bool; 2] {
        /// Many times what squares of radii are rounded by, as a share.
        const NOISE: f64 = 1e-12;
        let hull = segment.hull();
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        if self.up > FLAT * self.out {
            let [bottom, top] = hull.map(|p| (p.y - self.height) / self.up);
            let room = FAR * self.height.abs() / self.up;
            (low, high) = (bottom - room, top + room);
            if !near([low, high]) {
                return [false; 2];
            }
        }
        // Steep rays cross it where they have its height.
        if self.up > self.out {
            return [true; 2];
        }
        let widest = hull[0].x.abs().max(hull[1].x.abs());
        let narrowest = hull[0].x.max(-hull[1].x).max(0.0);
        let chord = |radius: f64, noise: f64| {
            let square = radius * radius * (1.0 + noise) - self.nearest * (1.0 - noise);
            square.max(0.0).sqrt() / self.out
        };
        let (from, to) = (chord(narrowest, -NOISE), chord(widest, NOISE));
        let meets = |start: f64, end: f64| {
            let (start, end) = (start.max(low), end.min(high));
            start <= end && near([start, end])
        };
        [meets(-to, -from), meets(from, to)]
    }

    /// Calls back with the place on the segment and the distance of every crossing between distances that are `near`.
    fn meet(&self, segment: &Segment, near: impl Fn([f64; 2]) -> bool, mut found: impl FnMut(f64, f64)) {
        let [before, after] = self.comes_near(segment, &near);
        if !before && !after {
            return;
        }
        let mut seeds = self.seeds(segment);
        if self.up > self.out {
            let rise = |p: DVec2| (p.y - self.height) / self.up;
            sign_changes(
                &seeds,
                [0.0, 1.0],
                |w| self.gap(segment.point(w)),
                |from, to| Self::may_be_near(segment, [from, to], rise, &near),
                |w| found(w, rise(segment.point(w))),
            );
            return;
        }
        let mut height = segment.polynomial(|p| p.y);
        height[0] -= self.height;
        if segment.is_straight() {
            seeds.extend(Some(-height[0] / height[1]).filter(|w| (0.0..=1.0).contains(w)));
        } else {
            let levels = roots_between::<4>(&height, 0.0, 1.0);
            if self.up < FLAT * self.out {
                let turns = segment.extremes(|p| p.y);
                for &place in levels.as_slice().iter().chain(turns.as_slice()) {
                    self.seeds_near(segment, place, &mut seeds);
                }
            }
            seeds.extend_from_slice(levels.as_slice());
        }
        seeds.sort_unstable_by(f64::total_cmp);
        for (branch, comes_near) in [(-1.0, before), (1.0, after)] {
            if !comes_near {
                continue;
            }
            let distance = |p: DVec2| branch * self.along(p) / self.out;
            sign_changes(
                &seeds,
                [0.0, 1.0],
                |w| self.above(segment.point(w), branch),
                |from, to| Self::may_be_near(segment, [from, to], distance, &near),
                |w| {
                    let on = segment.point(w);
                    if on.x * on.x >= self.nearest {
                        found(w, distance(on));
                    }
                },
            );
        }
    }

    /// In which of four boxes of radii and heights the ray may meet anything: where [`Passing::gap`] has no one
    /// sign.
    #[inline(always)]
    fn reaches(&self, hulls: &Hulls) -> u32 {
        /// Many times what the gap is rounded by, as a share.
        const NOISE: f64 = 1e-13;
        let Hulls { low, high } = hulls;
        let widest = low[0].abs().greater(high[0].abs());
        let narrowest = low[0].greater(-high[0]).greater(Lanes::ZERO);
        let (below, above) = (-(low[1] - self.height), high[1] - self.height);
        let (least, most) = ((-below).greater(-above).greater(Lanes::ZERO), below.greater(above));
        let (up, out) = (self.up * self.up, self.out * self.out);
        let size = most + self.height.abs();
        let wide = widest * widest;
        let noise = ((wide + self.nearest) * up + most * size * out) * NOISE;
        let inner = (wide - self.nearest) * up - least * least * out + noise;
        let outer = most * most * out - (narrowest * narrowest - self.nearest) * up + noise;
        inner.bits(|inner| inner >= 0.0)
            & outer.bits(|outer| outer >= 0.0)
            & (wide * (1.0 + NOISE)).bits(|wide| wide >= self.nearest)
    }
}

fn square(p: [f64; 4]) -> [f64; 7] {
    let mut out = [0.0; 7];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in p.iter().enumerate() {
            out[i + j] += a * b;
        }
    }
    out
}

impl Lathe {
    /// Calls back with the crossings in a range, in no order; `visit` answers with the end of what is of interest from
    /// then on.
    #[inline(always)]
    fn visit(&self, ray: &Ray, range: Range, mut visit: impl FnMut(Crossing) -> f64) {
        let speed = ray.direction.length();
        let d = ray.direction / speed;
        let flat = DVec2::new(d.x, d.z);
        let away = flat.length_squared();
        let start = -DVec2::new(ray.origin.x, ray.origin.z).dot(flat) / away;
        // A ray along the axis starts at the middle height.
        let [low, high] = self.profile.hull();
        let start = if start.is_finite() { start } else { (0.5 * (low.y + high.y) - ray.origin.y) / d.y };
        if !start.is_finite() {
            return;
        }
        let near = d.mul_add(DVec3::splat(start), ray.origin);
        // Upside down where the ray goes down: only the square and the sign of `up` times `out` count.
        let passing = Passing {
            nearest: near.x * near.x + near.z * near.z,
            height: near.y,
            out: away.sqrt(),
            up: d.y.abs(),
        };
        let sense = if d.y < 0.0 { -1.0 } else { 1.0 };
        let range = Cell::new(range);
        let near = |ends: [f64; 2]| {
            let Range { min, max } = range.get();
            let [one, other] = ends.map(|t| (sense * t + start) / speed);
            let room = FAR * ((ends[0].abs() + ends[1].abs() + start.abs()) / speed);
            one.min(other) - room < max && one.max(other) + room > min
        };
        widest(
            #[inline(always)]
            || {
                self.profile.each_near(
                    #[inline(always)]
                    |hulls| passing.reaches(hulls),
                    |part, segment| {
                        passing.meet(segment, near, |w, t| {
                            let t = (sense * t + start) / speed;
                            let Range { min, max } = range.get();
                            if min < t && t < max {
                                range.set(Range { min, max: visit(Crossing { t, part, at: [w, 0.0] }) });
                            }
                        });
                        false
                    },
                );
            },
        );
    }
}

impl Shape for Lathe {
    fn bounds(&self) -> Bounds {
        let [low, high] = self.profile.hull();
        let radius = low.x.abs().max(high.x.abs());
        Bounds::new(DVec3::new(-radius, low.y, -radius), DVec3::new(radius, high.y, radius))
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        let from = out.len();
        self.visit(ray, range, |crossing| {
            out.push(crossing);
            range.max
        });
        out[from..].sort_by(|a, b| a.t.total_cmp(&b.t));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut nearest = None;
        self.visit(ray, range, |crossing| {
            nearest = Some(crossing);
            crossing.t
        });
        nearest
    }

    fn is_closed(&self) -> bool {
        // Ends on the axis leave nothing open.
        !self.profile.is_open_within([DVec2::new(f64::MIN_POSITIVE, f64::NEG_INFINITY), DVec2::INFINITY])
    }

    fn inside(&self, point: DVec3) -> bool {
        self.profile.encloses(DVec2::new(point.x.hypot(point.z), point.y))
    }

    fn inside_along(&self, point: &[Band; 3]) -> Band {
        // From the axis outward, however near; ends on the axis itself leave nothing open.
        let off_axis = |y: f64| DVec2::new(f64::MIN_POSITIVE, y);
        let leaves_unseen = |ray: &Ray, range: Range| {
            self.profile.is_open_within([range.min, range.max].map(|t| off_axis(ray.at(t).y)))
        };
        let passes = |ray: &Ray, range| self.occludes(ray, range) || leaves_unseen(ray, range);
        uncrossed::inside_unless(self, passes, point)
    }

    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        let segment = &self.profile.segments()[crossing.part as usize];
        let slope = segment.slope(crossing.at[0]);
        let radius = point.x.hypot(point.z);
        let normal = DVec3::new(slope.y * point.x, -slope.x * radius, slope.y * point.z);
        if normal == DVec3::ZERO { DVec3::Y } else { normal }
    }

    fn uv(&self, point: DVec3, crossing: &Crossing) -> Option<DVec2> {
        let count = self.profile.segments().len() as f64;
        let v = (f64::from(crossing.part) + crossing.at[0]) / count;
        Some(DVec2::new(turn(point), v.min(1.0)))
    }

    fn reproject(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        let on = self.profile.segments()[crossing.part as usize].point(crossing.at[0]);
        let radius = point.x.hypot(point.z);
        let scale = if radius == 0.0 { 0.0 } else { on.x.abs() / radius };
        DVec3::new(point.x * scale, on.y, point.z * scale)
    }
}

/// The angle about the y axis, from +x towards +z, in 0 … 1.
pub(super) fn turn(point: DVec3) -> f64 {
    (point.z.atan2(point.x) / TAU).rem_euclid(1.0)
}

#[cfg(test)]
mod tests {
    use super::super::battery::{self, battery, table};
    use super::*;

    fn points(all: &[[f64; 2]], size: f64) -> Vec<DVec2> {
        all.iter().map(|p| DVec2::from(*p) * size).collect()
    }

    fn linear(all: &[[f64; 2]], size: f64) -> Lathe {
        let segments = points(all, size).windows(2).map(|p| Segment::linear(p[0], p[1])).collect();
        Lathe { profile: Curve::new(segments) }
    }

    fn cubic(all: &[[f64; 2]], size: f64) -> Lathe {
        let segments = points(all, size).windows(4).map(|p| Segment::cubic(p[0], p[1], p[2], p[3])).collect();
        Lathe { profile: Curve::new(segments) }
    }

    const TOP: [[f64; 2]; 4] = [[0., 0.], [1., 0.2], [0.5, 1.], [0., 1.5]];
    const VASE: [[f64; 2]; 6] = [[0.1, -0.5], [0.4, 0.], [1., 0.5], [0.5, 1.], [0.2, 1.5], [0., 2.]];
    const DIAMOND: [[f64; 2]; 5] = [[0., -0.7], [0.8, -0.3], [0.5, 0.1], [0.7, 0.5], [0., 0.8]];

    battery! {
        straight: |size| linear(&DIAMOND, size);
        smooth: |size| cubic(&[[-0.5, -0.6], [0., -0.8], [0.8, -0.3], [0.4, 0.2], [0., 0.8], [-0.5, 0.5]], size);
        closed: |size| linear(&[[0.5, -0.3], [0.9, -0.3], [0.9, 0.5], [0.5, 0.5], [0.5, -0.3]], size);
    }

    #[test]
    fn straight_profiles_agree_with_povray() {
        table(
            &linear(&TOP, 1.0),
            "from <0.1,0.6,-5> dir <0,0,1> | P <0.1, 0.6, -0.743303437365924> N <0.113066440534012, 0.52999894000318, -0.840426738996609>
            from <0.1,0.4,-5> dir <0.01,0.05,1> | P <0.142723773741742, 0.613618868708711, -0.727622625825782> N <0.163225142250833, 0.52999894000318, -0.832141019619091>
            from <0.3,5,0.1> dir <0,-1,0> | P <0.3, 1.183772233983162, 0.1> N <0.670820393249937, 0.707106781186548, 0.223606797749979>
            from <5,0.7,0.1> dir <-1,0,0> | P <0.680188393020638, 0.7, 0.1> N <0.838979787178834, 0.52999894000318, 0.123345207855286>
            inside <0.5,0.5,0> | 1
            inside <0.85,0.5,0> | 0
            extent | <-1, 0, -1> .. <1, 1.5, 1>",
        );
        table(
            &linear(&[[0.5, 0.], [1., 0.], [1., 1.], [0.5, 1.], [0.5, 0.]], 1.0),
            "from <0.1,0.6,-5> dir <0,0,1> | P <0.1, 0.6, -0.994987437106619> N <0.1, 0, -0.99498743710662>
            from <0.7,5,0.1> dir <0,-1,0> | P <0.7, 1, 0.1> N <0, 1, 0>
            from <0.2,0.5,0> dir <1,0,0> | P <0.5, 0.5, 0> N <-1, 0, 0>
            inside <0.2,0.5,0> | 0
            inside <0.7,0.5,0> | 1",
        );
    }

    #[test]
    fn splines_agree_with_povray() {
        let quadratic = points(&[[0., -0.5], [0.4, 0.], [1., 0.5], [0.5, 1.], [0.2, 1.5]], 1.0);
        let segments = quadratic.windows(3).map(|p| Segment::quadratic(p[0], p[1], p[2])).collect();
        table(
            &Lathe { profile: Curve::new(segments) },
            "from <0.1,0.6,-5> dir <0,0,1> | P <0.1, 0.6, -0.982926243418091> N <0.095827200892683, 0.321902733238702, -0.941910705907161>
            from <0.1,0.4,-5> dir <0.01,0.05,1> | P <0.140223886861527, 0.601119434307635, -0.977611313847296> N <0.134221992836577, 0.326073417001726, -0.935767376736225>
            inside <0.5,0.5001,0> | 1
            extent | <-1.001136422157288, 0, -1.001136422157288> .. <1.001136422157288, 1.5, 1.001136422157288>",
        );
        table(
            &cubic(&VASE, 1.0),
            "from <0.1,0.6,-5> dir <0,0,1> | P <0.1, 0.6, -0.962016548714208> N <0.084542222541465, 0.575655433000418, -0.813310171499687>
            from <0.1,0.4,-5> dir <0.01,0.05,1> | P <0.140446564530666, 0.602232822653332, -0.955343546933365> N <0.118126304803978, 0.583443739685196, -0.803517005878227>
            from <0.3,5,0.1> dir <0,-1,0> | P <0.3, 1.276478507188429, 0.1> N <0.827748035694054, 0.488572966692721, 0.275916011898018>
            inside <0.5,0.5001,0> | 1
            extent | <-1.000526905059814, 0, -1.000526905059814> .. <1.000526905059814, 1.5, 1.000526905059814>",
        );
        #[rustfmt::skip]
        let bezier = points(
            &[[0., 0.], [0.5, 0.], [1., 0.2], [1., 0.5], [1., 0.5], [1., 0.8], [0.5, 1.2], [0., 1.2]], 1.0,
        );
        let segments = bezier.chunks(4).map(|p| Segment::bezier(p[0], p[1], p[2], p[3])).collect();
        let lathe = Lathe { profile: Curve::new(segments) };
        // POV-Ray's solver ends at z = -0.978057401834.
        table(
            &lathe,
            "from <0.1,0.6,-5> dir <0,0,1> | P <0.1, 0.6, -0.978057402155> N <0.096779461457, 0.307669284720, -0.946558686548>
            from <0.3,5,0.1> dir <0,-1,0> | P <0.3, 1.14990519602998, 0.1> N <0.281698456014016, 0.954897306799311, 0.093899485338005>
            extent | <-1, 0, -1> .. <1, 1.200000047683716, 1>",
        );
        battery::uv(&lathe, [0.3, 0.9, -5.0], [0.0, 0.0, 1.0], [0.81408, 0.71347]);
    }

    #[test]
    fn uv_agrees_with_povray() {
        battery::uv(&linear(&TOP, 1.0), [0.1, 0.6, -5.0], [0.0, 0.0, 1.0], [0.77128, 0.50001]);
        battery::uv(&cubic(&VASE, 1.0), [0.3, 0.9, -5.0], [0.0, 0.0, 1.0], [0.83261, 0.6]);
    }

    #[test]
    fn a_point_at_the_height_of_a_joint_is_inside() {
        // POV-Ray counts the joint twice and says 0 for the first, and for the vase.
        table(&cubic(&VASE, 1.0), "inside <0.5,0.5,0> | 1");
        let double_cone = linear(&[[0., -1.], [1., 0.], [0., 1.]], 1.0);
        table(&double_cone, "inside <0.5,0,0> | 1\ninside <0.5,1e-12,0> | 1");
    }
}
