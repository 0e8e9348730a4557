//! Internal functions that are algebraic surfaces (docs/spec/language.md 4.5).

use std::f64::consts::SQRT_2;

use super::{Formula, PARAMETERS, cl};

/// Parameters besides the point, and the formula. A, B, C of the specification are a, b, c: the squares
/// of x, y, z.
pub(super) fn find(number: u8) -> Option<(usize, Formula)> {
    Some(match number {
        4 => (2, |x, y, z, p| {
            let (a, b, c, s) = (x * x, y * y, z * z, p[1] * p[1]);
            let t = a + c + 2.0 * p[1] * y - s;
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
                * (a * c - c * c - 2.0 * a * z + 2.0 * c * z + a - c - s * s - b * b - 2.0 * a * b - b * c
                    + 2.0 * b * z
                    + b))
        }),
        14 => (1, |x, y, z, p| {
            let (a, b, c) = (x * x, y * y, z * z);
            cl(-p[0] * (a * a + 2.0 * a * c - 0.36 * a - b * b + 0.25 * b + c * c))
        }),
        16 => (6, dupin),
        18 => (1, |x, y, z, p| {
            let below = if z.abs() < 0.2 { 0.2 } else { z };
            let d = y * y - x * x;
            // The last term takes the square of z as it came.
            let a = d / (2.0 * below) + 2.0 * z * z / 9.0;
            let b = d / (4.0 * below);
            cl(-p[0] * (a * a * a - 6.0 * b * b))
        }),
        20 => (3, |x, y, z, p| {
            cl(p[0] * ((y * y + z * z) * (1.0 + (p[2] - 4.0 * p[1]) * x) + x * x * (1.0 + p[2])))
        }),
        22 => (1, |x, y, z, p| cl(p[0] * (0.5 * x.powi(5) + 0.5 * x.powi(4) - y * y - z * z))),
        23 => (1, |x, y, z, p| {
            let (a, b, c) = (x * x, y * y, z * z);
            let s = 2.0 * a + b + c - 1.0;
            cl(-p[0] * (s.powi(3) - 0.1 * a * z.powi(3) - b * z.powi(3)))
        }),
        30 => (1, |x, y, z, p| {
            let (a, b, c) = (x * x, y * y, z * z);
            let (s, t) = (a + b + c - 13.0, 3.0 * a + b - 4.0 * c - 12.0);
            cl(-p[0] * (4.0 * s.powi(3) + 27.0 * t * t))
        }),
        31 => (3, |x, y, z, p| {
            let (a, b, c) = (x * x, y * y, z * z);
            let (big, small) = (p[1] * p[1], p[2] * p[2]);
            let (sum, d) = (big + small, big - small);
            cl(-p[0]
                * (a * a + 2.0 * a * b - 2.0 * a * c - 2.0 * sum * a + b * b - 2.0 * b * c
                    + 2.0 * d * b
                    + c * c
                    + 2.0 * sum * c
                    + d * d))
        }),
        33 => (3, |x, y, z, p| {
            let (a, q) = (x * x, p[2] * p[2]);
            cl(-p[0] * (y * y + z * z - q * a * a + q * p[1] * p[1] * a))
        }),
        35 => (1, |x, y, z, p| {
            let c = z * z;
            let s = x * x + y * y + c - 1.0;
            let t = s - 2.0 * y;
            cl(-p[0] * ((s + 2.0 * y) * (t * t - 8.0 * c) + 16.0 * x * z * t))
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
            cl(-p[0] * (4.0 * a * (a + b + c) - b * (1.0 - b - c)))
        }),
        42 => (1, |_, y, z, p| cl(-p[0] * (y.powi(3) + z.powi(3) - 6.0 * y * z))),
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
                * (a * a + 2.0 * a * b - 2.0 * a * z - sum * a + b * b - 2.0 * b * z
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
            cl(-p[0] * (s * s - 2.0 * sum * a + 2.0 * d * b - 2.0 * sum * c + d * d))
        }),
        72 => (1, |x, y, z, p| {
            let (a, s) = (x * x, y * y + z * z);
            cl(-p[0] * (4.0 * (a * a + s * s) + 17.0 * a * s - 20.0 * (a + s) + 17.0))
        }),
        73 => (1, |x, y, z, p| cl(-p[0] * (x * x - y * z * z))),
        74 => (2, |x, y, z, p| cl(-p[0] * (p[1] * (y - 1.0) + (x * x + z * z) * y))),
        _ => return None,
    })
}

fn boy(x: f64, y: f64, z: f64, p: &[f64; PARAMETERS]) -> f64 {
    let (a, b, c) = (x * x, y * y, z * z);
    let (w, h) = (1.0 - z, a + b);
    cl(p[0]
        * p[1]
        * (64.0 * w.powi(3) * z.powi(3) - 48.0 * w * w * c * (3.0 * a + 3.0 * b + 2.0 * c)
            + 12.0
                * w
                * z
                * (27.0 * h * h - 24.0 * c * h + 36.0 * SQRT_2 * y * z * (b - 3.0 * a) + 4.0 * c * c)
            + (9.0 * a + 9.0 * b - 2.0 * c)
                * (-81.0 * h * h - 72.0 * c * h + 108.0 * SQRT_2 * x * z * (a - 3.0 * b) + 4.0 * c * c)))
}

fn dupin(x: f64, y: f64, z: f64, p: &[f64; PARAMETERS]) -> f64 {
    let [p0, p1, p2, p3, p4, p5, ..] = *p;
    let b = y * y;
    let s = x * x + b + z * z;
    let (r, m, t) = (p5 * p5, p2 * p2, p4 * p4);
    let q = (m - t - (p3 + p1) * (p3 + p1)) * (m - t - (p3 - p1) * (p3 - p1));
    let along = p3 * x + p4 * y;
    cl(-p0
        * (q * s * s
            + 2.0 * r * ((p1 * p1 - p3 * p3 + m - t) * (2.0 * along - r) - 4.0 * p4 * m * y) * s
            + 4.0 * r * r * along * (along - r)
            + 4.0 * r * r * p1 * p1 * b
            + r.powi(4)))
}
