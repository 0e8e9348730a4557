//! `tiling 25` … `tiling 27`: Penrose's floors, by walking down the substitution
//! (docs/spec/patterns-textures.md 2.7.2). The plane is taken as complex numbers x + iz.

use crate::math::noise::EPSILON;
use crate::math::{DVec2, DVec3};

/// Golden ratio and its inverse.
const PHI: f64 = 1.618_033_988_749_895;
const Q: f64 = PHI - 1.0;

/// One of Penrose's tilings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Penrose {
    /// `tiling 25`.
    Pentagons,
    /// `tiling 26`.
    KitesAndDarts,
    /// `tiling 27`.
    Rhombs,
}

impl Penrose {
    /// `None` where this number is not one of Penrose's.
    pub fn new(number: u32) -> Option<Self> {
        match number {
            25 => Some(Self::Pentagons),
            26 => Some(Self::KitesAndDarts),
            27 => Some(Self::Rhombs),
            _ => None,
        }
    }

    pub(super) fn value(self, p: DVec3) -> f64 {
        let w = DVec2::new(p.x, p.z);
        if w.length() <= EPSILON {
            return 1.0;
        }
        match self {
            Self::Pentagons => pentagons(w),
            Self::KitesAndDarts => halves(w, false),
            Self::Rhombs => halves(w, true),
        }
    }
}

/// e(a): the unit number at `degrees`.
fn e(degrees: f64) -> DVec2 {
    DVec2::from_angle(degrees.to_radians())
}

fn sine(degrees: f64) -> f64 {
    degrees.to_radians().sin()
}

fn cosine(degrees: f64) -> f64 {
    degrees.to_radians().cos()
}

fn tangent(degrees: f64) -> f64 {
    degrees.to_radians().tan()
}

/// The product of complex numbers.
fn times(u: DVec2, v: DVec2) -> DVec2 {
    u.rotate(v)
}

fn real(x: f64) -> DVec2 {
    DVec2::new(x, 0.0)
}

fn conjugate(w: DVec2) -> DVec2 {
    DVec2::new(w.x, -w.y)
}

fn fold(w: DVec2) -> DVec2 {
    DVec2::new(w.x, w.y.abs())
}

/// Into one tenth of the plane.
fn five_fold(w: DVec2) -> DVec2 {
    let w = fold(w);
    let r = w.length();
    if w.x >= r * cosine(36.0) {
        return w;
    }
    fold(times(w, e(if w.x < r * cosine(108.0) { -144.0 } else { -72.0 })))
}

/// Distance to the line through the real point `p` in the direction of `degrees`.
fn distance(w: DVec2, p: f64, degrees: f64) -> f64 {
    (sine(degrees) * (w.x - p) - cosine(degrees) * w.y).abs()
}

/// How many substitution steps reach from the tile at the origin to distance `d`.
fn steps(d: f64, growth: f64) -> i32 {
    (d.ln() / growth.ln()).ceil().max(0.0) as i32
}

/// Kites and darts, and rhombs cut into the same halves.
fn halves(w: DVec2, rhombs: bool) -> f64 {
    #[derive(PartialEq)]
    enum Half {
        Kite,
        Dart,
    }
    let mut w = five_fold(w);
    if rhombs {
        w *= Q;
    }
    let n = steps(w.x + w.y * cosine(72.0) / sine(72.0), PHI * PHI);
    w *= Q.powi(2 * n);
    if n % 2 == 1 {
        w = times(w, e(-36.0));
    }
    let mut half = Half::Kite;
    for _ in 0..2 * n {
        w = fold(w);
        (half, w) = match half {
            Half::Kite if w.y < (w.x - Q) * tangent(144.0) => (Half::Dart, PHI * w),
            Half::Kite => (Half::Kite, PHI * times(e(108.0), w - e(36.0))),
            Half::Dart if w.y < (w.x - Q) * tangent(108.0) => (Half::Kite, PHI * times(e(-36.0), w)),
            Half::Dart => (Half::Dart, PHI * times(e(-144.0), w - DVec2::X)),
        };
    }
    w = fold(w);
    let slope = if rhombs { 5.55 } else { 4.46 };
    let lower = |a: f64, b: f64| (0.5 - slope * a.min(b) / 2.0).clamp(0.0, 0.5 - 1e-6);
    let upper = |a: f64, b: f64| (1.0 - slope * a.min(b) / 2.0).max(0.5 + 1e-6);
    match (half, rhombs) {
        (Half::Kite, false) => lower(distance(w, 0.0, 36.0), distance(w, 1.0, 108.0)),
        (Half::Dart, false) => upper(w.y, distance(w, 1.0, 144.0)),
        (Half::Kite, true) if w.y < (w.x - Q) * tangent(72.0) => {
            upper(distance(w, Q, 72.0), distance(w, 1.0, 108.0))
        }
        (Half::Kite, true) => lower(w.y, distance(w, Q, 72.0)),
        (Half::Dart, true) => lower(distance(w, 0.0, 36.0), distance(w, 1.0, 144.0)),
    }
}

