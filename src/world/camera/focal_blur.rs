//! Focal blur: many rays through a lens, the same for every rendering
//! (docs/spec/camera-image.md 8).

use std::f64::consts::{PI, TAU};

use super::{Frame, bokeh};
use crate::math::confidence::thresholds;
use crate::math::{Bounds, DVec2, DVec3, Lanes};
use crate::world::accel::Pencil;
use crate::world::texture::Pigment;
use crate::world::{Ray, Rays};

/// A lens and when enough rays went through it.
#[derive(Clone, Debug)]
pub struct FocalBlur {
    /// The middle of the lens.
    location: DVec3,
    /// Half the aperture across and upwards: the lens' extent along the camera's axes.
    axes: [DVec3; 2],
    /// Distance in focus over the length of the camera's direction.
    focus: f64,
    /// Places on the lens, each coordinate from -½ to ½, in the order they are used.
    places: Vec<DVec2>,
    /// How far a ray may leave its place.
    spread: f64,
    /// Rays traced before the variance is looked at, again and again.
    batches: &'static [u32],
    /// The least number of rays.
    min_samples: u32,
    /// For each number of rays the variance below which they are enough.
    thresholds: Vec<f64>,
}

/// What a lens is made from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// `aperture`.
    pub aperture: f64,
    /// Distance in focus.
    pub distance: f64,
    /// Least and most rays, the latter at least 1.
    pub samples: [u32; 2],
    /// In (0, 1).
    pub confidence: f64,
    /// Variance below which sampling stops.
    pub variance: f64,
}

impl FocalBlur {
    /// The lens of a camera; `bokeh` is its brightness over the unit square.
    pub fn new(frame: &Frame, lens: &Lens, bokeh: Option<&Pigment>) -> Self {
        let most = lens.samples[1];
        let grid = Grid::of(most);
        let (places, batches, spread) = match bokeh {
            Some(pigment) => (bokeh::places(pigment, most as usize), &[][..], even_spread(most)),
            None => (places(grid, most as usize), grid.batches, grid.spread(most)),
        };
        let across = frame.up.cross(frame.direction).normalize_or_zero();
        let upward = frame.direction.cross(across).normalize_or_zero();
        Self {
            location: frame.location,
            axes: [across, upward].map(|axis| lens.aperture / 2.0 * axis),
            focus: lens.distance / frame.direction.length(),
            places,
            spread,
            batches,
            min_samples: lens.samples[0],
            thresholds: thresholds(most, lens.confidence, lens.variance),
        }
    }

    /// The ray of sample `index` for the pinhole direction `direction`, not normalised; `shift` moves
    /// it on the lens, each component from -½ to ½. Wherever the projection's rays start, those of a
    /// lens start at the eye.
    #[inline]
    pub fn ray(&self, direction: DVec3, index: usize, shift: DVec2) -> Ray {
        let place = self.places[index] + 2.0 * self.spread * shift;
        let offset = place.x * self.axes[0] - place.y * self.axes[1];
        Ray::new(self.location + offset, (direction * self.focus - offset).normalize_or_zero())
    }

    /// The same for four directions and the samples from number `first` on; where there are no more, the last
    /// again. The directions are unit where [`FocalBlur::pencil`] has the rays.
    #[inline(always)]
    pub fn rays(&self, directions: &[Lanes; 3], first: usize, shifts: &[Lanes; 2]) -> Rays {
        let (mut x, mut y) = (Lanes::ZERO, Lanes::ZERO);
        for lane in 0..Lanes::COUNT {
            let place = self.places[(first + lane).min(self.places.len() - 1)];
            (x.0[lane], y.0[lane]) = (place.x, place.y);
        }
        let [x, y] = [x + shifts[0] * (2.0 * self.spread), y + shifts[1] * (2.0 * self.spread)];
        let (across, upward) = (self.axes[0].to_array(), self.axes[1].to_array());
        let location = self.location.to_array();
        let mut rays = Rays { origin: [Lanes::ZERO; 3], direction: *directions };
        for axis in 0..3 {
            let offset = x * across[axis] - y * upward[axis];
            rays.origin[axis] = offset + location[axis];
            rays.direction[axis] = directions[axis] * self.focus - offset;
        }
        rays.normalize();
        rays
    }

    /// The middle of the lens, and the corners of a square around all places where rays start.
    pub fn extent(&self) -> (DVec3, [DVec3; 4]) {
        let wide = 0.5 + self.spread;
        let (x, y) = (wide * self.axes[0], wide * self.axes[1]);
        let at = |corner: DVec3| self.location + corner;
        (self.location, [at(x + y), at(x - y), at(y - x), at(-x - y)])
    }

    /// The rays from all over the lens for directions, not normalised, that are between four; `None` where
    /// rays may start where they are in focus.
    pub fn pencil(&self, directions: &[DVec3; 4]) -> Option<Pencil> {
        let through = directions.iter().map(|&direction| self.location + direction * self.focus);
        Pencil::new(Bounds::of(self.extent().1), Bounds::of(through))
    }

    /// The most rays a pixel gets.
    pub fn max_samples(&self) -> usize {
        self.places.len()
    }

    /// How many rays batch `index` adds, before the cut at the most.
    pub fn batch(&self, index: usize) -> usize {
        self.batches.get(index).copied().unwrap_or(4) as usize
    }

    /// Whether `count` rays are enough: `below` tells whether the variance of their mean is below a limit, by the number
    /// of the component. Mostly the first tells.
    #[inline]
    pub fn is_enough(&self, count: usize, below: impl Fn(usize, f64) -> bool) -> bool {
        let enough = |component| below(component, self.thresholds[count - 1]);
        count >= self.min_samples as usize && (0..4).all(enough)
    }
}

