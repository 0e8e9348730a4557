//! Four points at once, one in each lane. Points of a row or of neighbouring pixels are mostly in one cell: its corners
//! are then looked up once. Points on a plane of the lattice take nothing from the corners beyond it.

use std::arch::x86_64::*;

use super::{Lattice, each, every, places, transposed};
use crate::math::Lanes;

/// One coordinate of four points.
pub(super) struct Axis {
    /// Numbers of the lower planes.
    planes: __m128i,
    /// Distances from the lower and the upper planes.
    offset: [__m256d; 2],
    /// Influence of the lower and the upper planes.
    weight: [__m256d; 2],
}

/// What the corners add up to; `$slopes` gives half of the entry and the three after it of the corner on these sides.
macro_rules! sum_corners {
    ($at:expr, $slopes:ident) => {{
        let [x, y, z] = $at;
        if is_zero(z.offset[0]) {
            let mut sum = _mm256_setzero_pd();
            macro_rules! add_corner {
                ($side:literal) => {
                    let [half, rx, ry, _] = $slopes!($side);
                    let slope = _mm256_add_pd(half, _mm256_mul_pd(rx, x.offset[$side & 1]));
                    let slope = _mm256_add_pd(slope, _mm256_mul_pd(ry, y.offset[$side >> 1]));
                    let weight = _mm256_mul_pd(x.weight[$side & 1], y.weight[$side >> 1]);
                    sum = _mm256_add_pd(sum, _mm256_mul_pd(weight, slope));
                };
            }
            add_corner!(0);
            add_corner!(1);
            add_corner!(2);
            add_corner!(3);
            if is_finite(sum) {
                return sum;
            }
        }
        let mut sum = _mm256_setzero_pd();
        macro_rules! add_corner {
            ($side:literal) => {
                let (i, j, k) = ($side & 1, $side >> 1 & 1, $side >> 2);
                let [half, rx, ry, rz] = $slopes!($side);
                let slope = _mm256_add_pd(half, _mm256_mul_pd(rx, x.offset[i]));
                let slope = _mm256_add_pd(slope, _mm256_mul_pd(ry, y.offset[j]));
                let slope = _mm256_add_pd(slope, _mm256_mul_pd(rz, z.offset[k]));
                let weight = _mm256_mul_pd(_mm256_mul_pd(x.weight[i], y.weight[j]), z.weight[k]);
                sum = _mm256_add_pd(sum, _mm256_mul_pd(weight, slope));
            };
        }
        add_corner!(0);
        add_corner!(1);
        add_corner!(2);
        add_corner!(3);
        add_corner!(4);
        add_corner!(5);
        add_corner!(6);
        add_corner!(7);
        sum
    }};
}

impl Lattice {
    /// What the corners around four points add up to once these are scaled by each of `scales`.
    #[target_feature(enable = "avx2")]
    pub(super) fn points(&self, point: &[Lanes; 3], scales: &[f64], sums: &mut [Lanes]) {
        let [x, y, z] = [wide(&point[0]), wide(&point[1]), wide(&point[2])];
        for (scale, sum) in scales.iter().zip(sums) {
            let scale = _mm256_set1_pd(*scale);
            let at = [
                Axis::of(_mm256_mul_pd(x, scale)),
                Axis::of(_mm256_mul_pd(y, scale)),
                Axis::of(_mm256_mul_pd(z, scale)),
            ];
            let found = match shared_cell(&at) {
                Some(cell) => self.in_one_cell(cell, &at),
                None => self.anywhere(&at),
            };
            *sum = Lanes(each(found));
        }
    }

    /// Points in a cell with these lower planes.
    #[target_feature(enable = "avx2")]
    fn in_one_cell(&self, [cell_x, cell_y, cell_z]: [u32; 3], at: &[Axis; 3]) -> __m256d {
        let columns = self.columns(cell_x, cell_y);
        macro_rules! slopes {
            ($side:literal) => {{
                let slopes = self.slopes[self.gradient(columns[$side & 3], cell_z + ($side >> 2))];
                [every::<0>(slopes), every::<1>(slopes), every::<2>(slopes), every::<3>(slopes)]
            }};
        }
        sum_corners!(at, slopes)
    }

    /// Points that have each a cell of their own.
    #[target_feature(enable = "avx2")]
    pub(super) fn anywhere(&self, at: &[Axis; 3]) -> __m256d {
        let [x, y, z] = [at[0].numbers(), at[1].numbers(), at[2].numbers()];
        let columns = [
            self.columns(x[0], y[0]),
            self.columns(x[1], y[1]),
            self.columns(x[2], y[2]),
            self.columns(x[3], y[3]),
        ];
        macro_rules! slopes {
            ($side:literal) => {
                transposed([
                    self.slopes[self.gradient(columns[0][$side & 3], z[0] + ($side >> 2))],
                    self.slopes[self.gradient(columns[1][$side & 3], z[1] + ($side >> 2))],
                    self.slopes[self.gradient(columns[2][$side & 3], z[2] + ($side >> 2))],
                    self.slopes[self.gradient(columns[3][$side & 3], z[3] + ($side >> 2))],
                ])
            };
        }
        sum_corners!(at, slopes)
    }

