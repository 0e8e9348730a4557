//! `crackle` and the seeds of `facets` (docs/spec/patterns-textures.md 2.3 and 4.3).

use std::cell::RefCell;
use std::sync::LazyLock;

use crate::math::DVec3;
use crate::math::noise::{EPSILON, cell_point, noise, vector_noise};

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

/// The sum that stands for a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Metric {
    /// `metric 2`: squares.
    Square,
    /// `metric 1`: absolute values.
    Absolute,
    /// Any other whole power up to 8.
    Whole(i32),
    /// Any other power.
    Power(f64),
}

impl Metric {
    /// Beyond this multiplying out is no longer as exact as a power.
    const LARGEST_WHOLE: f64 = 8.0;

    /// The metric for the number a user writes.
    pub fn new(metric: f64) -> Self {
        match metric {
            2.0 => Self::Square,
            1.0 => Self::Absolute,
            whole if whole > 0.0 && whole <= Self::LARGEST_WHOLE && whole.fract() == 0.0 => {
                Self::Whole(whole as i32)
            }
            other => Self::Power(other),
        }
    }

    fn sum(self, d: DVec3) -> f64 {
        match self {
            Self::Square => d.x * d.x + d.y * d.y + d.z * d.z,
            Self::Absolute => d.x.abs() + d.y.abs() + d.z.abs(),
            Self::Whole(m) => d.x.abs().powi(m) + d.y.abs().powi(m) + d.z.abs().powi(m),
            Self::Power(m) => d.x.abs().powf(m) + d.y.abs().powf(m) + d.z.abs().powf(m),
        }
    }

    fn distance(self, sum: f64) -> f64 {
        match self {
            Self::Square => sum.sqrt(),
            Self::Absolute => sum,
            Self::Whole(m) => sum.powf(1.0 / f64::from(m)),
            Self::Power(m) => sum.powf(1.0 / m),
        }
    }

    fn offset(self, offset: f64) -> f64 {
        match self {
            _ if offset == 0.0 => 0.0,
            Self::Square => offset * offset,
            Self::Absolute => offset,
            Self::Whole(m) => offset.powi(m),
            Self::Power(m) => offset.powf(m),
        }
    }

    /// Whether a seed in the cell at `offset` from the cell of a point at `inside` (its place in
    /// its own cell, 0 … 1) could be as near as `limit`. Only squares are worth the exact question.
    fn may_reach(self, offset: [i32; 3], inside: DVec3, limit: f64) -> bool {
        let gap = |o: i32, f: f64| match o {
            0 => 0.0,
            1.. => f64::from(o) - f,
            _ => f - f64::from(o + 1),
        };
        let d = DVec3::new(gap(offset[0], inside.x), gap(offset[1], inside.y), gap(offset[2], inside.z));
        let least = match self {
            Self::Square => d.length_squared(),
            Self::Absolute => d.element_sum(),
            Self::Whole(m) => d.max_element().powi(m),
            Self::Power(_) => return true,
        };
        // A little slack keeps rounding from hiding a seed on the very boundary.
        least <= limit * (1.0 + 1e-9) + 1e-9
    }

    /// Whether no seed two cells away, a whole cell between, can be as near as `limit`.
    fn ends_nearby(self, limit: f64) -> bool {
        let grows = match self {
            Self::Power(m) => m > 0.0,
            _ => true,
        };
        grows && limit < 1.0 - 1e-9
    }
}

/// So many of the [`NEIGHBOURS`] share a corner with the cell itself.
const ADJACENT: usize = 27;

/// The cells whose seeds may be among the nearest three: at most one step of two. The nearest cells come
/// first, so that the far ones can be passed over.
static NEIGHBOURS: LazyLock<Vec<[i32; 3]>> = LazyLock::new(|| {
    let steps = || -2..=2_i32;
    let all = steps().flat_map(|x| steps().flat_map(move |y| steps().map(move |z| [x, y, z])));
    let mut near: Vec<_> = all.filter(|o| o.iter().filter(|c| c.abs() == 2).count() <= 1).collect();
    near.sort_by_key(|o| (o.iter().any(|c| c.abs() == 2), o.iter().map(|c| c * c).sum::<i32>()));
    near
});

/// The seeds of a cell and those around it, in the order of the [`NEIGHBOURS`].
struct Seeds {
    cell: [i32; 3],
    places: [DVec3; ADJACENT],
}

thread_local! {
    /// Those around the last point asked for: the next one is mostly in the same cell.
    static SEEDS: RefCell<Seeds> = RefCell::new(Seeds::of([0; 3]));
}

impl Seeds {
    fn of(cell: [i32; 3]) -> Self {
        Self { cell, places: std::array::from_fn(|number| seed(cell, NEIGHBOURS[number])) }
    }
}

/// The seed of the cell at `offset` from another.
fn seed(cell: [i32; 3], offset: [i32; 3]) -> DVec3 {
    let corner = std::array::from_fn(|axis| cell[axis].wrapping_add(offset[axis]));
    DVec3::from_array(corner.map(f64::from)) + cell_point(corner)
}

/// The three least sums and the seed of the least.
struct Nearest {
    sums: [f64; 3],
    seed: DVec3,
}

impl Nearest {
    fn meet(&mut self, seed: DVec3, sum: f64) {
        let [a, b, c] = self.sums;
        if sum >= c {
            return;
        }
        if sum < a {
            self.sums = [sum, a, b];
            self.seed = seed;
        } else if sum < b {
            self.sums = [a, sum, b];
        } else {
            self.sums[2] = sum;
        }
    }
}

impl Crackle {
    pub(super) fn value(&self, p: DVec3) -> f64 {
        let corner = (p - EPSILON).floor();
        let cell = corner.to_array().map(|c| c as i32);
        let mut nearest = Nearest { sums: [f64::INFINITY; 3], seed: DVec3::ZERO };
        SEEDS.with_borrow_mut(|seeds| {
            if seeds.cell != cell {
                *seeds = Seeds::of(cell);
            }
            let sums = seeds.places.map(|seed| self.metric.sum(p - seed));
            for (seed, sum) in seeds.places.into_iter().zip(sums) {
                nearest.meet(seed, sum);
            }
        });
        if !self.metric.ends_nearby(nearest.sums[2]) {
            for &offset in &NEIGHBOURS[ADJACENT..] {
                if self.metric.may_reach(offset, p - corner, nearest.sums[2]) {
                    let seed = seed(cell, offset);
                    nearest.meet(seed, self.metric.sum(p - seed));
                }
            }
        }
        let Nearest { sums, seed: nearest } = nearest;
        if let Some(generator) = self.solid {
            return noise(generator, nearest);
        }
        let offset = self.metric.offset(self.offset);
        let [a, b, c] = sums.map(|sum| self.metric.distance(sum + offset));
        (self.form.x * a + self.form.y * b + self.form.z * c).clamp(0.0, 1.0)
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
        let inside = q - (q - EPSILON).floor();
        for (number, &offset) in NEIGHBOURS.iter().enumerate() {
            if number == ADJACENT && self.signless() && self.metric.ends_nearby(best.0) {
                break;
            }
            if self.signless() && !self.metric.may_reach(offset, inside, best.0) {
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
