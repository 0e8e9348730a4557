//! Surfaces of revolution.

use crate::model::Model;
use crate::real::Real;
use crate::shoot_at;

fn around<T: Real>([x, _, z]: &[T; 3]) -> T {
    x.clone().square() + z.clone().square()
}

/// Two balls and the band between them.
struct Ovus {
    bottom: f64,
    top: f64,
}

impl Ovus {
    /// Height of the middle of the band's circle, where the band begins and ends.
    fn heights<T: Real>(&self) -> [T; 3] {
        let (b, t) = (T::of(self.bottom), T::of(self.top));
        let middle = t.clone().times(2.0) - b.clone() - t.clone().square() / b.clone().times(2.0);
        let end = (b.clone() - middle.clone()) * t.clone() / (b.clone().times(2.0) - t) + b;
        [middle.clone(), -middle, end]
    }
}

impl Model for Ovus {
    fn pieces(&self) -> usize {
        3
    }
    fn equation<T: Real>(&self, piece: usize, p: &[T; 3]) -> T {
        let y = p[1].clone();
        match piece {
            0 => around(p) + y.square() - T::of(self.bottom).square(),
            1 => around(p) + y.plus(-self.bottom).square() - T::of(self.top).square(),
            _ => {
                let [middle, ..] = self.heights::<T>();
                let major = (T::of(self.bottom).square() - middle.clone().square()).sqrt();
                let square = T::of(2.0 * self.bottom).square() - (y - middle).square();
                around(p) - (square.sqrt() - major).square()
            }
        }
    }
    fn limit<T: Real>(&self, piece: usize, p: &[T; 3]) -> Option<T> {
        let [_, low, high] = self.heights::<T>();
        let y = p[1].clone();
        Some(match piece {
            0 => y - low,
            1 => high - y,
            _ => (low - y.clone()).max(y - high),
        })
    }
    fn reach(&self) -> f64 {
        self.bottom + self.top
    }
}

#[test]
fn ovus() {
    shoot_at("ovus", |size| {
        let (bottom, top) = (0.6 * size, 0.4 * size);
        (format!("ovus {{ {bottom:e}, {top:e} }}"), Ovus { bottom, top })
    });
}

/// Radii and heights; the first and the last only give slopes.
struct Sor {
    points: Vec<[f64; 2]>,
}

impl Sor {
    /// The point at the border of the lower or upper end, for the last two pieces.
    fn end(&self, piece: usize) -> Option<usize> {
        let ends = [1, self.points.len() - 2];
        ends.get(piece.checked_sub(self.points.len() - 3)?).copied()
    }
}

impl Model for Sor {
    fn pieces(&self) -> usize {
        self.points.len() - 1
    }
    fn equation<T: Real>(&self, piece: usize, p: &[T; 3]) -> T {
        if let Some(end) = self.end(piece) {
            return p[1].clone().plus(-self.points[end][1]);
        }
        // The square of the radius and its slope are given at both heights.
        let point = |i: usize| self.points[piece + i].map(T::of);
        let slope = |a: usize, at: usize, b: usize| {
            let ([ra, ya], [r, _], [rb, yb]) = (point(a), point(at), point(b));
            r.times(2.0) * (rb - ra) / (yb - ya)
        };
        let ([from, low], [to, high]) = (point(1), point(2));
        let height = high - low.clone();
        let mean = (to.square() - from.clone().square()) / height.clone();
        let (start, end) = (slope(0, 1, 2), slope(1, 2, 3));
        let second = (mean.clone().times(3.0) - start.clone().times(2.0) - end.clone()) / height.clone();
        let third = (start.clone() + end - mean.times(2.0)) / height.square();
        let h = p[1].clone() - low;
        around(p) - (from.square() + h.clone() * (start + h.clone() * (second + h * third)))
    }
    fn limit<T: Real>(&self, piece: usize, p: &[T; 3]) -> Option<T> {
        Some(if let Some(end) = self.end(piece) {
            around(p) - T::of(self.points[end][0]).square()
        } else {
            let (low, high) = (self.points[piece + 1][1], self.points[piece + 2][1]);
            (T::of(low) - p[1].clone()).max(p[1].clone().plus(-high))
        })
    }
    fn reach(&self) -> f64 {
        self.points[1..self.points.len() - 1].iter().flatten().fold(0.0, |most, x| x.abs().max(most))
    }
}

fn list(points: &[[f64; 2]]) -> String {
    points.iter().map(|[x, y]| format!("<{x:e},{y:e}>")).collect::<Vec<_>>().join(", ")
}

fn scaled(points: &[[f64; 2]], size: f64) -> Vec<[f64; 2]> {
    points.iter().map(|p| p.map(|x| x * size)).collect()
}

