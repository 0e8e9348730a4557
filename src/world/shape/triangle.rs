//! `triangle` and `smooth_triangle` (docs/spec/primitives.md 4.1), and the test meshes share.

use super::{Crossing, Shape};
use crate::math::{Bounds, DVec3, Transform};
use crate::world::{Range, Ray};

/// Three corners, edges included; [`Crossing::at`] are the weights of the second and third.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangle {
    corners: [DVec3; 3],
    /// Normals at the corners of a smooth one.
    normals: Option<Box<[DVec3; 3]>>,
}

impl Triangle {
    /// `None` where the corners span no area. Normals are normalised; a zero one becomes +x, as in meshes.
    pub fn new(corners: [DVec3; 3], normals: Option<[DVec3; 3]>) -> Option<Self> {
        let area = face_normal(corners);
        let normals = normals.map(|all| Box::new(all.map(|n| n.normalize_or(DVec3::X))));
        (area != DVec3::ZERO && area.is_finite()).then_some(Self { corners, normals })
    }

    /// Where a transform takes it; `None` where the corners run the other way round there, or lie on a line.
    pub fn transformed(&self, by: &Transform) -> Option<Self> {
        let corners = self.corners.map(|corner| by.point(corner));
        let area = face_normal(corners);
        let kept = by.forward.matrix3.determinant() > 0.0 && area != DVec3::ZERO && area.is_finite();
        let normals = self.normals.as_ref().map(|normals| Box::new(normals.map(|normal| by.normal(normal))));
        kept.then_some(Self { corners, normals })
    }
}

/// The normal of corners that run clockwise where it points to the viewer; its length is twice the area.
pub(super) fn face_normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    (c - a).cross(b - a)
}

/// What the corners have, blended by the barycentric coordinates of a crossing.
pub(super) fn blend<T>(corners: [T; 3], at: [f64; 2]) -> T
where
    T: std::ops::Mul<f64, Output = T> + std::ops::Add<Output = T>,
{
    let [a, b, c] = corners;
    a * (1.0 - at[0] - at[1]) + b * at[0] + c * at[1]
}

/// A ray prepared for many triangles: the axes permuted and sheared so that it runs along z
/// (Woop, Benthin, Wald, JCGT 2013). Neighbours compute a shared edge from the same numbers, so no
/// ray slips between them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sheared {
    origin: DVec3,
    axes: [usize; 3],
    shear: DVec3,
}

/// An edge of triangles in the space of a ray.
#[derive(Clone, Copy, Debug)]
pub(super) struct Base {
    b: DVec3,
    c: DVec3,
    /// Twice the signed area between the edge and the ray.
    area: f64,
}

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meeting {
    /// Distance.
    pub t: f64,
    /// Weights of the second and third corner.
    pub at: [f64; 2],
    /// Whether an edge or corner was met, to the last bit.
    pub on_edge: bool,
    /// Whether the point belongs to this triangle rather than to the neighbour behind the edge.
    pub owned: bool,
}

impl Sheared {
    pub(super) fn new(ray: &Ray) -> Self {
        let d = ray.direction;
        let z = d.abs().max_position();
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        // Keep the sense of rotation.
        let axes = if d[z] < 0.0 { [y, x, z] } else { [x, y, z] };
        let shear = DVec3::new(d[axes[0]] / d[z], d[axes[1]] / d[z], 1.0 / d[z]);
        Self { origin: ray.origin, axes, shear }
    }

    #[inline(always)]
    fn corner(&self, p: DVec3) -> DVec3 {
        let from = (p - self.origin).to_array();
        let z = from[self.axes[2]];
        DVec3::new(
            from[self.axes[0]] - self.shear.x * z,
            from[self.axes[1]] - self.shear.y * z,
            self.shear.z * z,
        )
    }

    /// The bits of those of `N` triangles that the ray may meet; the others it misses surely.
    /// The same test as in [`Sheared::meet`], side by side, but that no sign is made exact.
    #[inline(always)]
    pub(super) fn may_meet<const N: usize>(&self, triangles: &[[DVec3; 3]; N]) -> u32 {
        // Which axis is which is asked once, not of each corner.
        match self.axes[2] {
            0 => self.may_meet_along(
                triangles,
                #[inline(always)]
                |p| [p.y, p.z, p.x],
            ),
            1 => self.may_meet_along(
                triangles,
                #[inline(always)]
                |p| [p.z, p.x, p.y],
            ),
            _ => self.may_meet_along(
                triangles,
                #[inline(always)]
                |p| [p.x, p.y, p.z],
            ),
        }
    }

