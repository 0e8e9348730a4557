//! Internal functions that are distances, blobs, coils and the like (docs/spec/language.md 4.5).

use std::f64::consts::{FRAC_PI_3, FRAC_PI_6, PI, TAU};

use super::{Formula, Number, Unary, section};

/// Parameters besides the point, and the formula.
pub(super) fn find<N: Number>(number: u8) -> Option<(usize, Formula<N>)> {
    Some(match number {
        6 => (5, |x, y, z, p| {
            let (half, rest, one) = (p[0] / 2.0, y * y + z * z, N::constant(1.0));
            let a = (((x + half) * (x + half) + rest) * p[2] * p[2]).min(one);
            let b = (((x - half) * (x - half) + rest) * p[4] * p[4]).min(one);
            -(p[1] * (-a + 1.0) * (-a + 1.0) + p[3] * (-b + 1.0) * (-b + 1.0))
        }),
        7 => (4, |x, y, z, p| {
            let rest = y * y + z * z;
            let ball = |x: N| (-p[1] * (x * x + rest)).exp();
            p[3] - p[2] * (ball(x) + ball(x - p[0]))
        }),
        9 => (1, comma),
        10 => (4, |x, y, z, p| p[3] - p[2] * folded(ellipsoids(x, y, z, p), N::max)),
        17 => (3, |x, y, z, p| (x * x * p[0] * p[0] + y * y * p[1] * p[1] + z * z * p[2] * p[2]).sqrt()),
        19 => (4, |x, y, z, p| p[3] - p[2] * folded(ellipsoids(x, y, z, p), N::add)),
        24 => (10, helical_torus),
        25 => (7, helix1),
        26 => (7, helix2),
        27 => (1, |x, y, _, _| hexagon(x, y).0),
        28 => (1, |x, y, _, _| hexagon(x, y).1),
        32 => (4, |x, y, z, p| p[3] - p[2] * folded(ellipsoids(x, y, z, p), N::min)),
        40 => (5, mesh1),
        47 => (0, |x, y, z, _| (x * x + z * z).sqrt().atan2(y)),
        51 => (5, |x, y, z, p| {
            let radius = p[0] + p[1] * y + p[2] * y * y + p[3] * y.powi(3) + p[4] * y.powi(4);
            (x * x + z * z).sqrt() - radius.max(N::constant(-5.0))
        }),
        52 => (6, |x, y, z, p| {
            let radius = p[1] + p[2] * y + p[3] * y * y + p[4] * y.powi(3) + p[5] * y.powi(4);
            let Some(count) = p[0].fixed() else { return N::unknown() };
            let distance = |i: i32| {
                let (sin, cos) = (TAU * f64::from(i) / count).sin_cos();
                (x - radius * sin).hypot(z - radius * cos)
            };
            (0..count as i32).map(distance).fold(N::constant(10000.0), N::min)
        }),
        53 => (1, |x, y, z, _| {
            let x = off_axis(x, z, 1e-6);
            let t = (x * x + z * z).sqrt().atan2(y).cos();
            let r = (x * x + y * y + z * z).sqrt() * 2.0;
            let q = r * r * (-r * 0.33333333).exp() * (t * 3.0 * t - 1.0);
            -(q * q - 12.0) * 0.1
        }),
        57 => (0, |x, y, z, _| {
            N::wide(
                #[inline(always)]
                || length(x, y, z),
            )
        }),
        60 => (4, |x, y, z, p| {
            N::wide(
                #[inline(always)]
                || {
                    let nothing = N::constant(0.0);
                    let a = (x.abs() - (p[1] - p[0])).max(nothing);
                    let b = (y.abs() - (p[2] - p[0])).max(nothing);
                    let c = (z.abs() - (p[3] - p[0])).max(nothing);
                    length(a, b, c) - p[0] - 1e-6
                },
            )
        }),
        61 => (1, |x, y, z, p| {
            N::wide(
                #[inline(always)]
                || length(x, y, z) - p[0],
            )
        }),
        62 => (5, |x, y, z, p| {
            let ball = p[4] * (-p[3] * (x * x + y * y + z * z)).exp();
            -p[2] * (ball - folded(ellipsoids(x, y, z, p), N::add))
        }),
        63 => {
            (4, |x, y, z, p| y - p[0] * (p[1] * x).cos() * (p[2] * z).cos() * (-p[3] * (x * x + z * z)).exp())
        }
        64 => (6, |x, y, z, p| {
            let r = (x * x + z * z).sqrt();
            let x = off_axis(x, z, 1e-6);
            let r = r + p[0] * z.atan2(x) / TAU;
            let s = section(r.rem(p[0]) - p[0] / 2.0, y, p[5]);
            let d = (x * x + y * y + z * z).sqrt();
            -(p[2] - d).min(p[1] - s.min(d))
        }),
        68 => (2, |x, y, z, p| {
            let (around, along) = (N::constant(2.0) / p[0], N::constant(2.0) / p[1]);
            let ring = (x.abs().powf(around) + y.abs().powf(around)).powf(p[0] / p[1]);
            -(ring + z.abs().powf(along)).powf(p[1] * 0.5) + 1.0
        }),
        69 => (0, |x, _, z, _| x.atan2(z)),
        70 => (2, |x, y, z, p| {
            N::wide(
                #[inline(always)]
                || {
                    let out = (x * x + z * z).sqrt() - p[0];
                    (out * out + y * y).sqrt() - p[1]
                },
            )
        }),
        _ => return None,
    })
}

