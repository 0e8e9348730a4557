//! Planes and pieces of planes.

use povista::math::DVec3;

use crate::model::Model;
use crate::real::Real;
use crate::shoot_at;

/// a·p = b.
struct Plane {
    normal: [f64; 3],
    distance: f64,
    size: f64,
}

fn dot<T: Real>(normal: [f64; 3], [x, y, z]: &[T; 3]) -> T {
    x.clone().times(normal[0]) + y.clone().times(normal[1]) + z.clone().times(normal[2])
}

impl Model for Plane {
    fn equation<T: Real>(&self, _piece: usize, p: &[T; 3]) -> T {
        let length = self.normal.map(T::of).map(T::square);
        let [x, y, z] = length;
        dot(self.normal, p) - (x + y + z).sqrt().times(self.distance)
    }
    fn reach(&self) -> f64 {
        4.0 * self.size
    }
}

#[test]
fn plane() {
    shoot_at("plane", |size| {
        let distance = 0.25 * size;
        let normal = [0.5, 1.0, -0.25];
        (format!("plane {{ <0.5,1,-0.25>, {distance:e} }}"), Plane { normal, distance, size })
    });
}

/// A ring about the y axis, in the plane of x and z.
struct Disc {
    outer: f64,
    inner: f64,
}

impl Model for Disc {
    fn equation<T: Real>(&self, _piece: usize, p: &[T; 3]) -> T {
        p[1].clone()
    }
    fn limit<T: Real>(&self, _piece: usize, [x, _, z]: &[T; 3]) -> Option<T> {
        let square = x.clone().square() + z.clone().square();
        let beyond = square.clone() - T::of(self.outer).square();
        Some(beyond.max(T::of(self.inner).square() - square))
    }
    fn reach(&self) -> f64 {
        self.outer
    }
}

#[test]
fn disc() {
    shoot_at("disc", |size| {
        let (outer, inner) = (0.9 * size, 0.3 * size);
        (format!("disc {{ 0, y, {outer:e}, {inner:e} }}"), Disc { outer, inner })
    });
}

/// Triangles: each piece one.
pub(super) struct Triangles {
    pub(super) corners: Vec<[[f64; 3]; 3]>,
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[i] - b[i])
}

impl Model for Triangles {
    fn pieces(&self) -> usize {
        self.corners.len()
    }
    fn equation<T: Real>(&self, piece: usize, p: &[T; 3]) -> T {
        // Linear in p, so that wide intervals are no wider than they must be.
        let [a, b, c] = self.corners[piece].map(|corner| corner.map(T::of));
        let from = |to: &[T; 3]| -> [T; 3] { std::array::from_fn(|i| to[i].clone() - a[i].clone()) };
        let (e, f, off) = (from(&b), from(&c), from(p));
        let normal = |i: usize, j: usize| e[i].clone() * f[j].clone() - e[j].clone() * f[i].clone();
        let [x, y, z] = off;
        normal(1, 2) * x + normal(2, 0) * y + normal(0, 1) * z
    }
    fn limit<T: Real>(&self, piece: usize, p: &[T; 3]) -> Option<T> {
        // Seen along an axis that the triangle isn't edge-on to: right of each edge, going around.
        let [a, b, c] = self.corners[piece];
        let (e, f) = (minus(b, a), minus(c, a));
        let normal = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
        let axis = (0..3).max_by(|&i, &j| normal[i].abs().total_cmp(&normal[j].abs())).unwrap_or(0);
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let turn = normal[axis].signum();
        let beyond = |from: [f64; 3], to: [f64; 3]| {
            let along = [u, v].map(|i| T::of(to[i]) - T::of(from[i]));
            let off = [u, v].map(|i| p[i].clone() - T::of(from[i]));
            let [along_u, along_v] = along;
            let [off_u, off_v] = off;
            (along_v * off_u - along_u * off_v).times(turn)
        };
        Some(beyond(a, b).max(beyond(b, c)).max(beyond(c, a)))
    }
    fn reach(&self) -> f64 {
        self.corners.iter().flatten().flatten().fold(0.0, |most, x| x.abs().max(most))
    }
    fn ball(&self, piece: usize) -> Option<(DVec3, f64)> {
        let corners = self.corners[piece].map(DVec3::from_array);
        let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        Some((middle, corners.map(|corner| corner.distance(middle)).into_iter().fold(0.0, f64::max)))
    }
}

pub(super) fn vector(p: [f64; 3]) -> String {
    format!("<{:e},{:e},{:e}>", p[0], p[1], p[2])
}

