//! Lattice noise on four lanes at once, for processors with AVX2. The same operations in the same order as in
//! [`super::lattice`] give the same bits: what a cell's corners add is summed one after the other, and lanes hold
//! what is independent: several points, the components of a vector, or products before they are summed.

mod four;

use std::arch::x86_64::*;
use std::sync::LazyLock;

use glam::DVec3;

use super::tables::{GRADIENT, HASH, HASH_SIZE, SHIFT};
use super::{EPSILON, Octaves};
use crate::math::Lanes;
use four::{Axis, is_finite, is_zero};

/// The fixed tables in the order in which they are read here. There is one only where there is AVX2.
pub(super) struct Lattice {
    /// The lattice hash table.
    hash: [u16; HASH_SIZE],
    /// Half of an entry of the gradient table, and the three after it.
    slopes: [__m256d; 256],
    /// For each component of vector noise its entry of the gradient table.
    vectors: [__m256d; 259],
    /// The same, halved.
    halves: [__m256d; 256],
}

static LATTICE: LazyLock<Option<Box<Lattice>>> = LazyLock::new(|| {
    // SAFETY: the processor has been asked.
    is_x86_feature_detected!("avx2").then(|| unsafe { Lattice::new() })
});

/// A point seen from its cell.
struct Place {
    /// Numbers of the cell's lower planes.
    cell: [u32; 3],
    /// Distances from the lower and the upper planes in lanes 0, 1, 2.
    offset: [__m256d; 2],
    /// Influence of the lower and the upper planes.
    weight: [__m256d; 2],
}

