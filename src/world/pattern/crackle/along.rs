//! Crackles along lines: bounds of their values.

use super::{ADJACENT, Crackle, Metric, NEIGHBOURS, SEEDS, Seeds, seed};
use crate::math::noise::{EPSILON, noise};
use crate::math::{Band, DVec3, Lanes};

/// A value along a stretch: in the middle, by how much it rises to the end, and what it may be off.
type Strip = [f64; 3];

/// All values are between 0 and 1.
const ANY: Strip = [0.5, 0.0, 0.5];

/// The longest stretch, to either side of its middle, of which something is said.
const LONGEST: f64 = 0.5;

/// Coordinates up to here.
const FAR: f64 = 1e8;

/// Many times what a distance is rounded by, as a share.
const ROUNDING: f64 = 1e-13;

/// A stretch with all that is beside it.
#[derive(Clone, Copy)]
struct Stretch {
    middle: DVec3,
    along: DVec3,
    reach: DVec3,
    /// No point is farther from the middle, by the metric.
    spread: f64,
}

impl Crackle {
    /// Whether distances obey the inequality of triangles.
    fn has_distances(&self) -> bool {
        self.metric.exponent() >= 1.0 && self.metric.offset(self.offset) >= 0.0
    }

    /// What holds the values at all points that these hold.
    pub(in crate::world::pattern) fn along(&self, p: &[Band; 3]) -> Band {
        let strips: [Strip; Lanes::COUNT] = std::array::from_fn(|lane| {
            let of =
                |value: fn(&Band) -> Lanes| DVec3::from_array(p.each_ref().map(|band| value(band).0[lane]));
            let (middle, along, reach) = (of(|b| b.middle), of(|b| b.slope), of(|b| b.reach));
            self.strip(middle, along, reach)
        });
        let lanes = |part: usize| Lanes(strips.map(|strip| strip[part]));
        let band = Band { middle: lanes(0), slope: lanes(1), reach: lanes(2) };
        band.loose().max(Band::constant(0.0)).min(Band::constant(1.0))
    }

    fn strip(&self, middle: DVec3, along: DVec3, reach: DVec3) -> Strip {
        let half = along.abs() + reach;
        // What is no number is not short either.
        if !(half.max_element() <= LONGEST && middle.abs().max_element() < FAR) {
            return ANY;
        }
        let rounding = ROUNDING * (1.0 + middle.abs().max_element());
        let spread = self.metric.distance(self.metric.sum(half)) * (1.0 + ROUNDING) + rounding;
        let stretch = Stretch { middle, along, reach, spread };
        let room = half + 2.0 * EPSILON;
        let (low, high) = ((middle - room - EPSILON).floor(), (middle + room).floor());
        let steps = |i: usize| (low[i] as i32)..=(high[i] as i32);
        let cells = steps(0).flat_map(|x| steps(1).flat_map(move |y| steps(2).map(move |z| [x, y, z])));
        cells.map(|cell| self.in_cell(cell, stretch)).reduce(hull).unwrap_or(ANY)
    }

