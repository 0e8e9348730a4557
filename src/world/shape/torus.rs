//! `torus { major, minor }` (docs/spec/primitives.md 3.7).

mod four;
mod line;

use std::f64::consts::{PI, TAU};

use self::line::Line;
use super::{Crossing, Shape};
use crate::math::double::Double;
use crate::math::roots::{self, Search};
use crate::math::wide::widest;
use crate::math::{Band, Bounds, DVec2, DVec3};
use crate::world::{Range, Ray};

/// (√(x² + z²) - major)² + y² = minor². Part 1 is the inner sheet of a spindle torus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torus {
    /// Radius of the circle the tube follows; positive.
    pub major: f64,
    /// Radius of the tube; positive.
    pub minor: f64,
}

/// How much larger than the torus the bounds are that clip the ray, so that a tangent ray isn't lost.
const ROOM: f64 = 1.0 + 1e-9;

/// How far beyond the ends of a range roots are looked for, in units of the torus' size.
const BESIDE: f64 = 1e-6;

/// The share of a ray's speed at which it enters or leaves the tube where a Newton step is known to better a root.
const STEEP: f64 = 0.01;

/// The longest step that betters a root where a ray grazes, as a share of the tube's radius: roots are as good as half
/// of the digits there.
const LEAP: f64 = 1e-6;

/// Without the detour by which `hypot` avoids overflow.
fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

impl Torus {
    /// major² - minor².
    #[inline(always)]
    fn power(&self) -> f64 {
        (self.major - self.minor) * (self.major + self.minor)
    }

    /// Whether a ray whose origin is at its closest approach passes the sphere and the slab around, as squares
    /// alone tell.
    #[inline(always)]
    fn is_passed_by(&self, ray: &Ray) -> bool {
        let radius = (self.major + self.minor) * ROOM;
        let square = radius * radius - ray.origin.length_squared();
        let above = ray.origin.y.abs() - self.minor * ROOM;
        let rise = ray.direction.y * ray.direction.y * square;
        let misses_slab = above > 0.0 && above * above * ray.direction.length_squared() > rise * ROOM;
        // What is no number passes.
        square.is_nan() || square < 0.0 || misses_slab
    }

    /// The stretch of the ray in which roots are looked for, inside the slab and the sphere around.
    #[inline(always)]
    fn clip(&self, ray: &Ray, speed: f64) -> Option<[f64; 2]> {
        let radius = (self.major + self.minor) * ROOM;
        let square = radius * radius - ray.origin.length_squared();
        let half = square.sqrt() / speed;
        if half.is_nan() {
            return None;
        }
        let height = self.minor * ROOM;
        let (origin, direction) = (ray.origin.y, ray.direction.y);
        if direction == 0.0 {
            return (origin.abs() <= height).then_some([-half, half]);
        }
        let per = 1.0 / direction;
        let (one, other) = ((-height - origin) * per, (height - origin) * per);
        let (low, high) = (one.min(other).max(-half), one.max(other).min(half));
        (low <= high).then_some([low, high])
    }

    /// Where a ray that doesn't pass by has its closest approach, and the ray from there.
    #[inline(always)]
    fn moved(&self, ray: &Ray) -> Option<(f64, Ray)> {
        let (shift, ray) = ray.moved_to(DVec3::ZERO);
        (!self.is_passed_by(&ray)).then_some((shift, ray))
    }