/// A regular arrangement of places, and the batches it is used in.
#[derive(Clone, Copy)]
struct Grid {
    places: &'static [(f64, f64)],
    batches: &'static [u32],
}

impl Grid {
    /// The largest with at most `count` places, but at least four.
    fn of(count: u32) -> Self {
        match count {
            0..7 => Self { places: &SQUARE, batches: &[] },
            7..19 => Self { places: &HEXAGON_7, batches: &[7] },
            19..37 => Self { places: &HEXAGON_19, batches: &[7, 6, 6] },
            37.. => Self { places: &HEXAGON_37, batches: &[7, 6, 6, 4, 4, 4, 4, 2] },
        }
    }

    /// How far rays may leave their places where there are `count` of them.
    fn spread(self, count: u32) -> f64 {
        match count {
            7 => 0.144_338,
            19 => 0.096_225,
            37 => 0.072_168_8,
            _ => even_spread(count),
        }
    }
}

/// The same for places that are no grid.
fn even_spread(count: u32) -> f64 {
    0.5 / f64::from(count).sqrt()
}

const SQUARE: [(f64, f64); 4] = [(-0.25, 0.25), (0.25, 0.25), (-0.25, -0.25), (0.25, -0.25)];

const HEXAGON_7: [(f64, f64); 7] = [
    (-0.288675, 0.0),
    (0.0, 0.0),
    (0.288675, 0.0),
    (-0.144338, 0.25),
    (-0.144338, -0.25),
    (0.144338, 0.25),
    (0.144338, -0.25),
];

const HEXAGON_19: [(f64, f64); 19] = [
    (-0.19245, 0.333333),
    (-0.19245, -0.333333),
    (0.19245, 0.333333),
    (0.19245, -0.333333),
    (0.3849, 0.0),
    (-0.3849, 0.0),
    (0.0, 0.0),
    (0.0, 0.333333),
    (0.0, -0.333333),
    (-0.288675, 0.166667),
    (-0.288675, -0.166667),
    (0.288675, 0.166667),
    (0.288675, -0.166667),
    (-0.096225, 0.166667),
    (-0.096225, -0.166667),
    (0.096225, 0.166667),
    (0.096225, -0.166667),
    (-0.19245, 0.0),
    (0.19245, 0.0),
];

const HEXAGON_37: [(f64, f64); 37] = [
    (0.0, 0.0),
    (-0.216506, 0.375),
    (0.216506, -0.375),
    (-0.216506, -0.375),
    (0.216506, 0.375),
    (-0.433013, 0.0),
    (0.433013, 0.0),
    (-0.144338, 0.25),
    (0.144338, -0.25),
    (-0.144338, -0.25),
    (0.144338, 0.25),
    (-0.288675, 0.0),
    (0.288675, 0.0),
    (-0.072169, 0.125),
    (0.072169, -0.125),
    (-0.072169, -0.125),
    (0.072169, 0.125),
    (-0.144338, 0.0),
    (0.144338, 0.0),
    (-0.360844, 0.125),
    (-0.360844, -0.125),
    (0.360844, 0.125),
    (0.360844, -0.125),
    (-0.288675, 0.25),
    (-0.288675, -0.25),
    (0.288675, 0.25),
    (0.288675, -0.25),
    (-0.072169, 0.375),
    (-0.072169, -0.375),
    (0.072169, 0.375),
    (0.072169, -0.375),
    (-0.216506, 0.125),
    (-0.216506, -0.125),
    (0.216506, 0.125),
    (0.216506, -0.125),
    (0.0, 0.25),
    (0.0, -0.25),
];

/// `count` places: those of the grid, then some of a low-discrepancy disc that keep their distance
/// (docs/spec/camera-image.md 8.2).
fn places(grid: Grid, count: usize) -> Vec<DVec2> {
    let mut places: Vec<DVec2> = grid.places.iter().take(count).map(|&(x, y)| DVec2::new(x, y)).collect();
    let cells = 2 * (count as f64 / PI).sqrt().ceil() as usize + 1;
    let cell = |place: DVec2| {
        let index = |x: f64| (((x + 0.5) * cells as f64) as usize).min(cells - 1);
        index(place.y) * cells + index(place.x)
    };
    let mut taken = vec![false; cells * cells];
    for &place in &places {
        taken[cell(place)] = true;
    }
    let mut budget = 10 * count;
    let mut candidates = (1..).map(|k| {
        let radius = (radical_inverse(k, 2) / 4.0).sqrt();
        DVec2::from_angle(TAU * radical_inverse(k, 3)) * radius
    });
    while let (true, Some(mut place)) = (places.len() < count, candidates.next()) {
        budget -= 1;
        while budget > count - places.len() && (taken[cell(place)] || place.length_squared() > 0.25) {
            let Some(next) = candidates.next() else { break };
            place = next;
            budget -= 1;
        }
        taken[cell(place)] = true;
        places.push(place);
    }
    places
}

/// The digits of `n` mirrored at the point.
pub(super) fn radical_inverse(mut n: u64, base: u64) -> f64 {
    let (mut value, mut digit) = (0.0, 1.0 / base as f64);
    while n > 0 {
        value += (n % base) as f64 * digit;
        digit /= base as f64;
        n /= base;
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_count_of_places_fits_the_lens() {
        for count in [1, 4, 5, 7, 10, 19, 30, 37, 60, 200] {
            let places = places(Grid::of(count), count as usize);
            assert_eq!(places.len(), count as usize);
            assert!(places.iter().all(|place| place.length() <= 0.5), "{count}");
        }
    }
}