    /// The same for a ray that runs along the last of the axes `order` gives.
    #[inline(always)]
    fn may_meet_along<const N: usize>(
        &self,
        triangles: &[[DVec3; 3]; N],
        order: impl Fn(DVec3) -> [f64; 3],
    ) -> u32 {
        let [origin_x, origin_y, origin_z] = order(self.origin);
        // Both axes change places where the ray runs backward, which no answer here depends on.
        let turned = self.axes[0] != (self.axes[2] + 1) % 3;
        let (shear_x, shear_y) =
            if turned { (self.shear.y, self.shear.x) } else { (self.shear.x, self.shear.y) };
        let mut lanes = [[[0.0; N]; 2]; 3];
        for side in 0..3 {
            let mut at = [[0.0; N]; 3];
            for lane in 0..N {
                [at[0][lane], at[1][lane], at[2][lane]] = order(triangles[lane][side]);
            }
            for lane in 0..N {
                let along = at[2][lane] - origin_z;
                lanes[side][0][lane] = at[0][lane] - origin_x - shear_x * along;
                lanes[side][1][lane] = at[1][lane] - origin_y - shear_y * along;
            }
        }
        let (mut below, mut above) = ([false; N], [false; N]);
        for (from, to) in [(1, 2), (2, 0), (0, 1)] {
            let ([from_x, from_y], [to_x, to_y]) = (&lanes[from], &lanes[to]);
            for lane in 0..N {
                let (one, other) = (to_x[lane] * from_y[lane], to_y[lane] * from_x[lane]);
                let doubt = DOUBT * (one.abs() + other.abs());
                below[lane] |= one - other < -doubt;
                above[lane] |= one - other > doubt;
            }
        }
        (0..N).fold(0, |mask, lane| mask | u32::from(!(below[lane] && above[lane])) << lane)
    }

    /// Where the ray meets a triangle.
    #[inline(always)]
    pub(super) fn meet(&self, [a, b, c]: [DVec3; 3]) -> Option<Meeting> {
        self.meet_over(&self.base(b, c), a)
    }

    /// The edge between the second and the third corner, which another triangle may have as well.
    #[inline(always)]
    pub(super) fn base(&self, b: DVec3, c: DVec3) -> Base {
        let (b, c) = (self.corner(b), self.corner(c));
        Base { b, c, area: edge(b, c) }
    }

    /// Where the ray meets the triangle over an edge whose first corner is `a`.
    #[inline(always)]
    pub(super) fn meet_over(&self, base: &Base, a: DVec3) -> Option<Meeting> {
        let (a, Base { b, c, area }) = (self.corner(a), *base);
        let weights = [area, edge(c, a), edge(a, b)];
        let some = |wanted: fn(&f64) -> bool| weights.iter().any(wanted);
        if some(|w| *w < 0.0) && some(|w| *w > 0.0) {
            return None;
        }
        let [u, v, w] = weights;
        let sum = u + v + w;
        let t = (u * a.z + v * b.z + w * c.z) / sum;
        if !t.is_finite() {
            return None;
        }
        let on_edge = some(|w| *w == 0.0);
        let owned = !on_edge
            || [(u, b, c), (v, c, a), (w, a, b)].into_iter().all(|(weight, from, to)| {
                weight != 0.0 || sum > 0.0 && owns(to - from) || sum < 0.0 && owns(from - to)
            });
        Some(Meeting { t, at: [v / sum, w / sum], on_edge, owned })
    }
}

impl Sheared {
    /// Whether the ray passes so close to the border of a triangle, on either side, that neighbours
    /// whose corners were rounded apart may both miss it or both have it.
    pub(super) fn grazes(&self, corners: [DVec3; 3], distance: f64) -> bool {
        let [a, b, c] = corners.map(|p| self.corner(p));
        let sides = [(b, c), (c, a), (a, b)].map(|(from, to)| {
            let room = distance * (to - from).truncate().length();
            (edge(from, to), room)
        });
        let within = |sense: f64| sides.iter().all(|(area, room)| sense * area >= -room);
        sides.iter().any(|(area, room)| area.abs() <= *room) && (within(1.0) || within(-1.0))
    }
}

/// Rounding error of a signed area, relative to its terms.
const DOUBT: f64 = 4.0 * f64::EPSILON;

/// Twice the signed area between an edge and the ray, its sign exact.
#[inline(always)]
fn edge(from: DVec3, to: DVec3) -> f64 {
    let (one, other) = (to.x * from.y, to.y * from.x);
    let area = one - other;
    if area.abs() > DOUBT * (one.abs() + other.abs()) {
        return area;
    }
    exact_edge(from, to)
}

#[cold]
fn exact_edge(from: DVec3, to: DVec3) -> f64 {
    let coord = |p: DVec3| robust::Coord { x: p.x, y: p.y };
    robust::orient2d(coord(to), coord(from), robust::Coord { x: 0.0, y: 0.0 })
}

