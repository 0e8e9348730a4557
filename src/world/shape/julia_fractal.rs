//! `julia_fractal` (docs/spec/primitives.md 5.3).

pub mod hypercomplex;

use super::sphere::Sphere;
use super::{Crossing, Shape};
use crate::math::roots::between;
use crate::math::{Bounds, DVec3, DVec4};
use crate::world::{Range, Ray};
use hypercomplex::Function;

/// The points of a slice through four dimensions that never leave a ball while a function with a
/// constant added is applied to them again and again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JuliaFractal {
    /// The constant.
    pub constant: DVec4,
    /// What is applied.
    pub map: Map,
    /// How many times; at least 1.
    pub iterations: u32,
    /// The shortest step of the march.
    pub step: f64,
    /// The fourth coordinate of a point, as factors of the others and a constant.
    pub slice: DVec4,
}

/// The function a [`JuliaFractal`] applies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Map {
    /// The square of a quaternion.
    Square,
    /// Its cube.
    Cube,
    /// The square of a hypercomplex number. POV-Ray's hypercomplex `cube` squares too, but estimates
    /// and shades otherwise.
    HypercomplexSquare {
        /// It was called `cube`.
        cube: bool,
    },
    /// Another function of a hypercomplex number.
    Hypercomplex(Function),
}

/// How far behind its start a ray begins to look for the surface that may be there, many times what rounding
/// moves it by. The ball's radius is about 2 whatever the size of the object.
const NEAR: f64 = 1e-12;

/// The same for a ray that has just left a surface: this one is rough, and as for POV-Ray's shadow rays there is
/// none at once.
const AT_ONCE: f64 = 1e-3;

/// The product of quaternions with the real part first.
fn product(a: DVec4, b: DVec4) -> DVec4 {
    DVec4::new(
        a.x * b.x - a.y * b.y - a.z * b.z - a.w * b.w,
        a.x * b.y + a.y * b.x + a.z * b.w - a.w * b.z,
        a.x * b.z - a.y * b.w + a.z * b.x + a.w * b.y,
        a.x * b.w + a.y * b.z - a.z * b.y + a.w * b.x,
    )
}

/// What an orbit says about the point it began at.
struct Orbit {
    inside: bool,
    /// By how much the square of its last distance exceeds that at which it has escaped.
    excess: f64,
    /// How far the march may safely go.
    clear: f64,
}

impl JuliaFractal {
    fn is_quaternion(&self) -> bool {
        matches!(self.map, Map::Square | Map::Cube)
    }

    /// The radius of the ball around everything.
    fn radius(&self) -> f64 {
        if self.is_quaternion() { (1.0 + self.constant.length() + 1e-7).min(2.0) } else { 4.0 }
    }

    /// The square of the distance at which an orbit has escaped.
    fn escape(&self) -> f64 {
        let radius = self.radius();
        if self.is_quaternion() { radius * radius + 1e-7 } else { 16.0 }
    }

    fn start(&self, p: DVec3) -> DVec4 {
        p.extend(self.slice.truncate().dot(p) + self.slice.w)
    }

    fn apply(&self, q: DVec4) -> DVec4 {
        let image = match self.map {
            Map::Square => product(q, q),
            Map::Cube => product(q, product(q, q)),
            Map::HypercomplexSquare { .. } => hypercomplex::product(q, q),
            Map::Hypercomplex(function) => function.apply(q),
        };
        image + self.constant
    }

    /// Follows the orbit of a point; `direction` is a unit vector along the march.
    fn follow(&self, p: DVec3, direction: DVec3) -> Orbit {
        let escape = self.escape();
        let mut q = self.start(p);
        let mut chain = 1.0;
        let mut excess = 0.0;
        for turn in 0..self.iterations {
            let square = q.length_squared();
            excess = square - escape;
            chain *= square.sqrt();
            if square > escape || square.is_nan() {
                let clear = match self.map {
                    Map::Square => spread(square, chain, 0.5_f64.powi(turn as i32 + 1)),
                    Map::Cube => spread(square, chain, (1.0 / 3.0_f64).powi(turn as i32 + 1)),
                    _ => self.clearance(p, direction, turn, square),
                };
                return Orbit { inside: false, excess, clear: clear.max(self.step) };
            }
            q = self.apply(q);
        }
        Orbit { inside: true, excess, clear: self.step }
    }

    /// POV-Ray's guess of how far a hypercomplex orbit that escaped is from one that doesn't.
    fn clearance(&self, p: DVec3, direction: DVec3, turn: u32, square: f64) -> f64 {
        let slope = -2.0 * self.gradient(p, turn).dot(direction);
        let clear = square / slope;
        if slope > 2e-8 && clear > self.step && clear < 30.0 * self.step { clear } else { self.step }
    }