pub(super) fn scaled<const N: usize>(points: [[f64; 3]; N], size: f64) -> [[f64; 3]; N] {
    points.map(|p| p.map(|x| x * size))
}

const CORNERS: [[f64; 3]; 3] = [[-0.9, -0.6, 0.1], [0.8, -0.4, -0.5], [0.1, 0.9, 0.4]];

#[test]
fn triangle() {
    shoot_at("triangle", |size| {
        let corners = scaled(CORNERS, size);
        let [a, b, c] = corners.map(vector);
        (format!("triangle {{ {a}, {b}, {c} }}"), Triangles { corners: vec![corners] })
    });
}

#[test]
fn smooth_triangle() {
    shoot_at("smooth_triangle", |size| {
        let corners = scaled(CORNERS, size);
        let [a, b, c] = corners.map(vector);
        let object = format!("smooth_triangle {{ {a}, <0.2,0.1,1>, {b}, <0.1,-0.2,1>, {c}, <0.3,0,1> }}");
        (object, Triangles { corners: vec![corners] })
    });
}

/// A sphere cut into triangles: no ray through it may slip between two of them.
fn ball(size: f64) -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    const AROUND: usize = 8;
    const UP: usize = 4;
    let mut points = vec![[0.0, -size, 0.0], [0.0, size, 0.0]];
    for row in 1..UP {
        for place in 0..AROUND {
            let (up, turn) = (row as f64 / UP as f64 - 0.5, place as f64 / AROUND as f64);
            let (y, radius) = (up * std::f64::consts::PI).sin_cos();
            let (z, x) = (turn * std::f64::consts::TAU).sin_cos();
            points.push([size * radius * x, size * y, size * radius * z]);
        }
    }
    let at = |row: usize, place: usize| 2 + (row - 1) * AROUND + place % AROUND;
    let mut faces = Vec::new();
    for place in 0..AROUND {
        faces.push([0, at(1, place), at(1, place + 1)]);
        faces.push([1, at(UP - 1, place + 1), at(UP - 1, place)]);
        for row in 1..UP - 1 {
            faces.push([at(row, place), at(row + 1, place), at(row + 1, place + 1)]);
            faces.push([at(row, place), at(row + 1, place + 1), at(row, place + 1)]);
        }
    }
    (points, faces)
}

#[test]
fn mesh() {
    shoot_at("mesh", |size| {
        let (points, faces) = ball(size);
        let corners: Vec<_> = faces.iter().map(|face| face.map(|i| points[i])).collect();
        let all: Vec<_> =
            corners.iter().map(|face| format!("triangle {{ {} }}", face.map(vector).join(", "))).collect();
        (format!("mesh {{ {} }}", all.join(" ")), Triangles { corners })
    });
}

#[test]
fn mesh2() {
    shoot_at("mesh2", |size| {
        let (points, faces) = ball(size);
        let list: Vec<_> = points.iter().map(|p| vector(*p)).collect();
        let indices: Vec<_> = faces.iter().map(|[a, b, c]| format!("<{a},{b},{c}>")).collect();
        let object = format!(
            "mesh2 {{ vertex_vectors {{ {}, {} }} face_indices {{ {}, {} }} }}",
            list.len(),
            list.join(", "),
            indices.len(),
            indices.join(", ")
        );
        (object, Triangles { corners: faces.iter().map(|face| face.map(|i| points[i])).collect() })
    });
}

/// A flat outline in the plane of x and y: a square with a square hole.
struct Frame {
    size: f64,
}

impl Model for Frame {
    fn equation<T: Real>(&self, _piece: usize, p: &[T; 3]) -> T {
        p[2].clone()
    }
    fn limit<T: Real>(&self, _piece: usize, [x, y, _]: &[T; 3]) -> Option<T> {
        let within = x.clone().abs().max(y.clone().abs());
        Some(within.clone().plus(-self.size).max(-within.plus(-0.5 * self.size)))
    }
    fn reach(&self) -> f64 {
        self.size
    }
}

#[test]
fn polygon() {
    shoot_at("polygon", |size| {
        let square = |s: f64| {
            let corner = |x: f64, y: f64| format!("<{x:e},{y:e}>");
            [corner(-s, -s), corner(s, -s), corner(s, s), corner(-s, s), corner(-s, -s)].join(", ")
        };
        (format!("polygon {{ 10, {}, {} }}", square(size), square(0.5 * size)), Frame { size })
    });
}
