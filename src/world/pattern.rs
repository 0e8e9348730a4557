//! Patterns: a point becomes a number (docs/spec/patterns-textures.md 2).

pub mod agate;
mod along;
pub mod brick;
pub mod cells;
pub mod crackle;
pub mod density_file;
pub mod falloff;
mod four;
pub mod hexagon;
pub mod mandel;
pub mod noise;
pub mod pavement;
pub mod penrose;
pub mod quilted;
pub mod ripples;
pub mod simple;
pub mod slope;
pub mod spiral;
pub mod tiling;
pub mod triangular;
pub mod wood;

#[cfg(test)]
mod tests;

use std::sync::Arc;

use super::image::ImageMap;
use super::sample::{Field, Inside, Sample, Samples};
use super::warp::Warps;
use crate::math::noise::{EPSILON, cycle, triangle};
use crate::math::{Band, DVec3, Lanes, tally};
use crate::world::warp::mapping::cube_face;

/// A pattern with its way in and its finishing step.
#[derive(Clone, Debug)]
pub struct Pattern {
    /// Moves the point first.
    pub warps: Warps,
    /// Gives the raw value.
    pub formula: Formula,
    /// 0 keeps the raw value.
    pub frequency: f64,
    /// Added after the frequency.
    pub phase: f64,
    /// Shape of a period.
    pub wave: Wave,
}

/// The shape of a pattern's period.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the language's own words")]
pub enum Wave {
    Ramp,
    Triangle,
    Sine,
    Scallop,
    Cubic,
    /// With its exponent.
    Poly(f64),
}

/// What gives a pattern's raw value.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "the language's own words")]
pub enum Formula {
    Agate(agate::Agate),
    Aoi,
    /// Has no value of its own: whoever holds it weighs all entries of its map.
    Average,
    Boxed,
    /// `bozo` and `spotted`, with the noise generator.
    Bozo(u8),
    Brick(brick::Brick),
    /// As a number the same as `bozo`; normals differ.
    Bumps(u8),
    Cells,
    Checker,
    Crackle(Box<crackle::Crackle>),
    Cubic,
    Cylindrical,
    DensityFile(Box<density_file::DensityFile>),
    /// With the noise generator.
    Dents(u8),
    /// Bends normals only; as a number it is 0.
    Facets(Box<crackle::Facets>),
    Fractal(Box<mandel::Fractal>),
    Function(Arc<dyn Field>),
    /// Unit direction.
    Gradient(DVec3),
    /// With the noise generator.
    Granite(u8),
    Hexagon,
    Image(Box<ImageMap>),
    Leopard,
    Marble(agate::Marble),
    Object(Arc<dyn Inside>),
    Onion,
    Pavement(Box<pavement::Pavement>),
    Penrose(penrose::Penrose),
    Pigment(Arc<dyn Field>),
    Planar,
    Quilted(quilted::Quilted),
    Radial,
    Ripples(ripples::Ripples),
    Slope(Box<slope::Slope>),
    Spherical,
    Spiral1(spiral::Spiral),
    Spiral2(spiral::Spiral),
    Square,
    Tiling(tiling::Tiling),
    Triangular,
    Waves(ripples::Ripples),
    Wood(wood::Wood),
    /// With the noise generator.
    Wrinkles(u8),
}

/// What values start again at (docs/spec/patterns-textures.md 2.1).
const PERIOD: f64 = 1.00001;

impl Pattern {
    /// A formula as it is: no warps, the raw value.
    pub fn plain(formula: Formula) -> Self {
        Self { warps: Warps::default(), formula, frequency: 0.0, phase: 0.0, wave: Wave::Ramp }
    }

    /// Whether its value takes hardly any time to find.
    #[inline(always)]
    pub fn is_soon_known(&self) -> bool {
        let few = matches!(
            self.formula,
            Formula::Boxed
                | Formula::Cells
                | Formula::Checker
                | Formula::Cylindrical
                | Formula::Gradient(_)
                | Formula::Onion
                | Formula::Planar
                | Formula::Spherical
                | Formula::Square
        );
        few && self.warps.is_soon_gone()
    }

    /// The finished value at a point where it is one of the commonest that [is soon known](Self::is_soon_known), compiled
    /// together with what is around it.
    #[inline(always)]
    pub fn soon_value(&self, point: DVec3) -> Option<f64> {
        let raw = match &self.formula {
            Formula::Checker => simple::checker(self.warps.soon_point(point)?),
            Formula::Gradient(direction) => gradient(*direction, self.warps.soon_point(point)?),
            _ => return None,
        };
        tally::patterns(1);
        Some(self.finish(raw))
    }

    /// The finished value at the point the pattern sees, which has gone through `warps` already.
    pub fn value_at(&self, p: DVec3, sample: &Sample) -> f64 {
        tally::patterns(1);
        self.finish(self.formula.raw(p, sample))
    }