    /// The same, as the seeds around one cell have it.
    fn in_cell(&self, cell: [i32; 3], stretch: Stretch) -> Strip {
        if !self.has_distances() {
            return self.in_cell_by_sums(cell, stretch);
        }
        let Stretch { middle, spread, .. } = stretch;
        let mut near: Vec<(f64, DVec3)> = Vec::with_capacity(NEIGHBOURS.len());
        let distance = |seed: DVec3| (self.metric.distance(self.metric.sum(middle - seed)), seed);
        SEEDS.with_borrow_mut(|seeds| {
            let seeds = match seeds {
                Some(seeds) if seeds.cell == cell => seeds,
                _ => seeds.insert(Seeds::of(cell)),
            };
            let places = (0..ADJACENT).map(|i| DVec3::new(seeds.x[i], seeds.y[i], seeds.z[i]));
            near.extend(places.map(distance));
        });
        near.sort_by(|a, b| a.0.total_cmp(&b.0));
        if near[2].0 + 2.0 * spread >= 1.0 {
            near.extend(NEIGHBOURS[ADJACENT..].iter().map(|&offset| distance(seed(cell, offset))));
            near.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        if let Some(generator) = self.solid {
            let first = near.iter().take_while(|(d, _)| *d <= near[0].0 + 2.0 * spread);
            let values = first.map(|(_, seed)| noise(generator, *seed));
            return values.map(|v| [v, 0.0, 0.0]).reduce(hull).unwrap_or(ANY);
        }
        let mut sum = [0.0; 3];
        for (k, weight) in self.form.to_array().into_iter().enumerate() {
            let apart = |a: usize, b: usize| near[b].0 - near[a].0 > 2.0 * spread;
            let alone = (k == 0 || apart(k - 1, k)) && apart(k, k + 1);
            let strip = self.distance_along(near[k], stretch, alone);
            sum = [sum[0] + weight * strip[0], sum[1] + weight * strip[1], sum[2] + weight.abs() * strip[2]];
        }
        sum
    }

    /// The same by what every seed's sum is between: the least of all are between the least of either bound.
    fn in_cell_by_sums(&self, cell: [i32; 3], Stretch { middle, along, reach, .. }: Stretch) -> Strip {
        let half = along.abs() + reach + ROUNDING * (1.0 + middle.abs().max_element());
        let bounds = |seed: DVec3| {
            let gap = (middle - seed).abs();
            let [near, far] = [(gap - half).max(DVec3::ZERO), gap + half].map(|d| self.metric.sum(d));
            let [low, high] = if self.metric.grows() { [near, far] } else { [far, near] };
            [low * (1.0 - ROUNDING), high * (1.0 + ROUNDING)]
        };
        let seeds: Vec<_> = NEIGHBOURS.iter().map(|&offset| seed(cell, offset)).collect();
        let sums: Vec<_> = seeds.iter().map(|&seed| bounds(seed)).collect();
        let sorted = |bound: usize| {
            let mut all: Vec<_> = sums.iter().map(|sum| sum[bound]).collect();
            all.sort_by(f64::total_cmp);
            all
        };
        let (lows, highs) = (sorted(0), sorted(1));
        if let Some(generator) = self.solid {
            let first = seeds.iter().zip(&sums).filter(|(_, [low, _])| *low <= highs[0]);
            let values = first.map(|(seed, _)| noise(generator, *seed));
            return values.map(|v| [v, 0.0, 0.0]).reduce(hull).unwrap_or(ANY);
        }
        let offset = self.metric.offset(self.offset);
        let (mut low, mut high) = (0.0, 0.0);
        for (k, weight) in self.form.to_array().into_iter().enumerate() {
            if weight == 0.0 && self.metric.grows() {
                continue;
            }
            let [a, b] = [lows[k], highs[k]].map(|sum| weight * self.metric.distance(sum + offset));
            let room = ROUNDING * (a.abs() + b.abs());
            (low, high) = (low + a.min(b) - room, high + a.max(b) + room);
        }
        // What is no number is above no threshold, and below none.
        if !(low.is_finite() && high.is_finite()) {
            return ANY;
        }
        [0.5 * (low + high), 0.0, 0.5 * (high - low)]
    }

    /// The distance to a seed, or if others may take its place, what is as far.
    fn distance_along(&self, (distance, seed): (f64, DVec3), stretch: Stretch, alone: bool) -> Strip {
        let Stretch { middle, along, reach, spread } = stretch;
        let offset = self.metric.offset(self.offset);
        let with_offset = |d: f64| match self.metric {
            Metric::Absolute => d + offset,
            _ if offset == 0.0 => d,
            Metric::Square => (d * d + offset).sqrt(),
            Metric::Halves(_) | Metric::Power(_) => {
                self.metric.distance(d.powf(self.metric.exponent()) + offset)
            }
        };
        let [nearest, here, farthest] =
            [(distance - spread).max(0.0), distance, distance + spread].map(with_offset);
        if alone && self.metric == Metric::Square && nearest > 0.0 {
            // No second derivative is above one over the distance.
            let bend = spread * spread / (2.0 * nearest) + reach.length() + ROUNDING * (1.0 + farthest);
            return [here, (middle - seed).dot(along) / here, bend];
        }
        let half = (farthest - here).max(here - nearest);
        [here, 0.0, half + ROUNDING * (1.0 + farthest)]
    }
}

/// What holds both.
fn hull(a: Strip, b: Strip) -> Strip {
    let bounds = |[middle, slope, reach]: Strip| {
        let spread = slope.abs() + reach;
        [middle - spread, middle + spread]
    };
    if a == b {
        return a;
    }
    let ([a, b], [c, d]) = (bounds(a), bounds(b));
    let (low, high) = (a.min(c), b.max(d));
    [0.5 * (low + high), 0.0, 0.5 * (high - low)]
}
