//! `isosurface` (docs/spec/primitives.md 5.2).

#[cfg(test)]
mod holes;
mod search;

use std::cell::Cell;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use super::r#box::Cuboid;
use super::sphere::Sphere;
use super::stretch::Stretch;
use super::{Crossing, Remark, Shape};
use crate::math::{Band, Bounds, DVec3, Lanes};
use crate::world::sample::Field;
use crate::world::{Range, Ray};
use search::Search;

/// Where a function has the value of a threshold, within a container; inside it isn't above.
///
/// Part 0 is the function's surface, the others are the container's, counted from 1.
#[derive(Clone, Debug)]
pub struct Isosurface {
    /// The function.
    pub function: Arc<dyn Field>,
    /// The threshold.
    pub threshold: f64,
    /// Where the surface is looked for.
    pub container: Container,
    /// What is thinner may be missed, if only by functions of which nothing is known or where the surface all but
    /// touches the ray; also the step that gives normals; positive.
    pub accuracy: f64,
    /// The steepest the function is, as its author says. Where nothing else is known of the function a stretch
    /// that it can't cross zero in at this gradient is passed over.
    pub max_gradient: f64,
    /// The share by which a steeper gradient met on the way exceeds itself as the new bound.
    pub adaptive: Option<f64>,
    /// How many crossings a ray has at most.
    pub most: usize,
    /// Without the container's own surface where it cuts the solid.
    pub open: bool,
    /// The steepest gradient that rays have met.
    pub steepest: Steepest,
}

/// The largest of many positive numbers, 0 before there are any.
#[derive(Debug, Default)]
pub struct Steepest(AtomicU64);

impl Steepest {
    fn add(&self, gradient: f64) {
        // Bits of numbers that aren't negative are in their order.
        self.0.fetch_max(gradient.to_bits(), Ordering::Relaxed);
    }

    fn get(&self) -> f64 {
        f64::from_bits(self.0.load(Ordering::Relaxed))
    }
}

impl Clone for Steepest {
    fn clone(&self) -> Self {
        Self(AtomicU64::new(self.get().to_bits()))
    }
}

/// The container of an [`Isosurface`].
#[derive(Clone, Copy, Debug)]
#[expect(missing_docs, reason = "the variants are named after what they hold")]
pub enum Container {
    Box(Cuboid),
    Sphere(Sphere),
}

impl Container {
    fn shape(&self) -> &dyn Shape {
        match self {
            Self::Box(cuboid) => cuboid,
            Self::Sphere(sphere) => sphere,
        }
    }

    /// The box around it.
    pub(super) fn bounds(&self) -> Bounds {
        self.shape().bounds()
    }

    /// What of a line is inside.
    pub(super) fn stretch(&self, ray: &Ray) -> Option<Stretch> {
        match self {
            Self::Box(cuboid) => cuboid.stretch(ray),
            Self::Sphere(sphere) => sphere.stretch(ray),
        }
    }

    fn holds(&self, point: DVec3) -> bool {
        match self {
            Self::Box(cuboid) => cuboid.inside(point),
            Self::Sphere(s) => (point - s.center).length_squared() <= s.radius * s.radius,
        }
    }
}

/// POV-Ray starts this many times the accuracy behind a surface to look for the next; so do we where bands
/// don't tell how soon the function is off zero.
const AWAY: f64 = 5.0;

impl Isosurface {
    fn value(&self, point: DVec3) -> f64 {
        self.function.at(point) - self.threshold
    }

    /// Calls back with the crossings from `start` on, ascending, until it returns `false`.
    fn walk(&self, ray: &Ray, start: f64, found: impl FnMut(Crossing) -> bool) {
        let steepest = Cell::new(0.0);
        self.walk_along(ray, start, &steepest, found);
        if steepest.get() > self.max_gradient {
            self.steepest.add(steepest.get());
        }
    }

