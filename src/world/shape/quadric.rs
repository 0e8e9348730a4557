//! `quadric { <A,B,C>, <D,E,F>, <G,H,I>, J }` (docs/spec/primitives.md 3.8).

use super::stretch::Stretch;
use super::{Crossing, Shape};
use crate::math::wide::widest;
use crate::math::{Band, Bounds, DMat3, DVec3, roots};
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
    /// Whether it is known that all lines are inside on one stretch: an ellipsoid, a cylinder, a paraboloid.
    convex: bool,
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
        let (bounds, extent) = (Bounds::ALL, Bounds::ALL);
        let convex = products == DVec3::ZERO && squares.min_element() >= 0.0;
        let quadric = Self { matrix, linear, constant, center, bounds, extent, convex };
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

    /// Where a line meets it, near enough to be [polished](Self::polish): how far the line was moved, the line
    /// then, and the distances from there.
    #[inline(always)]
    fn near_hits(&self, ray: &Ray) -> Option<(f64, Ray, [f64; 2])> {
        let (shift, ray) = ray.moved_to(self.center);
        let (o, d) = (ray.origin, ray.direction);
        let across = self.matrix * d;
        let (a, b) = (d.dot(across), o.dot(across) + 0.5 * self.linear.dot(d));
        let c = o.dot(self.matrix * o + self.linear) + self.constant;
        Some((shift, ray, roots::quadratic(a, b, c)?))
    }

    /// Where a line meets it; no numbers where it doesn't.
    fn hits(&self, ray: &Ray) -> [f64; 2] {
        widest(
            #[inline(always)]
            || match self.near_hits(ray) {
                Some((shift, ray, [one, other])) => {
                    [shift + self.polish(&ray, one), shift + self.polish(&ray, other)]
                }
                None => [f64::NAN; 2],
            },
        )
    }

    /// Whether [`Quadric::stretch`] knows it.
    pub(super) fn is_convex(&self) -> bool {
        self.convex
    }

    /// Where a line is inside of one that is convex.
    pub(super) fn stretch(&self, ray: &Ray) -> Option<Stretch> {
        let [one, other] = self.hits(ray);
        if !one.is_nan() {
            return Stretch::new(one.min(other), 0, one.max(other), 0);
        }
        // Without roots a line along which nothing changes is inside all along, or not at all.
        let along = ray.direction.dot(self.matrix * ray.direction) == 0.0;
        (along && self.inside(ray.origin)).then_some(Stretch::LINE)
    }

    /// One Newton step where it is smaller than what it corrects.
    #[inline(always)]
    fn polish(&self, ray: &Ray, t: f64) -> f64 {
        let p = ray.at(t);
        let turned = self.matrix * p;
        let value = p.dot(turned + self.linear) + self.constant;
        let step = value / (2.0 * turned + self.linear).dot(ray.direction);
        if step.abs() < 1e-6 * t.abs() { t - step } else { t }
    }
}

impl Quadric {
    /// A box around the part of the inside that is in `within`, if only that.
    pub(in crate::world) fn narrowed(&self, within: Bounds) -> Bounds {
        let mut bounds = within;
        // What bounds one axis may help to bound the next.
        for axis in [0, 1, 2, 0, 1] {
            let [low, high] = self.span(axis, bounds);
            bounds.min[axis] = bounds.min[axis].max(low);
            bounds.max[axis] = bounds.max[axis].min(high);
        }
        bounds
    }

