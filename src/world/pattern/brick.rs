//! `brick` (docs/spec/patterns-textures.md 2.6).

use crate::math::noise::EPSILON;
use crate::math::{Band, DVec3};

/// `brick`: 0 is mortar, 1 is brick.
#[derive(Clone, Copy, Debug)]
pub struct Brick {
    size: DVec3,
    mortar: f64,
}

impl Brick {
    /// Size of a brick with its mortar, and the thickness of the mortar.
    pub fn new(size: DVec3, mortar: f32) -> Self {
        Self { size, mortar: f64::from((f64::from(mortar) - EPSILON * 2.0) as f32) }
    }

    pub(super) fn value(&self, p: DVec3) -> f64 {
        let m = self.mortar;
        let at = p + (EPSILON + m);
        let (share, part) = (m / self.size, at / self.size);
        if fraction(part.y) <= share.y {
            return 0.0;
        }
        // Bricks of odd courses are moved by half a brick.
        let even_course = fraction(part.y * 0.5) <= 0.5;
        let (x, z) = if even_course { (part.x, part.z + 0.5) } else { (part.x + 0.5, part.z) };
        let mortar = fraction(x) <= share.x || fraction(z) <= share.z;
        f64::from(!mortar)
    }

    /// What holds the values at all points that these hold.
    pub(super) fn along(&self, p: &[Band; 3]) -> Band {
        let share = self.mortar / self.size;
        let part = [0, 1, 2].map(|i| (p[i] + (EPSILON + self.mortar)) * (1.0 / self.size[i]));
        let is_mortar = |part: Band, share: f64| part.fraction().less_equal(Band::constant(share));
        let beside = |x: Band, z: Band| is_mortar(x, share.x).or(is_mortar(z, share.z));
        let even_course = (part[1] * 0.5).fraction().less_equal(Band::constant(0.5));
        let between = even_course
            .and(beside(part[0], part[2] + 0.5))
            .or(even_course.is_false().and(beside(part[0] + 0.5, part[2])));
        is_mortar(part[1], share.y).or(between).is_false()
    }
}

fn fraction(t: f64) -> f64 {
    let f = t - t.trunc();
    if f < 0.0 { f + 1.0 } else { f }
}