    /// Frequency, phase and wave (docs/spec/patterns-textures.md 2.1).
    #[inline(always)]
    fn finish(&self, raw: f64) -> f64 {
        let mut v = raw;
        if self.frequency != 0.0 {
            v = v * self.frequency + self.phase;
            // The remainder of what is less anyway is the same, but not as soon found.
            if v.abs() >= PERIOD || v.is_nan() {
                v %= PERIOD;
            }
        }
        if v < 0.0 {
            v -= v.floor();
        }
        if self.wave == Wave::Ramp { v } else { self.wave.of(v) }
    }
}

impl Wave {
    /// What becomes of a value from 0 to 1.
    fn of(self, v: f64) -> f64 {
        match self {
            Self::Ramp => v,
            Self::Triangle => triangle(v),
            Self::Sine => (1.0 + cycle(v)) * 0.5,
            Self::Scallop => cycle(v * 0.5).abs(),
            Self::Cubic => v * v * ((-2.0 * v) + 3.0),
            Self::Poly(exponent) => v.powf(exponent),
        }
    }
}

impl Field for Pattern {
    fn value(&self, sample: &Sample) -> f64 {
        self.value_at(self.warps.point(sample.point), sample)
    }

    fn four(&self, samples: &Samples) -> Lanes {
        self.values(samples)
    }

    fn enclose(&self, point: &[Band; 3]) -> Band {
        self.along(point, &[point[0], point[1]])
    }

    fn enclose_mapped(&self, point: &[Band; 3], uv: &[Band; 2]) -> Band {
        self.along(point, uv)
    }

    fn is_known(&self) -> bool {
        self.is_held()
    }
}

impl Formula {
    fn raw(&self, p: DVec3, sample: &Sample) -> f64 {
        match self {
            Self::Agate(agate) => agate.value(p),
            Self::Aoi => slope::aoi(sample),
            Self::Average | Self::Facets(_) => 0.0,
            Self::Boxed => falloff::boxed(p),
            Self::Bozo(generator) | Self::Bumps(generator) => crate::math::noise::noise(*generator, p),
            Self::Brick(brick) => brick.value(p),
            Self::Cells => cells::value(p),
            Self::Checker => simple::checker(p),
            Self::Crackle(crackle) => crackle.value(p),
            Self::Cubic => cube_face(p) as f64,
            Self::Cylindrical => falloff::cylindrical(p),
            Self::DensityFile(file) => file.value(p),
            Self::Dents(generator) => noise::dents(*generator, p),
            Self::Fractal(fractal) => fractal.value(p),
            Self::Function(function) => fold(function.value(&sample.moved(p))),
            Self::Gradient(direction) => gradient(*direction, p),
            Self::Granite(generator) => noise::granite(*generator, p),
            Self::Hexagon => hexagon::value(p),
            Self::Image(map) => map.pattern_value(p),
            Self::Leopard => simple::leopard(p),
            Self::Marble(marble) => marble.value(p),
            Self::Object(object) => f64::from(object.inside(p)),
            Self::Onion => fraction(p.length()),
            Self::Pavement(pavement) => pavement.value(p),
            Self::Penrose(penrose) => penrose.value(p),
            Self::Pigment(pigment) => pigment.value(&sample.moved(p)),
            Self::Planar => falloff::planar(p),
            Self::Quilted(quilted) => quilted.value(p),
            Self::Radial => simple::radial(p),
            Self::Ripples(ripples) => ripples.ripples(p),
            Self::Slope(slope) => slope.value(p, sample),
            Self::Spherical => falloff::spherical(p),
            Self::Spiral1(spiral) => spiral.single(p),
            Self::Spiral2(spiral) => spiral.double(p),
            Self::Square => simple::square(p),
            Self::Tiling(tiling) => tiling.value(p),
            Self::Triangular => triangular::value(p),
            Self::Waves(ripples) => ripples.waves(p),
            Self::Wood(wood) => wood.value(p),
            Self::Wrinkles(generator) => noise::wrinkles(*generator, p),
        }
    }
}

/// How far a point is along a direction.
#[inline(always)]
fn gradient(direction: DVec3, p: DVec3) -> f64 {
    fold(p.x * direction.x + p.y * direction.y + p.z * direction.z)
}

/// Values over 1 start again at 0; negative ones stay.
#[inline(always)]
fn fold(v: f64) -> f64 {
    if v > 1.0 { fraction(v) } else { v }
}

/// The same as the remainder `v % 1.0`, exactly, but for the detour through a loop; coordinates are
/// kept well within what fits 64 bits.
#[inline(always)]
fn fraction(v: f64) -> f64 {
    if v.abs() < 1e18 { v - v as i64 as f64 } else { v % 1.0 }
}

/// The same as `c.floor()`, of coordinates within what fits 64 bits: no call where the processor's
/// rounding may not be used.
#[inline(always)]
fn floor(c: f64) -> f64 {
    let whole = c as i64 as f64;
    if whole > c { whole - 1.0 } else { whole }
}

/// Whether a whole number is odd.
#[inline(always)]
fn is_odd(whole: f64) -> bool {
    whole as i64 & 1 == 1
}

/// Number of the cell of size 1 that `c` is in; boundaries belong to the upper cell.
#[inline(always)]
fn cell_above(c: f64) -> f64 {
    floor(c + EPSILON)
}