    /// From where to where along an axis the part of the inside is that is in `within`: the roots of
    /// a x² + b x + c for the least c and the extreme values of b that the other two coordinates give.
    fn span(&self, axis: usize, within: Bounds) -> [f64; 2] {
        let others = [(axis + 1) % 3, (axis + 2) % 3];
        let mut rest = (self.matrix, self.linear, self.constant);
        for other in others {
            let endless = within.min[other] == f64::NEG_INFINITY || within.max[other] == f64::INFINITY;
            if endless && rest.0.col(other)[other] > 0.0 {
                rest = least_along(rest, other);
            }
        }
        let (matrix, linear, constant) = rest;
        let side = |other: usize| [within.min[other], within.max[other]];
        let mut b = [linear[axis]; 2];
        let mut c = constant;
        for other in others {
            let [low, high] = scaled(2.0 * matrix.col(axis)[other], side(other));
            b = [b[0] + low, b[1] + high];
            c += least_value(matrix.col(other)[other], linear[other], side(other));
        }
        let [low, high] = scaled(2.0 * matrix.col(others[0])[others[1]], side(others[0]));
        c += scaled(low, side(others[1]))[0].min(scaled(high, side(others[1]))[0]);
        let a = matrix.col(axis)[axis];
        let reach = if a > 0.0 {
            let root = (b[0] * b[0]).max(b[1] * b[1]) - 4.0 * a * c;
            let root = root.max(0.0).sqrt();
            [(-b[1] - root) / (2.0 * a), (-b[0] + root) / (2.0 * a)]
        } else if a == 0.0 && b[0] > 0.0 {
            [f64::NEG_INFINITY, (-c / b[0]).max(-c / b[1])]
        } else if a == 0.0 && b[1] < 0.0 {
            [(-c / b[0]).min(-c / b[1]), f64::INFINITY]
        } else {
            [f64::NAN; 2]
        };
        // More than all rounding, also that of terms that cancel.
        let size = |x: f64| if x.is_finite() { x.abs() } else { 0.0 };
        let room = 1e-6 * (size(reach[0]) + size(reach[1]));
        let bound = |x: f64, room: f64, none: f64| if x.is_finite() { x + room } else { none };
        [bound(reach[0], -room, f64::NEG_INFINITY), bound(reach[1], room, f64::INFINITY)]
    }
}

/// The function's least values along an axis, as a function of the other two coordinates.
fn least_along((matrix, linear, constant): (DMat3, DVec3, f64), axis: usize) -> (DMat3, DVec3, f64) {
    let column = matrix.col(axis);
    let (square, slope) = (column[axis], linear[axis]);
    let across = DMat3::from_cols(column * column.x, column * column.y, column * column.z);
    let mut matrix = matrix - across * square.recip();
    let mut linear = linear - column * (slope / square);
    // Exactly, not but for rounding.
    for other in 0..3 {
        matrix.col_mut(axis)[other] = 0.0;
        matrix.col_mut(other)[axis] = 0.0;
    }
    linear[axis] = 0.0;
    (matrix, linear, constant - slope * slope / (4.0 * square))
}

/// The products of a number and those of an interval; nothing times infinity is nothing.
fn scaled(by: f64, [low, high]: [f64; 2]) -> [f64; 2] {
    match by {
        0.0 => [0.0; 2],
        _ if by > 0.0 => [by * low, by * high],
        _ => [by * high, by * low],
    }
}