    /// The stretches in which the ray may meet the tube: what [`clip`](Self::clip) leaves, but for the cylinder
    /// through the hole, which parts the near from the far side. One that ends before it starts is none.
    #[inline(always)]
    fn stretches(&self, ray: &Ray, speed: f64) -> [[f64; 2]; 2] {
        const NONE: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];
        let Some([low, high]) = self.clip(ray, speed) else {
            return [NONE; 2];
        };
        let (o, d) = (ray.origin, ray.direction);
        let hole = self.major - self.minor - (ROOM - 1.0) * (self.major + self.minor);
        let along = o.x * d.x + o.z * d.z;
        let steep = d.x * d.x + d.z * d.z;
        let chord = along * along - steep * (o.x * o.x + o.z * o.z - hole * hole);
        if hole <= 0.0 || chord <= 0.0 {
            return [[low, high], NONE];
        }
        let half = chord.sqrt();
        [[low, high.min((-along - half) / steep)], [low.max((half - along) / steep), high]]
    }

    /// The quartic along a ray whose origin is at its closest approach, in units of the ring's size and
    /// the ray's own length, so that all coefficients are of order 1.
    fn quartic(&self, ray: &Ray, speed: f64) -> [f64; 5] {
        let size = self.major + self.minor;
        let (o, d) = (ray.origin / size, ray.direction / speed);
        let (major, minor) = (self.major / size, self.minor / size);
        let around = length(o.x, o.z);
        let along = o.x * d.x + o.z * d.z;
        let steep = d.x * d.x + d.z * d.z;
        let m = o.dot(d);
        let k = o.length_squared() + (major - minor) * (major + minor);
        // The constant is a product in which the distance from the tube keeps its digits.
        let tube = (around - major) * (around - major) + (o.y - minor) * (o.y + minor);
        let four = 4.0 * major * major;
        [
            tube * (k + 2.0 * major * around),
            4.0 * m * k - 2.0 * four * along,
            4.0 * m * m + 2.0 * k - four * steep,
            4.0 * m,
            1.0,
        ]
    }

    /// Calls back with the crossings in range, ascending, until told to stop.
    #[inline(always)]
    fn each(&self, whole: &Ray, range: Range, mut found: impl FnMut(Crossing) -> bool) {
        let Some((shift, ray)) = self.moved(whole) else {
            return;
        };
        let speed = ray.direction.length();
        let stretches = self.stretches(&ray, speed);
        let line = Line::new(self, ray.origin.to_array(), ray.direction.to_array(), self.power());
        let beside = BESIDE * (self.major + self.minor) / speed;
        let wanted = [range.min - shift - beside, range.max - shift + beside];
        let mut found = |t: f64| {
            let (t, part, grazes) = self.polish(&ray, t);
            let t = if grazes { self.grazed(whole, t + shift) } else { t + shift };
            t < range.max && (t <= range.min || found(Crossing::new(t, part)))
        };
        for [low, high] in stretches {
            if low > high {
                continue;
            }
            let (b, noise) = line.bernstein(low, high, low.abs().max(high.abs()));
            match roots::each_told_apart(
                &b,
                noise,
                [low, high],
                wanted,
                #[inline(always)]
                |t| line.value(t),
                &mut found,
            ) {
                Search::Done => {}
                Search::Stopped => return,
                Search::Doubt(from) => {
                    if !self.each_in_doubt(&ray, speed, [from, high], wanted, &mut found) {
                        return;
                    }
                }
            }
        }
    }

    /// Calls back with the roots between two ends where they are hard to tell apart; whether more are wanted.
    #[cold]
    fn each_in_doubt(
        &self,
        ray: &Ray,
        speed: f64,
        ends: [f64; 2],
        wanted: [f64; 2],
        found: &mut dyn FnMut(f64) -> bool,
    ) -> bool {
        let quartic = self.quartic(ray, speed);
        let unit = (self.major + self.minor) / speed;
        let [ends, wanted] = [ends, wanted].map(|ends| ends.map(|end| end / unit));
        roots::each_root::<5>(&quartic, ends, wanted, &mut |root| found(root * unit))
    }

    /// Whether the ray meets the surface in `range`, as far as signs alone tell.
    #[inline(always)]
    fn is_met(&self, ray: &Ray, range: Range) -> Option<bool> {
        let Some((shift, ray)) = self.moved(ray) else {
            return Some(false);
        };
        let line = Line::new(self, ray.origin.to_array(), ray.direction.to_array(), self.power());
        for [low, high] in self.stretches(&ray, ray.direction.length()) {
            let (low, high) = (low.max(range.min - shift), high.min(range.max - shift));
            if low < high {
                let (b, noise) = line.bernstein(low, high, low.abs().max(high.abs()));
                if roots::any_told_apart(b, noise)? {
                    return Some(true);
                }
            }
        }
        Some(false)
    }

    /// One Newton step on the distance from the tube, whose cancellation is milder than the quartic's, the part of the
    /// surface, and whether the ray grazes it.
    #[inline(always)]
    fn polish(&self, ray: &Ray, t: f64) -> (f64, u32, bool) {
        let point = ray.at(t);
        let (ring, part) = self.nearest_ring(point);
        let from = point - ring;
        let excess = from.length() - self.minor;
        let slope = from.dot(ray.direction) / from.length();
        let step = excess / slope;
        let polished = t - step;
        let speed = ray.direction.length();
        // What the step leaves is bounded by the curvature, beside which this one is small.
        if slope.abs() > STEEP * speed
            && step.abs() * speed < STEEP.powi(4) * self.minor.min(self.major - self.minor)
        {
            return (polished, part, false);
        }
        // Near a tangent the step is noise: keep the quartic's root.
        let better = |t: f64| ((ray.at(t) - self.nearest_ring(ray.at(t)).0).length() - self.minor).abs();
        let t = if step.is_finite() && better(polished) < excess.abs() { polished } else { t };
        (t, part, true)
    }

    /// One Newton step where a ray grazes the surface, which makes much of little rounding.
    #[cold]
    fn grazed(&self, ray: &Ray, t: f64) -> f64 {
        let square = |number: Double| number * number;
        let [x, y, z] = Double::along(ray.origin, ray.direction, t).map(square);
        let [major, minor] = [self.major, self.minor].map(|radius| square(Double::of(radius)));
        let base = x + y + z + major - minor;
        let value = square(base) - Double::of(4.0) * major * (x + z);
        let (p, d) = (ray.at(t), ray.direction);
        let slope = base.rounded() * p.dot(d) - 2.0 * self.major * self.major * (p.x * d.x + p.z * d.z);
        let step = value.rounded() / (4.0 * slope);
        if step.abs() * d.length() <= LEAP * self.minor { t - step } else { t }
    }

    /// The middle of the tube `point` lies on, and its part: for the inner sheet that is across the axis.
    #[inline(always)]
    fn nearest_ring(&self, point: DVec3) -> (DVec3, u32) {
        let around = length(point.x, point.z);
        let scale = self.major / around;
        let across = if around == 0.0 {
            DVec3::X * self.major
        } else {
            DVec3::new(point.x * scale, 0.0, point.z * scale)
        };
        if self.major >= self.minor {
            return (across, 0);
        }
        let outer = (length(around - self.major, point.y) - self.minor).abs();
        let inner = (length(around + self.major, point.y) - self.minor).abs();
        if inner < outer { (-across, 1) } else { (across, 0) }
    }
}