    /// Vector noise at four points once these are scaled by each of `scales`.
    #[target_feature(enable = "avx2")]
    pub(super) fn vectors_of_points(&self, point: &[Lanes; 3], scales: &[f64], vectors: &mut [[Lanes; 3]]) {
        let [x, y, z] = [wide(&point[0]), wide(&point[1]), wide(&point[2])];
        for (scale, vector) in scales.iter().zip(vectors) {
            let scale = _mm256_set1_pd(*scale);
            let scaled = [_mm256_mul_pd(x, scale), _mm256_mul_pd(y, scale), _mm256_mul_pd(z, scale)];
            let at = [Axis::of(scaled[0]), Axis::of(scaled[1]), Axis::of(scaled[2])];
            let [x, y, z] = match shared_cell(&at) {
                Some(cell) => self.vectors_in_one_cell(cell, &at),
                None => self.vectors_anywhere(&scaled, &at),
            };
            *vector = [Lanes(each(x)), Lanes(each(y)), Lanes(each(z))];
        }
    }

    #[target_feature(enable = "avx2")]
    fn vectors_in_one_cell(&self, [cell_x, cell_y, cell_z]: [u32; 3], at: &[Axis; 3]) -> [__m256d; 3] {
        let columns = self.columns(cell_x, cell_y);
        let [x, y, z] = at;
        let mut sum = [_mm256_setzero_pd(); 3];
        // What a corner adds to each component, with the slopes of the corner along x, y and perhaps z.
        macro_rules! add {
            ($gradient:ident, $weight:ident, $([$next:literal, $offset:expr]),+) => {
                add!(@ 0, $gradient, $weight, $([$next, $offset]),+);
                add!(@ 1, $gradient, $weight, $([$next, $offset]),+);
                add!(@ 2, $gradient, $weight, $([$next, $offset]),+);
            };
            (@ $component:literal, $gradient:ident, $weight:ident, $([$next:literal, $offset:expr]),+) => {
                let slope = every::<$component>(self.halves[$gradient]);
                $(
                    let along = every::<$component>(self.vectors[$gradient + $next]);
                    let slope = _mm256_add_pd(slope, _mm256_mul_pd(along, $offset));
                )+
                sum[$component] = _mm256_add_pd(sum[$component], _mm256_mul_pd($weight, slope));
            };
        }
        if is_zero(z.offset[0]) {
            macro_rules! add_corner {
                ($side:literal) => {
                    let (i, j) = ($side & 1, $side >> 1);
                    let gradient = self.gradient(columns[$side], cell_z);
                    let weight = _mm256_mul_pd(x.weight[i], y.weight[j]);
                    add!(gradient, weight, [1, x.offset[i]], [2, y.offset[j]]);
                };
            }
            add_corner!(0);
            add_corner!(1);
            add_corner!(3);
            add_corner!(2);
            if is_finite(_mm256_add_pd(_mm256_add_pd(sum[0], sum[1]), sum[2])) {
                return sum;
            }
            sum = [_mm256_setzero_pd(); 3];
        }
        macro_rules! add_corner {
            ($side:literal) => {
                let (i, j, k) = ($side & 1, $side >> 1 & 1, $side >> 2);
                let gradient = self.gradient(columns[$side & 3], cell_z + k as u32);
                let weight = _mm256_mul_pd(_mm256_mul_pd(x.weight[i], y.weight[j]), z.weight[k]);
                add!(gradient, weight, [1, x.offset[i]], [2, y.offset[j]], [3, z.offset[k]]);
            };
        }
        add_corner!(0);
        add_corner!(1);
        add_corner!(3);
        add_corner!(2);
        add_corner!(6);
        add_corner!(7);
        add_corner!(5);
        add_corner!(4);
        sum
    }

