//! Patterns along lines: bounds of their values, for surfaces that are made of them.
//!
//! Where there is no surface yet: `slope` and `aoi` are 0.

use std::f64::consts::{PI, TAU};

use super::noise::WRINKLES;
use super::{
    Formula, PERIOD, Pattern, Wave, agate, cells, hexagon, quilted, ripples, simple, triangular, wood,
};
use crate::math::noise::EPSILON;
use crate::math::{Band, DVec3, Lanes};

/// A point.
type Point = [Band; 3];

const ZERO: Band = Band::constant(0.0);
const ONE: Band = Band::constant(1.0);

impl Pattern {
    /// Whether [`Pattern::along`] says something.
    pub(super) fn is_held(&self) -> bool {
        self.formula.is_held()
    }

    /// What holds the finished values at all points that these hold, with these texture coordinates.
    pub(super) fn along(&self, point: &Point, uv: &[Band; 2]) -> Band {
        let mut v = self.formula.along(&self.warps.along(*point), uv);
        let mut positive = self.formula.is_positive();
        let is_plain = self.frequency == 1.0 && self.phase == 0.0 && self.formula.is_within_one();
        if self.frequency != 0.0 && !is_plain {
            v = (v * self.frequency + self.phase).remainder(Band::constant(PERIOD));
            positive &= self.frequency > 0.0 && self.phase >= 0.0;
        }
        if !positive {
            let all = v.max(ZERO).hull(Band::between(0.0, 1.0));
            v = v.where_positive(v.low() + f64::MIN_POSITIVE, (v - v.floor()).where_positive(-v.high(), all));
        }
        match self.wave {
            Wave::Ramp => v,
            Wave::Triangle => -(v.remainder(ONE) * 2.0 - 1.0).abs() + 1.0,
            Wave::Sine => (v.cycle() + 1.0) * 0.5,
            Wave::Scallop => (v * 0.5).cycle().abs(),
            Wave::Cubic => v * v * (v * -2.0 + 3.0),
            Wave::Poly(exponent) => v.powf(Band::constant(exponent)),
        }
    }
}

impl Formula {
    fn is_held(&self) -> bool {
        match self {
            Self::Function(field) | Self::Pigment(field) => field.is_known(),
            _ => true,
        }
    }

    /// Whether raw values are never negative.
    fn is_positive(&self) -> bool {
        !matches!(
            self,
            Self::Fractal(_)
                | Self::Function(_)
                | Self::Gradient(_)
                | Self::Marble(_)
                | Self::Pigment(_)
                | Self::Spiral1(_)
                | Self::Waves(_)
        )
    }

    /// Whether raw values are from 0 to 1, for sure; there may be others of which they are.
    fn is_within_one(&self) -> bool {
        matches!(
            self,
            Self::Boxed
                | Self::Bozo(_)
                | Self::Bumps(_)
                | Self::Crackle(_)
                | Self::Cylindrical
                | Self::Planar
                | Self::Spherical
        )
    }

    fn along(&self, p: &Point, uv: &[Band; 2]) -> Band {
        let [x, y, z] = *p;
        match self {
            Self::Agate(agate) => agate.along(p),
            Self::Aoi | Self::Average | Self::Facets(_) | Self::Slope(_) => ZERO,
            Self::Boxed => fall(x.abs().max(y.abs()).max(z.abs())),
            Self::Bozo(generator) | Self::Bumps(generator) => Band::noise(*generator, *p),
            Self::Brick(brick) => brick.along(p),
            Self::Cells => in_cells(p, [0.0, 1.0], cells::value),
            Self::Checker => in_cells(p, [0.0, 1.0], simple::checker),
            Self::Crackle(crackle) => crackle.along(p),
            Self::Cubic => cube_face(p),
            Self::Cylindrical => fall((x.square() + z.square()).sqrt()),
            Self::DensityFile(file) => file.along(p),
            Self::Dents(generator) => {
                let n = Band::noise(*generator, *p);
                n * n * n
            }
            Self::Fractal(fractal) => fractal.along(p),
            Self::Function(function) => fold(function.enclose(p)),
            Self::Gradient(d) => fold(x * d.x + y * d.y + z * d.z),
            Self::Granite(generator) => granite(*generator, p),
            Self::Hexagon => hexagon::along(p),
            Self::Image(map) => map.pattern_along(p),
            Self::Leopard => {
                let wave = (x.sin_cos().0 + y.sin_cos().0 + z.sin_cos().0) * (1.0 / 3.0);
                wave.square()
            }
            Self::Marble(marble) => marble.along(p),
            Self::Object(object) => object.enclose(p),
            Self::Onion => length(p).remainder(ONE),
            Self::Pavement(pavement) => pavement.along(p),
            Self::Penrose(penrose) => penrose.along(p),
            Self::Pigment(pigment) => pigment.enclose_mapped(p, uv),
            Self::Planar => fall(y.abs()),
            Self::Quilted(quilted) => quilted.along(p),
            Self::Radial => radial(p),
            Self::Ripples(ripples) => ripples.ripples_along(p),
            Self::Spherical => fall(length(p)),
            Self::Spiral1(spiral) => spiral.single_along(p),
            Self::Spiral2(spiral) => spiral.double_along(p),
            Self::Square => in_cells(&[x, ZERO, z], [0.0, 3.0], simple::square),
            Self::Tiling(tiling) => tiling.along(p),
            Self::Triangular => triangular::along(p),
            Self::Waves(ripples) => ripples.waves_along(p),
            Self::Wood(wood) => wood.along(p),
            Self::Wrinkles(generator) => wrinkles(*generator, p),
        }
    }
}

