//! `julia_fractal` (docs/spec/primitives.md 5.3).

mod along;
mod clear;
pub mod hypercomplex;
mod march;

use std::sync::Arc;

use super::isosurface::{Container, Isosurface, Steepest};
use super::sphere::Sphere;
use super::{Crossing, Shape};
use crate::math::wide::widest;
use crate::math::{Band, Bounds, DVec3, DVec4, Lanes};
use crate::world::sample::{Field, Sample};
use crate::world::{Range, Ray};
use hypercomplex::Function;

/// The points of a slice through four dimensions that never leave a ball while a function with a
/// constant added is applied to them again and again.
///
/// That is where a function of the point isn't above zero: `Orbit::excess`. Where a high precision is asked for, it
/// is found as any such surface, by bands, so that no step is too long. Else it is marched towards as in POV-Ray.
#[derive(Clone, Debug)]
pub struct JuliaFractal {
    orbit: Orbit,
    surface: Isosurface,
    ball: Sphere,
    /// The shortest step of the march.
    step: f64,
}

/// What makes a [`JuliaFractal`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit {
    /// The constant.
    pub constant: DVec4,
    /// What is applied.
    pub map: Map,
    /// How many points of an orbit are looked at; at least 1.
    pub iterations: u32,
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

/// The length of a stretch that isn't divided any more, where bands leave it open whether the surface is met twice or
/// not at all. The ball's radius is about 2 whatever the size of the object.
const FINE: f64 = 1e-6;

/// As steep as the excess is taken to be where a ray may start on the surface.
const STEEP: f64 = 1e4;

/// Half the stretch that the slope of the excess is taken over.
const STEP: f64 = 1e-9;

/// A point whose excess is this small is on the surface, but for rounding.
const ON_SURFACE: f64 = 1e-9;

/// A march with steps as short as this, a `precision` of 200, would be slower than to be exact.
const EXACT: f64 = 1.0 / 200.0;

/// How far behind its start a ray that has just left a surface begins to look: this one is rough, and as for POV-Ray's
/// shadow rays there is none at once.
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

/// The sum of both products of two quaternions, in which what the order turns round cancels.
#[inline(always)]
fn both_products(a: DVec4, b: DVec4) -> DVec4 {
    let real = a.x * b.x - a.y * b.y - a.z * b.z - a.w * b.w;
    ((a * b.x + b * a.x) * 2.0).with_x(2.0 * real)
}

/// The square of a quaternion, given the squares of its real part and of the length of the imaginary one.
#[inline(always)]
fn squared(q: DVec4, real: f64, imaginary: f64) -> DVec4 {
    (q * (2.0 * q.x)).with_x(real - imaginary)
}

/// Its cube, likewise.
#[inline(always)]
fn cubed(q: DVec4, real: f64, imaginary: f64) -> DVec4 {
    (q * (3.0 * real - imaginary)).with_x(q.x * (real - 3.0 * imaginary))
}

/// The squares of the real part and of the length of the imaginary one.
#[inline(always)]
fn squares(q: DVec4) -> [f64; 2] {
    [q.x * q.x, q.y * q.y + q.z * q.z + q.w * q.w]
}

impl Orbit {
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

    /// By how much the square of an orbit's greatest distance exceeds that at which it has escaped: at most 1, as
    /// orbits that have escaped for good are soon no numbers.
    fn excess(&self, p: DVec3) -> f64 {
        let escape = self.escape();
        let mut q = self.start(p);
        let mut most = -escape;
        for turn in 0..self.iterations {
            let excess = q.length_squared() - escape;
            if excess >= 1.0 || excess.is_nan() {
                return 1.0;
            }
            most = most.max(excess);
            if turn + 1 < self.iterations {
                q = self.apply(q);
            }
        }
        most
    }

    /// The gradient of the excess: bands of short stretches have its slopes.
    fn slope(&self, p: DVec3) -> DVec3 {
        let at = [0, 1, 2].map(|axis| {
            let mut along = Lanes::ZERO;
            along.0[axis] = STEP;
            Band::line(Lanes::splat(p[axis]), along)
        });
        let [x, y, z, _] = self.along(&at).slope.0;
        DVec3::new(x, y, z)
    }

