//! Crackles along lines: bounds of their values.

use super::{ADJACENT, BESIDE, Crackle, Kept, Least, Metric, NEIGHBOURS, SEEDS, Seeds, insert, seed};
use crate::math::noise::{EPSILON, noise};
use crate::math::wide::widest;
use crate::math::{Band, DVec3, Lanes};

/// A value along a stretch: in the middle, by how much it rises to the end, and what it may be off.
type Strip = [f64; 3];

/// All values are between 0 and 1.
const ANY: Strip = [0.5, 0.0, 0.5];

/// The longest stretch, to either side of its middle, of which something is said.
const LONGEST: f64 = 0.5;

/// What may be off by as much isn't worth the search for seeds.
const VAGUE: f64 = 0.6;

/// Coordinates up to here.
const FAR: f64 = 1e8;

/// The last bits of sums, where places of seeds are kept.
const PLACE: u64 = 31;

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
    /// The lowest and the highest numbers of the cells it may touch.
    cells: [[i32; 3]; 2],
}

impl Stretch {
    fn touches(&self, cell: [i32; 3]) -> bool {
        let [low, high] = self.cells;
        (0..3).all(|axis| low[axis] <= cell[axis] && cell[axis] <= high[axis])
    }
}

impl Crackle {
    /// Whether distances obey the inequality of triangles.
    fn has_distances(&self) -> bool {
        self.metric.exponent() >= 1.0 && (self.offset == 0.0 || self.metric.offset(self.offset) >= 0.0)
    }

    /// What holds the values at all points that these hold.
    pub(in crate::world::pattern) fn along(&self, p: &[Band; 3]) -> Band {
        let strips = SEEDS.with_borrow_mut(|seeds| {
            widest(
                #[inline(always)]
                || self.strips(p, seeds),
            )
        });
        let [a, b, c, d] = strips;
        let lanes = |part: usize| Lanes([a[part], b[part], c[part], d[part]]);
        let band = Band { middle: lanes(0), slope: lanes(1), reach: lanes(2) };
        band.loose().max(Band::constant(0.0)).min(Band::constant(1.0))
    }

    /// The same lane by lane; the seeds around a cell are looked through for all lanes at once.
    #[inline(always)]
    fn strips(&self, p: &[Band; 3], seeds: &mut Kept) -> [Strip; Lanes::COUNT] {
        // Written out: closures may become calls, of which none knows wide registers.
        let half = |axis: usize| p[axis].slope.abs() + p[axis].reach;
        let half = [half(0), half(1), half(2)];
        let Lanes(spread) = self.metric.distances(self.metric.sum_of_four(half[0], half[1], half[2]));
        let stretches = [
            self.stretch(p, 0, spread[0]),
            self.stretch(p, 1, spread[1]),
            self.stretch(p, 2, spread[2]),
            self.stretch(p, 3, spread[3]),
        ];
        let middles = [p[0].middle, p[1].middle, p[2].middle];
        let mut strips: [Option<Strip>; Lanes::COUNT] = [None; Lanes::COUNT];
        for (first, stretch) in stretches.iter().enumerate() {
            let Some(Stretch { cells: [low, high], .. }) = stretch else { continue };
            for cx in low[0]..=high[0] {
                for cy in low[1]..=high[1] {
                    for cz in low[2]..=high[2] {
                        let cell = [cx, cy, cz];
                        let touching = |lane: usize| stretches[lane].filter(|stretch| stretch.touches(cell));
                        if (0..first).any(|lane| touching(lane).is_some()) {
                            continue;
                        }
                        let around = seeds.around(cell);
                        let near = Near::of_four(around, middles, self.metric);
                        for (lane, all) in strips.iter_mut().enumerate().skip(first) {
                            let Some(stretch) = touching(lane) else { continue };
                            let strip = if self.has_distances() {
                                self.in_cell(cell, stretch, Near::of_lane(&near, lane, around))
                            } else {
                                self.in_cell_by_sums(cell, stretch)
                            };
                            *all = Some(all.map_or(strip, |all| hull(all, strip)));
                        }
                    }
                }
            }
        }
        let [a, b, c, d] = strips;
        [a.unwrap_or(ANY), b.unwrap_or(ANY), c.unwrap_or(ANY), d.unwrap_or(ANY)]
    }