    fn walk_along(
        &self,
        ray: &Ray,
        start: f64,
        steepest: &Cell<f64>,
        mut found: impl FnMut(Crossing) -> bool,
    ) {
        let speed = ray.direction.length();
        let Some(stretch) =
            self.container.stretch(ray).filter(|s| s.enter.t.is_finite() && s.leave.t > start)
        else {
            return;
        };
        let begin = start.max(stretch.enter.t);
        let mut search = Search {
            surface: self,
            origin: ray.at(begin),
            direction: ray.direction / speed,
            gradient: self.max_gradient,
            steepest,
            // In POV-Ray it is a length in the scene, which is too coarse for what is scaled down.
            accuracy: self.accuracy * speed.min(1.0),
        };
        let away = AWAY * self.accuracy;
        let end = (stretch.leave.t - begin) * speed;
        let mut push = |t: f64, lag: f64, part: u32| {
            found(Crossing { at: [lag / speed, 0.0], ..Crossing::new(begin + t / speed, part) })
        };
        let mut left = self.most;
        let enters = begin > start;
        let mut look = enters.then(|| search.look(0.0, end)).flatten();
        let told = look.and_then(|look| look.starts_below());
        let value = if told.is_some() { f64::NAN } else { search.value(0.0) };
        let (mut from, mut inside) = (0.0, told.unwrap_or(value < 0.0));
        if enters {
            if inside && !self.open {
                left -= 1;
                if !push(0.0, 0.0, stretch.enter.part + 1) {
                    return;
                }
            }
        } else if value.abs() < 4.0 * self.max_gradient * self.accuracy {
            // The ray starts on the surface, or as good as: which side it is on shows a little farther.
            (from, inside) = search.departure(0.0, away.min(end)).unwrap_or_else(|| {
                let from = away.min(end);
                (from, search.value(from) < 0.0)
            });
        }
        while left > 0 {
            let sign = if inside { -1.0 } else { 1.0 };
            let Some((root, after)) = search.first(from, end, sign, look.take()) else {
                break;
            };
            left -= 1;
            inside = !inside;
            if !push(root, after - root, 0) {
                return;
            }
            let departure = search.departure(root, (after + away).min(end) - root);
            from = match departure {
                Some((from, below)) if below == inside => from,
                _ => after + away,
            };
            if from >= end {
                break;
            }
        }
        if inside && !self.open && (left > 0 || self.most == 1 && !enters) && search.value(end) < 0.0 {
            found(Crossing::new(stretch.leave.t, stretch.leave.part + 1));
        }
    }
}

impl Shape for Isosurface {
    fn bounds(&self) -> Bounds {
        self.container.bounds()
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.walk(ray, range.min, |crossing| {
            if range.contains(crossing.t) {
                out.push(crossing);
            }
            crossing.t < range.max
        });
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut nearest = None;
        self.walk(ray, range.min, |crossing| {
            nearest = range.contains(crossing.t).then_some(crossing);
            nearest.is_none() && crossing.t < range.max
        });
        nearest
    }

    fn inside(&self, point: DVec3) -> bool {
        self.container.holds(point) && self.value(point) <= 0.0
    }

    fn inside_along(&self, point: &[Band; 3]) -> Band {
        let below = (self.function.enclose(point) - self.threshold).less_equal(Band::constant(0.0));
        let within = match &self.container {
            Container::Box(cuboid) => cuboid.inside_along(point),
            Container::Sphere(sphere) => sphere.inside_along(point),
        };
        within.and(below)
    }

