//! `bicubic_patch` (docs/spec/primitives.md 4.5).

use rustc_hash::FxHashSet;

use super::mesh::{Face, Lists, Mesh};
use super::{Crossing, Shape};
use crate::math::{Bounds, DVec2, DVec3};
use crate::world::{Range, Ray};

/// A Bézier patch as the triangles POV-Ray makes of it, with the patch's own normals at their corners.
#[derive(Clone, Debug)]
pub struct BicubicPatch {
    /// Its texture coordinates are the patch's parameters u and v.
    mesh: Mesh,
    /// Texture coordinates of the patch's corners.
    uv: [DVec2; 4],
    /// The box around the control points.
    extent: Bounds,
}

/// Control points, by u and v.
type Points = [[DVec3; 4]; 4];

/// The finest grid the parameters are divided by: 2 to this power. Steps beyond it are ignored.
const FINEST: u32 = 12;

/// A rectangle of parameters in steps of the finest grid.
#[derive(Clone, Copy, Debug)]
struct Leaf {
    from: [u32; 2],
    to: [u32; 2],
}

impl BicubicPatch {
    /// From control points row by row; `None` where they span no triangle.
    ///
    /// A part is divided, `steps` times at most along u and v, until its control points are nearer
    /// than `flatness` to a plane.
    pub fn new(points: &[DVec3; 16], flatness: f64, steps: [u32; 2], uv: Option<[DVec2; 4]>) -> Option<Self> {
        let control: Points = std::array::from_fn(|i| std::array::from_fn(|j| points[4 * i + j]));
        let whole = Leaf { from: [0; 2], to: [1 << FINEST; 2] };
        let mut leaves = Vec::new();
        divide(&control, whole, 0, flatness, steps.map(|s| s.min(FINEST)), &mut leaves);
        let mesh = tessellate(&control, &leaves)?;
        let uv = uv.unwrap_or([DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y]);
        let extent = Bounds::of(points.iter().copied());
        (!mesh.bounds().is_empty()).then_some(Self { mesh, uv, extent })
    }
}

fn divide(points: &Points, leaf: Leaf, depth: u32, flatness: f64, steps: [u32; 2], leaves: &mut Vec<Leaf>) {
    let split = steps.map(|limit| depth < limit);
    if split == [false; 2] || is_flat(points, flatness) {
        leaves.push(leaf);
        return;
    }
    let halves = |points: &Points, leaf: Leaf, axis: usize| {
        let (low, high) = if axis == 0 { halve(points) } else { halve_across(points) };
        let middle = (leaf.from[axis] + leaf.to[axis]) / 2;
        let (mut first, mut second) = (leaf, leaf);
        (first.to[axis], second.from[axis]) = (middle, middle);
        [(low, first), (high, second)]
    };
    let mut parts = vec![(*points, leaf)];
    for axis in (0..2).filter(|axis| split[*axis]) {
        parts = parts.iter().flat_map(|(points, leaf)| halves(points, *leaf, axis)).collect();
    }
    for (points, leaf) in parts {
        divide(&points, leaf, depth + 1, flatness, steps, leaves);
    }
}

/// Whether the control points are near the plane through three corners.
fn is_flat(points: &Points, flatness: f64) -> bool {
    let corner = points[0][0];
    let others = [points[0][3], points[3][0], points[3][3]];
    let Some(pair) = [[0, 1], [0, 2], [1, 2]]
        .map(|pair| pair.map(|i: usize| others[i] - corner))
        .into_iter()
        .find(|[a, b]| a.cross(*b).length_squared() > 1e-20 * a.length_squared() * b.length_squared())
    else {
        return false;
    };
    let normal = pair[0].cross(pair[1]).normalize();
    points.iter().flatten().all(|p| (*p - corner).dot(normal).abs() < flatness)
}

/// Both halves along u, by de Casteljau's construction.
fn halve(points: &Points) -> (Points, Points) {
    let (mut low, mut high) = (*points, *points);
    for j in 0..4 {
        let [a, b, c, d] = std::array::from_fn(|i| points[i][j]);
        let (ab, bc, cd) = (a.midpoint(b), b.midpoint(c), c.midpoint(d));
        let (abc, bcd) = (ab.midpoint(bc), bc.midpoint(cd));
        let middle = abc.midpoint(bcd);
        for (i, (l, h)) in [(a, middle), (ab, bcd), (abc, cd), (middle, d)].into_iter().enumerate() {
            (low[i][j], high[i][j]) = (l, h);
        }
    }
    (low, high)
}

/// Both halves along v.
fn halve_across(points: &Points) -> (Points, Points) {
    let (low, high) = halve(&transposed(points));
    (transposed(&low), transposed(&high))
}

fn transposed(points: &Points) -> Points {
    std::array::from_fn(|i| std::array::from_fn(|j| points[j][i]))
}

