//! Curves through points, docs/spec/language.md 5.

/// How the points of a spline are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[expect(missing_docs, reason = "the language's own words")]
pub enum SplineKind {
    #[default]
    Linear,
    Quadratic,
    Cubic,
    Natural,
}

/// A point: its key, and up to five components.
type Point = (f64, [f64; 5]);

/// The value at `p` of a spline through points sorted by strictly growing keys. Without a point
/// it is zero.
pub fn evaluate(kind: SplineKind, points: &[Point], p: f64) -> [f64; 5] {
    let [first, .., last] = points else {
        return points.first().map_or([0.0; 5], |point| point.1);
    };
    if kind == SplineKind::Cubic {
        return cubic(points, p);
    }
    if p <= first.0 {
        return first.1;
    }
    if p >= last.0 {
        return last.1;
    }
    let i = segment(points, p);
    match kind {
        SplineKind::Quadratic if points.len() > 2 => parabola(&points[i.max(1) - 1..], p),
        SplineKind::Natural => natural(points, i, p),
        _ => linear(&points[i], &points[i + 1], p),
    }
}

/// The segment `p` lies in: after the point with this index. `p` lies between the ends.
fn segment(points: &[Point], p: f64) -> usize {
    points.partition_point(|point| point.0 < p).clamp(1, points.len() - 1) - 1
}

fn each(f: impl Fn(usize) -> f64) -> [f64; 5] {
    std::array::from_fn(f)
}

fn linear(a: &Point, b: &Point, p: f64) -> [f64; 5] {
    let t = (p - a.0) / (b.0 - a.0);
    each(|c| a.1[c] + t * (b.1[c] - a.1[c]))
}

/// The parabola through the first three points, by Lagrange's weights.
fn parabola(points: &[Point], p: f64) -> [f64; 5] {
    let [a, b, c] = [&points[0], &points[1], &points[2]];
    let weight = |at: f64, m: f64, n: f64| (p - m) * (p - n) / ((at - m) * (at - n));
    let (wa, wb, wc) = (weight(a.0, b.0, c.0), weight(b.0, a.0, c.0), weight(c.0, a.0, b.0));
    each(|i| wa * a.1[i] + wb * b.1[i] + wc * c.1[i])
}

/// The cubic spline whose curvature is zero at both ends.
fn natural(points: &[Point], i: usize, p: f64) -> [f64; 5] {
    let h = points[i + 1].0 - points[i].0;
    let d = p - points[i].0;
    each(|c| {
        let m = curvatures(points, c);
        let (a, b) = (points[i].1[c], points[i + 1].1[c]);
        let slope = (b - a) / h - h * (m[i + 1] + 2.0 * m[i]) / 6.0;
        a + d * (slope + d * (m[i] / 2.0 + d * (m[i + 1] - m[i]) / (6.0 * h)))
    })
}

/// Second derivatives at the points: solves the tridiagonal system by elimination.
fn curvatures(points: &[Point], c: usize) -> Vec<f64> {
    let n = points.len() - 1;
    let h = |k: usize| points[k + 1].0 - points[k].0;
    let slope = |k: usize| (points[k + 1].1[c] - points[k].1[c]) / h(k);
    let (mut factor, mut right) = (vec![0.0; n + 1], vec![0.0; n + 1]);
    for k in 1..n {
        let pivot = 2.0 * (h(k - 1) + h(k)) - h(k - 1) * factor[k - 1];
        factor[k] = h(k) / pivot;
        right[k] = (6.0 * (slope(k) - slope(k - 1)) - h(k - 1) * right[k - 1]) / pivot;
    }
    for k in (1..n).rev() {
        right[k] -= factor[k] * right[k + 1];
    }
    right
}

/// Catmull-Rom: defined between the second point and the last but one.
fn cubic(points: &[Point], p: f64) -> [f64; 5] {
    let n = points.len() - 1;
    if n == 1 {
        return each(|c| (points[0].1[c] + points[1].1[c]) / 2.0);
    }
    if p <= points[1].0 {
        return points[1].1;
    }
    if p > points[n - 1].0 {
        return points[n - 1].1;
    }
    let i = segment(points, p);
    let dt = points[i + 1].0 - points[i].0;
    let u = (p - points[i].0) / dt;
    each(|c| {
        let rise = |k: usize| (points[k + 1].1[c] - points[k].1[c]) / (points[k + 1].0 - points[k].0);
        let slope = |k: usize| (rise(k - 1) + rise(k)) / 2.0;
        let (a, b) = (points[i].1[c], points[i + 1].1[c]);
        let (u2, u3) = (u * u, u * u * u);
        a * (2.0 * u3 - 3.0 * u2 + 1.0)
            + b * (3.0 * u2 - 2.0 * u3)
            + dt * slope(i) * (u3 - 2.0 * u2 + u)
            + dt * slope(i + 1) * (u3 - u2)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: [Point; 5] = [
        (0.0, [0.0; 5]),
        (1.0, [1.0, 2.0, 3.0, 0.0, 0.0]),
        (3.0, [5.0, 0.0, 0.0, 0.0, 0.0]),
        (4.0, [1.0, 1.0, 1.0, 0.0, 0.0]),
        (6.0, [2.0, 2.0, 2.0, 0.0, 0.0]),
    ];

    fn check(kind: SplineKind, points: &[Point], cases: &[(f64, [f64; 3])]) {
        for &(p, wanted) in cases {
            let found = evaluate(kind, points, p);
            for c in 0..3 {
                assert!((found[c] - wanted[c]).abs() < 1e-9, "{kind:?} at {p}: {found:?}, not {wanted:?}");
            }
        }
    }

    #[test]
    fn each_kind_gives_what_pov_ray_gives() {
        let four = &POINTS[..4];
        check(SplineKind::Linear, four, &[(2.0, [3.0, 1.0, 1.5]), (-1.0, [0.0; 3]), (9.0, [1.0; 3])]);
        let parabola = [(0.5, [0.416666666667, 1.25, 1.875]), (2.0, [2.666666666667, 2.0, 3.0])];
        check(SplineKind::Quadratic, four, &parabola);
        let natural = [(0.5, [0.2890625, 1.2578125, 1.875]), (3.5, [3.4453125, 0.2890625, 0.21875])];
        check(SplineKind::Natural, four, &natural);
        let cubic = [(0.5, [1.0, 2.0, 3.0]), (2.0, [3.625, 1.125, 1.75]), (5.0, [1.0; 3])];
        check(SplineKind::Cubic, &POINTS, &cubic);
    }

    #[test]
    fn a_cubic_through_two_points_is_their_middle_everywhere() {
        check(SplineKind::Cubic, &POINTS[..2], &[(0.25, [0.5, 1.0, 1.5]), (7.0, [0.5, 1.0, 1.5])]);
    }
}
