//! `polygon` (docs/spec/primitives.md 4.2).

use super::{Crossing, Shape};
use crate::math::{Bounds, DVec2, DVec3};
use crate::world::{Range, Ray};

/// A flat figure between closed contours, by the even-odd rule.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    /// A point of the plane.
    origin: DVec3,
    /// Unit normal.
    normal: DVec3,
    bounds: Bounds,
    /// The axis the normal is nearest to, dropped to decide what is inside the contours.
    dropped: usize,
    /// Edges of all contours without that axis.
    edges: Vec<[DVec2; 2]>,
}

/// How far from its plane a polygon's point may lie, in units of the polygon's size. POV-Ray allows
/// 1e-10 in the scene's units and draws nothing beyond.
const FLATNESS: f64 = 1e-6;

impl Polygon {
    /// From closed contours one after another, each ending with its first point; a last one left open
    /// is closed. `None` where the points lie on a line or not in a plane.
    pub fn new(points: &[DVec3]) -> Option<Self> {
        let origin = *points.first()?;
        let bounds = Bounds::of(points.iter().copied());
        let size = bounds.size().max_element();
        let normal = plane_normal(points, size)?;
        if !points.iter().all(|p| (*p - origin).dot(normal).abs() <= FLATNESS * size) {
            return None;
        }
        let dropped = normal.abs().max_position();
        let flat = |p: DVec3| match dropped {
            0 => DVec2::new(p.y, p.z),
            1 => DVec2::new(p.z, p.x),
            _ => DVec2::new(p.x, p.y),
        };
        let edges = contours(points, size).into_iter().flatten().map(|edge| edge.map(flat)).collect();
        Some(Self { origin, normal, bounds, dropped, edges })
    }

    fn covers(&self, p: DVec3) -> bool {
        let p = match self.dropped {
            0 => DVec2::new(p.y, p.z),
            1 => DVec2::new(p.z, p.x),
            _ => DVec2::new(p.x, p.y),
        };
        let crossed = |[a, b]: &&[DVec2; 2]| {
            if (a.y > p.y) == (b.y > p.y) {
                return false;
            }
            // Neighbouring polygons walk a shared edge in opposite senses: compare from its lower end.
            let (low, high) = if a.y < b.y { (*a, *b) } else { (*b, *a) };
            (high - low).perp_dot(p - low) > 0.0
        };
        self.edges.iter().filter(crossed).count() % 2 == 1
    }
}

/// The direction of u × v, for the first u and v from the first point that span an area.
fn plane_normal(points: &[DVec3], size: f64) -> Option<DVec3> {
    let from = |p: &DVec3| *p - points[0];
    let counts = |v: &DVec3| v.length() > FLATNESS * size;
    let u = points.iter().map(from).find(counts)?;
    let normal =
        points.iter().map(|p| u.cross(from(p))).find(|n| n.length() > FLATNESS * size * u.length())?;
    Some(normal.normalize())
}

/// Edges by contour.
fn contours(points: &[DVec3], size: f64) -> Vec<Vec<[DVec3; 2]>> {
    // POV-Ray takes points as near as 1e-10, in each coordinate, for the same.
    let same = f64::min(1e-10, FLATNESS * size);
    let mut all = Vec::new();
    let mut rest = points;
    while let [first, tail @ ..] = rest {
        let end = tail.iter().position(|p| (*p - *first).abs().max_element() <= same);
        let count = end.map_or(rest.len(), |end| end + 1);
        let corners = &rest[..count];
        let next = corners.iter().skip(1).chain([first]);
        all.push(corners.iter().zip(next).map(|(a, b)| [*a, *b]).collect());
        rest = &rest[end.map_or(rest.len(), |end| end + 2)..];
    }
    all
}

impl Shape for Polygon {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn extent(&self) -> Bounds {
        /// A side thinner than this is widened by as much, both ways.
        const THIN: f64 = 0.001;
        let mut bounds = self.bounds;
        for axis in 0..3 {
            if bounds.size()[axis] < THIN {
                bounds.min[axis] -= THIN;
                bounds.max[axis] += THIN;
            }
        }
        bounds
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        out.extend(self.nearest(ray, range));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let t = (self.origin - ray.origin).dot(self.normal) / self.normal.dot(ray.direction);
        (range.contains(t) && self.covers(ray.at(t))).then(|| Crossing::new(t, 0))
    }

