//! Internal functions that are algebraic surfaces (docs/spec/language.md 4.5).

use std::f64::consts::SQRT_2;

use super::{Formula, Number, cl};

/// Parameters besides the point, and the formula. A, B, C of the specification are a, b, c: the squares
/// of x, y, z.
pub(super) fn find<N: Number>(number: u8) -> Option<(usize, Formula<N>)> {
    Some(match number {
        4 => (2, |x, y, z, p| {
            let (a, b, c, s) = (x * x, y * y, z * z, p[1] * p[1]);
            let t = a + c + p[1] * 2.0 * y - s;
            cl(p[0] * (b * (s - a - c) - t * t))
        }),
        5 => (2, |x, y, z, p| {
            let (a, c) = (x * x, z * z);
            let s = a + y * y + c;
            cl(-p[0] * (s * s - p[1] * (a + c) * y))
        }),
        8 => (2, boy),
        11 => (1, |x, y, z, p| cl(p[0] * (x * x * z * z - y))),
        12 => (1, |x, y, z, p| cl(p[0] * (z + y * y * y - x * x * x))),
        13 | 43 => (1, |x, y, z, p| {
            let (a, b, c) = (x * x, y * y, z * z);
            let s = a - z;
            cl(p[0]
                * (a * c - c * c - a * 2.0 * z + c * 2.0 * z + a - c - s * s - b * b - a * 2.0 * b - b * c
                    + b * 2.0 * z
                    + b))
        }),
        14 => (1, |x, y, z, p| {
            let (a, b, c) = (x * x, y * y, z * z);
            cl(-p[0] * (a * a + a * 2.0 * c - a * 0.36 - b * b + b * 0.25 + c * c))
        }),
        16 => (6, dupin),
        18 => (1, |x, y, z, p| {
            let below = (z.abs() - 0.2).choose(N::constant(0.2), z);
            let d = y * y - x * x;
            // The last term takes the square of z as it came.
            let a = d / (below * 2.0) + z * 2.0 * z / 9.0;
            let b = d / (below * 4.0);
            cl(-p[0] * (a * a * a - b * 6.0 * b))
        }),
        20 => (3, |x, y, z, p| {
            cl(p[0] * ((y * y + z * z) * ((p[2] - p[1] * 4.0) * x + 1.0) + x * x * (p[2] + 1.0)))
        }),
        22 => (1, |x, y, z, p| cl(p[0] * (x.powi(5) * 0.5 + x.powi(4) * 0.5 - y * y - z * z))),
        23 => (1, |x, y, z, p| {
            let (a, b, c) = (x * x, y * y, z * z);
            let s = a * 2.0 + b + c - 1.0;
            cl(-p[0] * (s.powi(3) - a * 0.1 * z.powi(3) - b * z.powi(3)))
        }),
        30 => (1, |x, y, z, p| {
            let (a, b, c) = (x * x, y * y, z * z);
            let (s, t) = (a + b + c - 13.0, a * 3.0 + b - c * 4.0 - 12.0);
            cl(-p[0] * (s.powi(3) * 4.0 + t * 27.0 * t))
        }),
        31 => (3, |x, y, z, p| {
            let (a, b, c) = (x * x, y * y, z * z);
            let (big, small) = (p[1] * p[1], p[2] * p[2]);
            let (sum, d) = (big + small, big - small);
            cl(-p[0]
                * (a * a + a * 2.0 * b - a * 2.0 * c - sum * 2.0 * a + b * b - b * 2.0 * c
                    + d * 2.0 * b
                    + c * c
                    + sum * 2.0 * c
                    + d * d))
        }),
        33 => (3, |x, y, z, p| {
            let (a, q) = (x * x, p[2] * p[2]);
            cl(-p[0] * (y * y + z * z - q * a * a + q * p[1] * p[1] * a))
        }),
        35 => (1, |x, y, z, p| {
            let c = z * z;
            let s = x * x + y * y + c - 1.0;
            let t = s - y * 2.0;
            cl(-p[0] * ((s + y * 2.0) * (t * t - c * 8.0) + x * 16.0 * z * t))
        }),
        36 => (1, |x, y, z, p| {
            let (a, b, c) = (x * x, y * y, z * z);
            cl(-p[0] * (a * a + b * b + c * c - a - b - c - a * b - a * c - b * c + 1.0))
        }),
        37 => (4, |x, y, z, p| {
            let (a, b, c) = (x * x, y * y, z * z);
            cl(-p[0]
                * (a * a
                    + b * b
                    + c * c
                    + p[1] * (a + b + c)
                    + p[2] * (a * b + a * c + b * c)
                    + p[3] * x * y * z
                    - 1.0))
        }),
        38 => (1, |x, y, z, p| {
            let a = x * x;
            cl(-p[0] * (a * a - a + y * y + z * z))
        }),
        41 => (1, |x, y, z, p| {
            let (a, b, c) = (x * x, y * y, z * z);
            cl(-p[0] * (a * 4.0 * (a + b + c) - b * (-b + 1.0 - c)))
        }),
        42 => (1, |_, y, z, p| cl(-p[0] * (y.powi(3) + z.powi(3) - y * 6.0 * z))),
        44 => (4, |x, y, z, p| {
            let (a, c) = (x * x, z * z);
            let q = p[1] * p[1];
            let s = a + y * y + c + q;
            cl(-p[0] * (s * s - p[3] * q * (a + c) - p[2] * p[2]))
        }),
        45 => (1, |x, y, z, p| cl(-p[0] * (x * x - y + z * z))),
        46 => (3, |x, y, z, p| {
            let (a, b, c) = (x * x, y * y, z * z);
            let (big, small) = (p[1] * p[1], p[2] * p[2]);
            let (sum, d) = (big + small, big - small);
            cl(-p[0]
                * (a * a + a * 2.0 * b - a * 2.0 * z - sum * a + b * b - b * 2.0 * z
                    + d * b
                    + c
                    + sum * z
                    + d * d))
        }),
        48 => (1, |x, y, z, p| {
            let (a, b, c) = (x * x, y * y, z * z);
            cl(p[0] * (a * a + b * b + c * c - a - b - c))
        }),
        49 => (1, |x, y, z, p| -cl(-p[0] * (x.powi(4) - x.powi(3) + y * y + z * z))),
        54 => (1, |x, y, z, p| cl(-p[0] * (x.powi(4) + z.powi(4) - y))),
        55 => (1, |x, y, z, p| cl(-p[0] * (x.powi(4) - z.powi(4) - y))),
        56 => (3, |x, y, z, p| {
            let (s, q) = (x * x + z * z, p[2] * p[2]);
            cl(-p[0] * (s * y * y + q * s - p[1] * p[1] * q))
        }),
        65 => (1, |x, y, z, p| {
            let (a, b, c) = (x * x, y * y, z * z);
            cl(-p[0] * (a * b + a * c + b * c + x * y * z))
        }),
        66 => (4, |x, y, z, p| {
            let q = p[3] * p[3];
            cl(-p[0] * ((p[2] - x) * (y * y + z * z) - q * p[1] * x * x - q * x.powi(3)))
        }),
        71 => (3, |x, y, z, p| {
            let (a, b, c) = (x * x, y * y, z * z);
            let (big, small) = (p[1] * p[1], p[2] * p[2]);
            let (sum, d, s) = (big + small, big - small, a + b + c);
            cl(-p[0] * (s * s - sum * 2.0 * a + d * 2.0 * b - sum * 2.0 * c + d * d))
        }),
        72 => (1, |x, y, z, p| {
            let (a, s) = (x * x, y * y + z * z);
            cl(-p[0] * ((a * a + s * s) * 4.0 + a * 17.0 * s - (a + s) * 20.0 + 17.0))
        }),
        73 => (1, |x, y, z, p| cl(-p[0] * (x * x - y * z * z))),
        74 => (2, |x, y, z, p| cl(-p[0] * (p[1] * (y - 1.0) + (x * x + z * z) * y))),
        _ => return None,
    })
}