    /// The gradient of the orbit's squared distance after so many iterations.
    fn gradient(&self, p: DVec3, iterations: u32) -> DVec3 {
        let mut q = self.start(p);
        if self.is_quaternion() {
            // The orbits of neighbours along the three axes, linearised.
            let mut rows = [DVec4::X, DVec4::Y, DVec4::Z];
            for _ in 0..iterations {
                for d in &mut rows {
                    *d = match self.map {
                        Map::Square => both_products(*d, q),
                        _ => {
                            let square = product(q, q);
                            product(*d, square) + product(q, product(*d, q)) + product(square, *d)
                        }
                    };
                }
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
}

impl Field for Orbit {
    fn value(&self, sample: &Sample) -> f64 {
        self.excess(sample.point)
    }

    fn enclose(&self, point: &[Band; 3]) -> Band {
        widest(
            #[inline(always)]
            || self.along(point),
        )
    }

    fn is_known(&self) -> bool {
        true
    }
}

impl JuliaFractal {
    /// The fractal of these orbits, with the shortest step of the march towards it; positive.
    pub fn new(orbit: Orbit, step: f64) -> Self {
        let ball = Sphere { center: DVec3::ZERO, radius: orbit.radius() };
        let surface = Isosurface {
            function: Arc::new(orbit),
            threshold: 0.0,
            container: Container::Sphere(ball),
            accuracy: FINE,
            max_gradient: STEEP,
            adaptive: None,
            most: usize::MAX,
            open: false,
            steepest: Steepest::default(),
        };
        Self { orbit, surface, ball, step }
    }

    /// Whether nothing may be missed.
    fn is_exact(&self) -> bool {
        self.step <= EXACT && !matches!(self.orbit.map, Map::Hypercomplex(_))
    }

    /// What of a range is looked at along a ray: those that leave the surface start at 0.
    fn looked_at(&self, ray: &Ray, range: Range) -> Option<Range> {
        let stretch = self.ball.stretch(ray).filter(|s| s.enter.t.is_finite())?;
        let leaves = range.min == 0.0 && self.orbit.excess(ray.origin).abs() < ON_SURFACE;
        let min = if leaves { AT_ONCE / ray.direction.length() } else { range.min };
        let ball = Range { min: stretch.enter.t, max: stretch.leave.t };
        let min = self.orbit.skipped(ray, Range { min, ..range }, ball);
        (min < ball.max).then_some(Range { min, ..range })
    }
}

impl Shape for JuliaFractal {
    fn bounds(&self) -> Bounds {
        self.surface.bounds()
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        if !self.is_exact() {
            self.walk(ray, range.min, |t| {
                if range.contains(t) {
                    out.push(Crossing::new(t, 0));
                }
                t < range.max
            });
        } else if let Some(range) = self.looked_at(ray, range) {
            self.surface.crossings(ray, range, out);
        }
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        if self.is_exact() {
            return self.surface.nearest(ray, self.looked_at(ray, range)?);
        }
        let mut nearest = None;
        self.walk(ray, range.min, |t| {
            nearest = range.contains(t).then(|| Crossing::new(t, 0));
            nearest.is_none() && t < range.max
        });
        nearest
    }

    fn inside(&self, point: DVec3) -> bool {
        if self.is_exact() { self.orbit.excess(point) <= 0.0 } else { self.follow(point, DVec3::ZERO).inside }
    }

    fn inside_along(&self, point: &[Band; 3]) -> Band {
        match self.is_exact() {
            true => self.orbit.enclose(point).less_equal(Band::constant(0.0)),
            false => Band::between(0.0, 1.0),
        }
    }

    /// Of the next point of the orbit, as in POV-Ray, but for functions, of which it has wrong ones.
    fn normal(&self, point: DVec3, _crossing: &Crossing) -> DVec3 {
        self.orbit.gradient(point, self.orbit.iterations).normalize_or(DVec3::X)
    }

    fn geometric_normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        if !self.is_exact() {
            return self.normal(point, crossing);
        }
        let slope = if crossing.part == 0 { self.orbit.slope(point) } else { point };
        slope
            .try_normalize()
            .unwrap_or_else(|| self.orbit.gradient(point, self.orbit.iterations).normalize_or(DVec3::X))
    }

    fn interpolates(&self) -> bool {
        self.is_exact()
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{Probe, battery, table};
    use super::*;
    use crate::math::DVec2;

    fn make(constant: [f64; 4], map: Map, iterations: u32, precision: f64) -> JuliaFractal {
        let orbit = Orbit { constant: DVec4::from(constant), map, iterations, slice: DVec4::ZERO };
        JuliaFractal::new(orbit, 1.0 / precision)
    }

    fn quaternion() -> JuliaFractal {
        make([-0.083, 0.0, -0.83, -0.025], Map::Square, 4, 500.0)
    }

    battery! {
        square: || quaternion();
        cube: || make([-0.162, 0.163, 0.56, -0.599], Map::Cube, 3, 500.0);
        hypercomplex: || make([-0.162, 0.163, 0.56, -0.599], Map::HypercomplexSquare { cube: false }, 4, 500.0);
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
        let sliced = JuliaFractal::new(Orbit { slice, ..square.orbit }, square.step);
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
            let mut q = fractal.orbit.start(p);
            for _ in 0..fractal.orbit.iterations {
                q = fractal.orbit.apply(q);
            }
            q.length_squared()
        };
        let rise = |axis: DVec3| beyond(hit.point + 1e-6 * axis) - beyond(hit.point - 1e-6 * axis);
        let normal = DVec3::new(rise(DVec3::X), rise(DVec3::Y), rise(DVec3::Z)).normalize();
        assert!(hit.normal.abs_diff_eq(normal, 1e-6), "{} {normal}", hit.normal);
    }

    #[test]
    fn bands_hold_how_far_orbits_escape() {
        for map in [Map::Square, Map::Cube, Map::HypercomplexSquare { cube: false }] {
            let orbit = make([-0.162, 0.163, 0.56, -0.599], map, 5, 500.0).orbit;
            let slice = DVec4::new(0.2, -0.3, 0.1, 0.05);
            let mut narrow = 0;
            for orbit in [orbit, Orbit { slice, ..orbit }] {
                for n in 0..400 {
                    let middle = DVec3::new(0.37, 0.71, 0.53) * f64::from(n);
                    let middle = 3.0 * middle.fract_gl() - 1.5;
                    let along = DVec3::new(0.6, 0.5, -0.7) * 0.5_f64.powi(n % 25);
                    let at = [0, 1, 2].map(|i| Band::line(Lanes::splat(middle[i]), Lanes::splat(along[i])));
                    let band = orbit.enclose(&at);
                    for step in -8..=8 {
                        let s = f64::from(step) / 8.0;
                        let off = orbit.excess(middle + s * along) - band.middle.0[1] - band.slope.0[1] * s;
                        assert!(off.abs() <= band.reach.0[1] * (1.0 + 1e-9), "{map:?} {n}: {off:e} {band:?}");
                    }
                    narrow += u32::from(n % 25 > 20 && band.reach.0[1] < 1e-3);
                }
            }
            assert!(narrow > 100, "{map:?}: {narrow}");
        }
    }
}
