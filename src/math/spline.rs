//! Splines through points with up to five components (docs/spec/language.md 5).

/// How points are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
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

/// The value at `p` of a spline through points sorted by rising key; zero without a point.
/// For many values of one spline, make a [`Spline`].
pub fn evaluate(kind: SplineKind, points: &[(f64, Value)], p: f64) -> Value {
    Spline::new(kind, points, 5).map_or([0.0; 5], |spline| spline.at(p))
}

/// A spline ready to be evaluated.
#[derive(Clone, Debug, PartialEq)]
pub struct Spline {
    kind: SplineKind,
    keys: Box<[f64]>,
    values: Box<[Value]>,
    /// Second derivatives of a natural spline at its points.
    bends: Box<[Value]>,
    size: usize,
}

impl Spline {
    /// Points sorted by rising key; `size` components of each are in use. `None` without points.
    pub fn new(kind: SplineKind, points: &[(f64, Value)], size: usize) -> Option<Self> {
        let keys: Box<[f64]> = points.iter().map(|point| point.0).collect();
        let values: Box<[Value]> = points.iter().map(|point| point.1).collect();
        let bends = if kind == SplineKind::Natural { natural_bends(&keys, &values) } else { Box::default() };
        (!keys.is_empty()).then_some(Self { kind, keys, values, bends, size: size.min(5) })
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
            SplineKind::Quadratic if last > 1 => self.parabola(i.max(1), p),
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

    /// The parabola through the points around `middle`.
    fn parabola(&self, middle: usize, p: f64) -> Value {
        let [t0, t1, t2] = [0, 1, 2].map(|k| self.keys[middle + k - 1]);
        let w0 = (p - t1) * (p - t2) / ((t0 - t1) * (t0 - t2));
        let w1 = (p - t0) * (p - t2) / ((t1 - t0) * (t1 - t2));
        let w2 = (p - t0) * (p - t1) / ((t2 - t0) * (t2 - t1));
        let [a, b, c] = [0, 1, 2].map(|k| &self.values[middle + k - 1]);
        each(|k| a[k] * w0 + b[k] * w1 + c[k] * w2)
    }

    fn natural(&self, i: usize, p: f64) -> Value {
        let (d, h) = (p - self.keys[i], self.keys[i + 1] - self.keys[i]);
        let [(v0, m0), (v1, m1)] = [i, i + 1].map(|k| (&self.values[k], &self.bends[k]));
        each(|c| {
            let slope = (v1[c] - v0[c]) / h - h * (m1[c] + 2.0 * m0[c]) / 6.0;
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
        let (u2, u3) = (u * u, u * u * u);
        each(|c| {
            values[i][c] * (2.0 * u3 - 3.0 * u2 + 1.0)
                + values[i + 1][c] * (3.0 * u2 - 2.0 * u3)
                + width * slope(i, c) * (u3 - 2.0 * u2 + u)
                + width * slope(i + 1, c) * (u3 - u2)
        })
    }
}

fn each(component: impl Fn(usize) -> f64) -> Value {
    std::array::from_fn(component)
}

/// Solves the tridiagonal system for the second derivatives.
fn natural_bends(keys: &[f64], values: &[Value]) -> Box<[Value]> {
    let n = keys.len();
    let mut bends = vec![[0.0; 5]; n];
    let mut ratios = vec![0.0; n];
    for k in 1..n.saturating_sub(1) {
        let (before, after) = (keys[k] - keys[k - 1], keys[k + 1] - keys[k]);
        let pivot = 2.0 * (before + after) - before * ratios[k - 1];
        ratios[k] = after / pivot;
        bends[k] = each(|c| {
            let rise = (values[k + 1][c] - values[k][c]) / after - (values[k][c] - values[k - 1][c]) / before;
            (6.0 * rise - before * bends[k - 1][c]) / pivot
        });
    }
    for k in (1..n.saturating_sub(1)).rev() {
        bends[k] = each(|c| bends[k][c] - ratios[k] * bends[k + 1][c]);
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
}
