//! `isosurface` (docs/spec/primitives.md 5.2).

use std::sync::Arc;

use super::r#box::Cuboid;
use super::sphere::Sphere;
use super::stretch::Stretch;
use super::{Crossing, Shape};
use crate::math::roots::between;
use crate::math::{Bounds, DVec3};
use crate::world::sample::{Field, Sample};
use crate::world::{Range, Ray};

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
    /// The shortest stretch that is looked at, also the step that gives normals; positive.
    pub accuracy: f64,
    /// The steepest the function is, as its author says: a stretch that it can't cross zero in at this
    /// gradient is passed over.
    pub max_gradient: f64,
    /// The share by which a steeper gradient met on the way exceeds itself as the new bound.
    pub adaptive: Option<f64>,
    /// How many crossings a ray has at most.
    pub most: usize,
    /// Without the container's own surface where it cuts the solid.
    pub open: bool,
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

/// POV-Ray starts this many times the accuracy behind a surface to look for the next.
const AWAY: f64 = 5.0;

/// A search along one ray, in which distances are lengths.
struct Search<'a> {
    surface: &'a Isosurface,
    origin: DVec3,
    direction: DVec3,
    gradient: f64,
    accuracy: f64,
}

impl Search<'_> {
    fn value(&self, t: f64) -> f64 {
        self.surface.value(self.origin + t * self.direction)
    }

    /// The first place behind `from` at which the value times `sign` becomes negative, up to `to`;
    /// with the end of the short stretch it was found in.
    fn first(&mut self, from: f64, to: f64, sign: f64) -> Option<(f64, f64)> {
        let at = |search: &Self, t: f64| (t, sign * search.value(t));
        let mut low = at(self, from);
        let mut rest = vec![at(self, to)];
        while let Some(high) = rest.last().copied() {
            let length = high.0 - low.0;
            if let Some(share) = self.surface.adaptive {
                let slope = (high.1 - low.1).abs() / length * share;
                if slope > self.gradient {
                    self.gradient = slope * share;
                }
            }
            let middle = low.0 + 0.5 * length;
            if length < self.accuracy || middle <= low.0 || middle >= high.0 {
                if high.1 < 0.0 {
                    let root = if low.1 > 0.0 { between(low, high, |t| sign * self.value(t)) } else { low.0 };
                    return Some((root, high.0));
                }
            } else if low.1 + high.1 - self.gradient * length < 0.0 {
                rest.push(at(self, middle));
                continue;
            }
            low = high;
            rest.pop();
        }
        None
    }
}

impl Isosurface {
    fn value(&self, point: DVec3) -> f64 {
        self.function.value(&Sample::at(point)) - self.threshold
    }

    /// Calls back with the crossings from `start` on, ascending, until it returns `false`.
    fn walk(&self, ray: &Ray, start: f64, mut found: impl FnMut(Crossing) -> bool) {
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
            // In POV-Ray it is a length in the scene, which is too coarse for what is scaled down.
            accuracy: self.accuracy * speed.min(1.0),
        };
        let away = AWAY * self.accuracy;
        let end = (stretch.leave.t - begin) * speed;
        let mut push = |t: f64, lag: f64, part: u32| {
            found(Crossing { at: [lag / speed, 0.0], ..Crossing::new(begin + t / speed, part) })
        };
        let value = search.value(0.0);
        let mut left = self.most;
        let (mut from, mut inside) = (0.0, value < 0.0);
        if begin > start {
            if inside && !self.open {
                left -= 1;
                if !push(0.0, 0.0, stretch.enter.part + 1) {
                    return;
                }
            }
        } else if value.abs() < 4.0 * self.max_gradient * self.accuracy {
            // The ray starts on the surface, or as good as: which side it is on shows a little farther.
            from = away.min(end);
            inside = search.value(from) < 0.0;
        }
        while left > 0 {
            let sign = if inside { -1.0 } else { 1.0 };
            let Some((root, after)) = search.first(from, end, sign) else {
                break;
            };
            left -= 1;
            inside = !inside;
            if !push(root, after - root, 0) {
                return;
            }
            from = after + away;
            if from >= end {
                break;
            }
        }
        if inside && !self.open && (left > 0 || self.most == 1 && begin <= start) && search.value(end) < 0.0 {
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

    /// By differences with the accuracy as step, as in POV-Ray.
    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        if let Some(part) = crossing.part.checked_sub(1) {
            return self.container.shape().normal(point, &Crossing::new(crossing.t, part));
        }
        let here = self.value(point);
        let rise = |axis: DVec3| self.value(point + self.accuracy * axis) - here;
        let normal = DVec3::new(rise(DVec3::X), rise(DVec3::Y), rise(DVec3::Z));
        normal.try_normalize().unwrap_or(DVec3::X)
    }

    /// POV-Ray stops up to the accuracy behind the surface: textures as fine as that show it.
    fn lag(&self, crossing: &Crossing) -> f64 {
        crossing.at[0]
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

    /// x² + y² + z² - 1.
    #[derive(Debug)]
    struct Ball;

    impl Field for Ball {
        fn value(&self, sample: &Sample) -> f64 {
            sample.point.length_squared() - 1.0
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
        }
    }

    /// The distance from the surface of a ball.
    #[derive(Debug)]
    struct Distance(f64);

    impl Field for Distance {
        fn value(&self, sample: &Sample) -> f64 {
            sample.point.length() - self.0
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
    fn a_gradient_said_too_small_hides_the_surface_as_in_povray() {
        let ray = Ray::new(DVec3::new(0.1, 0.2, -5.0), DVec3::Z);
        let flat = Isosurface { max_gradient: 0.2, ..ball(cube(2.0)) };
        assert!(flat.nearest(&ray, Range::AHEAD).is_none());
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
