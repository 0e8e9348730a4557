//! `quadric { <A,B,C>, <D,E,F>, <G,H,I>, J }` (docs/spec/primitives.md 3.8).

use super::{Crossing, Shape};
use crate::math::{Bounds, DMat3, DVec3, roots};
use crate::world::{Range, Ray};

/// p·Mp + l·p + c = 0 with a symmetric M; inside where it is not above 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Quadric {
    matrix: DMat3,
    linear: DVec3,
    constant: f64,
    /// Where the gradient vanishes, if there is just one such point; else the origin.
    center: DVec3,
    bounds: Bounds,
    /// POV-Ray bounds only what has no products.
    extent: Bounds,
}

impl Quadric {
    /// From the coefficients of x², y², z²; xy, xz, yz; x, y, z; 1.
    pub fn new(squares: DVec3, products: DVec3, linear: DVec3, constant: f64) -> Self {
        let p = products * 0.5;
        let matrix = DMat3::from_cols(
            DVec3::new(squares.x, p.x, p.y),
            DVec3::new(p.x, squares.y, p.z),
            DVec3::new(p.y, p.z, squares.z),
        );
        let inverse = matrix.inverse();
        let center = -0.5 * (inverse * linear);
        let center = if center.is_finite() { center } else { DVec3::ZERO };
        let quadric = Self { matrix, linear, constant, center, bounds: Bounds::ALL, extent: Bounds::ALL };
        let bounds = quadric.ellipsoid_bounds(inverse);
        let extent = if products == DVec3::ZERO { bounds } else { Bounds::ALL };
        Self { bounds, extent, ..quadric }
    }

    /// The box of an ellipsoid, all of space for anything else.
    fn ellipsoid_bounds(&self, inverse: DMat3) -> Bounds {
        let m = self.matrix;
        let minor = roots::difference_of_products(m.x_axis.x, m.y_axis.y, m.x_axis.y, m.x_axis.y);
        let size = -self.value(self.center).0;
        let half = (DVec3::new(inverse.x_axis.x, inverse.y_axis.y, inverse.z_axis.z) * size).map(f64::sqrt);
        let definite = m.x_axis.x > 0.0 && minor > 0.0 && m.determinant() > 0.0;
        if !(definite && half.is_finite()) {
            return Bounds::ALL;
        }
        // The inverse is rounded: leave room for that.
        let half = half * (1.0 + 1e-12);
        Bounds { min: self.center - half, max: self.center + half }
    }

    /// The function at `p` and the size of the terms whose rounding it carries.
    fn value(&self, p: DVec3) -> (f64, f64) {
        let value = p.dot(self.matrix * p + self.linear) + self.constant;
        let m = self.matrix.abs();
        let a = p.abs();
        (value, a.dot(m * a + self.linear.abs()) + self.constant.abs())
    }

    fn gradient(&self, p: DVec3) -> DVec3 {
        2.0 * (self.matrix * p) + self.linear
    }

    fn hits(&self, ray: &Ray) -> [f64; 2] {
        let (shift, ray) = ray.moved_to(self.center);
        let (o, d) = (ray.origin, ray.direction);
        let a = d.dot(self.matrix * d);
        let b = 0.5 * self.gradient(o).dot(d);
        let Some(found) = roots::quadratic(a, b, self.value(o).0) else {
            return [f64::NAN; 2];
        };
        found.map(|t| shift + self.polish(&ray, t))
    }

    /// One Newton step where it is smaller than what it corrects.
    fn polish(&self, ray: &Ray, t: f64) -> f64 {
        let p = ray.at(t);
        let step = self.value(p).0 / self.gradient(p).dot(ray.direction);
        if step.abs() < 1e-6 * t.abs() { t - step } else { t }
    }
}

impl Shape for Quadric {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn extent(&self) -> Bounds {
        self.extent
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        let [one, other] = self.hits(ray);
        if range.contains(one) {
            out.push(Crossing::new(one, 0));
        }
        if range.contains(other) && other != one {
            out.push(Crossing::new(other, 0));
        }
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let hit = self.hits(ray).into_iter().find(|t| range.contains(*t))?;
        Some(Crossing::new(hit, 0))
    }

    fn inside(&self, point: DVec3) -> bool {
        self.value(point).0 <= 0.0
    }

    fn normal(&self, point: DVec3, _crossing: &Crossing) -> DVec3 {
        let gradient = self.gradient(point);
        if gradient == DVec3::ZERO { DVec3::X } else { gradient }
    }