/// Distance from the origin.
#[inline(always)]
fn length<N: Number>(x: N, y: N, z: N) -> N {
    (x * x + y * y + z * z).sqrt()
}

/// x, or a little more on the y axis, where angles have no meaning.
fn off_axis<N: Number>(x: N, z: N, little: f64) -> N {
    if x.fixed() == Some(0.0) && z.fixed() == Some(0.0) { N::constant(little) } else { x }
}

/// The rest over a multiple of a whole turn, from 0 on.
fn turned<N: Number>(angle: N, turn: N) -> N {
    let rest = angle.rem(turn);
    rest.choose(rest + turn, rest)
}

/// E1, E2, E3 of the specification: three crossed ellipsoids.
fn ellipsoids<N: Number>(x: N, y: N, z: N, p: &[N]) -> [N; 3] {
    let (a, b, c) = (x * x, y * y, z * z);
    let ellipsoid = |a: N, b: N, c: N| (-p[1] * (a + b + c)).exp();
    [ellipsoid(p[0] * a, p[0] * b, c), ellipsoid(p[0] * a, b, p[0] * c), ellipsoid(a, p[0] * b, p[0] * c)]
}

fn folded<N: Number>([a, b, c]: [N; 3], with: fn(N, N) -> N) -> N {
    with(with(a, b), c)
}

fn comma<N: Number>(x: N, y: N, z: N, p: &[N]) -> N {
    let size = p[0];
    let x = off_axis(x, z, 0.0001);
    let angle = z.atan2(x);
    let from_quarter = ((x + size / 4.0).powi(2) + z * z).sqrt();
    let tail = size / 2.0 * (angle / 2.0).cos() - ((from_quarter - size * 3.0 / 4.0).powi(2) + y * y).sqrt();
    let head = size / 2.0 - ((x - size / 2.0).powi(2) + y * y + z * z).sqrt();
    -z.min(tail).max(head)
}

fn helical_torus<N: Number>(x: N, y: N, z: N, p: &[N]) -> N {
    let distance = (x * x + z * z).sqrt();
    let x = off_axis(x, z, 1e-6);
    let angle = x.atan2(z);
    let r = ((distance - p[0]).powi(2) + y * y).sqrt();
    let t = turned(angle * p[1] + p[2] * (distance - p[0]).atan2(y), N::constant(TAU)) - PI;
    let ripple = p[3] * (p[7] * (t * p[8]).atan2(r - p[5]) + angle * p[9]).cos();
    let winding = p[4] + ripple - ((r - p[5]).powi(2) + t * t * p[6]).sqrt().min(r + p[5]);
    -(p[4] + p[5] - p[0] - distance).max(winding)
}

fn helix1<N: Number>(x: N, y: N, z: N, p: &[N]) -> N {
    let r = (x * x + z * z).sqrt();
    let x = off_axis(x, z, 1e-6);
    let turns = p[1] * p[0];
    let t = turned(p[0] * z.atan2(x) + y * turns, N::constant(TAU));
    let (mut out, mut up) = (r - p[3], (t - PI) / p[4] / turns);
    if p[5].fixed() != Some(1.0) && p[6].fixed() != Some(0.0) {
        let angle = p[6].unary(Unary::Radians);
        let (sin, cos) = (angle.sin(), angle.cos());
        (out, up) = (out * cos - up * sin, out * sin + up * cos);
    }
    (p[3] + r).min(section(out, up, p[5])) - p[2]
}

fn helix2<N: Number>(x: N, y: N, z: N, p: &[N]) -> N {
    let angle = y * p[1];
    let (sin, cos) = (angle.sin(), angle.cos());
    let (a, b) = (x - p[3] * cos, z - p[3] * sin);
    section(a * cos + b * sin, b * cos - a * sin, p[5]) - p[2]
}

/// The two coordinates in a floor of hexagons.
fn hexagon<N: Number>(x: N, y: N) -> (N, N) {
    let half = 3_f64.sqrt() / 2.0;
    let a = (x.abs().rem(N::constant(2.0 * half)) - half).abs();
    let b = (y.abs().rem(N::constant(3.0)) - 1.5).abs();
    // The nearer of two neighbours' middles.
    let farther = (-a + half).powi(2) + (-b + 1.5).powi(2) - (a * a + b * b);
    let (a, b) = (farther.choose(-a + half, a), farther.choose(-b + 1.5, b));
    let (sin, cos) = FRAC_PI_3.sin_cos();
    let beyond = b.atan2(a) - FRAC_PI_6;
    (beyond.choose(a, a * cos + b * sin), beyond.choose(b, (b * cos - a * sin).abs()))
}

fn mesh1<N: Number>(x: N, y: N, z: N, p: &[N]) -> N {
    let thread = |v: N, half: N| p[2] * (turned(v, half * 2.0) - half).abs();
    let wave = |v: N, period: N| (v * PI / period).cos() * p[3];
    let (k, l) = (wave(z, p[1]), wave(x, p[0]));
    let distance = |height: N, across: N| (height * p[4]).hypot(across);
    distance(y - k, thread(x, p[0]))
        .min(distance(y + k, thread(x - p[0], p[0])))
        .min(distance(y + l, thread(z, p[1])))
        .min(distance(y - l, thread(z - p[1], p[1])))
}
