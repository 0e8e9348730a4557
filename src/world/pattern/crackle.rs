//! `crackle` and the seeds of `facets` (docs/spec/patterns-textures.md 2.3 and 4.3).

mod along;
mod four;
mod metric;

pub use metric::Metric;
use metric::power_of_halves;

use std::cell::RefCell;
use std::sync::LazyLock;

use crate::math::noise::{EPSILON, cell_point, noise, vector_noise};
use crate::math::wide::widest;
use crate::math::{DVec3, Lanes};

/// `crackle`.
#[derive(Clone, Copy, Debug)]
pub struct Crackle {
    /// Weights of the distances to the nearest three seeds.
    pub form: DVec3,
    /// How distances are measured.
    pub metric: Metric,
    /// Added to every distance, under the root.
    pub offset: f64,
    /// Instead of distances, noise at the nearest seed by this generator.
    pub solid: Option<u8>,
}

/// `facets`.
#[derive(Clone, Copy, Debug)]
pub struct Facets {
    /// Size of a facet.
    pub size: f64,
    /// 0: facets of directions. Otherwise facets of space, tilted by this much.
    pub coords: f64,
    /// How distances are measured.
    pub metric: Metric,
}

/// The least that seeds of cells may add to sums: for each axis by the step to the cell, from -2 to 2.
struct Least([[f64; 5]; 3]);

impl Least {
    /// For a point at `inside`, its place from the corner of the cell that steps are counted from.
    fn new(metric: Metric, inside: DVec3) -> Self {
        let mut least = [[0.0; 5]; 3];
        if metric.grows() {
            let inside = inside.to_array();
            for axis in 0..3 {
                let gaps = [1.0 + inside[axis], inside[axis], 0.0, 1.0 - inside[axis], 2.0 - inside[axis]];
                for step in [0, 1, 3, 4] {
                    least[axis][step] = metric.part(gaps[step].max(0.0));
                }
            }
        }
        Self(least)
    }

    /// Whether a seed in the cell at `offset` could be as near as `limit`.
    fn may_reach(&self, offset: [i32; 3], limit: f64) -> bool {
        let at = |axis: usize| self.0[axis][(offset[axis] + 2) as usize % 5];
        Self::is_within(at(0) + at(1) + at(2), limit)
    }

    /// The same for any cell at `step` along one axis.
    fn may_any_reach(&self, axis: usize, step: i32, limit: f64) -> bool {
        Self::is_within(self.0[axis][(step + 2) as usize % 5], limit)
    }

    /// A little slack keeps rounding from hiding a seed on the very boundary.
    fn is_within(least: f64, limit: f64) -> bool {
        least <= limit * (1.0 + 1e-9) + 1e-9
    }
}

/// So many of the [`NEIGHBOURS`] share a corner with the cell itself.
const ADJACENT: usize = 27;

/// The steps along two axes to what is at most one step away along both, the nearest first.
const BESIDE: [[i32; 2]; 9] = [[0, 0], [-1, 0], [1, 0], [0, -1], [0, 1], [-1, -1], [-1, 1], [1, -1], [1, 1]];

/// Room for as many, in whole registers.
const PLACES: usize = 28;

/// The cells whose seeds may be among the nearest three: at most one step of two. The nearest cells come
/// first, so that the far ones can be passed over.
static NEIGHBOURS: LazyLock<Vec<[i32; 3]>> = LazyLock::new(|| {
    let steps = || -2..=2_i32;
    let all = steps().flat_map(|x| steps().flat_map(move |y| steps().map(move |z| [x, y, z])));
    let mut near: Vec<_> = all.filter(|o| o.iter().filter(|c| c.abs() == 2).count() <= 1).collect();
    near.sort_by_key(|o| (o.iter().any(|c| c.abs() == 2), o.iter().map(|c| c * c).sum::<i32>()));
    near
});

/// The seeds of a cell and those around it, in the order of the [`NEIGHBOURS`], coordinate by coordinate.
struct Seeds {
    cell: [i32; 3],
    x: [f64; PLACES],
    y: [f64; PLACES],
    z: [f64; PLACES],
}

