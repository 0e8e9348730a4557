//! What is asked of every ray, and how much of it may fail.

use super::Dice;
use crate::math::{Band, DVec3, Lanes};
use crate::world::shape::{Crossing, Shape};
use crate::world::{Range, Ray};

/// A question to a ray's crossings, and the share of rays that may answer it wrongly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Check {
    /// All crossings are in order, finite and in the range asked for.
    Ordered,
    /// The nearest crossing, and whether there is one, agree with all crossings.
    Nearest,
    /// The hit point is within the bounds, but for its rounding.
    Bounded,
    /// The point is on the surface: `reproject` moves it by its rounding.
    OnSurface,
    /// The normal is perpendicular to the surface through neighbouring hits.
    Normal,
    /// The normal points from the inside to the outside.
    Outward,
    /// Inside and outside alternate along the ray.
    Parity,
    /// Rays spawned from the point don't meet it again.
    Spawned,
    /// Bands hold what is inside.
    Enclosed,
}

const CHECKS: [(Check, f64); 9] = [
    (Check::Ordered, 0.0),
    (Check::Nearest, 0.0),
    (Check::Bounded, 0.0),
    (Check::OnSurface, 1e-3),
    (Check::Normal, 5e-3),
    (Check::Outward, 1e-2),
    (Check::Parity, 2e-3),
    (Check::Spawned, 1e-3),
    (Check::Enclosed, 0.0),
];

/// One shape's answers so far.
pub(super) struct Tally<'a> {
    shape: &'a dyn Shape,
    size: f64,
    at: DVec3,
    kind: &'a str,
    crossed: usize,
    asked: [usize; CHECKS.len()],
    failed: [Vec<u64>; CHECKS.len()],
}

impl<'a> Tally<'a> {
    pub(super) fn new(shape: &'a dyn Shape, size: f64, at: DVec3, kind: &'a str) -> Self {
        Self { shape, size, at, kind, crossed: 0, asked: [0; CHECKS.len()], failed: Default::default() }
    }

    /// Whether crossings alternate between in and out.
    fn solid(&self) -> bool {
        self.kind != "surface" && self.shape.is_solid()
    }

    fn ask(&mut self, check: Check, number: u64, passed: bool) {
        let index = CHECKS.iter().position(|(c, _)| *c == check).expect("the check is listed");
        self.asked[index] += 1;
        if !passed {
            self.failed[index].push(number);
        }
    }

    /// Ray `number`: at a point of the cube around the shape, from inside it to 10^5 sizes away.
    pub(super) fn shoot(&mut self, number: u64) {
        let mut dice = Dice::new(number);
        let distance = [1.0, 3.0, 30.0, 1e3, 1e5][number as usize % 5];
        let origin = self.at + self.size * distance * dice.cube();
        let target = self.at + self.size * dice.cube();
        let direction = (target - origin) * (0.1 + dice.unit()) / distance;
        let ray = Ray::new(origin, direction);
        let mut all = Vec::new();
        self.shape.crossings(&ray, Range::LINE, &mut all);
        self.check_order(number, &ray, &all);
        self.check_parity(number, &ray, &all);
        self.check_enclosed(number, &ray, &all);
        for crossing in &all {
            self.crossed += 1;
            self.check_point(number, &ray, crossing);
            self.check_spawned(number, &ray, crossing, &mut dice);
        }
    }