/// The least value of `square x² + slope x` in an interval.
fn least_value(square: f64, slope: f64, [low, high]: [f64; 2]) -> f64 {
    let at = |x: f64| {
        if square == 0.0 {
            scaled(slope, [x, x])[0]
        } else if x.is_infinite() {
            square * f64::INFINITY
        } else {
            x * (square * x + slope)
        }
    };
    let middle = -slope / (2.0 * square);
    let ends = at(low).min(at(high));
    if square > 0.0 && low < middle && middle < high { ends.min(at(middle)) } else { ends }
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
        widest(
            #[inline(always)]
            || {
                let (shift, ray, near) = self.near_hits(ray)?;
                for near in near {
                    let t = shift + self.polish(&ray, near);
                    if range.contains(t) {
                        return Some(Crossing::new(t, 0));
                    }
                }
                None
            },
        )
    }

    fn is_closed(&self) -> bool {
        true
    }

    fn inside(&self, point: DVec3) -> bool {
        self.value(point).0 <= 0.0
    }

    fn inside_along(&self, [x, y, z]: &[Band; 3]) -> Band {
        let row = |i: usize| {
            let m = self.matrix;
            *x * m.x_axis[i] + *y * m.y_axis[i] + *z * m.z_axis[i] + self.linear[i]
        };
        let value = *x * row(0) + *y * row(1) + *z * row(2) + self.constant;
        value.less_equal(Band::constant(0.0))
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
    use crate::math::dice::numbers;

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

    #[test]
    fn a_slab_bounds_what_it_cuts_out_of_a_quadric() {
        let slab = Bounds { min: DVec3::new(f64::NEG_INFINITY, -1.0, f64::NEG_INFINITY), ..Bounds::ALL };
        let slab = Bounds { max: DVec3::new(f64::INFINITY, 2.0, f64::INFINITY), ..slab };
        let bounds = |squares: [f64; 3], linear: [f64; 3], constant| {
            let (squares, linear) = (DVec3::from_array(squares), DVec3::from_array(linear));
            Quadric::new(squares, DVec3::ZERO, linear, constant).narrowed(slab)
        };
        let close = |bounds: Bounds, low: [f64; 3], high: [f64; 3]| {
            let (low, high) = (DVec3::from_array(low), DVec3::from_array(high));
            assert!(bounds.min.abs_diff_eq(low, 1e-4) && bounds.max.abs_diff_eq(high, 1e-4), "{bounds:?}");
            assert!(bounds.min.cmple(low).all() && bounds.max.cmpge(high).all(), "{bounds:?}");
        };
        let five = 5.0_f64.sqrt();
        close(bounds([1., 0., 1.], [0.; 3], -1.0), [-1., -1., -1.], [1., 2., 1.]);
        close(bounds([1., -1., 1.], [0.; 3], -1.0), [-five, -1., -five], [five, 2., five]);
        close(bounds([1., -1., 1.], [0.; 3], 0.0), [-2., -1., -2.], [2., 2., 2.]);
        // x² + z² = y, and one that is moved: (x - 3)² + z² = y.
        let root = 2.0_f64.sqrt();
        close(bounds([1., 0., 1.], [0., -1., 0.], 0.0), [-root, 0., -root], [root, 2., root]);
        close(bounds([1., 0., 1.], [-6., -1., 0.], 9.0), [3. - root, 0., -root], [3. + root, 2., root]);
        // Two sheets that open along x have no end there.
        assert!(!bounds([-1., 1., 1.], [0.; 3], 1.0).is_finite());
    }

    #[test]
    fn no_point_inside_is_outside_of_the_box() {
        let mut number = numbers(5);
        let mut narrowed = 0;
        for _ in 0..2000 {
            let mut point = || DVec3::new(number(), number(), number());
            let quadric = Quadric::new(point(), point() * 0.5, point(), 0.2 * point().x);
            let (a, b) = (2.0 * point(), 2.0 * point());
            let mut within = Bounds::new(a, b);
            if point().x > 0.0 {
                within.max.x = f64::INFINITY;
            }
            let bounds = quadric.narrowed(within);
            narrowed += u32::from(bounds != within);
            for _ in 0..40 {
                let reach = within.max.min(DVec3::splat(9.0)) - within.min;
                let p = within.min + reach * (point() + 0.5);
                assert!(!quadric.inside(p) || bounds.contains(p), "{quadric:?} {within:?} {bounds:?} {p}");
            }
        }
        assert!(narrowed > 100, "{narrowed}");
    }

    #[test]
    fn lines_are_inside_of_a_convex_one_on_one_stretch() {
        let cylinder = Quadric::new(DVec3::new(1., 0., 1.), DVec3::ZERO, DVec3::ZERO, -1.0);
        let stretch = |from: DVec3, to: DVec3| cylinder.stretch(&Ray::new(from, to));
        let across = stretch(DVec3::new(-3., 5., 0.), DVec3::X).unwrap();
        assert_eq!([across.enter.t, across.leave.t], [2.0, 4.0]);
        let along = stretch(DVec3::new(0.5, 5., 0.), DVec3::Y).unwrap();
        assert_eq!([along.enter.t, along.leave.t], [f64::NEG_INFINITY, f64::INFINITY]);
        assert!(stretch(DVec3::new(2., 5., 0.), DVec3::Y).is_none());
        assert!(stretch(DVec3::new(-3., 5., 2.), DVec3::X).is_none());
    }
}
