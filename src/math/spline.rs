//! Splines through points with up to five components (docs/spec/language.md 5).
//!
//! Operations come in POV-Ray's order, so that values agree to the last bit.

/// How points are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum SplineKind {
    /// `linear_spline`.
    #[default]
    Linear,
    /// `quadratic_spline`.
    Quadratic,
    /// `cubic_spline`, Catmull and Rom's.
    Cubic,
    /// `natural_spline`: the second derivative is continuous, and 0 at both ends.
    Natural,
}

/// A value: the components not in use are 0.
pub type Value = [f64; 5];

/// A spline ready to be evaluated.
#[derive(Clone, Debug, PartialEq)]
pub struct Spline {
    kind: SplineKind,
    keys: Box<[f64]>,
    values: Box<[Value]>,
    /// Second derivatives of a natural spline at its points.
    bends: Box<[Value]>,
    /// What a quadratic spline follows around each point but the first and last.
    parabolas: Box<[Parabola]>,
    size: usize,
}

/// `a (p - origin)² + b (p - origin) + c`.
#[derive(Clone, Debug, PartialEq)]
struct Parabola {
    origin: f64,
    a: Value,
    b: Value,
    c: Value,
}

impl Spline {
    /// Points sorted by rising key; `size` components of each are in use. `None` without points.
    pub fn new(kind: SplineKind, points: &[(f64, Value)], size: usize) -> Option<Self> {
        let keys: Box<[f64]> = points.iter().map(|point| point.0).collect();
        let values: Box<[Value]> = points.iter().map(|point| point.1).collect();
        let (mut bends, mut parabolas) = (Box::default(), Box::default());
        match kind {
            SplineKind::Natural => bends = natural_bends(&keys, &values),
            SplineKind::Quadratic => {
                let around = keys.windows(3).zip(values.windows(3));
                parabolas = around.map(|(keys, values)| Parabola::through(keys, values)).collect();
            }
            SplineKind::Linear | SplineKind::Cubic => {}
        }
        (!keys.is_empty()).then_some(Self { kind, keys, values, bends, parabolas, size: size.min(5) })
    }

    /// Components in use.
    pub fn size(&self) -> usize {
        self.size
    }

    /// The value at `p`.
    pub fn at(&self, p: f64) -> Value {
        let last = self.keys.len() - 1;
        let (keys, values) = (&self.keys, &self.values);
        if last == 0 {
            return values[0];
        }
        if self.kind == SplineKind::Cubic {
            return self.cubic(p);
        }
        if p <= keys[0] {
            return values[0];
        }
        if p >= keys[last] {
            return values[last];
        }
        let i = self.segment(p);
        match self.kind {
            SplineKind::Natural => self.natural(i, p),
            SplineKind::Quadratic if last > 1 => self.parabolas[i.saturating_sub(1)].at(p),
            _ => {
                let share = p - keys[i];
                let width = keys[i + 1] - keys[i];
                each(|c| values[i][c] + share * (values[i + 1][c] - values[i][c]) / width)
            }
        }
    }

    /// The i for which key i < p ≤ key i+1.
    fn segment(&self, p: f64) -> usize {
        self.keys.partition_point(|key| *key < p).clamp(1, self.keys.len() - 1) - 1
    }

    /// Which piece a key belongs to: 0 is what is before all of them, and the last one what is behind.
    pub(super) fn place(&self, key: f64) -> usize {
        let [first, last] = self.ends();
        let inner = self.keys[first..=last].partition_point(|start| *start < key);
        if last == first || inner > last - first { last - first + 1 } else { inner }
    }

    /// Where a piece begins and ends.
    pub(super) fn keys_of(&self, place: usize) -> [f64; 2] {
        let [first, last] = self.ends();
        let low = place.checked_sub(1).map_or(f64::NEG_INFINITY, |before| self.keys[first + before]);
        let high = self.keys[first..=last].get(place).copied().unwrap_or(f64::INFINITY);
        [low, high]
    }

    /// The keys between which the value isn't constant.
    fn ends(&self) -> [usize; 2] {
        let last = self.keys.len() - 1;
        match self.kind {
            SplineKind::Cubic if last > 1 => [1, last - 1],
            SplineKind::Cubic => [0, 0],
            _ => [0, last],
        }
    }