    /// The stretch in a lane with what is beside it, if it is worth the search for seeds. From its middle to its farthest
    /// corner it is as far as `spread`.
    #[inline(always)]
    fn stretch(&self, [x, y, z]: &[Band; 3], lane: usize, spread: f64) -> Option<Stretch> {
        let middle = DVec3::new(x.middle.0[lane], y.middle.0[lane], z.middle.0[lane]);
        let along = DVec3::new(x.slope.0[lane], y.slope.0[lane], z.slope.0[lane]);
        let reach = DVec3::new(x.reach.0[lane], y.reach.0[lane], z.reach.0[lane]);
        let half = along.abs() + reach;
        // What is no number is not short either.
        if !(half.max_element() <= LONGEST && middle.abs().max_element() < FAR) {
            return None;
        }
        let rounding = ROUNDING * (1.0 + middle.abs().max_element());
        let spread = spread * (1.0 + ROUNDING) + rounding;
        let vague = spread * self.form.abs().element_sum() >= VAGUE;
        if vague && self.solid.is_none() && self.has_distances() {
            return None;
        }
        let room = half + 2.0 * EPSILON;
        let cell_of = |p: DVec3| {
            let p = p.floor();
            [p.x as i32, p.y as i32, p.z as i32]
        };
        let cells = [cell_of(middle - room - EPSILON), cell_of(middle + room)];
        Some(Stretch { middle, along, reach, spread, cells })
    }