/// A piece of the pentagon tiling; the names are those of the specification's table.
#[derive(Clone, Copy)]
enum Piece {
    A,
    B0,
    B1,
    C0,
    C1,
    S,
    T0,
    T1,
    D0,
    D1,
}

fn pentagons(w: DVec2) -> f64 {
    let inner = 1.0 / (2.0 * tangent(36.0));
    let mut w = five_fold(w);
    let n = steps(2.0 * w.x * tangent(36.0), PHI.powi(4));
    w *= Q.powi(4 * n);
    let mut piece = Piece::A;
    for _ in 0..4 * n {
        (piece, w) = substitute(piece, folded(piece, w));
    }
    w = folded(piece, w);
    let rho = 1.0 / (2.0 * sine(36.0));
    let side = |w: DVec2| (five_fold(w).x - inner).abs();
    let star = |w: DVec2| distance(w, PHI * rho, 162.0);
    let (band, d) = match piece {
        Piece::A => (1.0, side(w)),
        Piece::B0 | Piece::B1 => (2.0, side(w)),
        Piece::C0 | Piece::C1 => (3.0, side(w)),
        Piece::S => (4.0, star(w)),
        Piece::T0 | Piece::T1 => {
            let edge = (w.x - Q * cosine(72.0) * rho).abs();
            (5.0, edge.min(star(five_fold(-conjugate(w)))))
        }
        Piece::D0 | Piece::D1 => (6.0, (sine(18.0) * (w.x + Q * rho) - cosine(18.0) * w.y).abs()),
    };
    let least = (band - 1.0) / 6.0 + if band == 1.0 { 0.0 } else { 1e-6 };
    (band / 6.0 - 5.55 * Q * d / 6.0).max(least).min(band / 6.0 - 1e-6)
}

fn folded(piece: Piece, w: DVec2) -> DVec2 {
    if matches!(piece, Piece::A) { five_fold(w) } else { fold(w) }
}

/// The smaller piece that `w` is in, and `w` seen from it.
fn substitute(piece: Piece, w: DVec2) -> (Piece, DVec2) {
    let rho = 1.0 / (2.0 * sine(36.0));
    let inner = 1.0 / (2.0 * tangent(36.0));
    let c = cosine(72.0);
    let (x, z) = (w.x, w.y);
    let bar = conjugate(w);
    // -ū - ρ e(72), where u is w turned.
    let flipped = |degrees| -conjugate(times(e(degrees), w)) - rho * e(72.0);
    let (next, moved) = match piece {
        Piece::A if z < (x - inner) * tangent(54.0) + 0.5 => (Piece::B0, w - real(inner + Q * c * rho)),
        Piece::A => (Piece::S, times(e(-36.0), w)),
        Piece::B0 if z < (x + rho) * tangent(18.0) => (Piece::D0, w + real(rho - Q * Q * rho)),
        Piece::B0 => (Piece::C0, flipped(-36.0)),
        Piece::B1 if z < (x - Q * Q * rho) * tangent(54.0) => (Piece::A, w - real(rho)),
        Piece::B1 if z < (x - Q * Q * rho) * tangent(162.0) => (Piece::D1, -bar),
        Piece::B1 => (Piece::B1, times(e(108.0), w) + real(Q * rho)),
        Piece::C0 if x < -c * rho => (Piece::B0, times(e(-144.0), w) - real(rho)),
        Piece::C0 if z > (x - Q * Q * rho) * tangent(126.0) => (Piece::C0, flipped(36.0)),
        Piece::C0 => (Piece::T0, w),
        Piece::C1 if x > Q * Q * c * rho => (Piece::B1, real(Q * Q * c * rho + Q * inner) - bar),
        Piece::C1 => (Piece::T1, w),
        Piece::S if x < Q * inner => (Piece::A, w),
        Piece::S => (Piece::C1, real(2.0 * Q * inner) - bar),
        Piece::T0 => (Piece::C1, times(e(72.0), w) + real(rho)),
        Piece::T1 if x > -PHI * c * rho => (Piece::A, -bar),
        Piece::T1 => (Piece::C1, w + real(rho)),
        Piece::D0 => (Piece::C1, w),
        Piece::D1 => (Piece::A, w),
    };
    (next, PHI * moved)
}