/// Bernstein's polynomials of degree 3 and their derivatives.
fn bernstein(t: f64) -> ([f64; 4], [f64; 4]) {
    let s = 1.0 - t;
    (
        [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t],
        [-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t],
    )
}

/// The point and the unit normal, +x where there is none.
fn evaluate(points: &Points, u: f64, v: f64) -> (DVec3, DVec3) {
    let ((in_u, slope_u), (in_v, slope_v)) = (bernstein(u), bernstein(v));
    let sum = |weights: [f64; 4], others: [f64; 4]| {
        let rows = points.iter().map(|row| row.iter().zip(others).map(|(p, w)| *p * w).sum::<DVec3>());
        rows.zip(weights).map(|(row, w)| row * w).sum::<DVec3>()
    };
    let (along_u, along_v) = (sum(slope_u, in_v), sum(in_u, slope_v));
    let normal = along_u.cross(along_v);
    let least = 1e-10 * along_u.length_squared() * along_v.length_squared();
    let normal = if normal.length_squared() <= least { DVec3::X } else { normal.normalize() };
    (sum(in_u, in_v), normal)
}

/// Triangles over the leaves: two to each, as in POV-Ray. A leaf with finer neighbours is a fan about
/// its middle, through every corner that lies on its edges, so that no crack opens between them.
fn tessellate(points: &Points, leaves: &[Leaf]) -> Option<Mesh> {
    let mut corners = FxHashSet::default();
    for Leaf { from: [u0, v0], to: [u1, v1] } in leaves {
        corners.extend([[*u0, *v0], [*u0, *v1], [*u1, *v1], [*u1, *v0]]);
    }
    let mut lists = Lists::default();
    let mut numbers = rustc_hash::FxHashMap::default();
    let mut vertex = |at: [u32; 2]| {
        *numbers.entry(at).or_insert_with(|| {
            let [u, v] = at.map(|step| f64::from(step) / f64::from(1_u32 << FINEST));
            let (point, normal) = evaluate(points, u, v);
            lists.vertices.push(point);
            lists.normals.push(normal);
            lists.uvs.push(DVec2::new(u, v));
            lists.vertices.len() as u32 - 1
        })
    };
    let mut faces = Vec::new();
    for leaf in leaves {
        let ring = ring(leaf, &corners);
        let triangles: Vec<[[u32; 2]; 3]> = match ring[..] {
            [a, b, c, d] => vec![[a, b, c], [a, c, d]],
            _ => {
                let middle = [0, 1].map(|axis| (leaf.from[axis] + leaf.to[axis]) / 2);
                let next = ring.iter().skip(1).chain(ring.first());
                ring.iter().zip(next).map(|(a, b)| [middle, *a, *b]).collect()
            }
        };
        for triangle in triangles {
            let v = triangle.map(&mut vertex);
            faces.push(Face { vertices: v, normals: Some(v), uvs: Some(v), textures: None });
        }
    }
    Mesh::new(lists, &faces, None)
}

/// The corners on the edges of a leaf, in order around it from its first.
fn ring(leaf: &Leaf, corners: &FxHashSet<[u32; 2]>) -> Vec<[u32; 2]> {
    let Leaf { from: [u0, v0], to: [u1, v1] } = *leaf;
    let mut ring = Vec::new();
    let mut edge = |from: [u32; 2], to: [u32; 2]| walk(from, to, corners, &mut ring);
    edge([u0, v0], [u0, v1]);
    edge([u0, v1], [u1, v1]);
    edge([u1, v1], [u1, v0]);
    edge([u1, v0], [u0, v0]);
    ring
}

/// Adds `from` and the corners before `to`: those of neighbours halve the edge, and halve it again.
fn walk(from: [u32; 2], to: [u32; 2], corners: &FxHashSet<[u32; 2]>, ring: &mut Vec<[u32; 2]>) {
    let middle = [0, 1].map(|axis| (from[axis] + to[axis]) / 2);
    if middle != from && middle != to && corners.contains(&middle) {
        walk(from, middle, corners, ring);
        walk(middle, to, corners, ring);
    } else {
        ring.push(from);
    }
}

impl Shape for BicubicPatch {
    fn bounds(&self) -> Bounds {
        self.mesh.bounds()
    }

    fn extent(&self) -> Bounds {
        self.extent
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.mesh.crossings(ray, range, out);
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        self.mesh.nearest(ray, range)
    }

    fn occludes(&self, ray: &Ray, range: Range) -> bool {
        self.mesh.occludes(ray, range)
    }

    fn inside(&self, _point: DVec3) -> bool {
        false
    }