/// How many cells' seeds are kept.
const KEPT: usize = 512;

/// The seeds around the cells last asked for: the next point is mostly in the same cell or in one beside, and where
/// samples go to and fro along rays, or several crackles are asked in turn, in one of many.
struct Kept(Vec<Option<Seeds>>);

thread_local! {
    static SEEDS: RefCell<Kept> = const { RefCell::new(Kept(Vec::new())) };
}

impl Kept {
    /// The seeds around a cell, known or made.
    #[inline(always)]
    fn around(&mut self, cell: [i32; 3]) -> &Seeds {
        if self.0.is_empty() {
            self.0.resize_with(KEPT, || None);
        }
        let place = &mut self.0[Self::place(cell)];
        if place.as_ref().is_some_and(|seeds| seeds.cell != cell) {
            *place = None;
        }
        place.get_or_insert_with(|| Seeds::of(cell))
    }

    /// Where a cell's seeds are: four cells along each axis have places of their own, those farther away other ones
    /// mostly.
    #[inline(always)]
    fn place([x, y, z]: [i32; 3]) -> usize {
        let near = x & 3 | (y & 3) << 2 | (z & 3) << 4;
        let far = (x >> 2).wrapping_mul(3) ^ (y >> 2).wrapping_mul(5) ^ (z >> 2).wrapping_mul(7);
        ((far << 6 | near) as u32 as usize) % KEPT
    }
}

impl Seeds {
    fn of(cell: [i32; 3]) -> Self {
        let nowhere = [f64::INFINITY; PLACES];
        let mut seeds = Self { cell, x: nowhere, y: nowhere, z: nowhere };
        for (place, &offset) in NEIGHBOURS[..ADJACENT].iter().enumerate() {
            [seeds.x[place], seeds.y[place], seeds.z[place]] = seed(cell, offset).to_array();
        }
        seeds
    }

    /// The sums of those nearest to a point, in order, as many as are `counting`, and the seed of the least for a
    /// `solid`.
    #[inline(always)]
    fn nearest(&self, p: DVec3, metric: Metric, counting: usize, solid: bool) -> Nearest {
        let sums = self.sums(p, metric);
        let least = if counting == 3 {
            least::<3>(&sums)
        } else {
            let [a, b] = least::<2>(&sums);
            [a, b, f64::INFINITY]
        };
        let mut nearest = Nearest { sums: least, seed: DVec3::ZERO };
        if solid && least[0] < f64::INFINITY {
            let place = sums.iter().position(|&sum| sum == least[0]);
            nearest.seed = place.map_or(DVec3::ZERO, |place| self.at(place));
        }
        nearest
    }

    #[inline(always)]
    fn at(&self, place: usize) -> DVec3 {
        DVec3::new(self.x[place], self.y[place], self.z[place])
    }

    /// The sums that stand for the distances from a point.
    #[inline(always)]
    fn sums(&self, p: DVec3, metric: Metric) -> [f64; PLACES] {
        match metric {
            Metric::Square => self.sums_of(p, |d| d * d),
            Metric::Absolute => self.sums_of(p, f64::abs),
            Metric::Halves(halves) if halves % 2 == 0 => {
                self.sums_of(p, |d| power_of_halves(d.abs(), halves & !1))
            }
            Metric::Halves(halves) => self.sums_of(p, |d| power_of_halves(d.abs(), halves)),
            Metric::Power(m) if metric.power_of_four().is_some() => self.sums_of_powers(p, m),
            Metric::Power(m) => self.sums_of(p, |d| d.abs().powf(m)),
        }
    }

    /// The same of powers, which four places are taken to at once.
    #[inline(always)]
    fn sums_of_powers(&self, p: DVec3, m: f64) -> [f64; PLACES] {
        let mut sums = [f64::INFINITY; PLACES];
        for place in (0..PLACES).step_by(Lanes::COUNT) {
            let Lanes(sum) = powers(p.x, &self.x, place, m)
                + powers(p.y, &self.y, place, m)
                + powers(p.z, &self.z, place, m);
            sums[place..place + Lanes::COUNT].copy_from_slice(&sum);
        }
        sums
    }

