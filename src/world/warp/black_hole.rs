//! `warp { black_hole … }` (docs/spec/patterns-textures.md 5.2).

use crate::math::DVec3;
use crate::math::noise::{EPSILON, cell_point};

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
