//! The splines of `prism`, `lathe` and `sphere_sweep` (docs/spec/primitives.md 6).

use crate::math::{DVec2, DVec4};
use crate::scene::shape::{self as scene, ContourSpline, SweepSpline, closing_distance};
use crate::world::shape::curve::{Curve, Segment};
use crate::world::shape::lathe::Lathe;
use crate::world::shape::prism::Prism;
use crate::world::shape::sphere_sweep::{self, SphereSweep};

/// `None` where the points make no segment.
pub(super) fn lathe(lathe: &scene::Lathe) -> Option<Lathe> {
    let points = lathe.points.as_slice();
    let segments: Vec<_> = match lathe.spline {
        ContourSpline::Linear => points.windows(2).map(|p| Segment::linear(p[0], p[1])).collect(),
        ContourSpline::Quadratic => points.windows(3).map(|p| Segment::quadratic(p[0], p[1], p[2])).collect(),
        ContourSpline::Cubic => points.windows(4).map(|p| Segment::cubic(p[0], p[1], p[2], p[3])).collect(),
        ContourSpline::Bezier => {
            points.chunks_exact(4).map(|p| Segment::bezier(p[0], p[1], p[2], p[3])).collect()
        }
    };
    (!segments.is_empty()).then(|| Lathe { profile: Curve::new(segments) })
}

/// `None` where an outline of a spline isn't closed: POV-Ray leaves such a prism out.
pub(super) fn prism(prism: &scene::Prism) -> Option<Prism> {
    let segments = match prism.spline {
        ContourSpline::Linear => linear(&prism.points),
        ContourSpline::Quadratic => runs(&prism.points, 1, 0, |p| Segment::quadratic(p[0], p[1], p[2]))?,
        ContourSpline::Cubic => runs(&prism.points, 1, 1, |p| Segment::cubic(p[0], p[1], p[2], p[3]))?,
        // POV-Ray runs through a Bézier segment from its end: that decides the side of the normals.
        ContourSpline::Bezier => {
            prism.points.chunks_exact(4).map(|p| Segment::bezier(p[3], p[2], p[1], p[0])).collect()
        }
    };
    let [one, other] = prism.heights;
    (!segments.is_empty()).then(|| Prism {
        outline: Curve::new(segments),
        heights: [one.min(other), one.max(other)],
        conic: prism.conic,
        open: prism.open,
    })
}

/// `None` where the spheres make no segment.
pub(super) fn sphere_sweep(sweep: &scene::SphereSweep) -> Option<SphereSweep> {
    use sphere_sweep::Segment;
    let balls: Vec<DVec4> = sweep.spheres.iter().map(|(center, radius)| center.extend(*radius)).collect();
    let of_four = |make: fn(DVec4, DVec4, DVec4, DVec4) -> Segment| {
        balls.windows(4).map(|b| make(b[0], b[1], b[2], b[3])).collect()
    };
    let segments: Vec<Segment> = match sweep.spline {
        SweepSpline::Linear => balls.windows(2).map(|b| Segment::linear(b[0], b[1])).collect(),
        SweepSpline::Cubic => of_four(Segment::cubic),
        SweepSpline::BSpline => of_four(Segment::b_spline),
    };
    // POV-Ray leaves room for a Catmull-Rom spline's swings.
    let room = if sweep.spline == SweepSpline::Cubic { 2.0 } else { 1.0 };
    SphereSweep::new(segments, &balls, room)
}

/// Polygons, each up to the point that repeats its first; the last is closed if it isn't.
fn linear(points: &[DVec2]) -> Vec<Segment> {
    let near = closing_distance(points);
    let mut segments = Vec::new();
    let mut rest = points;
    while let [first, tail @ ..] = rest {
        let end = tail.iter().position(|p| p.distance(*first) <= near).unwrap_or(tail.len());
        let corners = &rest[..=end];
        let next = corners[1..].iter().chain([first]);
        segments.extend(corners.iter().zip(next).map(|(a, b)| Segment::linear(*a, *b)));
        rest = tail.get(end + 1..).unwrap_or_default();
    }
    segments
}

/// Closed runs of a spline with `before` points of control ahead of each run and `after` behind; a run
/// ends where it returns to its first point. `None` where one doesn't.
fn runs(
    points: &[DVec2],
    before: usize,
    after: usize,
    segment: impl Fn(&[DVec2]) -> Segment,
) -> Option<Vec<Segment>> {
    let near = closing_distance(points);
    let mut segments = Vec::new();
    let mut rest = points;
    while !rest.is_empty() {
        let first = rest.get(before)?;
        let end = rest[before + 1..].iter().position(|p| p.distance(*first) <= near)? + before + 1;
        let run = rest.get(..=end + after)?;
        segments.extend(run.windows(before + after + 2).map(&segment));
        rest = &rest[run.len()..];
    }
    Some(segments)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn make(spline: ContourSpline, points: &[[f64; 2]]) -> Option<usize> {
        let points = points.iter().map(|p| DVec2::from(*p)).collect();
        let scene = scene::Prism { spline, conic: false, heights: [1.0, 0.0], points, open: false };
        prism(&scene).map(|prism| prism.outline.segments().len())
    }

    #[test]
    fn outlines_end_where_they_began() {
        let triangle = [[0., 0.], [1., 0.], [0., 1.], [0., 0.]];
        let twice = [triangle, triangle.map(|[x, y]| [x * 0.1 + 0.1, y * 0.1 + 0.1])].concat();
        assert_eq!(make(ContourSpline::Linear, &twice), Some(6));
        assert_eq!(make(ContourSpline::Linear, &triangle[..3]), Some(3));
        let cubic = [[0., 1.], [0., 0.], [1., 0.], [0., 1.], [0., 0.], [1., 0.]];
        assert_eq!(make(ContourSpline::Cubic, &cubic), Some(3));
        assert_eq!(make(ContourSpline::Cubic, &[cubic, cubic].concat()), Some(6));
        assert_eq!(make(ContourSpline::Quadratic, &cubic[..5]), Some(3));
    }

    #[test]
    fn an_open_spline_makes_no_prism() {
        assert_eq!(
            make(ContourSpline::Cubic, &[[0., 1.], [0., 0.], [1., 0.], [0., 1.], [0., 0.1], [1., 0.]]),
            None
        );
        assert_eq!(make(ContourSpline::Linear, &[]), None);
    }
}