    fn is_flat(&self) -> bool {
        true
    }

    fn inside(&self, _point: DVec3) -> bool {
        false
    }

    fn normal(&self, _point: DVec3, _crossing: &Crossing) -> DVec3 {
        self.normal
    }

    fn reproject(&self, point: DVec3, _crossing: &Crossing) -> DVec3 {
        point - (point - self.origin).dot(self.normal) * self.normal
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{battery, table};
    use super::*;

    fn polygon<const N: usize>(points: [[f64; 3]; N]) -> Option<Polygon> {
        Polygon::new(&points.map(DVec3::from))
    }

    battery! {
        tilted: |size, at| {
            let (u, v) = (DVec3::new(1.0, 0.2, 0.3), DVec3::new(-0.2, 1.0, 0.5));
            let corners = [(-0.5, -0.5), (0.6, -0.4), (0.1, 0.1), (0.5, 0.7), (-0.5, -0.5)];
            Polygon::new(&corners.map(|(a, b)| at + size * (a * u + b * v))).unwrap()
        }, surface;
    }

    #[test]
    fn probes_agree_with_povray() {
        let square = polygon([[0., 0., 0.], [2., 0., 0.], [2., 0., 1.], [0., 0., 1.], [0., 0., 0.]]).unwrap();
        table(
            &square,
            "from <0.5,3,0.3> dir <0,-1,0> | P <0.5, 0, 0.3> N <0, -1, 0>
            from <0.5,-3,0.3> dir <0,1,0> | P <0.5, 0, 0.3> N <0, -1, 0>
            from <2,3,0.5> dir <0,-1,0> | miss
            extent | <0, -0.001, 0> .. <2, 0.001, 1>",
        );
        let frame = polygon([
            [0., 0., 0.],
            [4., 0., 0.],
            [4., 4., 0.],
            [0., 4., 0.],
            [0., 0., 0.],
            [1., 1., 0.],
            [1., 3., 0.],
            [3., 3., 0.],
            [3., 1., 0.],
            [1., 1., 0.],
        ]);
        table(
            &frame.unwrap(),
            "from <2,2,-1> dir <0,0,1> | miss
            from <0.5,2,-1> dir <0,0,1> | P <0.5, 2, 0> N <0, 0, 1>",
        );
        table(
            &polygon([[0., 0., 0.], [1., 0., 0.], [0., 0., 1.]]).unwrap(),
            "from <0.2,3,0.2> dir <0,-1,0> | P <0.2, 0, 0.2> N <0, -1, 0>",
        );
        table(
            &polygon([[0., 0., 0.], [1., 1., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 0.]]).unwrap(),
            "from <0.25,0.5,-1> dir <0,0,1> | P <0.25, 0.5, 0> N <0, 0, -1>
            from <0.75,0.5,-1> dir <0,0,1> | P <0.75, 0.5, 0> N <0, 0, -1>
            from <0.5,0.25,-1> dir <0,0,1> | miss",
        );
    }

    #[test]
    fn points_off_the_plane_or_on_a_line_make_no_polygon() {
        assert_eq!(polygon([[0., 0., 0.], [1., 0., 0.], [1., 0., 1.], [0., 0.1, 1.], [0., 0., 0.]]), None);
        assert_eq!(polygon([[0., 0., 0.], [1., 0., 0.], [2., 0., 0.], [0., 0., 0.]]), None);
        assert_eq!(polygon([]), None);
    }

    #[test]
    fn a_shared_edge_belongs_to_one_of_its_polygons() {
        let left = polygon([[0., 0., 0.], [1., 0., 0.], [0.3, 1., 0.], [0., 1., 0.], [0., 0., 0.]]).unwrap();
        let right = polygon([[1., 0., 0.], [2., 0., 0.], [2., 1., 0.], [0.3, 1., 0.], [1., 0., 0.]]).unwrap();
        for i in 1..1000 {
            let s = f64::from(i) / 1000.0;
            let ray = Ray::new(DVec3::new(1.0 - 0.7 * s, s, -1.0), DVec3::Z);
            let hits = [&left, &right].map(|side| usize::from(side.occludes(&ray, Range::AHEAD)));
            assert_eq!(hits.iter().sum::<usize>(), 1, "{s}");
        }
    }
}