    /// Vector noise at the first `count` of four points that have each a cell of their own: lanes are components. What
    /// all have in common is found first, for a point alone is a long chain of what waits for each other, of which the
    /// processor sees but two at a time.
    #[target_feature(enable = "avx2")]
    pub(super) fn vectors_apart(&self, at: &[Axis; 3], count: usize) -> [__m256d; 4] {
        let numbers = [at[0].numbers(), at[1].numbers(), at[2].numbers()];
        let [x, y, z] = at;
        let offsets = [
            [each(x.offset[0]), each(x.offset[1])],
            [each(y.offset[0]), each(y.offset[1])],
            [each(z.offset[0]), each(z.offset[1])],
        ];
        let mut weights = [[0.0; 4]; 8];
        for side in 0..4 {
            let influence = _mm256_mul_pd(x.weight[side & 1], y.weight[side >> 1]);
            weights[side] = each(_mm256_mul_pd(influence, z.weight[0]));
            weights[side + 4] = each(_mm256_mul_pd(influence, z.weight[1]));
        }
        let mut found = [_mm256_setzero_pd(); 4];
        for point in 0..count {
            let columns = self.columns(numbers[0][point], numbers[1][point]);
            let plane = numbers[2][point];
            let offset = |axis: usize, side: usize| _mm256_set1_pd(offsets[axis][side][point]);
            let dx = [offset(0, 0), offset(0, 1)];
            let dy = [offset(1, 0), offset(1, 1)];
            let dz = [offset(2, 0), offset(2, 1)];
            let mut sum = _mm256_setzero_pd();
            macro_rules! add_corner {
                ($side:literal) => {
                    let (i, j, k) = ($side & 1, $side >> 1 & 1, $side >> 2);
                    let m = self.gradient(columns[$side & 3], plane + k as u32);
                    let slope = _mm256_add_pd(self.halves[m], _mm256_mul_pd(self.vectors[m + 1], dx[i]));
                    let slope = _mm256_add_pd(slope, _mm256_mul_pd(self.vectors[m + 2], dy[j]));
                    let slope = _mm256_add_pd(slope, _mm256_mul_pd(self.vectors[m + 3], dz[k]));
                    sum = _mm256_add_pd(sum, _mm256_mul_pd(_mm256_set1_pd(weights[$side][point]), slope));
                };
            }
            add_corner!(0);
            add_corner!(1);
            add_corner!(3);
            add_corner!(2);
            // The corners beyond the plane that the point is on add nothing.
            if !(offsets[2][0][point] == 0.0 && is_finite(sum)) {
                add_corner!(6);
                add_corner!(7);
                add_corner!(5);
                add_corner!(4);
            }
            found[point] = sum;
        }
        found
    }

    /// Vector noise at four points. Where there are less than four the last stands for several.
    #[target_feature(enable = "avx2")]
    fn vectors_anywhere(&self, points: &[__m256d; 3], at: &[Axis; 3]) -> [__m256d; 3] {
        let count = distinct(points);
        let mut found = self.vectors_apart(at, count);
        for place in count..4 {
            found[place] = found[place - 1];
        }
        let [x, y, z, _] = transposed(found);
        [x, y, z]
    }
}

impl Axis {
    #[inline]
    #[target_feature(enable = "avx2")]
    pub(super) fn of(c: __m256d) -> Self {
        let (planes, offset, weight) = places(c);
        Self { planes, offset, weight }
    }

    /// Numbers of the lower planes.
    #[inline]
    #[target_feature(enable = "avx2")]
    fn numbers(&self) -> [u32; 4] {
        super::numbers(self.planes)
    }
}

/// The lower planes of the cell that all four points are in, if it is one.
#[inline]
#[target_feature(enable = "avx2")]
fn shared_cell(at: &[Axis; 3]) -> Option<[u32; 3]> {
    let mut apart = _mm_setzero_si128();
    for axis in at {
        let first = _mm_shuffle_epi32::<0>(axis.planes);
        apart = _mm_or_si128(apart, _mm_xor_si128(axis.planes, first));
    }
    let first = |axis: &Axis| _mm_cvtsi128_si32(axis.planes) as u32;
    (_mm_testz_si128(apart, apart) == 1).then(|| [first(&at[0]), first(&at[1]), first(&at[2])])
}

/// How many points come first until all that follow are the same as the one before.
#[inline]
#[target_feature(enable = "avx2")]
fn distinct(points: &[__m256d; 3]) -> usize {
    let mut apart = 0;
    for c in points {
        let before = _mm256_permute4x64_pd::<0b10_01_00_00>(*c);
        apart |= _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_NEQ_UQ>(*c, before)) as u32;
    }
    // The first differs from none.
    (u32::BITS - (apart | 1).leading_zeros()) as usize
}

/// Whether all lanes are 0.
#[inline]
#[target_feature(enable = "avx2")]
pub(super) fn is_zero(v: __m256d) -> bool {
    _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_EQ_OQ>(v, _mm256_setzero_pd())) == 0b1111
}

/// Whether no lane is infinite or no number.
#[inline]
#[target_feature(enable = "avx2")]
pub(super) fn is_finite(v: __m256d) -> bool {
    is_zero(_mm256_sub_pd(v, v))
}

#[inline]
#[target_feature(enable = "avx2")]
fn wide(&Lanes([a, b, c, d]): &Lanes) -> __m256d {
    _mm256_set_pd(d, c, b, a)
}