    fn is_solid(&self) -> bool {
        false
    }

    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        self.mesh.normal(point, crossing)
    }

    fn interpolates(&self) -> bool {
        true
    }

    fn geometric_normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        self.mesh.geometric_normal(point, crossing)
    }

    fn uv(&self, point: DVec3, crossing: &Crossing) -> Option<DVec2> {
        let place = self.mesh.uv(point, crossing)?;
        let [a, b, c, d] = self.uv;
        Some(a.lerp(b, place.y).lerp(d.lerp(c, place.y), place.x))
    }

    fn reproject(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        self.mesh.reproject(point, crossing)
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{self, battery, table};
    use super::*;

    #[rustfmt::skip]
    const PROBED: [[f64; 3]; 16] = [
        [0., 0., 2.], [1., 0., 0.], [2., 0., 0.], [3., 0., -2.], [0., 1., 0.], [1., 1., 0.], [2., 1., 0.], [3., 1., 0.],
        [0., 2., 0.], [1., 2., 0.], [2., 2., 0.], [3., 2., 0.], [0., 3., 2.], [1., 3., 0.], [2., 3., 0.], [3., 3., -2.],
    ];

    fn make(flatness: f64, steps: [u32; 2], uv: Option<[DVec2; 4]>) -> BicubicPatch {
        BicubicPatch::new(&PROBED.map(DVec3::from), flatness, steps, uv).unwrap()
    }

    battery! {
        bent: |size, at| {
            let points = PROBED.map(|p| at + 0.4 * size * (DVec3::from(p) - DVec3::new(1.5, 1.5, 0.0)));
            BicubicPatch::new(&points, 0.0, [3, 2], None).unwrap()
        }, surface;
    }

    #[test]
    fn probes_agree_with_povray() {
        table(
            &make(0.01, [3, 3], None),
            "from <1.2,1.7,-5> dir <0,0,1> | P <1.2, 1.7, 0.082543945312501> N <-0.276895176681719, 0.030331840729394, -0.960421282858916>
            from <0.1,0.1,-5> dir <0.01,0.02,1> | P <0.164056130619048, 0.228112261238095, 1.405613061904748> N <-0.628516217858065, -0.628508057059653, -0.458197540478442>
            from <2.9,2.8,5> dir <0,0,-1> | P <2.9, 2.8, -1.531022135416666> N <-0.633308777236905, -0.644670873718708, -0.428158215211916>
            from <3.01,1,-5> dir <0,0,1> | miss",
        );
        table(
            &make(0.0, [0, 0], None),
            "from <1.2,1.7,-5> dir <0,0,1> | P <1.2, 1.7, 0.4> N <-0.768221279597376, -0.512147519731584, -0.384110639798688>",
        );
        table(
            &make(0.0, [1, 2], None),
            "from <1.2,1.7,-5> dir <0,0,1> | P <1.2, 1.7, 0.08125> N <-0.331880960970714, 0, -0.943321274935086>",
        );
        table(
            &make(1.0, [5, 5], None),
            "from <1.2,1.7,-5> dir <0,0,1> | P <1.2, 1.7, 0.08125> N <-0.307688793338883, 0, -0.951487050071446>",
        );
    }

    #[test]
    fn uv_agrees_with_povray() {
        let down = [0.0, 0.0, 1.0];
        battery::uv(&make(0.01, [3, 3], None), [1.2, 1.7, -5.0], down, [0.4, 0.56667]);
        let corners = [[0.1, 0.2], [0.9, 0.1], [0.8, 0.7], [0.2, 0.9]].map(DVec2::from);
        let mapped = make(0.0, [4, 4], Some(corners));
        battery::uv(&mapped, [1.2, 1.7, -5.0], down, [0.43133, 0.534]);
        battery::uv(&mapped, [2.5, 0.4, -5.0], down, [0.75778, 0.19889]);
    }

    #[test]
    fn parts_of_different_depth_leave_no_crack() {
        // The patch of docs/spec/primitives.md 9.1, in which POV-Ray leaves holes.
        #[rustfmt::skip]
        let points = [
            [-1., -1., 0.5], [-0.3, -1., -0.5], [0.3, -1., 0.5], [1., -1., 0.], [-1., -0.3, 0.], [-0.3, -0.3, -1.],
            [0.3, -0.3, 0.5], [1., -0.3, 0.], [-1., 0.3, 0.], [-0.3, 0.3, 0.5], [0.3, 0.3, -1.], [1., 0.3, 0.],
            [-1., 1., 0.], [-0.3, 1., 0.], [0.3, 1., 0.], [1., 1., 0.5],
        ].map(DVec3::from);
        let patch = BicubicPatch::new(&points, 0.1, [5, 5], None).unwrap();
        for y in -199..200 {
            for x in -199..200 {
                let origin = DVec3::new(f64::from(x) / 201.0, f64::from(y) / 201.0, -5.0);
                assert!(patch.occludes(&Ray::new(origin, DVec3::Z), Range::AHEAD), "{origin}");
            }
        }
    }
}
