//! `tiling 25` … `tiling 27`: Penrose's floors, by walking down the substitution
//! (docs/spec/patterns-textures.md 2.7.2). The plane is taken as complex numbers x + iz.
//!
//! All is written for numbers and for bands: these go both ways where it isn't sure on which side of a line they are.

use crate::math::noise::EPSILON;
use crate::math::{Band, DVec2, DVec3};
use crate::world::function::{Number, Unary};

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
        let w = self.in_first_tenth(w.to_array());
        self.after(self.steps(self.reach(w)), w)
    }

    /// What holds the values at all points that these hold.
    pub(super) fn along(self, [x, _, z]: &[Band; 3]) -> Band {
        Band::by_lanes([*x, *z], |w| {
            let spread = w.map(|c| c.spread().0[0]);
            let near = w.iter().all(|c| c.high().0[0] < FAR && c.low().0[0] > -FAR);
            if !(near && spread[0].max(spread[1]) < WIDEST) {
                return Band::between(0.0, 1.0);
            }
            let from_origin = length(w).low().0[0];
            let w = self.in_first_tenth(w);
            let reach = self.reach(w);
            // More steps than are needed end in the same tile.
            let steps = [reach.low(), reach.high()].map(|bound| self.steps(bound.0[0]));
            let all = (steps[0]..=steps[1]).map(|n| self.after(n, w)).reduce(Band::hull);
            let all = all.unwrap_or(Band::UNKNOWN);
            if from_origin <= EPSILON { all.hull(Band::constant(1.0)) } else { all }
        })
    }

    /// A tenth of the plane, scaled.
    fn in_first_tenth<N: Number>(self, w: [N; 2]) -> [N; 2] {
        let w = five_fold(w);
        if self == Self::Rhombs { w.map(|c| c * Q) } else { w }
    }

    /// How far from the tile at the origin a place is.
    fn reach<N: Number>(self, [x, z]: [N; 2]) -> N {
        match self {
            Self::Pentagons => x * 2.0 * tangent(36.0),
            Self::KitesAndDarts | Self::Rhombs => x + z * cosine(72.0) / sine(72.0),
        }
    }

    /// How many substitution steps reach from the tile at the origin to distance `d`.
    fn steps(self, d: f64) -> i32 {
        let growth = if self == Self::Pentagons { PHI.powi(4) } else { PHI * PHI };
        (d.ln() / growth.ln()).ceil().max(0.0) as i32
    }

    /// The value by so many steps.
    fn after<N: Number>(self, n: i32, w: [N; 2]) -> N {
        if self == Self::Pentagons {
            return pentagons(Piece::A, w.map(|c| c * Q.powi(4 * n)), 4 * n);
        }
        let mut w = w.map(|c| c * Q.powi(2 * n));
        if n % 2 == 1 {
            w = times(w, e(-36.0));
        }
        halves(Half::Kite, w, 2 * n, self == Self::Rhombs)
    }
}

/// The longest stretch, to either side of its middle, of which bands say something.
const WIDEST: f64 = 1.0;

/// Places up to here.
const FAR: f64 = 1e9;

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
fn times<N: Number>([x, z]: [N; 2], v: DVec2) -> [N; 2] {
    [x * v.x - z * v.y, z * v.x + x * v.y]
}

fn plus<N: Number>([x, z]: [N; 2], v: DVec2) -> [N; 2] {
    [x + v.x, z + v.y]
}

/// Plus a real number.
fn right<N: Number>([x, z]: [N; 2], by: f64) -> [N; 2] {
    [x + by, z]
}

/// The negative conjugate, plus a real number.
fn mirrored<N: Number>([x, z]: [N; 2], by: f64) -> [N; 2] {
    [-x + by, z]
}

fn length<N: Number>([x, z]: [N; 2]) -> N {
    (x.unary(Unary::Square) + z.unary(Unary::Square)).sqrt()
}

fn fold<N: Number>([x, z]: [N; 2]) -> [N; 2] {
    [x, z.abs()]
}

/// Into one tenth of the plane.
fn five_fold<N: Number>(w: [N; 2]) -> [N; 2] {
    let w = fold(w);
    let r = length(w);
    let turned = |degrees: f64| fold(times(w, e(degrees)));
    let (beyond_first, beyond_second) = (w[0] - r * cosine(36.0), w[0] - r * cosine(108.0));
    let (second, third) = (turned(-72.0), turned(-144.0));
    [0, 1].map(|i| beyond_first.pick(|| beyond_second.pick(|| third[i], || second[i]), || w[i]))
}

/// Distance to the line through the real point `p` in the direction of `degrees`.
fn distance<N: Number>([x, z]: [N; 2], p: f64, degrees: f64) -> N {
    ((x - p) * sine(degrees) - z * cosine(degrees)).abs()
}

/// How far above the line through the real point `p` in the direction of `degrees`.
fn above<N: Number>([x, z]: [N; 2], p: f64, degrees: f64) -> N {
    z - (x - p) * tangent(degrees)
}

#[derive(Clone, Copy, PartialEq)]
enum Half {
    Kite,
    Dart,
}