    /// One component of a piece: a key, and the coefficients of the powers of what is beyond it.
    pub(super) fn piece(&self, place: usize, c: usize) -> (f64, [f64; 4]) {
        let [first, last] = self.ends();
        let constant = place == 0 || place > last - first;
        if constant {
            let far = if place == 0 { f64::NEG_INFINITY } else { f64::INFINITY };
            return (0.0, [self.at(far)[c], 0.0, 0.0, 0.0]);
        }
        let i = first + place - 1;
        if let Some(Parabola { origin, a, b, c: constant }) = self.parabolas.get(i.saturating_sub(1)) {
            return (*origin, [constant[c], b[c], a[c], 0.0]);
        }
        let (start, h) = (self.keys[i], self.keys[i + 1] - self.keys[i]);
        let (v0, v1) = (self.values[i][c], self.values[i + 1][c]);
        let rise = (v1 - v0) / h;
        let coefficients = match self.kind {
            SplineKind::Natural => {
                let (m0, m1) = (self.bends[i][c], self.bends[i + 1][c]);
                [v0, rise - h * (m1 + 2.0 * m0) / 6.0, m0 / 2.0, (m1 - m0) / (6.0 * h)]
            }
            SplineKind::Cubic => {
                let slope = |k: usize| {
                    let rise = |a: usize, b: usize| {
                        (self.values[b][c] - self.values[a][c]) / (self.keys[b] - self.keys[a])
                    };
                    0.5 * (rise(k - 1, k) + rise(k, k + 1))
                };
                let (s0, s1) = (slope(i), slope(i + 1));
                [v0, s0, (3.0 * rise - 2.0 * s0 - s1) / h, (s0 + s1 - 2.0 * rise) / (h * h)]
            }
            SplineKind::Linear | SplineKind::Quadratic => [v0, rise, 0.0, 0.0],
        };
        (start, coefficients)
    }

    fn natural(&self, i: usize, p: f64) -> Value {
        let (d, h) = (p - self.keys[i], self.keys[i + 1] - self.keys[i]);
        let [(v0, m0), (v1, m1)] = [i, i + 1].map(|k| (&self.values[k], &self.bends[k]));
        each(|c| {
            let slope = (v1[c] - v0[c]) / h - h / 6.0 * (m1[c] + 2.0 * m0[c]);
            v0[c] + d * (slope + d * (m0[c] / 2.0 + d * (m1[c] - m0[c]) / (6.0 * h)))
        })
    }

    fn cubic(&self, p: f64) -> Value {
        let (keys, values) = (&self.keys, &self.values);
        let last = keys.len() - 1;
        if last == 1 {
            return each(|c| 0.5 * (values[0][c] + values[1][c]));
        }
        if p <= keys[1] || p.is_nan() {
            return values[1];
        }
        if p > keys[last - 1] {
            return values[last - 1];
        }
        let i = self.segment(p);
        let width = keys[i + 1] - keys[i];
        let u = (p - keys[i]) / width;
        let slope = |k: usize, c: usize| {
            let before = (values[k][c] - values[k - 1][c]) / (keys[k] - keys[k - 1]);
            let after = (values[k + 1][c] - values[k][c]) / (keys[k + 1] - keys[k]);
            0.5 * (before + after)
        };
        let starts = 2.0 * u * u * u - 3.0 * u * u + 1.0;
        let ends = 3.0 * u * u - 2.0 * u * u * u;
        let leaves = u * u * u - 2.0 * u * u + u;
        let arrives = u * u * u - u * u;
        each(|c| {
            values[i][c] * starts
                + values[i + 1][c] * ends
                + width * slope(i, c) * leaves
                + width * slope(i + 1, c) * arrives
        })
    }
}

impl Parabola {
    /// Loss of digits, as a multiple of the last one, from which on the parabola is not taken about 0 any more.
    ///
    /// POV-Ray always does, and with keys at a million that are 1 apart none of its digits are true.
    const LOSS: f64 = 1e7;

    /// Through three points.
    fn through(keys: &[f64], values: &[Value]) -> Self {
        let gaps = (keys[1] - keys[0]) * (keys[2] - keys[0]) * (keys[2] - keys[1]);
        let far = keys.iter().fold(0.0, |far: f64, key| far.max(key.abs()));
        let origin = if far * far * far > Self::LOSS * gaps { keys[1] } else { 0.0 };
        let [x1, x2, x3] = [0, 1, 2].map(|k| keys[k] - origin);
        let [y1, y2, y3] = [0, 1, 2].map(|k| &values[k]);
        let scale = (x1 - x2) * (x1 - x3) * (x2 - x3);
        let [q1, q2, q3] = [x1 * x1, x2 * x2, x3 * x3];
        let a = |c: usize| x2 * y1[c] - x3 * y1[c] - x1 * y2[c] + x3 * y2[c] + x1 * y3[c] - x2 * y3[c];
        let b = |c: usize| -q2 * y1[c] + q3 * y1[c] + q1 * y2[c] - q3 * y2[c] - q1 * y3[c] + q2 * y3[c];
        let c = |c: usize| {
            q2 * x3 * y1[c] - x2 * x3 * x3 * y1[c] - q1 * x3 * y2[c] + x1 * x3 * x3 * y2[c] + q1 * x2 * y3[c]
                - x1 * x2 * x2 * y3[c]
        };
        let scaled = |coefficient: &dyn Fn(usize) -> f64| each(|c| coefficient(c) / scale);
        Self { origin, a: scaled(&a), b: scaled(&b), c: scaled(&c) }
    }