    /// By differences with the accuracy as step, as in POV-Ray.
    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        if let Some(part) = crossing.part.checked_sub(1) {
            return self.container.shape().normal(point, &Crossing::new(crossing.t, part));
        }
        let DVec3 { x, y, z } = point;
        let step = self.accuracy;
        let places = [Lanes([x, x + step, x, x]), Lanes([y, y, y + step, y]), Lanes([z, z, z, z + step])];
        let [here, beside @ ..] = self.function.at_four(&places).map(|v| v - self.threshold).0;
        let normal = DVec3::from_array(beside.map(|v| v - here));
        normal.try_normalize().unwrap_or(DVec3::X)
    }

    /// POV-Ray stops up to the accuracy behind the surface: textures as fine as that show it.
    fn lag(&self, crossing: &Crossing) -> f64 {
        crossing.at[0]
    }

    /// POV-Ray warns of it too, but not with `evaluate`.
    fn remark(&self) -> Option<Remark> {
        let (found, said) = (self.steepest.get(), self.max_gradient);
        let wrong = self.adaptive.is_none() && found > said * (1.0 + 1e-6);
        wrong.then_some(Remark::TooSteep { found, said, holes: !self.function.is_known() })
    }

    fn reproject(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        match crossing.part.checked_sub(1) {
            Some(part) => self.container.shape().reproject(point, &Crossing::new(crossing.t, part)),
            None => point,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{Probe, battery, table};
    use super::*;
    use crate::world::sample::Sample;

    /// x² + y² + z² - 1.
    #[derive(Debug)]
    struct Ball;

    impl Field for Ball {
        fn value(&self, sample: &Sample) -> f64 {
            sample.point.length_squared() - 1.0
        }

        fn enclose(&self, point: &[Band; 3]) -> Band {
            square(point) - 1.0
        }

        fn is_known(&self) -> bool {
            true
        }
    }

    fn square([x, y, z]: &[Band; 3]) -> Band {
        x.square() + y.square() + z.square()
    }

    /// The same, of which nothing is known.
    #[derive(Debug)]
    struct Hidden;

    impl Field for Hidden {
        fn value(&self, sample: &Sample) -> f64 {
            Ball.value(sample)
        }
    }

    /// A shell of the unit sphere, this thick on both sides.
    #[derive(Debug)]
    struct Shell(f64);

    impl Field for Shell {
        fn value(&self, sample: &Sample) -> f64 {
            (sample.point.length() - 1.0).abs() - self.0
        }

        fn enclose(&self, point: &[Band; 3]) -> Band {
            (square(point).sqrt() - 1.0).abs() - self.0
        }

        fn is_known(&self) -> bool {
            true
        }
    }

    fn cube(half: f64) -> Container {
        Container::Box(Cuboid { min: DVec3::splat(-half), max: DVec3::splat(half) })
    }

    fn ball(container: Container) -> Isosurface {
        Isosurface {
            function: Arc::new(Ball),
            threshold: 0.0,
            container,
            accuracy: 1e-3,
            max_gradient: 4.0,
            adaptive: None,
            most: 1,
            open: false,
            steepest: Steepest::default(),
        }
    }

    /// The distance from the surface of a ball.
    #[derive(Debug)]
    struct Distance(f64);

    impl Field for Distance {
        fn value(&self, sample: &Sample) -> f64 {
            sample.point.length() - self.0
        }

        fn enclose(&self, point: &[Band; 3]) -> Band {
            square(point).sqrt() - self.0
        }

        fn is_known(&self) -> bool {
            true
        }
    }

    fn sized(size: f64, half: f64) -> Isosurface {
        Isosurface {
            function: Arc::new(Distance(size)),
            container: cube(half * size),
            accuracy: 1e-6 * size,
            max_gradient: 1.1,
            most: 10,
            ..ball(cube(1.0))
        }
    }

    battery! {
        whole: |size| sized(size, 1.5);
        cut: |size| sized(size, 0.9);
    }

    #[track_caller]
    fn near(shape: &Isosurface, from: [f64; 3], direction: [f64; 3], point: [f64; 3]) {
        let found = Probe::new(from.into(), direction.into()).hit(shape).unwrap().point;
        // POV-Ray ends up to the accuracy behind the surface.
        assert!(found.abs_diff_eq(point.into(), 1.5e-3), "{found}");
        assert!((found.length_squared() - 1.0 - shape.threshold).abs() < 1e-14, "{found}");
    }

    #[test]
    fn surfaces_are_found_where_povray_finds_them() {
        let all = ball(cube(2.0));
        near(&all, [0.1, 0.2, -5.0], [0.0, 0.0, 1.0], [0.1, 0.2, -0.974609375]);
        near(&all, [0.0; 3], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0005517578125]);
        near(&all, [0.1, 0.2, -5.0], [0.05, 0.1, 1.0], [0.314453125, 0.62890625, -0.7109375]);
        let high = Isosurface { threshold: 0.44, ..all };
        near(&high, [0.1, 0.2, -5.0], [0.0, 0.0, 1.0], [0.1, 0.2, -1.1787109375]);
        table(&high, "inside <0,0,1.1> | 1");
    }

    #[test]
    fn normals_are_differences_by_the_accuracy() {
        let found = Probe::new(DVec3::new(0.1, 0.2, -5.0), DVec3::Z).hit(&ball(cube(2.0))).unwrap();
        let differences = 2.0 * found.point + 1e-3;
        assert!(found.normal.abs_diff_eq(differences.normalize(), 1e-12), "{}", found.normal);
        // POV-Ray has the differences at a point that is less exact.
        let observed = DVec3::new(0.100540748652677, 0.200581294575779, -0.974504336638203);
        assert!(found.normal.abs_diff_eq(observed, 1e-4));
    }

    #[test]
    fn the_container_closes_the_solid() {
        table(
            &ball(cube(0.9)),
            "from <0.1,0.2,-5> dir <0,0,1> | P <0.1, 0.2, -0.9> N <0, 0, -1>
            from <0.8,0.8,-5> dir <0,0,1> | miss
            from <0.1,0.2,0> dir <0,0,1> | P <0.1, 0.2, 0.9> N <0, 0, 1>",
        );
        table(
            &ball(Container::Sphere(Sphere { center: DVec3::ZERO, radius: 0.5 })),
            "from <0.1,0.2,-5> dir <0,0,1> | P <0.1, 0.2, -0.447213595499957> N <0.2, 0.4, -0.894427190999916>
            from <0.1,0.2,0> dir <0,0,1> | P <0.1, 0.2, 0.447213595499958> N <0.2, 0.4, 0.894427190999916>
            extent | <-0.5, -0.5, -0.5> .. <0.5, 0.5, 0.5>",
        );
        let open = Isosurface { open: true, most: 10, ..ball(cube(0.9)) };
        table(&open, "from <0.1,0.2,-5> dir <0,0,1> | miss");
        near(&open, [0.8, 0.4, -5.0], [0.0, 0.0, 1.0], [0.8, 0.4, -0.446484375]);
    }

    #[test]
    fn crossings_end_at_the_number_asked_for() {
        let ray = Ray::new(DVec3::new(0.1, 0.2, -5.0), DVec3::Z);
        let count = |most| {
            let mut all = Vec::new();
            Isosurface { most, ..ball(cube(2.0)) }.crossings(&ray, Range::AHEAD, &mut all);
            all.len()
        };
        assert_eq!([count(1), count(2), count(10)], [1, 2, 2]);
    }

    #[test]
    fn a_gradient_said_too_small_makes_no_holes_and_is_remarked_on() {
        let flat = Isosurface { max_gradient: 0.2, ..ball(cube(2.0)) };
        near(&flat, [0.1, 0.2, -5.0], [0.0, 0.0, 1.0], [0.1, 0.2, -0.974609375]);
        let Some(Remark::TooSteep { found, said: 0.2, holes: false }) = flat.remark() else {
            panic!("{:?}", flat.remark());
        };
        assert!((1.0..4.0).contains(&found), "{found}");
        let right = ball(cube(2.0));
        near(&right, [0.1, 0.2, -5.0], [0.0, 0.0, 1.0], [0.1, 0.2, -0.974609375]);
        assert_eq!(right.remark(), None);
    }

    #[test]
    fn of_functions_of_which_nothing_is_known_the_gradient_must_be_right() {
        let ray = Ray::new(DVec3::new(0.1, 0.2, -5.0), DVec3::Z);
        let hidden =
            |max_gradient| Isosurface { function: Arc::new(Hidden), max_gradient, ..ball(cube(2.0)) };
        let found = hidden(4.0).nearest(&ray, Range::AHEAD).unwrap().t;
        assert_eq!(found, ball(cube(2.0)).nearest(&ray, Range::AHEAD).unwrap().t);
        assert!(hidden(0.2).nearest(&ray, Range::AHEAD).is_none());
    }

    #[test]
    fn what_is_thinner_than_the_accuracy_is_found() {
        let thin = Isosurface { function: Arc::new(Shell(1e-5)), accuracy: 0.01, ..ball(cube(2.0)) };
        for n in 0..200 {
            let ray = Ray::new(DVec3::new(f64::from(n) * 0.004, 0.13, -5.0), DVec3::Z);
            let found = thin.nearest(&ray, Range::AHEAD).map(|crossing| ray.at(crossing.t).length());
            assert!(found.is_some_and(|length| (length - 1.00001).abs() < 1e-14), "{n}: {found:?}");
        }
    }

    #[test]
    fn both_sides_of_what_is_thinner_than_the_accuracy_are_found() {
        let function = Arc::new(Shell(1e-5));
        let thin = Isosurface { function, accuracy: 0.01, most: 10, ..ball(cube(2.0)) };
        let mut all = Vec::new();
        thin.crossings(&Ray::new(DVec3::new(0.3, 0.13, -5.0), DVec3::Z), Range::AHEAD, &mut all);
        assert_eq!(all.len(), 4);
        let inner = thin.nearest(&Ray::new(DVec3::new(0.0, 0.0, 1.00001), DVec3::NEG_Z), Range::AHEAD);
        assert!(inner.is_some_and(|crossing| (crossing.t - 2e-5).abs() < 1e-15));
    }

    #[test]
    fn rays_that_all_but_touch_the_surface_meet_it() {
        for depth in [1e-3, 1e-6, 1e-9] {
            let ray = Ray::new(DVec3::new(0.0, 1.0 - depth, -5.0), DVec3::Z);
            let half = (depth * (2.0 - depth)).sqrt();
            let found = ball(cube(2.0)).nearest(&ray, Range::AHEAD).map(|crossing| crossing.t);
            assert!(found.is_some_and(|t| (t - 5.0 + half).abs() < 1e-14 / half), "{depth}: {found:?}");
            let beside = Ray::new(DVec3::new(0.0, 1.0 + depth, -5.0), DVec3::Z);
            assert!(ball(cube(2.0)).nearest(&beside, Range::AHEAD).is_none());
        }
    }

    #[test]
    fn a_ray_that_leaves_the_surface_does_not_meet_it_again() {
        let surface = ball(cube(2.0));
        let from = Probe::new(DVec3::new(0.1, 0.2, -5.0), DVec3::Z).hit(&surface).unwrap().point;
        assert!(!surface.occludes(&Ray::new(from, DVec3::new(0.3, 0.1, -1.0)), Range::AHEAD));
        let through = surface.nearest(&Ray::new(from, DVec3::Z), Range::AHEAD).unwrap();
        assert!((through.t - 2.0 * 0.95f64.sqrt()).abs() < 1e-14);
    }
}
