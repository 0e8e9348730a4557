//! Exact roots of a polynomial surface along a ray, by rational Sturm sequences.

use dashu::integer::IBig;
use dashu::rational::RBig;

use super::Dice;
use crate::math::DVec3;
use crate::world::shape::Shape;
use crate::world::{Range, Ray};

/// One term of a surface's polynomial: coefficient and exponents of x, y, z.
pub(crate) type Term = (f64, [usize; 3]);

type Poly = Vec<RBig>;

fn exact(x: f64) -> RBig {
    RBig::try_from(x).expect("a finite number")
}

fn trim(mut p: Poly) -> Poly {
    while p.last().is_some_and(|c| *c == RBig::ZERO) {
        p.pop();
    }
    p
}

fn product(a: &Poly, b: &Poly) -> Poly {
    let mut out = vec![RBig::ZERO; (a.len() + b.len()).saturating_sub(1)];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            out[i + j] += x * y;
        }
    }
    out
}

fn along(terms: &[Term], ray: &Ray) -> Poly {
    let mut sum: Poly = Vec::new();
    for (coefficient, exponents) in terms {
        let mut term = vec![exact(*coefficient)];
        for (axis, exponent) in exponents.iter().enumerate() {
            for _ in 0..*exponent {
                term = product(&term, &vec![exact(ray.origin[axis]), exact(ray.direction[axis])]);
            }
        }
        sum.resize(sum.len().max(term.len()), RBig::ZERO);
        for (to, c) in sum.iter_mut().zip(term) {
            *to += c;
        }
    }
    trim(sum)
}

fn value(p: &Poly, x: &RBig) -> RBig {
    p.iter().rev().fold(RBig::ZERO, |sum, c| sum * x + c)
}

fn sturm(p: &Poly) -> Vec<Poly> {
    let slope = p.iter().enumerate().skip(1).map(|(i, c)| c * RBig::from(IBig::from(i))).collect();
    let mut chain = vec![p.clone(), trim(slope)];
    while let [.., a, b] = chain.as_slice()
        && !b.is_empty()
    {
        let mut rest = a.clone();
        while rest.len() >= b.len() {
            let factor = &rest[rest.len() - 1] / &b[b.len() - 1];
            let shift = rest.len() - b.len();
            for (i, c) in b.iter().enumerate() {
                rest[i + shift] -= &factor * c;
            }
            rest.pop();
            rest = trim(rest);
        }
        if rest.is_empty() {
            break;
        }
        chain.push(rest.into_iter().map(|c| -c).collect());
    }
    chain
}

fn changes(chain: &[Poly], x: &RBig) -> usize {
    let signs: Vec<bool> =
        chain.iter().map(|p| value(p, x)).filter(|v| *v != RBig::ZERO).map(|v| v > RBig::ZERO).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

/// The distinct roots in (low, high], to 2^-70 of the interval.
fn roots(p: &Poly, low: f64, high: f64) -> Vec<f64> {
    let chain = sturm(p);
    let mut found = Vec::new();
    let mut work = vec![(exact(low), exact(high), 0)];
    while let Some((low, high, depth)) = work.pop() {
        if changes(&chain, &low) == changes(&chain, &high) {
            continue;
        }
        if depth == 70 {
            found.push(high.to_f64().value());
            continue;
        }
        let middle = (&low + &high) / RBig::from(2);
        work.push((middle.clone(), high, depth + 1));
        work.push((low, middle, depth + 1));
    }
    found
}

/// Compares crossings of rays at a shape of about unit size with the exact ones of its polynomial:
/// their number, but for near-double roots, and every distance to `ulps` of the ray's length.
#[track_caller]
pub(crate) fn oracle(shape: &dyn Shape, terms: &[Term], ulps: f64) {
    let mut worst = 0.0_f64;
    for number in 0..200 {
        let mut dice = Dice::new(number);
        let distance = [2.0, 20.0, 2000.0][number as usize % 3];
        let origin = dice.cube().normalize() * distance;
        let direction = (dice.cube() - origin).normalize();
        let ray = Ray::new(origin, direction);
        let expected = roots(&along(terms, &ray), 0.0, distance + 8.0);
        if expected.windows(2).any(|pair| pair[1] - pair[0] < 1e-3) {
            continue;
        }
        let mut all = Vec::new();
        shape.crossings(&ray, Range { min: 0.0, max: distance + 8.0 }, &mut all);
        let found: Vec<f64> = all.iter().map(|c| c.t).collect();
        assert_eq!(found.len(), expected.len(), "ray {number}: {found:?}, exactly {expected:?}");
        for (found, expected) in found.iter().zip(&expected) {
            let slant = slant(shape, &ray, *found);
            let error = (found - expected).abs() * slant / (f64::EPSILON * (distance + 1.0));
            worst = worst.max(error);
        }
    }
    println!("worst distance: {worst:.2} ulps of the ray's length, across the surface");
    assert!(worst <= ulps, "{worst} ulps");
}

/// Cosine between ray and normal: what a distance loses where the ray grazes.
fn slant(shape: &dyn Shape, ray: &Ray, t: f64) -> f64 {
    let crossing = shape.nearest(ray, Range { min: t - 1e-9, max: t + 1e-9 });
    let normal = |c| shape.normal(ray.at(t), &c).normalize_or(DVec3::X);
    crossing.map_or(1.0, |c| normal(c).dot(ray.direction).abs())
}