/// Kites and darts, and rhombs cut into the same halves: the value after so many more steps.
fn halves<N: Number>(half: Half, w: [N; 2], left: i32, rhombs: bool) -> N {
    let w = fold(w);
    if left > 0 {
        let to = |half: Half, w: [N; 2]| halves(half, w.map(|c| c * PHI), left - 1, rhombs);
        return match half {
            Half::Kite => above(w, Q, 144.0)
                .pick(|| to(Half::Dart, w), || to(Half::Kite, times(plus(w, -e(36.0)), e(108.0)))),
            Half::Dart => above(w, Q, 108.0).pick(
                || to(Half::Kite, times(w, e(-36.0))),
                || to(Half::Dart, times(right(w, -1.0), e(-144.0))),
            ),
        };
    }
    let slope = if rhombs { 5.55 } else { 4.46 };
    let bound = N::constant;
    let fall = |a: N, b: N| a.min(b) * slope / 2.0;
    let lower = |a: N, b: N| (-fall(a, b) + 0.5).max(bound(0.0)).min(bound(0.5 - 1e-6));
    let upper = |a: N, b: N| (-fall(a, b) + 1.0).max(bound(0.5 + 1e-6));
    match (half, rhombs) {
        (Half::Kite, false) => lower(distance(w, 0.0, 36.0), distance(w, 1.0, 108.0)),
        (Half::Dart, false) => upper(w[1], distance(w, 1.0, 144.0)),
        (Half::Kite, true) => above(w, Q, 72.0).pick(
            || upper(distance(w, Q, 72.0), distance(w, 1.0, 108.0)),
            || lower(w[1], distance(w, Q, 72.0)),
        ),
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

/// The value in a piece after so many more steps.
fn pentagons<N: Number>(piece: Piece, w: [N; 2], left: i32) -> N {
    let w = if matches!(piece, Piece::A) { five_fold(w) } else { fold(w) };
    if left > 0 {
        return substitute(piece, w, |piece, w| pentagons(piece, w.map(|c| c * PHI), left - 1));
    }
    let inner = 1.0 / (2.0 * tangent(36.0));
    let rho = 1.0 / (2.0 * sine(36.0));
    let side = || (five_fold(w)[0] - inner).abs();
    let star = |w: [N; 2]| distance(w, PHI * rho, 162.0);
    let (band, d) = match piece {
        Piece::A => (1.0, side()),
        Piece::B0 | Piece::B1 => (2.0, side()),
        Piece::C0 | Piece::C1 => (3.0, side()),
        Piece::S => (4.0, star(w)),
        Piece::T0 | Piece::T1 => {
            let edge = (w[0] - Q * cosine(72.0) * rho).abs();
            (5.0, edge.min(star(five_fold(mirrored(w, 0.0)))))
        }
        Piece::D0 | Piece::D1 => (6.0, ((w[0] + Q * rho) * sine(18.0) - w[1] * cosine(18.0)).abs()),
    };
    let least = (band - 1.0) / 6.0 + if band == 1.0 { 0.0 } else { 1e-6 };
    let [least, most] = [least, band / 6.0 - 1e-6].map(N::constant);
    (-(d * (5.55 * Q) / 6.0) + band / 6.0).max(least).min(most)
}

/// What comes of the smaller piece that `w` is in, and `w` seen from it.
fn substitute<N: Number>(piece: Piece, w: [N; 2], to: impl Fn(Piece, [N; 2]) -> N) -> N {
    let rho = 1.0 / (2.0 * sine(36.0));
    let inner = 1.0 / (2.0 * tangent(36.0));
    let c = cosine(72.0);
    let x = w[0];
    // -ū - ρ e(72), where u is w turned.
    let flipped = |degrees| plus(mirrored(times(w, e(degrees)), 0.0), -rho * e(72.0));
    let turned = |degrees| times(w, e(degrees));
    match piece {
        Piece::A => (above(w, inner, 54.0) - 0.5)
            .pick(|| to(Piece::B0, right(w, -(inner + Q * c * rho))), || to(Piece::S, turned(-36.0))),
        Piece::B0 => above(w, -rho, 18.0)
            .pick(|| to(Piece::D0, right(w, rho - Q * Q * rho)), || to(Piece::C0, flipped(-36.0))),
        Piece::B1 => above(w, Q * Q * rho, 54.0).pick(
            || to(Piece::A, right(w, -rho)),
            || {
                above(w, Q * Q * rho, 162.0)
                    .pick(|| to(Piece::D1, mirrored(w, 0.0)), || to(Piece::B1, right(turned(108.0), Q * rho)))
            },
        ),
        Piece::C0 => (x + c * rho).pick(
            || to(Piece::B0, right(turned(-144.0), -rho)),
            || (-above(w, Q * Q * rho, 126.0)).pick(|| to(Piece::C0, flipped(36.0)), || to(Piece::T0, w)),
        ),
        Piece::C1 => (-x + Q * Q * c * rho)
            .pick(|| to(Piece::B1, mirrored(w, Q * Q * c * rho + Q * inner)), || to(Piece::T1, w)),
        Piece::S => (x - Q * inner).pick(|| to(Piece::A, w), || to(Piece::C1, mirrored(w, 2.0 * Q * inner))),
        Piece::T0 => to(Piece::C1, right(turned(72.0), rho)),
        Piece::T1 => {
            (-x - PHI * c * rho).pick(|| to(Piece::A, mirrored(w, 0.0)), || to(Piece::C1, right(w, rho)))
        }
        Piece::D0 => to(Piece::C1, w),
        Piece::D1 => to(Piece::A, w),
    }
}