impl Lattice {
    /// The tables, where the processor can do this.
    pub(super) fn get() -> Option<&'static Self> {
        LATTICE.as_deref()
    }

    /// What the corners around `p` add up to.
    pub(super) fn sum(&self, p: DVec3) -> f64 {
        // SAFETY: a `Lattice` exists only where there is AVX2.
        unsafe { self.single(p.x, p.y, p.z) }
    }

    /// What the corners around `p` add up to once it is scaled by each of `scales`.
    pub(super) fn sums(&self, p: DVec3, scales: &[f64], sums: &mut [f64]) {
        // SAFETY: a `Lattice` exists only where there is AVX2.
        unsafe { self.several(p.x, p.y, p.z, scales, sums) }
    }

    /// What the corners around four points add up to once these are scaled by each of `scales`.
    pub(super) fn sums_at_four(&self, point: &[Lanes; 3], scales: &[f64], sums: &mut [Lanes]) {
        // SAFETY: a `Lattice` exists only where there is AVX2.
        unsafe { self.points(point, scales, sums) }
    }

    /// Vector noise at `p` scaled by each of `scales`.
    pub(super) fn vectors(&self, p: DVec3, scales: &[f64], vectors: &mut [DVec3]) {
        // SAFETY: a `Lattice` exists only where there is AVX2.
        unsafe { self.all_vectors(p.x, p.y, p.z, scales, vectors) }
    }

    /// The sum of octaves of vector noise at `p`.
    pub(super) fn turbulence(&self, p: DVec3, octaves: &Octaves) -> DVec3 {
        // SAFETY: a `Lattice` exists only where there is AVX2.
        unsafe { self.octaves(p.x, p.y, p.z, octaves) }
    }

    /// Vector noise at four points once these are scaled by each of `scales`.
    pub(super) fn vectors_at_four(&self, point: &[Lanes; 3], scales: &[f64], vectors: &mut [[Lanes; 3]]) {
        // SAFETY: a `Lattice` exists only where there is AVX2.
        unsafe { self.vectors_of_points(point, scales, vectors) }
    }

    #[target_feature(enable = "avx2")]
    fn new() -> Box<Self> {
        let r = &*GRADIENT;
        let half = _mm256_set1_pd(0.5);
        let vector = |k: usize| _mm256_set_pd(0.0, r[k + 8], r[k + 4], r[k]);
        Box::new(Self {
            hash: **HASH,
            slopes: std::array::from_fn(|k| _mm256_set_pd(r[k + 3], r[k + 2], r[k + 1], r[k] * 0.5)),
            vectors: std::array::from_fn(vector),
            halves: std::array::from_fn(|k| _mm256_mul_pd(vector(k), half)),
        })
    }

    /// Four points at once as long as there are enough.
    #[target_feature(enable = "avx2")]
    fn several(&self, x: f64, y: f64, z: f64, scales: &[f64], sums: &mut [f64]) {
        let p = lanes(x, y, z);
        let [x, y, z] = [_mm256_set1_pd(x), _mm256_set1_pd(y), _mm256_set1_pd(z)];
        let mut at = 0;
        while let Some(&[a, b, c, d]) = scales[at..].first_chunk() {
            let scale = _mm256_set_pd(d, c, b, a);
            let places = [
                Axis::of(_mm256_mul_pd(x, scale)),
                Axis::of(_mm256_mul_pd(y, scale)),
                Axis::of(_mm256_mul_pd(z, scale)),
            ];
            sums[at..at + 4].copy_from_slice(&each(self.anywhere(&places)));
            at += 4;
        }
        while let (Some(scale), Some(sum)) = (scales.get(at), sums.get_mut(at)) {
            *sum = self.one(_mm256_mul_pd(p, _mm256_set1_pd(*scale)));
            at += 1;
        }
    }

    /// What the numbers of the planes in x and y hash to.
    #[inline(always)]
    fn columns(&self, x: u32, y: u32) -> [u32; 4] {
        let hash = |index: u32| u32::from(self.hash[index as usize & (HASH_SIZE - 1)]);
        let (low, high) = (hash(x), hash(x + 1));
        [hash(low ^ y), hash(high ^ y), hash(low ^ (y + 1)), hash(high ^ (y + 1))]
    }

    #[inline(always)]
    fn gradient(&self, column: u32, z: u32) -> usize {
        usize::from(self.hash[(column ^ z) as usize & (HASH_SIZE - 1)] as u8)
    }

    #[target_feature(enable = "avx2")]
    fn single(&self, x: f64, y: f64, z: f64) -> f64 {
        self.one(lanes(x, y, z))
    }

    /// One point: lanes are corners.
    #[target_feature(enable = "avx2")]
    fn one(&self, p: __m256d) -> f64 {
        let Place { cell, offset, weight } = Place::of(p);
        let columns = self.columns(cell[0], cell[1]);
        let (dx, dy) = (along_x(offset), along_y(offset));
        let influence = _mm256_mul_pd(along_x(weight), along_y(weight));
        let mut sum = 0.0_f64;
        for k in 0..2 {
            // The corners beyond the plane that the point is on add nothing.
            if k == 1 && sum.is_finite() && is_zero(every::<2>(offset[0])) {
                break;
            }
            let plane = cell[2] + k as u32;
            let [a, b] = [self.gradient(columns[0], plane), self.gradient(columns[1], plane)];
            let [c, d] = [self.gradient(columns[2], plane), self.gradient(columns[3], plane)];
            let [half, x, y, z] =
                transposed([self.slopes[a], self.slopes[b], self.slopes[c], self.slopes[d]]);
            let slope = _mm256_add_pd(half, _mm256_mul_pd(x, dx));
            let slope = _mm256_add_pd(slope, _mm256_mul_pd(y, dy));
            let slope = _mm256_add_pd(slope, _mm256_mul_pd(z, every::<2>(offset[k])));
            let weight = _mm256_mul_pd(influence, every::<2>(weight[k]));
            for term in each(_mm256_mul_pd(weight, slope)) {
                sum += term;
            }
        }
        sum
    }

    #[target_feature(enable = "avx2")]
    fn all_vectors(&self, x: f64, y: f64, z: f64, scales: &[f64], vectors: &mut [DVec3]) {
        let p = [_mm256_set1_pd(x), _mm256_set1_pd(y), _mm256_set1_pd(z)];
        let (scales, rest) = scales.as_chunks();
        let (fours, remaining) = vectors.as_chunks_mut();
        for (scales, vectors) in scales.iter().zip(fours) {
            let found = self.vectors_apart(&scaled(p, scales), 4);
            *vectors = [point(found[0]), point(found[1]), point(found[2]), point(found[3])];
        }
        let p = lanes(x, y, z);
        for (scale, vector) in rest.iter().zip(remaining) {
            *vector = point(self.vector(_mm256_mul_pd(p, _mm256_set1_pd(*scale))));
        }
    }

    #[target_feature(enable = "avx2")]
    fn octaves(&self, x: f64, y: f64, z: f64, octaves: &Octaves) -> DVec3 {
        let p = [_mm256_set1_pd(x), _mm256_set1_pd(y), _mm256_set1_pd(z)];
        let Octaves { omega, lambda, .. } = *octaves;
        let count = octaves.count();
        let mut sum = _mm256_setzero_pd();
        let (mut strength, mut a) = (1.0, 1.0);
        for first in (0..count).step_by(4) {
            let b = a * lambda;
            let c = b * lambda;
            let d = c * lambda;
            let here = (count - first).min(4);
            let found = match here {
                1 => [self.vector(_mm256_mul_pd(lanes(x, y, z), _mm256_set1_pd(a))); 4],
                _ => self.vectors_apart(&scaled(p, &[a, b, c, d]), here),
            };
            a = d * lambda;
            for place in 0..here {
                if first + place == 0 {
                    sum = found[0];
                } else {
                    strength *= omega;
                    sum = _mm256_add_pd(sum, _mm256_mul_pd(_mm256_set1_pd(strength), found[place]));
                }
            }
        }
        point(sum)
    }

    /// Vector noise: lanes are components.
    #[target_feature(enable = "avx2")]
    fn vector(&self, p: __m256d) -> __m256d {
        let Place { cell, offset, weight } = Place::of(p);
        let columns = self.columns(cell[0], cell[1]);
        let [low, high] = offset;
        let dx = [every::<0>(low), every::<0>(high)];
        let dy = [every::<1>(low), every::<1>(high)];
        let dz = [every::<2>(low), every::<2>(high)];
        let influence = _mm256_mul_pd(along_x(weight), along_y(weight));
        let [low, high] = weight;
        let influence =
            [_mm256_mul_pd(influence, every::<2>(low)), _mm256_mul_pd(influence, every::<2>(high))];
        let mut sum = _mm256_setzero_pd();
        macro_rules! add_corner {
            ($side:literal) => {
                let (i, j, k) = ($side & 1, $side >> 1 & 1, $side >> 2);
                let m = self.gradient(columns[$side & 3], cell[2] + k as u32);
                let slope = _mm256_add_pd(self.halves[m], _mm256_mul_pd(self.vectors[m + 1], dx[i]));
                let slope = _mm256_add_pd(slope, _mm256_mul_pd(self.vectors[m + 2], dy[j]));
                let slope = _mm256_add_pd(slope, _mm256_mul_pd(self.vectors[m + 3], dz[k]));
                let weight = every::<{ $side & 3 }>(influence[k]);
                sum = _mm256_add_pd(sum, _mm256_mul_pd(weight, slope));
            };
        }
        add_corner!(0);
        add_corner!(1);
        add_corner!(3);
        add_corner!(2);
        // The corners beyond the plane that the point is on add nothing.
        if is_zero(dz[0]) && is_finite(sum) {
            return sum;
        }
        add_corner!(6);
        add_corner!(7);
        add_corner!(5);
        add_corner!(4);
        sum
    }
}