    /// The same with a way to what a coordinate adds. Written out: what is called for each place would not fill wide registers.
    #[expect(clippy::needless_range_loop, reason = "four lists are gone through side by side")]
    #[inline(always)]
    fn sums_of(&self, p: DVec3, part: impl Fn(f64) -> f64) -> [f64; PLACES] {
        let mut sums = [0.0; PLACES];
        for place in 0..PLACES {
            sums[place] = part(p.x - self.x[place]) + part(p.y - self.y[place]) + part(p.z - self.z[place]);
        }
        for sum in &mut sums[ADJACENT..] {
            *sum = f64::INFINITY;
        }
        sums
    }
}

/// The distances along an axis from a coordinate to four seeds, to a power. A function, for a closure would not be
/// compiled for wide registers.
#[inline(always)]
fn powers(c: f64, seeds: &[f64; PLACES], first: usize, m: f64) -> Lanes {
    let [i, j, k, l] = [first, first + 1, first + 2, first + 3];
    (-Lanes([seeds[i], seeds[j], seeds[k], seeds[l]]) + c).abs().power(m)
}

/// The least sums in order: four lists side by side first, then of these two, then of all.
#[inline(always)]
fn least<const COUNT: usize>(sums: &[f64; PLACES]) -> [f64; COUNT] {
    let mut least = [Lanes::splat(f64::INFINITY); COUNT];
    for place in 0..PLACES / Lanes::COUNT {
        let [i, j, k, l] = [4 * place, 4 * place + 1, 4 * place + 2, 4 * place + 3];
        insert(&mut least, Lanes([sums[i], sums[j], sums[k], sums[l]]));
    }
    let halves = least;
    for Lanes([a, b, c, d]) in halves {
        insert(&mut least, Lanes([c, d, a, b]));
    }
    let quarters = least;
    for Lanes([a, b, c, d]) in quarters {
        insert(&mut least, Lanes([b, a, d, c]));
    }
    let mut first = [0.0; COUNT];
    for place in 0..COUNT {
        first[place] = least[place].0[0];
    }
    first
}

/// Keeps the least numbers of each lane in order; what is no number isn't among them.
#[inline(always)]
fn insert<const COUNT: usize>(least: &mut [Lanes; COUNT], mut next: Lanes) {
    for known in least {
        (*known, next) = (next.lesser(*known), known.greater(next));
    }
}

/// The seed of the cell at `offset` from another.
#[inline]
fn seed(cell: [i32; 3], offset: [i32; 3]) -> DVec3 {
    let [x, y, z] =
        [cell[0].wrapping_add(offset[0]), cell[1].wrapping_add(offset[1]), cell[2].wrapping_add(offset[2])];
    DVec3::new(f64::from(x), f64::from(y), f64::from(z)) + cell_point([x, y, z])
}

/// The least sums, three or as many as count, and the seed of the least.
struct Nearest {
    sums: [f64; 3],
    seed: DVec3,
}

impl Nearest {
    #[inline(always)]
    fn meet(&mut self, seed: DVec3, sum: f64) {
        let [a, b, c] = self.sums;
        if sum < a {
            self.sums = [sum, a, b];
            self.seed = seed;
        } else if sum < b {
            self.sums = [a, sum, b];
        } else if sum < c {
            self.sums[2] = sum;
        }
    }

