//! A polynomial in the distance along a ray.

/// So many terms are few.
pub(super) const FEW: usize = 9;

/// A polynomial along a ray, the constant first; terms beyond the count are 0.
#[derive(Clone, Copy)]
pub(super) struct Along<const N: usize> {
    pub(super) terms: [f64; N],
    pub(super) count: usize,
}

impl<const N: usize> Along<N> {
    /// Without terms.
    pub(super) const ZERO: Self = Self { terms: [0.0; N], count: 0 };

    /// Times `origin + direction t`.
    #[inline(always)]
    pub(super) fn step(&mut self, origin: f64, direction: f64) {
        if self.count == 0 {
            return;
        }
        self.count += 1;
        let count = self.length();
        for i in (1..count).rev() {
            self.terms[i] = self.terms[i] * origin + self.terms[i - 1] * direction;
        }
        self.terms[0] *= origin;
    }

    /// How many terms are gone through: of few all, zeros too, as loops of a known length are written out.
    #[inline(always)]
    fn length(&self) -> usize {
        if N <= FEW { N } else { self.count }
    }

    #[inline(always)]
    pub(super) fn add(&mut self, other: &Self) {
        self.count = self.count.max(other.count);
        for i in 0..self.length() {
            self.terms[i] += other.terms[i];
        }
    }

    #[inline(always)]
    pub(super) fn add_constant(&mut self, constant: f64) {
        self.count = self.count.max(1);
        self.terms[0] += constant;
    }

    /// The sum of the sizes of its terms at a distance, of which its value there is rounded by some units.
    #[inline(always)]
    pub(super) fn size(&self, t: f64) -> f64 {
        let t = t.abs();
        self.terms[..self.length()].iter().rev().fold(0.0, |size, term| size * t + term.abs())
    }

    /// Whether it has few terms and is known to have no root on a ray with one end: beyond that all its terms are
    /// of one sign (Descartes).
    #[inline(always)]
    pub(super) fn is_void(&self, [low, high]: [f64; 2]) -> bool {
        if N > FEW || low.is_finite() == high.is_finite() {
            return false;
        }
        let (end, forward) = if low.is_finite() { (low, 1.0) } else { (-high, -1.0) };
        // The terms of the polynomial of the distance beyond the end, and how large they may be.
        let (mut terms, mut sizes, mut sign) = (self.terms, self.terms, 1.0);
        for i in 0..N {
            (terms[i], sizes[i]) = (terms[i] * sign, sizes[i].abs());
            sign *= forward;
        }
        for from in 0..N - 1 {
            for i in (from..N - 1).rev() {
                terms[i] += end * terms[i + 1];
                sizes[i] += end.abs() * sizes[i + 1];
            }
        }
        let (mut above, mut below) = (true, true);
        for i in 0..N {
            let noise = 8.0 * N as f64 * f64::EPSILON * sizes[i];
            above &= terms[i] > noise || sizes[i] == 0.0;
            below &= terms[i] < -noise || sizes[i] == 0.0;
        }
        above || below
    }
}