/// A point at four scales.
#[inline]
#[target_feature(enable = "avx2")]
fn scaled(p: [__m256d; 3], &[a, b, c, d]: &[f64; 4]) -> [Axis; 3] {
    let scale = _mm256_set_pd(d, c, b, a);
    [
        Axis::of(_mm256_mul_pd(p[0], scale)),
        Axis::of(_mm256_mul_pd(p[1], scale)),
        Axis::of(_mm256_mul_pd(p[2], scale)),
    ]
}

/// Lanes 0, 1 and 2.
#[inline]
#[target_feature(enable = "avx2")]
fn point(v: __m256d) -> DVec3 {
    let [x, y, z, _] = each(v);
    DVec3::new(x, y, z)
}

impl Place {
    #[inline]
    #[target_feature(enable = "avx2")]
    fn of(p: __m256d) -> Self {
        let (planes, offset, weight) = places(p);
        let [x, y, z, _] = numbers(planes);
        Self { cell: [x, y, z], offset, weight }
    }
}

/// For each lane the number of the lattice plane below, the distances from it and from the one above,
/// and the influence of both.
#[inline]
#[target_feature(enable = "avx2")]
fn places(c: __m256d) -> (__m128i, [__m256d; 2], [__m256d; 2]) {
    let one = _mm256_set1_pd(1.0);
    let below_zero = _mm256_cmp_pd::<_CMP_NGE_UQ>(c, _mm256_setzero_pd());
    let shifted = _mm256_sub_pd(c, _mm256_and_pd(below_zero, _mm256_set1_pd(1.0 - EPSILON)));
    let t = _mm256_cvttpd_epi32(shifted);
    let f = _mm256_sub_pd(c, _mm256_cvtepi32_pd(t));
    let s = _mm256_sub_pd(_mm256_set1_pd(3.0), _mm256_mul_pd(_mm256_set1_pd(2.0), f));
    let s = _mm256_mul_pd(_mm256_mul_pd(f, f), s);
    let planes = _mm_and_si128(_mm_add_epi32(t, _mm_set1_epi32(SHIFT)), _mm_set1_epi32(4095));
    (planes, [f, _mm256_sub_pd(f, one)], [_mm256_sub_pd(one, s), s])
}

