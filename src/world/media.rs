//! Media: what fills space between surfaces and dims, glows and scatters (docs/spec/atmosphere-gi.md 2).

pub mod phase;

pub use phase::Phase;

use std::sync::Arc;

use super::sample::{Sample, Samples};
use super::texture::Pigment;
use super::warp::Warps;
use crate::math::color::FourRgb;
use crate::math::{DVec3, Lanes, Rgb};

/// A `media`.
#[derive(Clone, Debug)]
pub struct Media {
    /// How it wants to be sampled.
    pub sampling: Sampling,
    /// Light lost per unit at density 1: absorbed, and scattered away.
    pub extinction: Rgb,
    /// Light given off per unit at density 1.
    pub emission: Rgb,
    /// Light of lamps scattered per unit at density 1.
    pub scattering: Rgb,
    /// Where scattered light goes.
    pub phase: Phase,
    /// How much there is.
    pub density: Density,
}

/// How a stretch through media is sampled (docs/spec/atmosphere-gi.md 2.1).
#[derive(Clone, Debug)]
pub struct Sampling {
    /// The integration.
    pub method: Method,
    /// The least number of intervals, at least 1.
    pub intervals: u32,
    /// Least samples of an interval, at least 1.
    pub min_samples: u32,
    /// Displacement of samples, in parts of their distance.
    pub jitter: f64,
    /// Share of the intervals that goes to lit pieces.
    pub ratio: f64,
    /// Whether no `density` was written.
    pub plain: bool,
}

/// The `method`s.
#[derive(Clone, Debug)]
pub enum Method {
    /// 1: at random places.
    Random(Extra),
    /// 2: in the middle of equal parts.
    Even(Extra),
    /// 3: where the light changes more samples are taken.
    Adaptive {
        /// Difference above which samples are taken between, `aa_threshold`.
        threshold: f32,
        /// How often parts are halved, `aa_level`, at least 1.
        level: u32,
    },
}

/// When more than the least number of samples are taken.
#[derive(Clone, Debug, Default)]
pub struct Extra {
    /// For 1, 2, … samples the variance of their mean that is small enough; the length is the most
    /// samples. Empty where the least number is the most.
    pub thresholds: Box<[f64]>,
}

/// So many densities are asked in the order of what they cost.
const FEW: usize = 4;

/// The product of a medium's `density` statements.
#[derive(Clone, Debug)]
pub struct Density {
    /// From the world to the space the statements were written in.
    place: Warps,
    /// The product of those that are the same everywhere.
    pub uniform: Rgb,
    /// Those that aren't.
    varying: Box<[Arc<Pigment>]>,
    /// The places of the first few in the order in which they are asked.
    order: Box<[u8]>,
}

impl Density {
    /// The product of a uniform density and of `varying` ones, written in the space that `place` leads to.
    pub fn new(place: Warps, uniform: Rgb, varying: Vec<Arc<Pigment>>) -> Self {
        // Where one is black the others need not be asked: first those that are soon known.
        let mut order: Box<[u8]> = (0..FEW as u8).take(varying.len()).collect();
        order.sort_by_key(|&place| !varying[usize::from(place)].is_soon_known());
        Self { place, uniform, varying: varying.into(), order }
    }

    /// Whether it is the same everywhere.
    pub fn is_uniform(&self) -> bool {
        self.varying.is_empty()
    }

    /// The density at a point of the world.
    pub fn at(&self, point: DVec3) -> Rgb {
        if self.is_uniform() {
            return self.uniform;
        }
        let sample = Sample::at(self.place.point(point));
        if let [field] = &self.varying[..] {
            return self.uniform * field.density(&sample);
        }
        let mut values = [Rgb::ONE; FEW];
        for &place in &self.order {
            let value = self.varying[usize::from(place)].density(&sample);
            if value == Rgb::ZERO {
                return Rgb::ZERO;
            }
            values[usize::from(place) % FEW] = value;
        }
        // Multiplied in the order of the text, whichever was asked first.
        let mut density = self.uniform;
        for value in &values[..self.order.len().min(FEW)] {
            density *= *value;
        }
        for field in self.varying.iter().skip(self.order.len()) {
            density *= field.density(&sample);
        }
        density
    }