    /// Meets the seeds of the cells two steps away along one axis.
    #[inline(never)]
    fn meet_far(&mut self, p: DVec3, corner: DVec3, cell: [i32; 3], metric: Metric, counting: usize) {
        let least = Least::new(metric, p - corner);
        for (axis, step) in [(0, -2), (0, 2), (1, -2), (1, 2), (2, -2), (2, 2)] {
            if !least.may_any_reach(axis, step, self.sums[counting - 1]) {
                continue;
            }
            for &[one, other] in &BESIDE {
                let mut offset = [step; 3];
                (offset[(axis + 1) % 3], offset[(axis + 2) % 3]) = (one, other);
                if least.may_reach(offset, self.sums[counting - 1]) {
                    let seed = seed(cell, offset);
                    self.meet(seed, metric.sum(p - seed));
                }
            }
        }
    }
}

impl Crackle {
    pub(super) fn value(&self, p: DVec3) -> f64 {
        SEEDS.with_borrow_mut(|seeds| {
            widest(
                #[inline(always)]
                || self.value_by(p, seeds),
            )
        })
    }

    /// How many of the nearest seeds the value is made of.
    fn counting(&self) -> usize {
        match self.form {
            // Sums that don't grow may spoil the value even without a share.
            _ if !self.metric.grows() => 3,
            _ if self.solid.is_some() => 1,
            form if form.z != 0.0 => 3,
            form if form.y != 0.0 => 2,
            _ => 1,
        }
    }

    /// The same, with seeds from which to go on.
    #[inline(always)]
    fn value_by(&self, p: DVec3, seeds: &mut Kept) -> f64 {
        let corner = (p - EPSILON).floor();
        let cell = [corner.x as i32, corner.y as i32, corner.z as i32];
        let counting = self.counting();
        let mut nearest = seeds.around(cell).nearest(p, self.metric, counting, self.solid.is_some());
        if !self.metric.ends_nearby(nearest.sums[counting - 1]) {
            nearest.meet_far(p, corner, cell, self.metric, counting);
        }
        let Nearest { sums, seed: nearest } = nearest;
        if let Some(generator) = self.solid {
            return noise(generator, nearest);
        }
        let offset = self.metric.offset(self.offset);
        let ([a, b, c], form) = (sums, self.form.to_array());
        let Lanes(distances) = match counting {
            1 => Lanes::splat(self.metric.distance(a + offset)),
            _ => self.metric.distances(Lanes([a, b, c, c]) + offset),
        };
        let mut sum = 0.0;
        for place in 0..3 {
            // What has no share doesn't count, unless it is infinite and spoils the sum.
            if form[place] != 0.0 || !self.metric.grows() {
                sum += form[place] * distances[place];
            }
        }
        sum.clamp(0.0, 1.0)
    }
}

impl Facets {
    /// The normal of the facet that `p` (or, without `coords`, the direction `n`) falls on; not unit.
    pub(crate) fn normal(&self, p: DVec3, n: DVec3) -> DVec3 {
        let n = n.normalize_or_zero();
        let query = if self.coords == 0.0 { n } else { p } * (1.0 / self.size.max(1e-6));
        let seed = self.nearest(query);
        if self.coords == 0.0 {
            return seed;
        }
        let tilt = vector_noise(seed);
        n + self.coords * (tilt - tilt.dot(n) * n)
    }

    /// POV-Ray's sum for metric 1 keeps the signs.
    fn signless(&self) -> bool {
        self.metric != Metric::Absolute
    }

    fn nearest(&self, q: DVec3) -> DVec3 {
        let mut best = (f64::INFINITY, DVec3::ZERO);
        let least = Least::new(self.metric, q - (q - EPSILON).floor());
        for (number, &offset) in NEIGHBOURS.iter().enumerate() {
            if number == ADJACENT && self.signless() && self.metric.ends_nearby(best.0) {
                break;
            }
            if self.signless() && !least.may_reach(offset, best.0) {
                continue;
            }
            let corner = (q + DVec3::from_array(offset.map(f64::from)) - EPSILON).floor();
            let seed = corner + cell_point(corner.to_array().map(|c| c as i32));
            let d = seed - q;
            let sum = if self.signless() { self.metric.sum(d) } else { d.element_sum() };
            if sum < best.0 {
                best = (sum, seed);
            }
        }
        best.1
    }
}

#[cfg(test)]
mod tests;