fn boy<N: Number>(x: N, y: N, z: N, p: &[N]) -> N {
    let (a, b, c) = (x * x, y * y, z * z);
    let (w, h) = (-z + 1.0, a + b);
    cl(p[0]
        * p[1]
        * (w.powi(3) * 64.0 * z.powi(3) - w * 48.0 * w * c * (a * 3.0 + b * 3.0 + c * 2.0)
            + w * 12.0
                * z
                * (h * 27.0 * h - c * 24.0 * h + y * (36.0 * SQRT_2) * z * (b - a * 3.0) + c * 4.0 * c)
            + (a * 9.0 + b * 9.0 - c * 2.0)
                * (-h * 81.0 * h - c * 72.0 * h + x * (108.0 * SQRT_2) * z * (a - b * 3.0) + c * 4.0 * c)))
}

fn dupin<N: Number>(x: N, y: N, z: N, p: &[N]) -> N {
    let &[p0, p1, p2, p3, p4, p5, ..] = p else { return N::unknown() };
    let b = y * y;
    let s = x * x + b + z * z;
    let (r, m, t) = (p5 * p5, p2 * p2, p4 * p4);
    let q = (m - t - (p3 + p1) * (p3 + p1)) * (m - t - (p3 - p1) * (p3 - p1));
    let along = p3 * x + p4 * y;
    cl(-p0
        * (q * s * s
            + r * 2.0 * ((p1 * p1 - p3 * p3 + m - t) * (along * 2.0 - r) - p4 * 4.0 * m * y) * s
            + r * 4.0 * r * along * (along - r)
            + r * 4.0 * r * p1 * p1 * b
            + r.powi(4)))
}
