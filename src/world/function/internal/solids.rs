//! Internal functions that are distances, blobs, coils and the like (docs/spec/language.md 4.5).

use std::f64::consts::{FRAC_PI_3, FRAC_PI_6, PI, TAU};

use super::{Formula, PARAMETERS, section};

/// Parameters besides the point, and the formula.
pub(super) fn find(number: u8) -> Option<(usize, Formula)> {
    Some(match number {
        6 => (5, |x, y, z, p| {
            let (half, rest) = (p[0] / 2.0, y * y + z * z);
            let a = (((x + half) * (x + half) + rest) * p[2] * p[2]).min(1.0);
            let b = (((x - half) * (x - half) + rest) * p[4] * p[4]).min(1.0);
            -(p[1] * (1.0 - a) * (1.0 - a) + p[3] * (1.0 - b) * (1.0 - b))
        }),
        7 => (4, |x, y, z, p| {
            let rest = y * y + z * z;
            let ball = |x: f64| (-p[1] * (x * x + rest)).exp();
            p[3] - p[2] * (ball(x) + ball(x - p[0]))
        }),
        9 => (1, comma),
        10 => (4, |x, y, z, p| p[3] - p[2] * ellipsoids(x, y, z, p).into_iter().fold(f64::NAN, f64::max)),
        17 => (3, |x, y, z, p| (x * x * p[0] * p[0] + y * y * p[1] * p[1] + z * z * p[2] * p[2]).sqrt()),
        19 => (4, |x, y, z, p| p[3] - p[2] * ellipsoids(x, y, z, p).into_iter().sum::<f64>()),
        24 => (10, helical_torus),
        25 => (7, helix1),
        26 => (7, helix2),
        27 => (1, |x, y, _, _| hexagon(x, y).0),
        28 => (1, |x, y, _, _| hexagon(x, y).1),
        32 => (4, |x, y, z, p| p[3] - p[2] * ellipsoids(x, y, z, p).into_iter().fold(f64::NAN, f64::min)),
        40 => (5, mesh1),
        47 => (0, |x, y, z, _| (x * x + z * z).sqrt().atan2(y)),
        51 => (5, |x, y, z, p| {
            let radius = p[0] + p[1] * y + p[2] * y * y + p[3] * y.powi(3) + p[4] * y.powi(4);
            (x * x + z * z).sqrt() - radius.max(-5.0)
        }),
        52 => (6, |x, y, z, p| {
            let radius = p[1] + p[2] * y + p[3] * y * y + p[4] * y.powi(3) + p[5] * y.powi(4);
            let distance = |i: i32| {
                let (sin, cos) = (TAU * f64::from(i) / p[0]).sin_cos();
                (x - radius * sin).hypot(z - radius * cos)
            };
            (0..p[0] as i32).map(distance).fold(10000.0, f64::min)
        }),
        53 => (1, |x, y, z, _| {
            let x = off_axis(x, z, 1e-6);
            let t = (x * x + z * z).sqrt().atan2(y).cos();
            let r = 2.0 * (x * x + y * y + z * z).sqrt();
            let q = r * r * (-0.33333333 * r).exp() * (3.0 * t * t - 1.0);
            -0.1 * (q * q - 12.0)
        }),
        57 => (0, |x, y, z, _| (x * x + y * y + z * z).sqrt()),
        60 => (4, |x, y, z, p| {
            let excess = |v: f64, half: f64| {
                let flat = half - p[0];
                let above = if v >= flat { v - flat } else { 0.0 };
                let below = if v <= -flat { -flat - v } else { 0.0 };
                above.max(below)
            };
            let (a, b, c) = (excess(x, p[1]), excess(y, p[2]), excess(z, p[3]));
            (a * a + b * b + c * c).sqrt() - p[0] - 1e-6
        }),
        61 => (1, |x, y, z, p| (x * x + y * y + z * z).sqrt() - p[0]),
        62 => (5, |x, y, z, p| {
            let ball = p[4] * (-p[3] * (x * x + y * y + z * z)).exp();
            -p[2] * (ball - ellipsoids(x, y, z, p).into_iter().sum::<f64>())
        }),
        63 => {
            (4, |x, y, z, p| y - p[0] * (p[1] * x).cos() * (p[2] * z).cos() * (-p[3] * (x * x + z * z)).exp())
        }
        64 => (6, |x, y, z, p| {
            let r = (x * x + z * z).sqrt();
            let x = off_axis(x, z, 1e-6);
            let r = r + p[0] * z.atan2(x) / TAU;
            let s = section(r % p[0] - p[0] / 2.0, y, p[5]);
            let d = (x * x + y * y + z * z).sqrt();
            -(p[2] - d).min(p[1] - s.min(d))
        }),
        68 => (2, |x, y, z, p| {
            let ring = (x.abs().powf(2.0 / p[0]) + y.abs().powf(2.0 / p[0])).powf(p[0] / p[1]);
            1.0 - (ring + z.abs().powf(2.0 / p[1])).powf(p[1] * 0.5)
        }),
        69 => (0, |x, _, z, _| x.atan2(z)),
        70 => (2, |x, y, z, p| {
            let out = (x * x + z * z).sqrt() - p[0];
            (out * out + y * y).sqrt() - p[1]
        }),
        _ => return None,
    })
}

