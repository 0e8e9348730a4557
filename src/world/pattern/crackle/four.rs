//! Crackles at four points at once, where these are in one cell: all have the same seeds around them.

use super::{ADJACENT, Crackle, EPSILON, Kept, Metric, SEEDS, Seeds, insert};
use crate::math::Lanes;
use crate::math::wide::widest;

impl Crackle {
    /// [`Crackle::value`] at each of four points.
    pub(in crate::world::pattern) fn four(&self, point: &[Lanes; 3]) -> Lanes {
        let side_by_side = SEEDS.with_borrow_mut(|kept| {
            widest(
                #[inline(always)]
                || self.in_one_cell(point, kept),
            )
        });
        let alone = |lane: usize| self.value(Lanes::point(point, lane));
        let Some((mut values, sure)) = side_by_side else {
            return Lanes([alone(0), alone(1), alone(2), alone(3)]);
        };
        for lane in 0..Lanes::COUNT {
            if sure & 1 << lane == 0 {
                values.0[lane] = alone(lane);
            }
        }
        values
    }

    /// Whether sums of powers, to which an offset is added, are found for four points with the bits of one by one.
    fn has_sums_of_four(&self) -> bool {
        let of_four = matches!(self.metric, Metric::Halves(_)) || self.metric.power_of_four().is_some();
        of_four && self.metric.offset(self.offset) >= 0.0
    }

    /// The values of points that are in one cell, and bits that say for which of them the seeds in the cells beside are
    /// enough.
    #[inline(always)]
    fn in_one_cell(&self, point: &[Lanes; 3], kept: &mut Kept) -> Option<(Lanes, u32)> {
        let mut cell = [0; 3];
        for axis in 0..3 {
            let corner = (point[axis] - EPSILON).map(f64::floor);
            let first = corner.0[0];
            if corner.bits(|c| c == first) != 0b1111 {
                return None;
            }
            cell[axis] = first as i32;
        }
        let counting = self.counting();
        let seeds = kept.around(cell);
        let sums = match (self.solid, self.metric, counting) {
            (None, Metric::Square, 1) => seeds.least_of_four::<1>(point, |d| d * d),
            (None, Metric::Square, _) => seeds.least_of_four::<3>(point, |d| d * d),
            (None, Metric::Absolute, _) => seeds.least_of_four::<3>(point, Lanes::abs),
            (None, Metric::Halves(_) | Metric::Power(_), 2..) if self.has_sums_of_four() => {
                seeds.least_sums_of_four(point, self.metric)
            }
            _ => return None,
        };
        let sure = sums[counting - 1].bits(|sum| self.metric.ends_nearby(sum));
        let offset = self.metric.offset(self.offset);
        let (form, mut values) = (self.form.to_array(), Lanes::ZERO);
        for place in 0..counting {
            if form[place] != 0.0 {
                values = values + self.metric.distances(sums[place] + offset) * form[place];
            }
        }
        Some((values.map(|v| v.clamp(0.0, 1.0)), sure))
    }
}

/// What is farther than this from each of four points isn't among the seeds nearest to any.
pub(super) struct Limits {
    squares: [Lanes; ADJACENT],
    farthest: Lanes,
}

impl Limits {
    /// Whether the seed at `place` is so far away.
    #[inline(always)]
    pub(super) fn exclude(&self, place: usize) -> bool {
        let beyond = self.squares[place] - self.farthest;
        beyond.all_positive()
    }
}

impl Seeds {
    /// By the squares of their distances, which are soon found, which seeds can't be among the `COUNT` nearest.
    #[inline(always)]
    pub(super) fn limits<const COUNT: usize>(&self, [x, y, z]: [Lanes; 3], metric: Metric) -> Option<Limits> {
        let stretched = metric.stretched()?;
        let mut squares = [Lanes::ZERO; ADJACENT];
        let mut least = [Lanes::splat(f64::INFINITY); COUNT];
        for (place, square) in squares.iter_mut().enumerate() {
            let (dx, dy, dz) = (x - self.x[place], y - self.y[place], z - self.z[place]);
            *square = dx * dx + dy * dy + dz * dz;
            insert(&mut least, *square);
        }
        Some(Limits { squares, farthest: least[COUNT - 1] * stretched })
    }

    /// For each of four points in the cell the three least sums by a metric of powers.
    #[inline(always)]
    fn least_sums_of_four(&self, &[x, y, z]: &[Lanes; 3], metric: Metric) -> [Lanes; 3] {
        let mut least = [Lanes::splat(f64::INFINITY); 3];
        let limits = self.limits::<3>([x, y, z], metric);
        for place in 0..ADJACENT {
            if limits.as_ref().is_some_and(|limits| limits.exclude(place)) {
                continue;
            }
            let (dx, dy, dz) = (x - self.x[place], y - self.y[place], z - self.z[place]);
            insert(&mut least, metric.sum_of_four(dx, dy, dz));
        }
        least
    }

    /// For each of four points in the cell the least sums, so many, in order.
    #[inline(always)]
    fn least_of_four<const COUNT: usize>(
        &self,
        [x, y, z]: &[Lanes; 3],
        part: impl Fn(Lanes) -> Lanes,
    ) -> [Lanes; 3] {
        let mut least = [Lanes::splat(f64::INFINITY); COUNT];
        for place in 0..ADJACENT {
            let sums = part(*x - self.x[place]) + part(*y - self.y[place]) + part(*z - self.z[place]);
            insert(&mut least, sums);
        }
        let mut first = [Lanes::splat(f64::INFINITY); 3];
        first[..COUNT].copy_from_slice(&least);
        first
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;

    #[test]
    fn four_at_once_are_as_one_after_the_other() {
        let forms = [DVec3::X, DVec3::new(-1.0, 1.0, 0.0), DVec3::new(0.2, -0.3, 0.7)];
        for (form, metric, solid) in forms
            .into_iter()
            .flat_map(|form| [2.0, 1.0, 1.5, 2.2, 3.0].map(|metric| (form, Metric::new(metric), None)))
            .chain([(DVec3::X, Metric::Square, Some(2))])
        {
            for offset in [0.0, 0.3] {
                let crackle = Crackle { form, metric, offset, solid };
                for n in 0..500 {
                    let step = Lanes([0.0, 1.0, 2.0, 3.0]) * (0.002 * 1.01_f64.powi(n));
                    let away = f64::from(n) * 0.173 - 40.0;
                    let point = [step + away, step * 0.3 - away, step * 0.1 + 0.7];
                    let found = crackle.four(&point).0;
                    let alone = |i: usize| crackle.value(Lanes::point(&point, i)).to_bits();
                    assert_eq!(found.map(f64::to_bits), [0, 1, 2, 3].map(alone), "{crackle:?} at {point:?}");
                }
            }
        }
    }
}
