//! `density_file`: a block of voxels in the unit cube (docs/spec/patterns-textures.md 2.4).

mod along;

use std::sync::Arc;

use crate::math::DVec3;

/// Voxels and how to read between them.
#[derive(Clone, Debug)]
pub struct DensityFile {
    /// Voxels along x, y, z; none is 0.
    pub size: [usize; 3],
    /// Bytes of a voxel: 1, 2 or 4.
    pub width: usize,
    /// Big-endian numbers, x fastest; the largest a voxel can hold stands for 1.
    pub voxels: Arc<[u8]>,
    /// How to read between voxels.
    pub interpolation: Interpolation,
}

/// How to read between voxels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the usual names")]
pub enum Interpolation {
    Nearest,
    Trilinear,
    Tricubic,
}

impl DensityFile {
    /// 0 outside the unit cube.
    pub(super) fn value(&self, p: DVec3) -> f64 {
        let inside = |c: f64| (0.0..1.0).contains(&c);
        if !(inside(p.x) && inside(p.y) && inside(p.z)) {
            return 0.0;
        }
        let [x, y, z] = self.size;
        let at = p * DVec3::new(x as f64, y as f64, z as f64);
        // Numbers above zero: what is before the point is the next whole number below.
        let [i, j, k] = [at.x as usize, at.y as usize, at.z as usize];
        let part = at - DVec3::new(i as f64, j as f64, k as f64);
        match self.interpolation {
            Interpolation::Nearest => self.voxel(i, j, k),
            Interpolation::Trilinear => self.linear([i, j, k], part),
            Interpolation::Tricubic => self.cubic([i, j, k], part),
        }
    }

    /// A voxel; the block repeats.
    fn voxel(&self, i: usize, j: usize, k: usize) -> f64 {
        let [x, y, z] = self.size;
        self.inner_voxel(repeated(i, x), repeated(j, y), repeated(k, z))
    }

    /// A voxel of the block itself.
    #[inline]
    fn inner_voxel(&self, i: usize, j: usize, k: usize) -> f64 {
        let [x, y, _] = self.size;
        let at = (k * y + j) * x + i;
        let bytes = &self.voxels[at * self.width..][..self.width];
        let number = bytes.iter().fold(0_u32, |number, byte| number << 8 | u32::from(*byte));
        f64::from(number) / f64::from(u32::MAX >> (32 - 8 * self.width))
    }

    fn linear(&self, [i, j, k]: [usize; 3], part: DVec3) -> f64 {
        let [x, y, z] = self.size;
        let [i, j, k] = [repeated(i, x), repeated(j, y), repeated(k, z)];
        let (right, above, behind) = (repeated(i + 1, x), repeated(j + 1, y), repeated(k + 1, z));
        let mix = |a: f64, b: f64, t: f64| a * (1.0 - t) + b * t;
        let row = |j, k| mix(self.inner_voxel(i, j, k), self.inner_voxel(right, j, k), part.x);
        let layer = |k| mix(row(j, k), row(above, k), part.y);
        mix(layer(k), layer(behind), part.z)
    }

    /// In single precision; along z first, then y, then x.
    fn cubic(&self, [i, j, k]: [usize; 3], part: DVec3) -> f64 {
        // Unsigned arithmetic takes the neighbour below 0 modulo 2^64, as POV-Ray does.
        let four = |c: usize| [c.wrapping_sub(1), c, c + 1, c + 2];
        let [x, y, z] = [part.x as f32, part.y as f32, part.z as f32];
        let column = |i, j| spline(four(k).map(|k| self.voxel(i, j, k) as f32), z);
        let row = |i| spline(four(j).map(|j| column(i, j)), y);
        f64::from(spline(four(i).map(row), x)).max(0.0)
    }
}

/// The remainder of a number that mostly is less anyway: dividing takes long.
#[inline]
fn repeated(number: usize, size: usize) -> usize {
    if number < size { number } else { number % size }
}

fn spline([a, b, c, d]: [f32; 4], t: f32) -> f32 {
    let m = 0.5 * (c - a);
    let n = 0.5 * (d - b);
    // The two coefficients are summed in double precision.
    let [fall, start, end] = [b - c, m, n].map(f64::from);
    let cubic = (2.0 * fall + start + end) as f32;
    let square = (-3.0 * fall - 2.0 * start - end) as f32;
    ((cubic * t + square) * t + m) * t + b
}