/// So many unit cubes are looked at one by one.
const CUBES: f64 = 27.0;

/// Coordinates up to here have cubes with numbers of 32 bits.
const FAR: f64 = 1e9;

/// A pattern that has one value in every unit cube, and what all of them are between.
fn in_cells(p: &Point, [least, most]: [f64; 2], value: impl Fn(DVec3) -> f64) -> Band {
    let room = 2.0 * EPSILON;
    let (low, high) =
        (p.map(|c| (c.low() - room).map(f64::floor)), p.map(|c| (c.high() + room).map(f64::floor)));
    let bounds: [[f64; 2]; Lanes::COUNT] = std::array::from_fn(|lane| {
        let (from, to) = (low.map(|c| c.0[lane]), high.map(|c| c.0[lane]));
        let count: f64 = (0..3).map(|i| to[i] - from[i] + 1.0).product();
        let near = from.iter().chain(&to).all(|c| c.abs() < FAR);
        if !(near && count <= CUBES) {
            return [least, most];
        }
        let mut bounds = [f64::INFINITY, f64::NEG_INFINITY];
        let steps =
            |i: usize| (0..=(to[i] - from[i]) as u32).map(move |step| from[i] + f64::from(step) + 0.5);
        for x in steps(0) {
            for y in steps(1) {
                for z in steps(2) {
                    let v = value(DVec3::new(x, y, z));
                    bounds = [bounds[0].min(v), bounds[1].max(v)];
                }
            }
        }
        bounds
    });
    Band::within(Lanes(bounds.map(|[low, _]| low)), Lanes(bounds.map(|[_, high]| high)))
}

/// Beside the edge of what is on a floor either side is meant.
pub(super) const BESIDE: f64 = 1e-9;

/// So many cells of a floor are looked at one by one.
const FLOOR_CELLS: f64 = 36.0;

/// A pattern made of unit squares: what all values are between, and those near the square with these numbers, which
/// are the same in all lanes.
pub(super) fn on_floor(
    at: [Band; 2],
    [least, most]: [f64; 2],
    value: impl Fn([Band; 2], [f64; 2]) -> Band,
) -> Band {
    Band::by_lanes(at, |at| {
        let from = at.map(|c| (c.low().0[0] - BESIDE).floor());
        let to = at.map(|c| (c.high().0[0] + BESIDE).floor());
        let count = (to[0] - from[0] + 1.0) * (to[1] - from[1] + 1.0);
        let near = from.iter().chain(&to).all(|c| c.abs() < FAR);
        if !(near && count <= FLOOR_CELLS) {
            return Band::between(least, most);
        }
        let steps = |i: usize| (0..=(to[i] - from[i]) as u32).map(move |step| from[i] + f64::from(step));
        let squares = steps(0).flat_map(|column| steps(1).map(move |row| [column, row]));
        squares.map(|square| value(at, square)).reduce(Band::hull).unwrap_or(Band::UNKNOWN)
    })
}

/// The numbers of the faces of a cube that a place may be seen on.
fn cube_face([x, y, z]: &Point) -> Band {
    let most = x.abs().max(y.abs()).max(z.abs());
    let (mut low, mut high) = (Lanes::splat(5.0), Lanes::ZERO);
    for (number, height) in (0..).zip([*x, *y, *z, -*x, -*y, -*z]) {
        let may = (height - most).high() + f64::MIN_POSITIVE;
        let number = Lanes::splat(f64::from(number));
        low = low.zip(number, f64::min).where_positive(may, low);
        high = high.zip(number, f64::max).where_positive(may, high);
    }
    Band::within(low, high)
}