impl Torus {
    /// The point of the surface next to a computed one, and the unit normal there, of the sheet that is nearest.
    #[inline]
    pub(super) fn touched(&self, point: DVec3) -> (DVec3, DVec3) {
        let ring = self.nearest_ring(point).0;
        let on = ring + (point - ring) * (self.minor / (point - ring).length());
        // What rounding took from the point shows in the direction as well.
        let away = on - self.nearest_ring(on).0;
        (on, away / away.length())
    }
}

impl Shape for Torus {
    fn bounds(&self) -> Bounds {
        let reach = self.major + self.minor;
        let half = DVec3::new(reach, self.minor, reach);
        Bounds::new(-half, half)
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.each(ray, range, |crossing| {
            out.push(crossing);
            true
        });
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        widest(
            #[inline(always)]
            || {
                let mut nearest = None;
                self.each(
                    ray,
                    range,
                    #[inline(always)]
                    |crossing| {
                        nearest = Some(crossing);
                        false
                    },
                );
                nearest
            },
        )
    }

    fn occludes(&self, ray: &Ray, range: Range) -> bool {
        let told = widest(
            #[inline(always)]
            || self.is_met(ray, range),
        );
        told.unwrap_or_else(|| self.nearest(ray, range).is_some())
    }

    fn is_closed(&self) -> bool {
        self.major >= self.minor
    }

    fn inside(&self, point: DVec3) -> bool {
        length(length(point.x, point.z) - self.major, point.y) <= self.minor
    }