/// The whole numbers in the lanes.
#[inline]
#[target_feature(enable = "avx2")]
fn numbers(v: __m128i) -> [u32; 4] {
    [
        _mm_extract_epi32::<0>(v) as u32,
        _mm_extract_epi32::<1>(v) as u32,
        _mm_extract_epi32::<2>(v) as u32,
        _mm_extract_epi32::<3>(v) as u32,
    ]
}

/// Lane 0 of the lower and of the upper value in turn: what differs along x.
#[inline]
#[target_feature(enable = "avx2")]
fn along_x([low, high]: [__m256d; 2]) -> __m256d {
    _mm256_blend_pd::<0b1010>(every::<0>(low), every::<0>(high))
}

/// Lane 1 of the lower value twice, then of the upper one: what differs along y.
#[inline]
#[target_feature(enable = "avx2")]
fn along_y([low, high]: [__m256d; 2]) -> __m256d {
    _mm256_blend_pd::<0b1100>(every::<1>(low), every::<1>(high))
}

/// One lane in all lanes.
#[inline]
#[target_feature(enable = "avx2")]
fn every<const LANE: i32>(v: __m256d) -> __m256d {
    match LANE {
        0 => _mm256_permute4x64_pd::<0x00>(v),
        1 => _mm256_permute4x64_pd::<0x55>(v),
        2 => _mm256_permute4x64_pd::<0xaa>(v),
        _ => _mm256_permute4x64_pd::<0xff>(v),
    }
}

/// Rows become columns.
#[inline]
#[target_feature(enable = "avx2")]
fn transposed([a, b, c, d]: [__m256d; 4]) -> [__m256d; 4] {
    let (ab, cd) = (_mm256_unpacklo_pd(a, b), _mm256_unpacklo_pd(c, d));
    let (ab_odd, cd_odd) = (_mm256_unpackhi_pd(a, b), _mm256_unpackhi_pd(c, d));
    [
        _mm256_permute2f128_pd::<0x20>(ab, cd),
        _mm256_permute2f128_pd::<0x20>(ab_odd, cd_odd),
        _mm256_permute2f128_pd::<0x31>(ab, cd),
        _mm256_permute2f128_pd::<0x31>(ab_odd, cd_odd),
    ]
}

#[inline]
#[target_feature(enable = "avx2")]
fn lanes(x: f64, y: f64, z: f64) -> __m256d {
    _mm256_set_pd(0.0, z, y, x)
}

#[inline]
#[target_feature(enable = "avx2")]
fn each(v: __m256d) -> [f64; 4] {
    let (low, high) = (_mm256_castpd256_pd128(v), _mm256_extractf128_pd::<1>(v));
    let (low_odd, high_odd) = (_mm_unpackhi_pd(low, low), _mm_unpackhi_pd(high, high));
    [_mm_cvtsd_f64(low), _mm_cvtsd_f64(low_odd), _mm_cvtsd_f64(high), _mm_cvtsd_f64(high_odd)]
}