impl quilted::Quilted {
    fn along(&self, p: &Point) -> Band {
        // From the middle of the cushion; where it may be another's, as far as from the seam.
        let v = p.map(|c| {
            let cell = c.floor();
            let from_seam = -(c - (c + 0.5).floor()).abs() + 0.5;
            from_seam.where_positive(cell.reach, (c - cell - 0.5).abs())
        });
        let t = length(&v);
        let s = -t + 1.0;
        let profile = t * t * t + t * (s * s) * (3.0 * self.control0) + (t * t) * s * (3.0 * self.control1);
        profile.abs() * (v[0] + v[1] + v[2]) * (1.154700538 / 3.0)
    }
}

fn length([x, y, z]: &Point) -> Band {
    (x.square() + y.square() + z.square()).sqrt()
}

fn fall(distance: Band) -> Band {
    -distance.max(ZERO).min(ONE) + 1.0
}

/// Values over 1 start again at 0; negative ones stay.
fn fold(v: Band) -> Band {
    let over = v.low() - 1.0;
    if (-v.high() + 1.0).all_positive() {
        return v;
    }
    let both = v.min(ONE).hull(Band::between(0.0, 1.0));
    v.where_positive(-v.high() + 1.0, v.remainder(ONE).where_positive(over, both))
}

fn granite(generator: u8, p: &Point) -> Band {
    let mut sum = ZERO;
    for octave in 0..6 {
        let scale = f64::from(1 << octave);
        let n = Band::noise(generator, p.map(|c| c * (4.0 * scale)));
        let folded =
            if generator <= 1 { (n - 0.5).abs() } else { (n * 2.0 - 1.0).abs().min(Band::constant(0.5)) };
        sum = sum + folded * (1.0 / scale);
    }
    sum
}

fn wrinkles(generator: u8, p: &Point) -> Band {
    let mut sum = ZERO;
    for scale in WRINKLES {
        let n = Band::noise(generator, p.map(|c| c * scale));
        let height = if generator <= 1 { n } else { (n * 2.0 - 0.5).max(ZERO).min(ONE) };
        sum = sum + height * (1.0 / scale);
    }
    sum * 0.5
}

/// Near the axis the pattern has a value of its own.
fn radial([x, _, z]: &Point) -> Band {
    let angle = (x.atan2(*z) + PI) * (1.0 / TAU) + 0.25;
    let off_axis = (x.abs().max(z.abs()) - 0.001).low();
    angle.where_positive(off_axis, Band::between(0.25, 1.25))
}

impl agate::Agate {
    fn along(&self, p: &Point) -> Band {
        let t = match self.strength {
            0.0 => ZERO,
            strength => self.octaves.scalar_along(self.generator, *p) * strength,
        };
        let n = ((t * 1.3 + p[2] * 1.1).cycle() + 1.0) * 0.5;
        n.max(ZERO).min(ONE).powf(Band::constant(0.77))
    }
}

impl agate::Marble {
    fn along(&self, p: &Point) -> Band {
        match self.turbulence {
            Some(t) => p[0] + t.octaves.scalar_along(t.generator, *p) * t.amount.x,
            None => p[0],
        }
    }
}

impl wood::Wood {
    fn along(&self, p: &Point) -> Band {
        let [mut x, mut y, _] = *p;
        if let Some(t) = self.turbulence {
            let [dx, dy, _] = t.octaves.vector_along(*p);
            (x, y) = (((x + dx) * t.amount.x).cycle() + x, ((y + dy) * t.amount.y).cycle() + y);
        }
        (x.square() + y.square()).sqrt()
    }
}

impl ripples::Ripples {
    fn sum(&self, p: &Point, height: impl Fn(Band, f64) -> Band) -> Band {
        let mut sum = ZERO;
        for source in self.sources.iter() {
            let away = length(&[p[0] - source.center.x, p[1] - source.center.y, p[2] - source.center.z]);
            // At the source itself the distance counts as 1.
            let away = away.where_positive(away.low(), away.hull(ONE));
            sum = sum + height(away, source.frequency);
        }
        sum * (1.0 / self.sources.len() as f64)
    }

    fn ripples_along(&self, p: &Point) -> Band {
        (self.sum(p, |away, _| (away * self.frequency + self.phase).cycle()) + 1.0) * 0.5
    }

    fn waves_along(&self, p: &Point) -> Band {
        let height = |away: Band, f: f64| (away * (self.frequency * f) + self.phase).cycle() * (1.0 / f);
        (self.sum(p, height) + 2.5) * 0.2
    }
}

#[cfg(test)]
mod tests;
