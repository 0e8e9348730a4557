//! Internal functions of a plane that may be swept around an axis (docs/spec/language.md 4.5, "R").

use super::{Formula, Number, Unary, cl, cl_to};

/// Parameters besides the point, and the formula.
pub(super) fn find<N: Number>(number: u8) -> Option<(usize, Formula<N>)> {
    Some(match number {
        0 => (5, |x, y, z, p| {
            let (x, y) = swept(x, y, z, &p[2..]);
            -cl_to(-p[0] * (x * x * x.abs() - x * x + y * y), p[1])
        }),
        1 => (5, |x, y, z, p| {
            let (x, y) = swept(x, y, z, &p[2..]);
            let (a, b) = (x * x, y * y);
            cl_to(-p[0] * (a * 2.0 * a - a * 3.0 * y + b - b * 2.0 * y + b * b), p[1])
        }),
        2 => (5, |x, y, z, p| {
            let (x, y) = swept(x, y, z, &p[2..]);
            let (a, b) = (x * x, y * y);
            cl_to(-p[0] * (a * a + a * b - a * 2.0 * y - x * b + b), p[1])
        }),
        3 => (5, |x, y, z, p| {
            let (x, y) = swept(x, y, z, &p[2..]);
            let (a, b) = (x * x, y * y);
            cl_to(-p[0] * (a * a + b * b + a * 2.0 * b + a * 3.0 * y - b * y), p[1])
        }),
        15 => (6, |x, y, z, p| {
            let (x, y) = swept(x, y, z, &p[3..]);
            let (a, b) = (x * x, y * y);
            cl(-p[0] * (a * (a - p[1] * p[1]) - b * (b - p[2] * p[2])))
        }),
        21 => (6, |x, y, z, p| {
            let (x, y) = swept(x, y, z, &p[3..]);
            cl(-p[0] * (y * y * ((p[2] - p[1] * 4.0) * x + 1.0) + x * x * (p[2] + 1.0)))
        }),
        34 => (6, |x, y, z, p| {
            let (x, y) = swept(x, y, z, &p[3..]);
            let a = x * x;
            cl(-p[0] * (y * y - p[2] * p[2] * a * a + p[1] * p[2].powi(3) * a))
        }),
        39 => (6, |x, y, z, p| {
            let (x, y) = swept(x, y, z, &p[3..]);
            let (a, q) = (x * x, p[2] * p[2]);
            cl(-p[0] * (y * y - p[1] * p[1] * q * a + q * a * a))
        }),
        50 => (7, |x, y, z, p| {
            let (x, y) = swept(x, y, z, &p[4..]);
            let q = p[3] * p[3];
            cl(-p[0] * (y * y - p[1] * q * x.powi(3) - p[2] * q * x.powi(4)))
        }),
        67 => (7, |x, y, z, p| {
            let (x, y) = swept(x, y, z, &p[4..]);
            let q = p[3] * p[3];
            cl(-p[0] * ((p[2] - x) * y * y - q * p[1] * x * x - q * x.powi(3)))
        }),
        75 => (6, |x, y, z, p| {
            let (x, y) = swept(x, y, z, &p[3..]);
            cl(-p[0] * (p[1] * p[1] * y + x * x * y - p[2]))
        }),
        _ => return None,
    })
}

/// Where in the plane a point of space is. The parameters are: whether to sweep at all, the distance of
/// the plane's origin from the axis, and the angle in degrees by which the plane is turned.
fn swept<N: Number>(x: N, y: N, z: N, parameters: &[N]) -> (N, N) {
    let &[sweep, distance, angle, ..] = parameters else { return (x, y) };
    match sweep.fixed() {
        Some(sweep) if sweep <= 0.0 => return (x, y),
        None => return (N::unknown(), N::unknown()),
        _ => {}
    }
    let out = (x * x + z * z).sqrt() - distance;
    if angle.fixed() == Some(0.0) {
        return (out, y);
    }
    let angle = angle.unary(Unary::Radians);
    let (sin, cos) = (angle.sin(), angle.cos());
    (out * cos - y * sin, out * sin + y * cos)
}
