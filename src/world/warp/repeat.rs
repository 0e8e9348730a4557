//! `warp { repeat … }` (docs/spec/patterns-textures.md 5.2).

use crate::math::{Band, DVec3, Lanes};

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
        if is_odd(block) {
            r *= self.flip;
            if self.flips_axis {
                r[self.axis] += self.width;
            }
        }
        r + block * self.offset
    }

    /// Where in the first slab four points are.
    #[inline(always)]
    pub(super) fn four(&self, p: [Lanes; 3]) -> [Lanes; 3] {
        let mut r = p;
        let blocks = (p[self.axis] / self.width).map(|slab| f64::from(slab.floor() as f32));
        r[self.axis] = r[self.axis] - (blocks * self.width).map(|start| f64::from(start as f32));
        for lane in 0..Lanes::COUNT {
            if is_odd(blocks.0[lane]) {
                for (coordinate, flip) in r.iter_mut().zip(self.flip.to_array()) {
                    coordinate.0[lane] *= flip;
                }
                if self.flips_axis {
                    r[self.axis].0[lane] += self.width;
                }
            }
        }
        for (coordinate, offset) in r.iter_mut().zip(self.offset.to_array()) {
            *coordinate = *coordinate + blocks * offset;
        }
        r
    }

    /// What holds the places in the first slab of all points that these hold.
    pub(super) fn along(&self, p: [Band; 3]) -> [Band; 3] {
        let slab = |c: f64| c / self.width;
        let slabs = p[self.axis].low().zip(p[self.axis].high(), |low, high| slab(low).min(slab(high)));
        let last = p[self.axis].low().zip(p[self.axis].high(), |low, high| slab(low).max(slab(high)));
        // Beside a boundary the quotient's rounding may say either.
        let (first, last) = (
            slabs.map(|n| (n - ROOM * (1.0 + n.abs())).floor()),
            last.map(|n| (n + ROOM * (1.0 + n.abs())).floor()),
        );
        let count = last - first;
        let (at_first, at_last) = (self.in_slabs(p, first), self.in_slabs(p, last));
        let any = self.in_any(p, first, last);
        [0, 1, 2].map(|i| {
            let two = at_first[i].hull(at_last[i]).where_positive(-count + 1.5, any[i]);
            let one = at_first[i].where_positive(-count + 0.5, two);
            // Single precision no longer counts so many.
            let most = Lanes::splat(MOST) - first.abs() - last.abs();
            one.where_positive(most, Band::UNKNOWN)
        })
    }

    /// The places of points that are in these slabs.
    fn in_slabs(&self, p: [Band; 3], slabs: Lanes) -> [Band; 3] {
        let mut moved = p;
        moved[self.axis] =
            moved[self.axis] - Band::numbers(slabs.map(|slab| f64::from((slab * self.width) as f32)));
        let odd = slabs.map(|slab| (slab % 2.0).abs());
        [0, 1, 2].map(|i| {
            let beyond = if i == self.axis && self.flips_axis { self.width } else { 0.0 };
            let mirrored = moved[i] * self.flip[i] + beyond;
            mirrored.where_positive(odd, moved[i]) + Band::numbers(slabs * self.offset[i])
        })
    }

    /// The places of points that may be in any of many slabs.
    fn in_any(&self, p: [Band; 3], first: Lanes, last: Lanes) -> [Band; 3] {
        let slabs = Band::within(first, last);
        [0, 1, 2].map(|i| {
            let place = if i == self.axis {
                let room = (first.abs() + last.abs() + 1.0) * (self.width.abs() * f64::from(f32::EPSILON));
                Band::within(-room + self.width.min(0.0), room + self.width.max(0.0))
            } else if self.flip[i] < 0.0 {
                p[i].hull(-p[i])
            } else {
                p[i]
            };
            place + slabs * self.offset[i]
        })
    }
}

/// Beside a boundary the number of a slab is not sure, for this share of it.
const ROOM: f64 = 1e-12;

/// So many slabs have numbers in single precision.
const MOST: f64 = 1e7;

/// Whether a whole number is odd, or no number at all.
#[inline(always)]
fn is_odd(block: f64) -> bool {
    // The remainder over 2 would do, but it is a loop.
    let half = block * 0.5;
    half - half.floor() != 0.0
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
