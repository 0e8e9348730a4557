//! `warp { repeat … }` (docs/spec/patterns-textures.md 5.2).

use crate::math::DVec3;

/// Cuts space into slabs that look alike.
#[derive(Clone, Debug)]
pub struct Repeat {
    axis: usize,
    width: f64,
    offset: DVec3,
    flip: DVec3,
    flips_axis: bool,
}

impl Repeat {
    /// `width` has one component that is not zero; slab number b is moved by b times `offset`, and
    /// in odd slabs the axes with a `flip` are mirrored. Widths are kept in single precision.
    pub fn new(width: DVec3, offset: DVec3, flip: DVec3) -> Self {
        let axis = (0..3).find(|&k| width[k] != 0.0).unwrap_or(0);
        Self {
            axis,
            width: f64::from(width[axis] as f32),
            offset,
            flip: flip.map(|f| if f == 0.0 { 1.0 } else { -1.0 }),
            flips_axis: flip[axis] != 0.0,
        }
    }

    /// Where in the first slab `p` is.
    pub fn point(&self, p: DVec3) -> DVec3 {
        let block = f64::from((p[self.axis] / self.width).floor() as f32);
        let mut r = p;
        r[self.axis] -= f64::from((block * self.width) as f32);
        if block % 2.0 != 0.0 {
            r *= self.flip;
            if self.flips_axis {
                r[self.axis] += self.width;
            }
        }
        r + block * self.offset
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// docs/spec/patterns-textures.md 5.3.
    #[test]
    fn slabs_repeat_flip_and_move() {
        let warp = Repeat::new(DVec3::Y * 1.3, DVec3::new(0.1, 0.2, 0.3), DVec3::new(1.0, 1.0, 0.0));
        let found = warp.point(DVec3::new(-1.3, 2.7, 0.45));
        assert!(found.abs_diff_eq(DVec3::new(-1.1, 0.500000095367432, 1.05), 1e-14), "{found}");
        let narrow = Repeat::new(DVec3::X * 0.7, DVec3::ZERO, DVec3::ZERO);
        let found = narrow.point(DVec3::new(-1.3, 2.7, 0.45));
        assert!((found.x - 0.099999976158142).abs() < 1e-15, "{found}");
    }
}