    fn at(&self, p: f64) -> Value {
        let p = p - self.origin;
        each(|c| (self.a[c] * p + self.b[c]) * p + self.c[c])
    }
}

fn each(component: impl Fn(usize) -> f64) -> Value {
    std::array::from_fn(component)
}

/// Solves the tridiagonal system for the second derivatives.
fn natural_bends(keys: &[f64], values: &[Value]) -> Box<[Value]> {
    let n = keys.len();
    let mut bends = vec![[0.0; 5]; n];
    let width = |k: usize| keys[k + 1] - keys[k];
    let rise = |k: usize, c: usize| (values[k + 1][c] - values[k][c]) / width(k);
    // Nothing is eliminated from the first row.
    let mut pivots = vec![f64::INFINITY; n];
    for k in 1..n.saturating_sub(1) {
        let (before, last) = (width(k - 1), bends[k - 1]);
        pivots[k] = 2.0 * (before + width(k)) - before * before / pivots[k - 1];
        bends[k] = each(|c| 6.0 * (rise(k, c) - rise(k - 1, c)) - before * last[c] / pivots[k - 1]);
    }
    for k in (1..n.saturating_sub(1)).rev() {
        let next = bends[k + 1];
        bends[k] = each(|c| (bends[k][c] - width(k) * next[c]) / pivots[k]);
    }
    bends.into()
}

#[cfg(test)]
mod tests {
    use super::*;

    const K: [(f64, [f64; 3]); 5] = [
        (0.0, [0.0, 0.0, 0.0]),
        (1.0, [1.0, 2.0, 3.0]),
        (3.0, [5.0, 0.0, 0.0]),
        (4.0, [1.0, 1.0, 1.0]),
        (6.0, [2.0, 2.0, 2.0]),
    ];

    fn check(kind: SplineKind, points: usize, expected: &[(f64, [f64; 3])]) {
        let points: Vec<_> = K[..points].iter().map(|&(key, [x, y, z])| (key, [x, y, z, 0.0, 0.0])).collect();
        let spline = Spline::new(kind, &points, 3).unwrap();
        for (p, expected) in expected {
            for (found, expected) in spline.at(*p).iter().zip(expected) {
                assert!((found - expected).abs() < 1e-9, "{kind:?} at {p}: {found} is not {expected}");
            }
        }
    }

    /// docs/spec/language.md 5.
    #[test]
    fn splines_are_povrays() {
        check(SplineKind::Linear, 4, &[(2.0, [3.0, 1.0, 1.5]), (-1.0, [0.0; 3]), (9.0, [1.0; 3])]);
        check(
            SplineKind::Quadratic,
            4,
            &[
                (0.5, [0.416666666667, 1.25, 1.875]),
                (2.0, [2.666666666667, 2.0, 3.0]),
                (3.5, [3.5, 0.333333333333, 0.291666666667]),
            ],
        );
        check(
            SplineKind::Natural,
            4,
            &[
                (0.5, [0.2890625, 1.2578125, 1.875]),
                (2.0, [3.9375, 1.1875, 1.875]),
                (3.5, [3.4453125, 0.2890625, 0.21875]),
            ],
        );
        check(
            SplineKind::Cubic,
            5,
            &[
                (0.5, [1.0, 2.0, 3.0]),
                (2.0, [3.625, 1.125, 1.75]),
                (3.5, [3.09375, 0.40625, 0.375]),
                (5.0, [1.0; 3]),
            ],
        );
        check(SplineKind::Cubic, 2, &[(0.25, [0.5, 1.0, 1.5])]);
    }

    /// POV-Ray gives `12.6…` for the second.
    #[test]
    fn parabolas_far_from_zero_keep_their_digits() {
        for far in [0.0, 1_048_576.0] {
            let points = [(far, 0.0), (far + 1.0, 1.0), (far + 2.0, 4.0)];
            let points = points.map(|(key, value)| (key, [value, 0.0, 0.0, 0.0, 0.0]));
            let spline = Spline::new(SplineKind::Quadratic, &points, 2).unwrap();
            assert_eq!(spline.at(far + 1.5)[0], 2.25);
        }
    }
}