    fn reproject(&self, point: DVec3, _crossing: &Crossing) -> DVec3 {
        let gradient = self.gradient(point);
        let step = gradient * (self.value(point).0 / gradient.length_squared());
        if step.is_finite() { point - step } else { point }
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{battery, oracle, table};
    use super::*;

    /// An ellipsoid of about `size` at `at`, or the paraboloid or hyperboloid with other signs.
    fn central(squares: DVec3, size: f64, at: DVec3) -> Quadric {
        let matrix = squares / (size * size);
        let linear = -2.0 * matrix * at;
        Quadric::new(matrix, DVec3::ZERO, linear, (matrix * at).dot(at) - 1.0)
    }

    battery! {
        ellipsoid: |size| central(DVec3::new(1.0, 2.0, 3.0), size, DVec3::ZERO);
        one_sheet: |size| central(DVec3::new(1.0, -1.0, 2.0), size, DVec3::ZERO);
        two_sheets: |size| central(DVec3::new(-1.0, 1.0, -2.0), size, DVec3::ZERO);
        tilted: |size| {
            let s = (size * size).recip();
            Quadric::new(DVec3::new(1.0, 2.0, 3.0) * s, DVec3::new(0.1, 0.2, 0.3) * s, DVec3::ZERO, -1.0)
        };
        paraboloid: |size| {
            let s = size.recip();
            Quadric::new(DVec3::new(s, 0.0, s), DVec3::ZERO, -DVec3::Y, 0.0)
        };
    }

    #[test]
    fn distances_are_exact_to_the_last_bits() {
        let squares = DVec3::new(1.0, -0.5, 2.0);
        oracle(
            &Quadric::new(squares, DVec3::new(0.25, 0.5, -0.75), DVec3::new(0.5, 0.0, 0.125), -1.0),
            &[
                (1.0, [2, 0, 0]),
                (-0.5, [0, 2, 0]),
                (2.0, [0, 0, 2]),
                (0.25, [1, 1, 0]),
                (0.5, [1, 0, 1]),
                (-0.75, [0, 1, 1]),
                (0.5, [1, 0, 0]),
                (0.125, [0, 0, 1]),
                (-1.0, [0, 0, 0]),
            ],
            8.0,
        );
    }

    #[test]
    fn probes_agree_with_povray() {
        let make = |a: [f64; 3], b: [f64; 3], c: [f64; 3], d| Quadric::new(a.into(), b.into(), c.into(), d);
        table(
            &make([1.0, 2.0, 3.0], [0.1, 0.2, 0.3], [0.4, 0.5, 0.6], -1.0),
            "from <0.1,0.2,-5> dir <0.02,0.03,1> | P <0.189068359752126, 0.333602539628189, -0.546582012393705> N <0.224227247556191, 0.539457527184437, -0.811608106056998>
            from <0,0,0> dir <1,0,0> | P <0.819803902718557, 0, 0> N <0.904721529416378, 0.258152664141355, 0.338874838557263>
            inside <0.2,0.1,0.1> | 1",
        );
        table(
            &make([1.0, 0.0, 1.0], [0.0; 3], [0.0, -1.0, 0.0], 0.0),
            "from <0.3,5,0.2> dir <0,-1,0> | P <0.3, 0.13, 0.2> N <0.486664263392288, -0.811107105653813, 0.324442842261525>
            from <0.3,5,0.2> dir <0.1,-1,0> | P <0.741080037762929, 0.589199622370705, 0.2> N <0.808970109234832, -0.545804817302082, 0.218321926920833>
            from <0,2,-5> dir <0,0,1> | P <0, 2, -1.414213562373095> N <0, -0.333333333333333, -0.942809041582063>",
        );
        table(
            &make([1.0, -1.0, 1.0], [0.0; 3], [0.0; 3], -1.0),
            "from <0.1,0.2,-5> dir <0,0,1> | P <0.1, 0.2, -1.014889156509223> N <0.096225044864938, -0.192450089729875, -0.976577546180386>
            from <0,0,0> dir <1,0,0> | P <1, 0, 0> N <1, 0, 0>",
        );
        table(
            &make([0.0; 3], [0.0; 3], [1.0, 2.0, 3.0], -4.0),
            "from <0,5,0> dir <0,-1,0> | P <0, 2, 0> N <0.267261241912424, 0.534522483824849, 0.801783725737273>
            inside <0,0,0> | 1",
        );
        table(
            &make([1.0; 3], [0.0; 3], [0.0; 3], -1.0),
            "from <5,0.9999999,0> dir <-1,0,0> | P <0.000447213582225, 0.9999999, 0> N <0.000447213582225, 0.999999900000001, 0>
            inside <1,0,0> | 1
            inside <1.0000000001,0,0> | 0
            extent | <-1, -1, -1> .. <1, 1, 1>",
        );
    }

    #[test]
    fn a_tangent_ray_and_the_apex_of_a_cone_are_hit() {
        // POV-Ray misses both.
        let sphere = Quadric::new(DVec3::ONE, DVec3::ZERO, DVec3::ZERO, -1.0);
        table(&sphere, "from <5,1,0> dir <-1,0,0> | P <0, 1, 0> N <0, 1, 0>");
        let cone = Quadric::new(DVec3::new(1.0, -1.0, 1.0), DVec3::ZERO, DVec3::ZERO, 0.0);
        table(&cone, "from <0,3,0> dir <0,-1,0> | P <0, 0, 0> N <1, 0, 0>");
    }
}