    /// Rays no renderer should shoot find nothing that isn't a number, and don't panic.
    pub(super) fn shoot_nonsense(&mut self) {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0] {
            for ray in [
                Ray::new(DVec3::splat(value), DVec3::X),
                Ray::new(self.at.with_y(value), DVec3::ONE),
                Ray::new(self.at, DVec3::splat(value)),
                Ray::new(self.at + self.size, DVec3::new(-1.0, value, 0.0)),
            ] {
                let mut all = Vec::new();
                self.shape.crossings(&ray, Range::AHEAD, &mut all);
                assert!(all.iter().all(|crossing| crossing.t.is_finite()), "{ray:?} found {all:?}");
                let nearest = self.shape.nearest(&ray, Range::AHEAD);
                assert!(nearest.is_none_or(|crossing| crossing.t.is_finite()), "{ray:?} found {nearest:?}");
            }
            self.shape.inside(DVec3::splat(value));
        }
    }

    fn check_order(&mut self, number: u64, ray: &Ray, all: &[Crossing]) {
        let sorted = all.is_sorted_by(|a, b| a.t <= b.t) && all.iter().all(|c| c.t.is_finite());
        let middle = all.get(all.len() / 2).map_or(0.0, |c| c.t);
        let range = Range { min: middle, max: f64::INFINITY };
        let mut beyond = Vec::new();
        self.shape.crossings(ray, range, &mut beyond);
        let room = 1e-9 * self.size / ray.direction.length();
        let same = |a: f64, b: f64| (a - b).abs() <= room + 1e-13 * b.abs();
        let expected: Vec<_> = all.iter().filter(|c| range.contains(c.t)).collect();
        let kept = beyond.len() == expected.len()
            && beyond.iter().zip(&expected).all(|(found, expected)| same(found.t, expected.t));
        self.ask(Check::Ordered, number, sorted && kept);

        let nearest = self.shape.nearest(ray, Range::AHEAD);
        let first = all.iter().find(|c| c.t > 0.0);
        let agree = match (nearest, first) {
            (Some(nearest), Some(first)) => same(nearest.t, first.t),
            (None, None) => true,
            _ => false,
        };
        self.ask(Check::Nearest, number, agree && self.shape.occludes(ray, Range::AHEAD) == first.is_some());
    }

    fn check_parity(&mut self, number: u64, ray: &Ray, all: &[Crossing]) {
        if !self.solid() {
            return;
        }
        let step = 0.1 * self.size / ray.direction.length();
        let ends = [all.first().map_or(0.0, |c| c.t - step), all.last().map_or(step, |c| c.t + step)];
        let mut inside = self.shape.inside(ray.at(ends[0]));
        let mut passed = true;
        for (i, crossing) in all.iter().enumerate() {
            let next = all.get(i + 1).map_or(ends[1], |next| next.t);
            // Stretches shorter than the rounding of their ends say nothing.
            if (next - crossing.t) * ray.direction.length() < 1e-6 * self.size {
                return;
            }
            let behind = self.shape.inside(ray.at(0.5 * (crossing.t + next)));
            passed &= behind != inside;
            inside = behind;
        }
        self.ask(Check::Parity, number, passed);
    }

    /// A stretch of the ray, long or short, near the surface or not.
    fn check_enclosed(&mut self, number: u64, ray: &Ray, all: &[Crossing]) {
        let mut dice = Dice::new(!number);
        let span = self.size / ray.direction.length();
        let half = span * 0.5_f64.powi((number % 20) as i32);
        let near = all.get(number as usize % all.len().max(1)).map_or(span * dice.unit(), |c| c.t);
        let (middle, along) = (ray.at(near + 2.0 * half * (dice.unit() - 0.5)), ray.direction * half);
        let place = [0, 1, 2].map(|i| Band::line(Lanes::splat(middle[i]), Lanes::splat(along[i])));
        let band = self.shape.inside_along(&place);
        let [low, high] = [band.low().0[1], band.high().0[1]];
        let holds = |share: i32| {
            let inside = f64::from(self.shape.inside(middle + 0.25 * f64::from(share) * along));
            low <= inside && inside <= high
        };
        let passed = (-4..=4).all(holds);
        self.ask(Check::Enclosed, number, passed);
    }

    /// The rounding of a point that was computed from this ray.
    fn rounding(&self, ray: &Ray, t: f64) -> f64 {
        let reach = (ray.origin - self.at).length() + (t * ray.direction).length();
        f64::EPSILON * (reach + self.at.length() + self.size)
    }

    fn check_point(&mut self, number: u64, ray: &Ray, crossing: &Crossing) {
        let shape = self.shape;
        let raw = ray.at(crossing.t);
        let point = shape.reproject(raw, crossing);
        let normal = shape.normal(point, crossing).normalize();
        let slant = normal.dot(ray.direction.normalize()).abs();
        let rounding = self.rounding(ray, crossing.t);
        let bounds = shape.bounds();
        let room = 16.0 * f64::EPSILON * (self.at.length() + self.size);
        let bounded = point.cmpge(bounds.min - room).all() && point.cmple(bounds.max + room).all();
        self.ask(Check::Bounded, number, bounded);
        // A ray that only grazes is known to half the digits along it, but not across.
        let off = (raw - point).dot(normal).abs();
        self.ask(Check::OnSurface, number, off <= 32.0 * rounding.max(self.size * 1e-15) / slant.max(0.05));

        if let Some(tilt) = self.neighbours_tilt(ray, crossing, point) {
            self.ask(Check::Normal, number, tilt < 1e-2);
        }
        if self.solid() {
            let step = if self.kind == "inward" { -1e-4 } else { 1e-4 } * self.size * normal;
            self.ask(Check::Outward, number, shape.inside(point - step) && !shape.inside(point + step));
        }
    }

    /// How far the normal is from perpendicular to the surface through three neighbouring hits.
    fn neighbours_tilt(&self, ray: &Ray, crossing: &Crossing, point: DVec3) -> Option<f64> {
        let step = 1e-5 * self.size.max(self.rounding(ray, crossing.t) * 1e10);
        let normal = self.shape.geometric_normal(point, crossing).normalize();
        if normal.dot(ray.direction.normalize()).abs() < 0.1 {
            return None;
        }
        let (u, v) = ray.direction.normalize().any_orthonormal_pair();
        let mut tilt = 0.0_f64;
        for side in [u, v] {
            let moved = Ray::new(ray.origin + side * step, ray.direction);
            let mut all = Vec::new();
            self.shape.crossings(&moved, Range::LINE, &mut all);
            let beside =
                all.iter().min_by(|a, b| (a.t - crossing.t).abs().total_cmp(&(b.t - crossing.t).abs()))?;
            let to = self.shape.reproject(moved.at(beside.t), beside) - point;
            if beside.part != crossing.part || to.length() > 20.0 * step {
                return None;
            }
            tilt = tilt.max(to.dot(normal).abs() / to.length());
        }
        Some(tilt)
    }

    fn check_spawned(&mut self, number: u64, ray: &Ray, crossing: &Crossing, dice: &mut Dice) {
        let point = self.shape.reproject(ray.at(crossing.t), crossing);
        let normal = self.shape.geometric_normal(point, crossing).normalize();
        // What the renderer knows of a hit: the size of the point and of the shape.
        let error = 32.0 * f64::EPSILON * (point.abs().max_element() + self.size);
        for side in [1.0, -1.0] {
            let out = side * normal;
            let mut direction = dice.cube();
            if direction.dot(out) < 0.0 {
                direction = -direction;
            }
            let slant = direction.dot(out) / direction.length();
            if slant < 1e-3 {
                continue;
            }
            let spawned = Ray::new(point + error * out, direction);
            let again = self.shape.nearest(&spawned, Range::AHEAD);
            let met = again.is_some_and(|c| c.t * direction.length() < 100.0 * error / slant);
            self.ask(Check::Spawned, number, !met);
        }
    }

    /// Prints the rates and fails where one is too high.
    pub(super) fn judge(&self) {
        assert!(self.crossed > 50, "only {} crossings at size {:e}", self.crossed, self.size);
        let mut bad = Vec::new();
        for (index, (check, allowed)) in CHECKS.iter().enumerate() {
            let (asked, failed) = (self.asked[index], &self.failed[index]);
            if failed.is_empty() {
                continue;
            }
            let rate = failed.len() as f64 / asked as f64;
            let line = format!(
                "size {:e} at {:e}: {check:?} fails {} of {asked}, first ray {}",
                self.size,
                self.at.length(),
                failed.len(),
                failed[0]
            );
            println!("{line}");
            if rate > *allowed {
                bad.push(line);
            }
        }
        assert!(bad.is_empty(), "{}\n{:?}", bad.join("\n"), self.shape);
    }
}
