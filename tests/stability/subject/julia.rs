//! Julia sets of quaternions and hypercomplex numbers.
//!
//! Proven are those whose orbits never return once they have left the ball of escape, which squares and cubes
//! are: a point is inside if the last point of its orbit that is looked at is. The precision is high: of a lower one
//! is asked that thin parts are missed as POV-Ray misses them.

use povista::math::DVec3;

use crate::model::Model;
use crate::real::{Real, Ring};
use crate::shoot_at;

#[derive(Clone, Copy)]
enum Map {
    Square,
    Cube,
    Hypercomplex,
}

struct Julia {
    map: Map,
    constant: [f64; 4],
    iterations: usize,
    size: f64,
}

/// Written out so that squares are known not to be negative.
fn raised<T: Ring>(map: Map, [x, y, z, w]: [T; 4]) -> [T; 4] {
    let square = |x: &T| x.clone().square();
    let twice = |x: &T, y: &T| (x.clone() * y.clone()).times(2.0);
    match map {
        Map::Square => {
            let real = square(&x) - (square(&y) + square(&z) + square(&w));
            [real, twice(&x, &y), twice(&x, &z), twice(&x, &w)]
        }
        Map::Cube => {
            let imaginary = square(&y) + square(&z) + square(&w);
            let share = square(&x).times(3.0) - imaginary.clone();
            let real = x.clone() * (square(&x) - imaginary.times(3.0));
            [real, y * share.clone(), z * share.clone(), w * share]
        }
        Map::Hypercomplex => {
            let real = square(&x) + square(&w) - (square(&y) + square(&z));
            [
                real,
                twice(&x, &y) - twice(&w, &z),
                twice(&x, &z) - twice(&w, &y),
                twice(&x, &w) + twice(&y, &z),
            ]
        }
    }
}

impl Julia {
    fn radius(&self) -> f64 {
        let constant = self.constant.map(|c| c * c).iter().sum::<f64>().sqrt();
        if let Map::Hypercomplex = self.map { 4.0 } else { (1.0 + constant + 1e-7).min(2.0) }
    }

    /// From beyond this distance the first turn leads out of the ball, for good.
    fn leap(&self) -> f64 {
        let constant = self.constant.map(|c| c * c).iter().sum::<f64>().sqrt();
        let exponent = if let Map::Cube = self.map { 3.0 } else { 2.0 };
        (self.radius() + constant).powf(1.0 / exponent)
    }

    /// The square of the distance after so many turns.
    fn square<T: Ring>(&self, p: &[T; 3], turns: usize) -> T {
        let [x, y, z] = p.clone().map(|c| c.over(self.size));
        let mut q = [x, y, z, T::of(0.0)];
        for _ in 0..turns {
            let [x, y, z, w] = raised(self.map, q);
            let [a, b, c, d] = self.constant;
            q = [x.plus(a), y.plus(b), z.plus(c), w.plus(d)];
        }
        let [x, y, z, w] = q;
        x.square() + y.square() + z.square() + w.square()
    }

    fn excess<T: Ring>(&self, p: &[T; 3]) -> T {
        let radius = self.radius();
        let escape = if let Map::Hypercomplex = self.map { 16.0 } else { radius * radius + 1e-7 };
        self.square(p, self.iterations - 1).plus(-escape)
    }

    fn beyond_ball<T: Ring>(&self, p: &[T; 3]) -> T {
        self.square(p, 0) - T::of(self.radius()).square()
    }

    fn either<T: Ring>(&self, piece: usize, p: &[T; 3]) -> T {
        if piece == 0 { self.excess(p) } else { self.beyond_ball(p) }
    }
}

impl Model for Julia {
    fn pieces(&self) -> usize {
        2
    }
    fn equation<T: Real>(&self, piece: usize, p: &[T; 3]) -> T {
        self.either(piece, p)
    }
    fn polynomial<T: Ring>(&self, piece: usize, p: &[T; 3]) -> Option<T> {
        Some(self.either(piece, p))
    }
    fn ball(&self, piece: usize) -> Option<(DVec3, f64)> {
        let radius = if piece == 0 { self.leap() } else { self.radius() };
        Some((DVec3::ZERO, radius * self.size))
    }
    fn limit<T: Real>(&self, piece: usize, p: &[T; 3]) -> Option<T> {
        Some(if piece == 0 { self.beyond_ball(p) } else { self.excess(p) })
    }
    fn reach(&self) -> f64 {
        self.radius() * self.size
    }
}

fn julia(name: &str, map: Map, constant: [f64; 4], iterations: usize) {
    let word = match map {
        Map::Square => "quaternion sqr",
        Map::Cube => "quaternion cube",
        Map::Hypercomplex => "hypercomplex sqr",
    };
    shoot_at(name, |size| {
        let [x, y, z, w] = constant;
        let object = format!(
            "julia_fractal {{ <{x},{y},{z},{w}> {word} max_iteration {iterations} precision 500 scale {size:e} }}"
        );
        (object, Julia { map, constant, iterations, size })
    });
}

#[test]
fn square() {
    julia("julia.square", Map::Square, [-0.083, 0.0, -0.83, -0.025], 4);
}

#[test]
fn cube() {
    julia("julia.cube", Map::Cube, [-0.162, 0.163, 0.56, -0.599], 3);
}

#[test]
fn hypercomplex() {
    julia("julia.hypercomplex", Map::Hypercomplex, [-0.162, 0.163, 0.56, -0.599], 4);
}
