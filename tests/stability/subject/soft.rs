//! Blobs, sweeps, superellipsoids: surfaces of one rounded piece.

use crate::model::Model;
use crate::real::Real;
use crate::shoot_at;

fn from<T: Real>(p: &[T; 3], to: [f64; 3]) -> [T; 3] {
    std::array::from_fn(|i| p[i].clone().plus(-to[i]))
}

fn length_squared<T: Real>([x, y, z]: [T; 3]) -> T {
    x.square() + y.square() + z.square()
}

fn dot<T: Real>(a: &[T; 3], b: &[T; 3]) -> T {
    a[0].clone() * b[0].clone() + a[1].clone() * b[1].clone() + a[2].clone() * b[2].clone()
}

fn vector(p: [f64; 3]) -> String {
    format!("<{:e},{:e},{:e}>", p[0], p[1], p[2])
}

/// Fields around segments, which may be points.
struct Blob {
    /// Both ends, radius and strength.
    parts: Vec<([f64; 3], [f64; 3], f64, f64)>,
    threshold: f64,
    reach: f64,
}

impl Model for Blob {
    fn equation<T: Real>(&self, _piece: usize, p: &[T; 3]) -> T {
        let fields = self.parts.iter().map(|&(a, b, radius, strength)| {
            let off = from(p, a);
            let off = if a == b {
                off
            } else {
                let along: [T; 3] = std::array::from_fn(|i| T::of(b[i]) - T::of(a[i]));
                let share = dot(&off, &along) / dot(&along, &along);
                let share = -(-share.positive()).max(T::of(-1.0));
                std::array::from_fn(|i| off[i].clone() - share.clone() * along[i].clone())
            };
            let square = T::of(radius).square();
            let rest = ((square.clone() - length_squared(off)) / square).positive();
            rest.square().times(strength)
        });
        fields.fold(T::of(self.threshold), |rest, field| rest - field)
    }
    fn reach(&self) -> f64 {
        self.reach
    }
}

#[test]
fn blob() {
    shoot_at("blob.spheres", |size| {
        let parts = [([0.0; 3], 1.5, 1.2), ([1.0, 0.3, 0.0], 1.4, 0.9), ([0.4, 0.6, -0.5], 0.6, -0.7)];
        let size = 0.6 * size;
        let parts: Vec<_> = parts.iter().map(|&(at, r, s)| (at.map(|x| x * size), r * size, s)).collect();
        let list: Vec<_> =
            parts.iter().map(|(at, r, s)| format!("sphere {{ {}, {r:e}, {s} }}", vector(*at))).collect();
        let object = format!("blob {{ threshold 0.4 {} }}", list.join(" "));
        let parts = parts.into_iter().map(|(at, r, s)| (at, at, r, s)).collect();
        (object, Blob { parts, threshold: 0.4, reach: 2.5 * size })
    });
}

#[test]
fn blob_of_tubes() {
    shoot_at("blob.cylinders", |size| {
        let parts =
            [([-0.7, -0.4, 0.0], [0.6, 0.1, 0.3], 0.5, 1.0), ([0.0, -0.8, 0.2], [0.1, 0.7, -0.2], 0.4, 1.5)];
        let parts: Vec<_> = parts
            .iter()
            .map(|&(a, b, r, s)| (a.map(|x| x * size), b.map(|x| x * size), r * size, s))
            .collect();
        let list: Vec<_> = parts
            .iter()
            .map(|(a, b, r, s)| format!("cylinder {{ {}, {}, {r:e}, {s} }}", vector(*a), vector(*b)))
            .collect();
        let object = format!("blob {{ threshold 0.5 {} }}", list.join(" "));
        (object, Blob { parts, threshold: 0.5, reach: 1.2 * size })
    });
}

/// Balls that grow along straight segments.
struct SphereSweep {
    balls: Vec<([f64; 3], f64)>,
}

impl Model for SphereSweep {
    fn equation<T: Real>(&self, _piece: usize, p: &[T; 3]) -> T {
        // How deep a point is in the ball that it is deepest in, segment by segment.
        let depths = self.balls.windows(2).map(|pair| {
            let ((a, r), (b, s)) = (pair[0], pair[1]);
            let off = from(p, a);
            let along: [T; 3] = std::array::from_fn(|i| T::of(b[i]) - T::of(a[i]));
            let growth = T::of(s) - T::of(r);
            let share = (dot(&off, &along) + T::of(r) * growth.clone())
                / (dot(&along, &along) - growth.clone().square());
            let share = -(-share.positive()).max(T::of(-1.0));
            let rest = std::array::from_fn(|i| off[i].clone() - share.clone() * along[i].clone());
            (T::of(r) + share * growth).square() - length_squared(rest)
        });
        -depths.reduce(Real::max).expect("a sweep has segments")
    }
    fn reach(&self) -> f64 {
        self.balls.iter().flat_map(|(c, r)| c.map(|x| x.abs() + r)).fold(0.0, f64::max)
    }
}

#[test]
fn sphere_sweep() {
    shoot_at("sphere_sweep.linear", |size| {
        let balls = [([-0.6, -0.5, 0.0], 0.25), ([0.4, 0.0, 0.0], 0.4), ([0.2, 0.7, 0.3], 0.1)];
        let balls: Vec<_> = balls.iter().map(|&(c, r)| (c.map(|x| x * size), r * size)).collect();
        let list: Vec<_> = balls.iter().map(|(c, r)| format!("{}, {r:e}", vector(*c))).collect();
        (format!("sphere_sweep {{ linear_spline 3, {} }}", list.join(", ")), SphereSweep { balls })
    });
}

/// |x|^a + |y|^a to the b / a, + |z|^b = 1, scaled.
struct Superellipsoid {
    size: f64,
    around: f64,
    across: f64,
}

impl Model for Superellipsoid {
    fn equation<T: Real>(&self, _piece: usize, p: &[T; 3]) -> T {
        let [x, y, z] = p.clone().map(|x| (x / T::of(self.size)).abs());
        let ring = x.power(self.around) + y.power(self.around);
        ring.power(self.across / self.around) + z.power(self.across).plus(-1.0)
    }
    fn reach(&self) -> f64 {
        self.size
    }
}

fn superellipsoid_of(east: f64, north: f64) -> impl Fn(f64) -> (String, Superellipsoid) {
    move |size| {
        let object = format!("superellipsoid {{ <{east},{north}> scale {size:e} }}");
        (object, Superellipsoid { size, around: 2.0 / east, across: 2.0 / north })
    }
}

#[test]
fn superellipsoid() {
    shoot_at("superellipsoid.round", superellipsoid_of(0.5, 0.25));
}

#[test]
fn pointed_superellipsoid() {
    shoot_at("superellipsoid.pointed", superellipsoid_of(1.5, 1.25));
}

#[test]
fn star_shaped_superellipsoid() {
    shoot_at("superellipsoid.star", superellipsoid_of(3.0, 2.5));
}

#[test]
fn waisted_superellipsoid() {
    shoot_at("superellipsoid.waisted", superellipsoid_of(3.0, 0.5));
}

#[test]
fn spindle_shaped_superellipsoid() {
    shoot_at("superellipsoid.spindle", superellipsoid_of(0.5, 3.0));
}