#[test]
fn sor() {
    shoot_at("sor", |size| {
        let points = [[0.2, -1.5], [0.5, -0.8], [0.9, -0.4], [0.4, 0.2], [0.6, 0.9], [0.3, 2.0]];
        let points = scaled(&points, size);
        (format!("sor {{ 6, {} }}", list(&points)), Sor { points })
    });
}

/// Straight stretches of a profile of radius and height.
struct Lathe {
    points: Vec<[f64; 2]>,
}

impl Model for Lathe {
    fn pieces(&self) -> usize {
        self.points.len() - 1
    }
    fn equation<T: Real>(&self, piece: usize, p: &[T; 3]) -> T {
        let ([r, y], [s, z]) = (self.points[piece], self.points[piece + 1]);
        let (rise, out) = (T::of(z) - T::of(y), T::of(s) - T::of(r));
        if y == z {
            return p[1].clone().plus(-y);
        }
        let radius = T::of(r) * rise.clone() + p[1].clone().plus(-y) * out;
        around(p) * rise.square() - radius.square()
    }
    fn limit<T: Real>(&self, piece: usize, p: &[T; 3]) -> Option<T> {
        let ([r, y], [s, z]) = (self.points[piece], self.points[piece + 1]);
        Some(if y == z {
            (around(p) - T::of(r.max(s)).square()).max(T::of(r.min(s)).square() - around(p))
        } else {
            p[1].clone().plus(-y.max(z)).max(-p[1].clone().plus(-y.min(z)))
        })
    }
    fn reach(&self) -> f64 {
        self.points.iter().flatten().fold(0.0, |most, x| x.abs().max(most))
    }
}

#[test]
fn lathe() {
    shoot_at("lathe.linear", |size| {
        let points = [[0.0, -0.7], [0.8, -0.3], [0.5, 0.1], [0.7, 0.5], [0.3, 0.5], [0.0, 0.8]];
        let points = scaled(&points, size);
        (format!("lathe {{ linear_spline {}, {} }}", points.len(), list(&points)), Lathe { points })
    });
}

/// A convex outline going round counterclockwise in x and z, swept along y, or scaled by it.
struct Prism {
    points: Vec<[f64; 2]>,
    heights: [f64; 2],
    conic: bool,
}

impl Prism {
    /// Positive outside of an edge.
    fn beyond<T: Real>(&self, edge: usize, p: &[T; 3]) -> T {
        let [a, b] = [edge, edge + 1].map(|i| self.points[i % self.points.len()]);
        let along = [0, 1].map(|i| T::of(b[i]) - T::of(a[i]));
        let scale = if self.conic { p[1].clone() } else { T::of(1.0) };
        let x = p[0].clone() - T::of(a[0]) * scale.clone();
        let z = p[2].clone() - T::of(a[1]) * scale;
        let [u, v] = along;
        v * x - u * z
    }
}

impl Model for Prism {
    fn pieces(&self) -> usize {
        self.points.len() + 2
    }
    fn equation<T: Real>(&self, piece: usize, p: &[T; 3]) -> T {
        match piece.checked_sub(self.points.len()) {
            Some(end) => p[1].clone().plus(-self.heights[end]),
            None => self.beyond(piece, p),
        }
    }
    fn limit<T: Real>(&self, piece: usize, p: &[T; 3]) -> Option<T> {
        let [low, high] = self.heights;
        let count = self.points.len();
        let edges = (0..count).filter(|edge| *edge != piece).map(|edge| self.beyond(edge, p));
        let within = (piece < count).then(|| p[1].clone().plus(-high).max(T::of(low) - p[1].clone()));
        edges.chain(within).reduce(Real::max)
    }
    fn reach(&self) -> f64 {
        let scale = if self.conic { self.heights[0].abs().max(self.heights[1].abs()) } else { 1.0 };
        let outline = self.points.iter().flatten().fold(0.0, |most: f64, x| x.abs().max(most)) * scale;
        self.heights.into_iter().fold(outline, |most, y| y.abs().max(most))
    }
}

const OUTLINE: [[f64; 2]; 5] = [[0.8, 0.1], [0.3, 0.7], [-0.6, 0.5], [-0.7, -0.4], [0.2, -0.8]];

#[test]
fn prism() {
    shoot_at("prism.linear", |size| {
        let (points, high) = (scaled(&OUTLINE, size), 0.5 * size);
        let object =
            format!("prism {{ {:e}, {high:e}, 6, {}, {} }}", -high, list(&points), list(&points[..1]));
        (object, Prism { points, heights: [-high, high], conic: false })
    });
}

#[test]
fn conic_prism() {
    shoot_at("prism.conic", |size| {
        let (low, high) = (0.25 * size, size);
        let object = format!(
            "prism {{ conic_sweep {low:e}, {high:e}, 6, {}, {} }}",
            list(&OUTLINE),
            list(&OUTLINE[..1])
        );
        (object, Prism { points: OUTLINE.to_vec(), heights: [low, high], conic: true })
    });
}