    /// The gradient of the orbit's squared distance after so many iterations.
    fn gradient(&self, p: DVec3, iterations: u32) -> DVec3 {
        let mut q = self.start(p);
        if self.is_quaternion() {
            // The orbits of neighbours along the three axes, linearised.
            let mut rows = [DVec4::X, DVec4::Y, DVec4::Z];
            for _ in 0..iterations {
                rows = rows.map(|d| match self.map {
                    Map::Square => product(d, q) + product(q, d),
                    _ => {
                        let square = product(q, q);
                        product(d, square) + product(q, product(d, q)) + product(square, d)
                    }
                });
                q = self.apply(q);
            }
            return DVec3::from_array(rows.map(|row| row.dot(q)));
        }
        // The product of the slopes of all turns. POV-Ray's are other functions but for squares.
        let slope = |q| match self.map {
            Map::Hypercomplex(function) => function.slope(q),
            _ => q,
        };
        let mut t = slope(q);
        for turn in 1..=iterations {
            q = self.apply(q);
            if turn < iterations {
                t = hypercomplex::product(t, slope(q));
            }
        }
        if self.map == (Map::HypercomplexSquare { cube: false }) {
            t *= 2.0_f64.powi(iterations as i32);
        }
        DVec3::new(
            t.x * q.x + t.y * q.y + t.z * q.z + t.w * q.w,
            -t.y * q.x + t.x * q.y - t.w * q.z + t.z * q.w,
            -t.z * q.x - t.w * q.y + t.x * q.z + t.y * q.w,
        )
    }

    /// Calls back with the distance of every crossing behind `start`, ascending, until it returns `false`.
    fn walk(&self, ray: &Ray, start: f64, mut found: impl FnMut(f64) -> bool) {
        let speed = ray.direction.length();
        let ball = Sphere { center: DVec3::ZERO, radius: self.radius() };
        let Some(stretch) = ball.stretch(ray).filter(|s| s.leave.t > start && s.enter.t.is_finite()) else {
            return;
        };
        let begin = start.max(stretch.enter.t);
        let (origin, direction) = (ray.at(begin), ray.direction / speed);
        let end = (stretch.leave.t - begin) * speed;
        let at = |t: f64| self.follow(origin + t * direction, direction);
        // Rays that leave a surface start at 0.
        let mut t = if begin == 0.0 && start == 0.0 { AT_ONCE } else { NEAR };
        let mut here = at(t);
        // What reaches the ball ends there.
        if here.inside && begin > start && !found(begin) {
            return;
        }
        while t < end {
            let next = t + here.clear;
            if next > end {
                if here.inside {
                    found(stretch.leave.t);
                }
                return;
            }
            let there = at(next);
            if there.inside != here.inside {
                // Close to the surface the sign is that of a smooth function: whether the last turn escapes.
                let sign = |orbit: &Orbit| {
                    if orbit.inside { orbit.excess } else { orbit.excess.max(f64::MIN_POSITIVE) }
                };
                let root = between((t, sign(&here)), (next, sign(&there)), |t| sign(&at(t)));
                if !found(begin + root / speed) {
                    return;
                }
            }
            (t, here) = (next, there);
        }
    }
}

/// The estimate for quaternions that escaped: how fast orbits part, from the product of all lengths.
fn spread(square: f64, chain: f64, share: f64) -> f64 {
    share * square.sqrt() / chain * square.ln()
}

impl Shape for JuliaFractal {
    fn bounds(&self) -> Bounds {
        let half = DVec3::splat(self.radius());
        Bounds::new(-half, half)
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.walk(ray, range.min, |t| {
            if range.contains(t) {
                out.push(Crossing::new(t, 0));
            }
            t < range.max
        });
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut nearest = None;
        self.walk(ray, range.min, |t| {
            nearest = range.contains(t).then(|| Crossing::new(t, 0));
            nearest.is_none() && t < range.max
        });
        nearest
    }

    fn inside(&self, point: DVec3) -> bool {
        self.follow(point, DVec3::ZERO).inside
    }