    fn inside_along(&self, [x, y, z]: &[Band; 3]) -> Band {
        let from_ring = (x.square() + z.square()).sqrt() - self.major;
        (from_ring.square() + y.square()).sqrt().less_equal(Band::constant(self.minor))
    }

    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        let around = length(point.x, point.z);
        if around == 0.0 {
            return point;
        }
        let ring = DVec3::new(point.x, 0.0, point.z) * (self.major / around);
        if crossing.part == 0 { point - ring } else { point + ring }
    }

    fn uv(&self, point: DVec3, _crossing: &Crossing) -> Option<DVec2> {
        let u = 1.0 - (point.z.atan2(point.x) + PI) / TAU;
        let v = (point.y.atan2(point.x.hypot(point.z) - self.major) + PI) / TAU;
        Some(DVec2::new(u, v))
    }

    fn reproject(&self, point: DVec3, _crossing: &Crossing) -> DVec3 {
        self.touched(point).0
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{self, battery, table};
    use super::*;
    use crate::math::dice::numbers;

    battery! {
        ring: |size| Torus { major: 0.75 * size, minor: 0.25 * size };
        thin: |size| Torus { major: size, minor: 0.01 * size };
        spindle: |size| Torus { major: 0.4 * size, minor: 0.6 * size }, surface;
    }

    #[test]
    fn distances_are_exact_to_the_last_bits() {
        // (x² + y² + z² + 0.5)² - 2.25 (x² + z²)
        battery::oracle(
            &Torus { major: 0.75, minor: 0.25 },
            &[
                (1.0, [4, 0, 0]),
                (1.0, [0, 4, 0]),
                (1.0, [0, 0, 4]),
                (2.0, [2, 2, 0]),
                (2.0, [2, 0, 2]),
                (2.0, [0, 2, 2]),
                (-1.25, [2, 0, 0]),
                (1.0, [0, 2, 0]),
                (-1.25, [0, 0, 2]),
                (0.25, [0, 0, 0]),
            ],
            8.0,
        );
    }

    #[test]
    fn probes_agree_with_povray() {
        let ring = Torus { major: 1.0, minor: 0.25 };
        table(
            &ring,
            "from <0.2,0.1,-5> dir <0.05,0.01,1> | P <0.392879520453854, 0.138575904090771, -1.142409590922925> N <0.270677197089838, 0.554303616363713, -0.787071379140227>
            from <0.9,5,0.1> dir <0.02,-1,0.03> | P <0.995023394577051, 0.248830271147462, 0.242535091865576> N <0.093874213825358, 0.995321084588916, 0.022881664087526>
            from <0,0,0> dir <1,0.1,0.2> | P <0.746623213730611, 0.074662321373061, 0.149324642746122> N <-0.935829847841236, 0.298649285492244, -0.187165969568247>
            from <1,0,0> dir <1,0,0> | P <1.25, 0, 0> N <1, 0, 0>
            from <1,0,0> dir <0,1,0> | P <1, 0.25, 0> N <0, 1, 0>
            from <5,0.2499999,0> dir <-1,0,0> | P <1.000223607, 0.2499999, 0> N <0.000894427, 0.9999996, 0>
            from <0,5,0> dir <0,-1,0> | miss
            from <0.2,0.1,-1e4> dir <0,0,1> | P <0.2, 0.1, -1.212747941452108> N <0.149132483164357, 0.399999999999558, -0.904300559806078>
            inside <1,0.25,0> | 1
            inside <1,0.2500001,0> | 0
            inside <0.75,0,0> | 1
            extent | <-1.25, -0.25, -1.25> .. <1.25, 0.25, 1.25>",
        );
        table(
            &Torus { major: 0.5, minor: 1.0 },
            "from <0.1,5,0> dir <0,-1,0> | P <0.1, 0.916515138991122, 0> N <-0.400000000000017, 0.916515138991161, 0>
            inside <0,0,0> | 1
            inside <0,0.9,0> | 0
            extent | <-1.5, -1, -1.5> .. <1.5, 1, 1.5>",
        );
    }

    #[test]
    fn signs_tell_of_every_surface_in_a_range() {
        let ring = Torus { major: 0.75, minor: 0.25 };
        let mut number = numbers(9);
        let (mut met, mut met_again) = (0, 0);
        for _ in 0..20_000 {
            let mut point = || 2.0 * DVec3::new(number(), number(), number());
            let (ray, way) = (Ray::new(point(), point().normalize()), point().normalize());
            let range = Range { min: 0.0, max: number().abs() * 4.0 };
            let found = ring.nearest(&ray, range);
            assert_eq!(ring.occludes(&ray, range), found.is_some(), "{ray:?} {range:?}");
            // A ray that leaves the surface starts beside it.
            if let Some(hit) = found {
                let on = ring.reproject(ray.at(hit.t), &hit);
                let normal = ring.normal(on, &hit).normalize();
                let leaving = Ray::new(on + 3e-14 * normal * way.dot(normal).signum(), way);
                let again = ring.nearest(&leaving, range).is_some();
                assert_eq!(ring.occludes(&leaving, range), again, "{leaving:?} {range:?}");
                met += 1;
                met_again += u32::from(again);
            }
        }
        assert!(met > 3000 && met_again > 1000, "{met} {met_again}");
    }

    #[test]
    fn a_ray_tangent_to_the_top_circle_hits_it() {
        // POV-Ray misses, or with `sturm` finds x = 0.999999995533311.
        table(
            &Torus { major: 1.0, minor: 0.25 },
            "from <5,0.25,0> dir <-1,0,0> | P <1, 0.25, 0> N <0, 1, 0>",
        );
    }

    #[test]
    fn the_inner_sheet_of_a_spindle_has_its_own_normal() {
        // POV-Ray gives it the outer sheet's, <-0.447, 0.894, 0>.
        table(
            &Torus { major: 0.5, minor: 1.0 },
            "from <0.1,0.2,0> dir <0,1,0> | P <0.1, 0.8, 0> N <0.6, 0.8, 0>",
        );
    }

    #[test]
    fn uv_agrees_with_povray() {
        let ring = Torus { major: 1.0, minor: 0.25 };
        battery::uv(&ring, [0.9, 5.0, 0.1], [0.0, -1.0, 0.0], [0.48238, 0.81167]);
        battery::uv(&ring, [-0.6, -5.0, -0.8], [0.0, 1.0, 0.0], [0.85241, 0.25]);
        battery::uv(&ring, [5.0, 0.1, 0.05], [-1.0, 0.0, 0.0], [0.49352, 0.5655]);
    }
}