/// x, or a little more on the y axis, where angles have no meaning.
fn off_axis(x: f64, z: f64, little: f64) -> f64 {
    if x == 0.0 && z == 0.0 { little } else { x }
}

/// E1, E2, E3 of the specification: three crossed ellipsoids.
fn ellipsoids(x: f64, y: f64, z: f64, p: &[f64; PARAMETERS]) -> [f64; 3] {
    let (a, b, c) = (x * x, y * y, z * z);
    let ellipsoid = |a: f64, b: f64, c: f64| (-p[1] * (a + b + c)).exp();
    [ellipsoid(p[0] * a, p[0] * b, c), ellipsoid(p[0] * a, b, p[0] * c), ellipsoid(a, p[0] * b, p[0] * c)]
}

fn comma(x: f64, y: f64, z: f64, p: &[f64; PARAMETERS]) -> f64 {
    let size = p[0];
    let x = off_axis(x, z, 0.0001);
    let angle = z.atan2(x);
    let from_quarter = ((x + size / 4.0).powi(2) + z * z).sqrt();
    let tail = size / 2.0 * (angle / 2.0).cos() - ((from_quarter - 3.0 * size / 4.0).powi(2) + y * y).sqrt();
    let head = size / 2.0 - ((x - size / 2.0).powi(2) + y * y + z * z).sqrt();
    -z.min(tail).max(head)
}

fn helical_torus(x: f64, y: f64, z: f64, p: &[f64; PARAMETERS]) -> f64 {
    let distance = (x * x + z * z).sqrt();
    let x = off_axis(x, z, 1e-6);
    let angle = x.atan2(z);
    let r = ((distance - p[0]).powi(2) + y * y).sqrt();
    let mut t = (angle * p[1] + p[2] * (distance - p[0]).atan2(y)) % TAU;
    if t < 0.0 {
        t += TAU;
    }
    t -= PI;
    let ripple = p[3] * (p[7] * (t * p[8]).atan2(r - p[5]) + angle * p[9]).cos();
    let winding = p[4] + ripple - ((r - p[5]).powi(2) + t * t * p[6]).sqrt().min(r + p[5]);
    -(p[4] + p[5] - p[0] - distance).max(winding)
}

fn helix1(x: f64, y: f64, z: f64, p: &[f64; PARAMETERS]) -> f64 {
    let r = (x * x + z * z).sqrt();
    let x = off_axis(x, z, 1e-6);
    let turns = p[1] * p[0];
    let mut t = (p[0] * z.atan2(x) + y * turns) % TAU;
    if t < 0.0 {
        t += TAU;
    }
    let (mut out, mut up) = (r - p[3], (t - PI) / p[4] / turns);
    if p[5] != 1.0 && p[6] != 0.0 {
        let (sin, cos) = p[6].to_radians().sin_cos();
        (out, up) = (out * cos - up * sin, out * sin + up * cos);
    }
    (p[3] + r).min(section(out, up, p[5])) - p[2]
}

fn helix2(x: f64, y: f64, z: f64, p: &[f64; PARAMETERS]) -> f64 {
    let (sin, cos) = (y * p[1]).sin_cos();
    let (a, b) = (x - p[3] * cos, z - p[3] * sin);
    section(a * cos + b * sin, b * cos - a * sin, p[5]) - p[2]
}

/// The two coordinates in a floor of hexagons.
fn hexagon(x: f64, y: f64) -> (f64, f64) {
    let half = 3_f64.sqrt() / 2.0;
    let mut a = (x.abs() % (2.0 * half) - half).abs();
    let mut b = (y.abs() % 3.0 - 1.5).abs();
    if a * a + b * b > (half - a).powi(2) + (1.5 - b).powi(2) {
        (a, b) = (half - a, 1.5 - b);
    }
    if b.atan2(a) < FRAC_PI_6 {
        return (a, b);
    }
    let (sin, cos) = FRAC_PI_3.sin_cos();
    (a * cos + b * sin, (b * cos - a * sin).abs())
}

fn mesh1(x: f64, y: f64, z: f64, p: &[f64; PARAMETERS]) -> f64 {
    let thread = |v: f64, half: f64| {
        let mut m = v % (2.0 * half);
        if m < 0.0 {
            m += 2.0 * half;
        }
        p[2] * (m - half).abs()
    };
    let wave = |v: f64, period: f64| (PI * v / period).cos() * p[3];
    let (k, l) = (wave(z, p[1]), wave(x, p[0]));
    let distance = |height: f64, across: f64| (height * p[4]).hypot(across);
    distance(y - k, thread(x, p[0]))
        .min(distance(y + k, thread(x - p[0], p[0])))
        .min(distance(y + l, thread(z, p[1])))
        .min(distance(y - l, thread(z - p[1], p[1])))
}
