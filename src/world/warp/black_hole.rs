//! `warp { black_hole … }` (docs/spec/patterns-textures.md 5.2).

use crate::math::noise::{EPSILON, cell_point};
use crate::math::{Band, DVec3, Lanes};

/// Pulls the pattern towards a point, or pushes it away.
#[derive(Clone, Debug)]
pub struct BlackHole {
    /// Middle of the hole, in the first block where it repeats.
    pub center: DVec3,
    /// Reach; points farther away stay.
    pub radius: f64,
    /// Strength.
    pub strength: f64,
    /// Exponent of the strength over the distance.
    pub falloff: f64,
    /// Pushes the pattern away.
    pub inverse: bool,
    /// Size of the blocks it repeats in; axes with 0 have no blocks.
    pub repeat: Option<DVec3>,
    /// Uncertainty of the middle in each block.
    pub turbulence: DVec3,
}

impl BlackHole {
    /// Where the pattern sees `p`.
    pub fn point(&self, p: DVec3) -> DVec3 {
        let mut center = self.center;
        if let Some(size) = self.repeat {
            let block = DVec3::from_array(std::array::from_fn(|k| {
                if size[k] >= EPSILON { (p[k] / size[k]).floor() } else { 0.0 }
            }));
            if self.turbulence != DVec3::ZERO {
                center += cell_point(block.to_array().map(|b| b as i32)) * self.turbulence;
            }
            center += size * block;
        }
        let d = p - center;
        let distance = d.length();
        if distance >= self.radius {
            return p;
        }
        let share = (self.radius - distance) / self.radius;
        let pull = (share.powf(self.falloff) * self.strength).min(1.0);
        if self.inverse { p - d * pull } else { p + d * pull }
    }

    /// The most that the strength is multiplied with: towards the end of a hole that falls off backwards it grows
    /// without bounds, but no distance that isn't the radius is nearer to it than what numbers part.
    fn greatest_share(&self) -> f64 {
        (0.5 * f64::EPSILON).powf(self.falloff.min(0.0))
    }

    /// How strong the pull may be at the hole's end, where it stops at once unless it has fallen off before.
    fn rim(&self) -> Band {
        let greatest = self.strength * self.greatest_share();
        Band::between(greatest.min(0.0), greatest.clamp(0.0, 1.0))
    }

    /// What holds the places of all points that these hold.
    pub(super) fn along(&self, p: [Band; 3]) -> [Band; 3] {
        if self.radius <= 0.0 {
            return p;
        }
        let size = self.repeat.unwrap_or(DVec3::ZERO);
        let blocks = [0, 1, 2].map(|k| {
            let block = |c: f64| if size[k] >= EPSILON { (c / size[k]).floor() } else { 0.0 };
            (p[k].low().map(block), p[k].high().map(block))
        });
        let mut centers = [Lanes::ZERO; 3];
        for lane in 0..Lanes::COUNT {
            let block = DVec3::from_array(blocks.map(|(low, _)| low.0[lane]));
            let moved = match self.repeat {
                Some(_) if self.turbulence != DVec3::ZERO => {
                    cell_point(block.to_array().map(|b| b as i32)) * self.turbulence
                }
                _ => DVec3::ZERO,
            };
            let center = self.center + moved + size * block;
            for (k, all) in centers.iter_mut().enumerate() {
                all.0[lane] = center[k];
            }
        }
        let d = [0, 1, 2].map(|k| p[k] - Band::numbers(centers[k]));
        let distance = (d[0].square() + d[1].square() + d[2].square()).sqrt();
        let zero = Band::constant(0.0);
        let share = -distance * (1.0 / self.radius) + 1.0;
        let pull_of =
            |share: Band| (share.powf(Band::constant(self.falloff)) * self.strength).min(Band::constant(1.0));
        let pull = if self.falloff > 0.0 {
            pull_of(share.max(zero))
        } else {
            let beside = zero.where_positive(-share.high(), self.rim());
            pull_of(share).where_positive(share.low(), beside)
        };
        let pull = if self.inverse { -pull } else { pull };
        // In several blocks at once: as far as the strongest of all pulls.
        let farthest = self.radius * (self.strength * self.greatest_share()).min(1.0).abs().max(1.0);
        let any = Band::between(-farthest, farthest);
        let many = blocks.iter().fold(Lanes::ZERO, |many, (low, high)| many + (*high - *low).abs());
        [0, 1, 2].map(|k| (p[k] + any).where_positive(many, p[k] + d[k] * pull))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// docs/spec/patterns-textures.md 5.3.
    #[test]
    fn holes_pull_as_povrays() {
        let single = BlackHole {
            center: DVec3::new(0.1, 0.2, 0.3),
            radius: 3.2,
            strength: 1.7,
            falloff: 1.3,
            inverse: true,
            repeat: None,
            turbulence: DVec3::ZERO,
        };
        let found = single.point(DVec3::new(-1.3, 2.7, 0.45));
        let expected = DVec3::new(-2.0 + 0.824526052013921, 2.477632049975142, 0.436657922998508);
        assert!(found.abs_diff_eq(expected, 1e-14), "{found}");

        let repeated = BlackHole {
            center: DVec3::splat(0.6),
            radius: 0.5,
            strength: 1.2,
            falloff: 2.0,
            inverse: false,
            repeat: Some(DVec3::new(2.0, 3.0, 0.0)),
            turbulence: DVec3::new(0.3, 0.4, 0.5),
        };
        let found = repeated.point(DVec3::new(0.55, 0.7, 0.5));
        let expected = DVec3::new(0.534809227632072, 0.695696444615803, 0.483964581518001);
        assert!(found.abs_diff_eq(expected, 1e-14), "{found}");
    }
}