    fn normal(&self, point: DVec3, _crossing: &Crossing) -> DVec3 {
        self.gradient(point, self.iterations).normalize_or(DVec3::X)
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{Probe, table};
    use super::*;
    use crate::math::DVec2;

    fn make(constant: [f64; 4], map: Map, iterations: u32, precision: f64) -> JuliaFractal {
        let constant = DVec4::from(constant);
        JuliaFractal { constant, map, iterations, step: 1.0 / precision, slice: DVec4::ZERO }
    }

    /// POV-Ray bisects to 1e-7: points agree to that, normals a little less.
    #[track_caller]
    fn near(shape: &JuliaFractal, from: [f64; 3], direction: [f64; 3], point: [f64; 3], normal: [f64; 3]) {
        let found = Probe::new(from.into(), direction.into()).hit(shape).unwrap();
        assert!(found.point.abs_diff_eq(point.into(), 2e-7), "{}", found.point);
        assert!(found.normal.abs_diff_eq(normal.into(), 1e-4), "{}", found.normal);
    }

    #[test]
    fn quaternions_agree_with_povray() {
        let square = make([-0.083, 0.0, -0.83, -0.025], Map::Square, 8, 15.0);
        let ahead = [0.0, 0.0, 1.0];
        let from = [0.1, 0.2, -5.0];
        near(
            &square,
            from,
            ahead,
            [0.1, 0.2, -0.341339583216304],
            [0.854707628308641, 0.141787631672129, -0.499370741649755],
        );
        near(
            &square,
            from,
            [0.02, 0.03, 1.0],
            [0.196106350881511, 0.344159526322266, -0.194682455924468],
            [0.444585906822016, 0.41532264352915, -0.793631194716541],
        );
        table(
            &square,
            "inside <0,0,0> | 1
            inside <0.3,0.2,0.1> | 1
            inside <0.9,0,0> | 0
            extent | <-1.834514379501343, -1.834514379501343, -1.834514379501343> .. <1.834514379501343, 1.834514379501343, 1.834514379501343>",
        );
        let cube = make([-0.162, 0.163, 0.56, -0.599], Map::Cube, 6, 30.0);
        near(
            &cube,
            from,
            ahead,
            [0.1, 0.2, -0.669658367320683],
            [0.907452908646375, 0.093403625992139, -0.409640063031871],
        );
        let normal = DVec4::new(0.3, 0.2, 0.1, 0.9).normalize();
        let slice = (-normal.truncate()).extend(0.1) / normal.w;
        let sliced = JuliaFractal { slice, ..square };
        near(
            &sliced,
            from,
            ahead,
            [0.1, 0.2, -0.339125486741975],
            [0.836711188886007, 0.157449734806646, -0.524522609047771],
        );
    }

    #[test]
    fn rays_that_leave_the_surface_outward_are_seldom_stopped_at_once() {
        let fractal = make([-0.083, 0.0, -0.83, -0.025], Map::Square, 6, 20.0);
        let (mut left, mut stopped) = (0, 0);
        for number in 0..1000_u32 {
            let at =
                DVec3::new(f64::from(number % 32) / 40.0 - 0.4, f64::from(number / 32) / 40.0 - 0.4, -5.0);
            let Some(hit) = Probe::new(at, DVec3::Z).hit(&fractal) else {
                continue;
            };
            let away = Ray::new(hit.point + 1e-14 * hit.normal, hit.normal);
            left += 1;
            stopped += u32::from(fractal.occludes(&away, Range { min: 0.0, max: 0.01 }));
        }
        assert!(left > 300 && stopped * 50 < left, "{stopped} of {left}");
    }

    #[test]
    fn hypercomplex_numbers_agree_with_povray() {
        let of = |map| make([-0.162, 0.163, 0.56, -0.599], map, 6, 30.0);
        let (from, direction) = ([0.1, 0.2, -7.0], [0.01, 0.02, 1.0]);
        let square = of(Map::HypercomplexSquare { cube: false });
        near(
            &square,
            from,
            direction,
            [0.164670911733538, 0.329341823467076, -0.532908826646225],
            [0.578437698745042, 0.658966634580752, -0.480804329410476],
        );
        let cube = of(Map::HypercomplexSquare { cube: true });
        table(&square, "inside <0.1,0.2,0.3> | 1\nextent | <-4, -4, -4> .. <4, 4, 4>");
        table(&cube, "inside <0.1,0.2,0.3> | 1");
        let inside =
            [Function::Ln, Function::Sin, Function::Asin, Function::Cos, Function::Tan, Function::Cosh];
        for function in inside {
            table(&of(Map::Hypercomplex(function)), "inside <0.1,0.2,0.3> | 1");
        }
        for function in [Function::Reciprocal, Function::Power(DVec2::new(3.0, 0.5))] {
            table(&of(Map::Hypercomplex(function)), "inside <0.1,0.2,0.3> | 0");
        }
    }

    /// POV-Ray looks for these on a wrong point and takes wrong normals.
    #[test]
    fn functions_have_the_normals_of_their_surface() {
        let fractal = make([-0.162, 0.163, 0.56, -0.599], Map::Hypercomplex(Function::Sin), 3, 30.0);
        let hit = Probe::new([0.1, 0.2, -7.0].into(), [0.01, 0.02, 1.0].into()).hit(&fractal).unwrap();
        let beyond = |p: DVec3| {
            let mut q = fractal.start(p);
            for _ in 0..fractal.iterations {
                q = fractal.apply(q);
            }
            q.length_squared()
        };
        let rise = |axis: DVec3| beyond(hit.point + 1e-6 * axis) - beyond(hit.point - 1e-6 * axis);
        let normal = DVec3::new(rise(DVec3::X), rise(DVec3::Y), rise(DVec3::Z)).normalize();
        assert!(hit.normal.abs_diff_eq(normal, 1e-6), "{} {normal}", hit.normal);
    }
}