#[cfg(test)]
mod tests {
    use super::super::lattice;
    use super::*;

    /// Points near and far, on planes of the lattice and beside them, and no points at all.
    fn points() -> impl Iterator<Item = DVec3> {
        let mut state = 1_u64;
        let mut number = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0
        };
        let edges = [0.0, -0.0, 1.0, -1.0, -1.0 + 5e-11, -3.0 - 5e-11, 4095.5, 2_147_483_647.5];
        let far = [-2_147_483_649.5, 3e9, -1e17, 1e300, f64::INFINITY, f64::NAN];
        let odd: Vec<f64> = edges.into_iter().chain(far).collect();
        let odd_points = (0..odd.len().pow(3)).map(move |n| {
            let count = odd.len();
            DVec3::new(odd[n % count], odd[n / count % count], odd[n / count / count])
        });
        let scattered = (0..100_000).map(move |n| {
            let size = 10_f64.powi(n % 7 - 1);
            DVec3::new(number(), number(), number()) * size
        });
        odd_points.chain(scattered)
    }

    fn bits(values: &[f64]) -> Vec<u64> {
        // Which of the many values that are no number comes out is nobody's business.
        values.iter().map(|v| if v.is_nan() { u64::MAX } else { v.to_bits() }).collect()
    }

    #[test]
    fn lanes_give_the_same_bits_as_one_point_at_a_time() {
        let Some(lanes) = Lattice::get() else { return };
        let scales = [1.0, 2.0, 4.0, 8.0, 0.3, -1.7];
        for p in points() {
            assert_eq!(bits(&[lanes.sum(p)]), bits(&[lattice::sum(p)]), "at {p}");
            let mut found = [0.0; 6];
            lanes.sums(p, &scales, &mut found);
            assert_eq!(bits(&found), bits(&scales.map(|scale| lattice::sum(scale * p))), "around {p}");
            let mut found = [DVec3::ZERO; 2];
            lanes.vectors(p, &scales[3..5], &mut found);
            let expected = [8.0, 0.3].map(|scale| lattice::vector(scale * p));
            for (found, expected) in found.into_iter().zip(expected) {
                assert_eq!(bits(&found.to_array()), bits(&expected.to_array()), "vectors at {p}");
            }
            let found = lanes.turbulence(p, &Octaves { count: 3, omega: 0.7, lambda: 2.1 });
            let [second, third] = [2.1, 2.1 * 2.1].map(|scale| lattice::vector(scale * p));
            let expected = lattice::vector(p) + 0.7 * second + 0.7 * 0.7 * third;
            assert_eq!(bits(&found.to_array()), bits(&expected.to_array()), "octaves at {p}");
        }
    }

    #[test]
    fn four_points_give_the_same_bits_as_one_at_a_time() {
        let Some(lanes) = Lattice::get() else { return };
        let scales = [1.0, 4.0, -0.3];
        let all: Vec<DVec3> = points().collect();
        // Neighbours in a row, mostly within one cell, and points that have nothing to do with each other.
        let rows = all.iter().map(|&p| [0.0, 0.01, 0.02, 0.03].map(|step| p + DVec3::X * step));
        let strangers = all.windows(4).map(|four| [four[0], four[1], four[2], four[3]]);
        for four in rows.chain(strangers) {
            let point = [0, 1, 2].map(|axis| Lanes(four.map(|p| p[axis])));
            let (mut sums, mut vectors) = ([Lanes::ZERO; 3], [[Lanes::ZERO; 3]; 3]);
            lanes.sums_at_four(&point, &scales, &mut sums);
            lanes.vectors_at_four(&point, &scales, &mut vectors);
            for (octave, scale) in scales.into_iter().enumerate() {
                let expected = four.map(|p| lattice::sum(scale * p));
                assert_eq!(bits(&sums[octave].0), bits(&expected), "{scale} times {four:?}");
                for (axis, found) in vectors[octave].iter().enumerate() {
                    let expected = four.map(|p| lattice::vector(scale * p)[axis]);
                    assert_eq!(bits(&found.0), bits(&expected), "{scale} times {four:?}");
                }
            }
        }
    }
}