    /// What holds the values on a stretch, as the seeds around one of its cells have it, of which these are near.
    fn in_cell(&self, cell: [i32; 3], stretch: Stretch, mut near: Near) -> Strip {
        let Stretch { middle, spread, .. } = stretch;
        // Those of the other cells are a whole cell away from all points of this one.
        let distances = |near: &Near| {
            let Lanes(distances) = widest(
                #[inline(always)]
                || self.metric.distances(Lanes(near.sums)),
            );
            distances
        };
        let mut known = distances(&near);
        if known[self.counting() - 1] + spread >= 1.0 - ROUNDING {
            near.meet_far(middle, cell, self.metric);
            known = distances(&near);
        }
        if let Some(generator) = self.solid {
            let within = |place: usize| known[place] <= known[0] + 2.0 * spread;
            if within(Near::COUNT - 1) {
                return ANY;
            }
            let values =
                (0..Near::COUNT).filter(|place| within(*place)).map(|i| noise(generator, near.seeds[i]));
            return values.map(|v| [v, 0.0, 0.0]).reduce(hull).unwrap_or(ANY);
        }
        let mut sum = [0.0; 3];
        for (k, weight) in self.form.to_array().into_iter().enumerate() {
            if weight == 0.0 {
                continue;
            }
            let apart = |a: usize, b: usize| known[b] - known[a] > 2.0 * spread;
            let alone = (k == 0 || apart(k - 1, k)) && apart(k, k + 1);
            let strip = self.distance_along((known[k], near.seeds[k]), stretch, alone);
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

    /// What the offset makes of a distance.
    #[inline(never)]
    fn with_offset(&self, distance: f64) -> f64 {
        let offset = self.metric.offset(self.offset);
        match self.metric {
            Metric::Absolute => distance + offset,
            Metric::Square => (distance * distance + offset).sqrt(),
            Metric::Halves(_) | Metric::Power(_) => {
                self.metric.distance(distance.powf(self.metric.exponent()) + offset)
            }
        }
    }

    /// The distance to a seed, or if others may take its place, what is as far.
    fn distance_along(&self, (distance, seed): (f64, DVec3), stretch: Stretch, alone: bool) -> Strip {
        let Stretch { middle, along, reach, spread, .. } = stretch;
        let [mut nearest, mut here, mut farthest] =
            [(distance - spread).max(0.0), distance, distance + spread];
        if self.offset != 0.0 {
            [nearest, here, farthest] = [nearest, here, farthest].map(|d| self.with_offset(d));
        }
        if alone && self.metric == Metric::Square && nearest > 0.0 {
            // No second derivative is above one over the distance.
            let bend = spread * spread / (2.0 * nearest) + reach.length() + ROUNDING * (1.0 + farthest);
            return [here, (middle - seed).dot(along) / here, bend];
        }
        let half = (farthest - here).max(here - nearest);
        [here, 0.0, half + ROUNDING * (1.0 + farthest)]
    }
}

/// The seeds nearest to a point, the nearest first, with the sums that stand for their distances: the three that
/// count, and the one that might take the place of the third.
struct Near {
    sums: [f64; Near::COUNT],
    seeds: [DVec3; Near::COUNT],
}

impl Near {
    const COUNT: usize = 4;

    /// The least sums for four points, of the seeds of the cells that share a corner, with the seeds' places in the last
    /// bits: these are less than what [`ROUNDING`] leaves room for.
    #[inline(always)]
    fn of_four(seeds: &Seeds, [x, y, z]: [Lanes; 3], metric: Metric) -> [Lanes; Self::COUNT] {
        let mut least = [Lanes::splat(f64::INFINITY); Self::COUNT];
        let limits = seeds.limits::<{ Self::COUNT }>([x, y, z], metric);
        for place in 0..ADJACENT {
            if limits.as_ref().is_some_and(|limits| limits.exclude(place)) {
                continue;
            }
            let (dx, dy, dz) = (x - seeds.x[place], y - seeds.y[place], z - seeds.z[place]);
            let sum = metric.sum_of_four(dx, dy, dz);
            let next = sum.map(|sum| f64::from_bits(sum.to_bits() & !PLACE | place as u64));
            insert(&mut least, next);
        }
        least
    }

    /// Those of one of four points.
    #[inline(always)]
    fn of_lane(least: &[Lanes; Self::COUNT], lane: usize, seeds: &Seeds) -> Self {
        let sum = |i: usize| least[i].0[lane];
        let seed = |i: usize| seeds.at((sum(i).to_bits() & PLACE) as usize % ADJACENT);
        Self { sums: [sum(0), sum(1), sum(2), sum(3)], seeds: [seed(0), seed(1), seed(2), seed(3)] }
    }

    /// Meets those of the other cells around, as far as they may be as near.
    #[inline(never)]
    fn meet_far(&mut self, p: DVec3, cell: [i32; 3], metric: Metric) {
        let corner = DVec3::new(f64::from(cell[0]), f64::from(cell[1]), f64::from(cell[2]));
        let least = Least::new(metric, p - corner);
        for (axis, step) in [(0, -2), (0, 2), (1, -2), (1, 2), (2, -2), (2, 2)] {
            if !least.may_any_reach(axis, step, self.sums[Self::COUNT - 1]) {
                continue;
            }
            for &[one, other] in &BESIDE {
                let mut offset = [step; 3];
                (offset[(axis + 1) % 3], offset[(axis + 2) % 3]) = (one, other);
                if least.may_reach(offset, self.sums[Self::COUNT - 1]) {
                    let seed = seed(cell, offset);
                    self.meet(metric.sum(p - seed), seed);
                }
            }
        }
    }

    #[inline(always)]
    fn meet(&mut self, sum: f64, seed: DVec3) {
        if sum >= self.sums[Self::COUNT - 1] {
            return;
        }
        let mut place = Self::COUNT - 1;
        while place > 0 && sum < self.sums[place - 1] {
            (self.sums[place], self.seeds[place]) = (self.sums[place - 1], self.seeds[place - 1]);
            place -= 1;
        }
        (self.sums[place], self.seeds[place]) = (sum, seed);
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
