//! Surfaces that are given by the coefficients of a polynomial.

use crate::model::Model;
use crate::real::Real;
use crate::shoot_at;

/// A sum of terms: coefficient and exponents of x, y, z.
struct Polynomial {
    terms: Vec<(f64, [usize; 3])>,
    reach: f64,
}

fn raised<T: Real>(x: &T, exponent: usize) -> T {
    match exponent {
        0 => T::of(1.0),
        1 => x.clone(),
        even if even % 2 == 0 => raised(x, even / 2).square(),
        odd => raised(x, odd - 1) * x.clone(),
    }
}

impl Model for Polynomial {
    fn equation<T: Real>(&self, _piece: usize, p: &[T; 3]) -> T {
        let term = |(c, exponents): &(f64, [usize; 3])| {
            let factors = exponents.iter().zip(p).filter(|(e, _)| **e > 0);
            factors.fold(T::of(*c), |product, (e, x)| product * raised(x, *e))
        };
        let mut all = self.terms.iter().map(term);
        let first = all.next().unwrap_or_else(|| T::of(0.0));
        all.fold(first, |sum, term| sum + term)
    }
    fn reach(&self) -> f64 {
        self.reach
    }
}

/// The terms of a shape of size 1, for one of another size, and how much is looked at of it.
fn subject<const N: usize>(
    degree: usize,
    terms: [(f64, [usize; 3]); N],
    reach: f64,
) -> impl Fn(f64) -> (String, Polynomial) {
    move |size| {
        let terms: Vec<_> = terms
            .iter()
            .map(|(c, e)| (c * size.powi(degree as i32 - e.iter().sum::<usize>() as i32), *e))
            .collect();
        let list: Vec<_> = terms.iter().map(|(c, [x, y, z])| format!("xyz({x},{y},{z}): {c:e}")).collect();
        let object = format!("polynomial {{ {degree}, {} }}", list.join(", "));
        (object, Polynomial { terms, reach: reach * size })
    }
}

fn quadric_of(
    squares: [f64; 3],
    products: [f64; 3],
    linear: [f64; 3],
    constant: f64,
    reach: f64,
) -> impl Fn(f64) -> (String, Polynomial) {
    move |size| {
        let linear = linear.map(|c| c * size);
        let constant = constant * size * size;
        let vector = |v: [f64; 3]| format!("<{:e},{:e},{:e}>", v[0], v[1], v[2]);
        let object = format!(
            "quadric {{ {}, {}, {}, {constant:e} }}",
            vector(squares),
            vector(products),
            vector(linear)
        );
        let terms = vec![
            (squares[0], [2, 0, 0]),
            (squares[1], [0, 2, 0]),
            (squares[2], [0, 0, 2]),
            (products[0], [1, 1, 0]),
            (products[1], [1, 0, 1]),
            (products[2], [0, 1, 1]),
            (linear[0], [1, 0, 0]),
            (linear[1], [0, 1, 0]),
            (linear[2], [0, 0, 1]),
            (constant, [0, 0, 0]),
        ];
        let terms = terms.into_iter().filter(|(c, _)| *c != 0.0).collect();
        (object, Polynomial { terms, reach: reach * size })
    }
}

#[test]
fn ellipsoid() {
    shoot_at("quadric.ellipsoid", quadric_of([1.5, 2.0, 3.0], [0.25, 0.5, 0.0], [0.0; 3], -1.0, 1.0));
}

#[test]
fn hyperboloid() {
    shoot_at("quadric.hyperboloid", quadric_of([1.5, -2.0, 3.0], [0.0; 3], [0.25, 0.0, 0.0], -0.5, 4.0));
}

#[test]
fn paraboloid() {
    shoot_at("quadric.paraboloid", quadric_of([1.0, 0.0, 2.0], [0.0; 3], [0.0, -1.0, 0.0], 0.0, 4.0));
}

#[test]
fn double_cone() {
    shoot_at("quadric.cone", quadric_of([1.0, -1.0, 1.0], [0.0; 3], [0.0; 3], 0.0, 4.0));
}

#[test]
fn cubic() {
    let terms = [(1.0, [3, 0, 0]), (-1.0, [0, 1, 0]), (1.0, [1, 0, 2]), (-0.25, [0, 0, 0])];
    shoot_at("cubic", subject(3, terms, 3.0));
}

#[test]
fn quartic() {
    // A torus of radii 3/4 and 1/4.
    let terms = [
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
    ];
    shoot_at("quartic.torus", subject(4, terms, 1.0));
}

#[test]
fn piriform() {
    let terms = [(4.0, [4, 0, 0]), (-4.0, [3, 0, 0]), (1.0, [0, 2, 0]), (1.0, [0, 0, 2])];
    shoot_at("quartic.piriform", subject(4, terms, 1.0));
}

#[test]
fn sextic() {
    let terms = [(1.0, [6, 0, 0]), (1.0, [0, 6, 0]), (1.0, [0, 0, 6]), (0.5, [2, 2, 2]), (-0.5, [0, 0, 0])];
    shoot_at("poly.6", subject(6, terms, 1.0));
}

#[test]
fn fifteenth() {
    let terms =
        [(1.0, [14, 0, 0]), (1.0, [0, 14, 0]), (2.0, [0, 0, 14]), (0.5, [1, 0, 14]), (-0.25, [0, 0, 0])];
    shoot_at("poly.15", subject(15, terms, 1.0));
}