/// Of two triangles beside an edge just one runs along it in this sense.
fn owns(edge: DVec3) -> bool {
    edge.y > 0.0 || edge.y == 0.0 && edge.x > 0.0
}

impl Shape for Triangle {
    fn bounds(&self) -> Bounds {
        Bounds::of(self.corners)
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        out.extend(self.nearest(ray, range));
    }

    #[inline]
    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let hit = Sheared::new(ray).meet(self.corners)?;
        range.contains(hit.t).then_some(Crossing { t: hit.t, part: 0, at: hit.at })
    }

    fn is_flat(&self) -> bool {
        true
    }

    fn inside(&self, _point: DVec3) -> bool {
        false
    }

    fn is_solid(&self) -> bool {
        false
    }

    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        match &self.normals {
            Some(normals) => blend(**normals, crossing.at),
            None => self.geometric_normal(point, crossing),
        }
    }

    /// On the side of the interpolated one, where there is one.
    fn interpolates(&self) -> bool {
        self.normals.is_some()
    }

    fn geometric_normal(&self, _point: DVec3, crossing: &Crossing) -> DVec3 {
        let normal = face_normal(self.corners);
        let smooth = self.normals.as_ref().map(|normals| blend(**normals, crossing.at));
        if smooth.is_some_and(|smooth| smooth.dot(normal) < 0.0) { -normal } else { normal }
    }

    fn reproject(&self, _point: DVec3, crossing: &Crossing) -> DVec3 {
        blend(self.corners, crossing.at)
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{battery, table};
    use super::*;

    fn vectors(all: [[f64; 3]; 3]) -> [DVec3; 3] {
        all.map(DVec3::from)
    }

    battery! {
        flat: |size, at| Triangle::new(
            [DVec3::NEG_X, DVec3::new(1.0, 0.2, 0.1), DVec3::new(0.3, 1.0, -0.5)].map(|p| at + size * p),
            None,
        ).unwrap(), surface;
    }

    #[test]
    fn probes_agree_with_povray() {
        let corners = vectors([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
        table(
            &Triangle::new(corners, None).unwrap(),
            "from <0.5,3,0.3> dir <0,-1,0> | P <0.5, 0, 0.3> N <0, 1, 0>
            from <0.5,-3,0.3> dir <0,1,0> | P <0.5, 0, 0.3> N <0, 1, 0>
            from <1,3,0.5> dir <0,-1,0> | P <1, 0, 0.5> N <0, 1, 0>
            from <1,3,0.50000001> dir <0,-1,0> | miss
            from <0,3,0> dir <0,-1,0> | P <0, 0, 0> N <0, 1, 0>
            from <0,3,0.5> dir <0,-1,0> | P <0, 0, 0.5> N <0, 1, 0>
            from <-1e-12,3,0.5> dir <0,-1,0> | miss
            from <1,3,0> dir <0,-1,0> | P <1, 0, 0> N <0, 1, 0>
            from <-5,0,0.3> dir <1,0,0> | miss",
        );
        let turned = Triangle::new([corners[1], corners[0], corners[2]], None).unwrap();
        table(&turned, "from <0.5,3,0.3> dir <0,-1,0> | P <0.5, 0, 0.3> N <0, -1, 0>");
        let normals = vectors([[-0.5, 1.0, -0.5], [0.5, 1.0, -0.5], [0.0, 1.0, 0.7]]);
        table(
            &Triangle::new(corners, Some(normals)).unwrap(),
            "from <0.5,3,0.3> dir <0,-1,0> | P <0.5, 0, 0.3> N <-0.098465336139503, 0.985642965535228, -0.137158747697166>
            from <0,3,0> dir <0,-1,0> | P <0, 0, 0> N <-0.408248290463863, 0.816496580927726, -0.408248290463863>
            from <0.1,3,0.8> dir <0,-1,0> | P <0.1, 0, 0.8> N <-0.045245685464341, 0.907338945451718, 0.417957971587368>
            from <1.9,3,0.01> dir <0,-1,0> | P <1.9, 0, 0.01> N <0.378482191340063, 0.831856859002146, -0.405913041142444>",
        );
    }

    #[test]
    fn normals_on_both_sides_of_the_plane_hide_nothing() {
        // POV-Ray drops such a triangle.
        let corners = [DVec3::NEG_X, DVec3::X, DVec3::Z];
        let smooth = Triangle::new(corners, Some([DVec3::Y, DVec3::Y, DVec3::NEG_Y])).unwrap();
        assert!(smooth.occludes(&Ray::new(DVec3::new(0.0, 3.0, 0.2), DVec3::NEG_Y), Range::AHEAD));
    }

    #[test]
    fn corners_on_a_line_make_no_triangle() {
        assert_eq!(Triangle::new([DVec3::ZERO, DVec3::X, 3.0 * DVec3::X], None), None);
    }
}