    /// The densities at four points of the world, the same bits as one by one.
    pub fn four(&self, point: &[Lanes; 3]) -> FourRgb {
        let mut density = FourRgb::all(self.uniform);
        if self.is_uniform() {
            return density;
        }
        let point = self.place.four(point);
        let samples = Samples::at(&point);
        if let [field] = &self.varying[..] {
            density.multiply(&field.densities(&samples));
            return density;
        }
        let mut values = [FourRgb::ZERO; FEW];
        let mut black = [false; Lanes::COUNT];
        for &place in &self.order {
            let found = self.varying[usize::from(place)].densities(&samples);
            for (lane, black) in black.iter_mut().enumerate() {
                *black |= found.get(lane) == Rgb::ZERO;
            }
            if black == [true; Lanes::COUNT] {
                return FourRgb::ZERO;
            }
            values[usize::from(place) % FEW] = found;
        }
        for value in &values[..self.order.len().min(FEW)] {
            density.multiply(value);
        }
        for field in self.varying.iter().skip(self.order.len()) {
            density.multiply(&field.densities(&samples));
        }
        for (lane, black) in black.into_iter().enumerate() {
            if black {
                density.set(lane, Rgb::ZERO);
            }
        }
        density
    }
}

impl Media {
    /// Whether it takes light from what is behind.
    pub fn dims(&self) -> bool {
        self.extinction != Rgb::ZERO
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgbft;
    use crate::world::pattern::{Formula, Pattern};
    use crate::world::sample::one_by_one;
    use crate::world::texture::BlendMap;

    fn colors(formula: Formula) -> Pigment {
        let gray = |v: f32| Rgbft::opaque(Rgb::new(v, 0.3 + v, 1.0 - v));
        let map = [(0.1, Rgbft::BLACK), (0.3, gray(0.7)), (0.35, gray(0.2)), (0.8, gray(0.9))];
        Pigment::Colors(Box::new(Pattern::plain(formula)), BlendMap::new(map).unwrap())
    }

    #[test]
    fn four_densities_are_as_one_after_the_other() {
        let maps = |positions: [f32; 2]| {
            let entries = [Formula::Spherical, Formula::Bozo(2)].map(|formula| Arc::new(colors(formula)));
            let gradient = Pattern::plain(Formula::Gradient(DVec3::X));
            Pigment::Pigments(Box::new(gradient), BlendMap::new(positions.into_iter().zip(entries)).unwrap())
        };
        let fields: [&dyn Fn() -> Pigment; 5] = [
            &|| colors(Formula::Spherical),
            &|| colors(Formula::Granite(1)),
            &|| maps([0.5, 0.5]),
            &|| maps([0.1, 0.9]),
            &|| Pigment::Color(Rgbft::opaque(Rgb::splat(0.4))),
        ];
        for count in 1..=fields.len() {
            for first in 0..fields.len() {
                let varying = (0..count).map(|field| Arc::new(fields[(first + field) % 5]())).collect();
                let density = Density::new(Warps::default(), Rgb::new(0.5, 1.0, 3.0), varying);
                for n in 0..200 {
                    let place = one_by_one(|lane| f64::from(n) * 0.01 - 1.0 + 0.02 * lane as f64);
                    let point = [place, place * 0.3 - 0.2, place * -0.7];
                    let found = density.four(&point);
                    for lane in 0..Lanes::COUNT {
                        let at = DVec3::new(point[0].0[lane], point[1].0[lane], point[2].0[lane]);
                        let expected = density.at(at).to_array().map(f32::to_bits);
                        assert_eq!(
                            found.get(lane).to_array().map(f32::to_bits),
                            expected,
                            "{density:?} at {at}"
                        );
                    }
                }
            }
        }
    }
}
