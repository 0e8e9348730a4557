//! `mesh` and `mesh2` (docs/spec/primitives.md 4.3, 4.4).

mod rim;

use std::sync::OnceLock;

use rim::Rim;

use super::triangle::{Meeting, Sheared, blend, face_normal};
use super::{Crossing, Shape, uncrossed};
use crate::math::wide::widest;
use crate::math::{Band, Bounds, DVec2, DVec3, tally};
use crate::world::accel::Bvh;
use crate::world::{Range, Ray};

/// Triangles that share lists of corners, normals and texture coordinates.
///
/// [`Crossing::part`] is the number of the face among those with an area, [`Crossing::at`] the weights
/// of its second and third corner.
#[derive(Clone, Debug)]
pub struct Mesh {
    lists: Lists,
    /// Corners of the faces, in the order of the hierarchy.
    faces: Box<[[u32; 3]]>,
    normals: Column,
    uvs: Column,
    textures: Column,
    bvh: Bvh,
    inside: Option<DVec3>,
    /// Once it was asked for.
    rim: OnceLock<Rim>,
}

/// What the faces of a [`Mesh`] refer to.
#[derive(Clone, Debug, Default)]
pub struct Lists {
    /// Corners.
    pub vertices: Vec<DVec3>,
    /// Normals, of any length.
    pub normals: Vec<DVec3>,
    /// Texture coordinates.
    pub uvs: Vec<DVec2>,
}

/// One triangle of a [`Mesh`]: indices into its lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Face {
    /// Corners.
    pub vertices: [u32; 3],
    /// Normals of a smooth triangle.
    pub normals: Option<[u32; 3]>,
    /// Texture coordinates; without them they are (0, 0).
    pub uvs: Option<[u32; 3]>,
    /// Textures of the corners, all equal for one on the whole face; `None` for the mesh's own.
    pub textures: Option<[u32; 3]>,
}

/// What faces have besides corners, in the same order.
#[derive(Clone, Debug)]
enum Column {
    /// No face has it.
    Nothing,
    /// All have it, with the numbers of their corners.
    AsCorners,
    /// [`NONE`] for those without.
    Own(Box<[[u32; 3]]>),
}

/// The indices of a face that has none.
const NONE: [u32; 3] = [u32::MAX; 3];

impl Column {
    fn new<F: Copy + Into<Face>>(faces: &[F], order: &[u32], of: impl Fn(Face) -> Option<[u32; 3]>) -> Self {
        let mut all = faces.iter().map(|&face| face.into());
        if all.clone().all(|face| of(face).is_none()) {
            Self::Nothing
        } else if all.all(|face| of(face) == Some(face.vertices)) {
            Self::AsCorners
        } else {
            Self::Own(order.iter().map(|&i| of(faces[i as usize].into()).unwrap_or(NONE)).collect())
        }
    }
}

/// The width of a seam between corners meant to be the same, relative to the mesh.
const SEAM: f64 = 1e-13;

/// How far `inside_vector` is turned where it runs along an edge, relative to its length.
const ASIDE: f64 = 1e-3;

/// Faces that are tested side by side.
const RUN: usize = 4;

impl Mesh {
    /// Faces without area are left out; normals are normalised, a zero one becomes +x.
    /// `inside` is the direction that decides what is inside; without it the mesh is a surface.
    /// `None` where a face refers to what isn't in the lists.
    pub fn new<F: Copy + Into<Face>>(mut lists: Lists, faces: &[F], inside: Option<DVec3>) -> Option<Self> {
        let within = |indices: [u32; 3], length: usize| indices.iter().all(|&i| (i as usize) < length);
        let valid = |face: &Face| {
            within(face.vertices, lists.vertices.len())
                && face.normals.is_none_or(|n| within(n, lists.normals.len()))
                && face.uvs.is_none_or(|uv| within(uv, lists.uvs.len()))
        };
        let face = |&face: &F| -> Face { face.into() };
        if !faces.iter().map(face).all(|face| valid(&face)) {
            return None;
        }
        lists.normals.iter_mut().for_each(|normal| *normal = normal.normalize_or(DVec3::X));
        // There may be millions: nothing is listed that can as well be worked out again.
        let boxes = (0..).zip(faces).filter_map(|(i, one)| {
            let corners = corners(&lists, face(one).vertices);
            let normal = face_normal(corners);
            (normal != DVec3::ZERO && normal.is_finite()).then(|| (Bounds::of(corners), i))
        });
        let (bvh, order) = Bvh::with_runs(boxes, RUN);
        let normals = Column::new(faces, &order, |face| face.normals);
        let uvs = Column::new(faces, &order, |face| face.uvs);
        let textures = Column::new(faces, &order, |face| face.textures);
        let faces = order.into_iter().map(|i| face(&faces[i as usize]).vertices).collect();
        let inside = inside.filter(|direction| *direction != DVec3::ZERO);
        Some(Self { bvh, lists, faces, normals, uvs, textures, inside, rim: OnceLock::new() })
    }

    fn rim(&self) -> &Rim {
        self.rim.get_or_init(|| Rim::new((0..self.faces.len() as u32).map(|face| self.corners(face))))
    }

    /// Calls back with every face that the ray meets in `range`, roughly the nearest first; the
    /// answer is the new end of the range, negative infinity to stop.
    #[inline(always)]
    fn meet(&self, ray: &Ray, range: Range, mut found: impl FnMut(u32, Meeting) -> f64) {
        widest(
            #[inline(always)]
            || {
                let sheared = Sheared::new(ray);
                let mut range = range;
                self.bvh.runs_along(
                    ray,
                    range,
                    #[inline(always)]
                    |run| {
                        tally::primitives(run.len());
                        let mut faces = [[DVec3::ZERO; 3]; RUN];
                        for (lane, face) in faces.iter_mut().enumerate() {
                            *face = self.corners((run.start + lane).min(run.end - 1) as u32);
                        }
                        let mut candidates = sheared.may_meet(&faces) & ((1 << run.len()) - 1);
                        while candidates != 0 {
                            let face = (run.start + candidates.trailing_zeros() as usize) as u32;
                            candidates &= candidates - 1;
                            match sheared.meet(self.corners(face)) {
                                Some(hit) if range.contains(hit.t) => range.max = found(face, hit),
                                _ => {}
                            }
                        }
                        range.max
                    },
                );
            },
        );
    }

    /// Whether a ray leaves the surface an odd number of times, and whether it comes too close to an
    /// edge to be sure.
    fn parity(&self, ray: &Ray) -> (bool, bool) {
        let sheared = Sheared::new(ray);
        let near = SEAM * self.bounds().size().max_element();
        let (mut odd, mut grazing) = (false, false);
        self.bvh.runs_along(ray, Range::AHEAD, |run| {
            for corners in run.map(|face| self.corners(face as u32)) {
                odd ^= sheared.meet(corners).is_some_and(|hit| hit.owned && hit.t > 0.0);
                grazing |= sheared.grazes(corners, near);
            }
            f64::INFINITY
        });
        (odd, grazing)
    }

    #[inline(always)]
    fn corners(&self, part: u32) -> [DVec3; 3] {
        corners(&self.lists, self.faces[part as usize])
    }

    /// What a column says of a face.
    #[inline]
    fn indices(&self, column: &Column, part: u32) -> Option<[u32; 3]> {
        match column {
            Column::Nothing => None,
            Column::AsCorners => Some(self.faces[part as usize]),
            Column::Own(indices) => Some(indices[part as usize]).filter(|indices| *indices != NONE),
        }
    }
}

#[inline(always)]
fn corners(lists: &Lists, [a, b, c]: [u32; 3]) -> [DVec3; 3] {
    let corner = |i: u32| lists.vertices[i as usize];
    [corner(a), corner(b), corner(c)]
}

impl Shape for Mesh {
    fn bounds(&self) -> Bounds {
        self.bvh.bounds()
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        let from = out.len();
        let mut edges = Vec::new();
        self.meet(ray, range, |part, hit| {
            let list = if hit.on_edge { &mut edges } else { &mut *out };
            list.push(Crossing { t: hit.t, part, at: hit.at });
            range.max
        });
        // Neighbours both report a shared edge: keep one of them.
        edges.sort_by(|a, b| a.t.total_cmp(&b.t));
        edges.dedup_by(|next, kept| (next.t - kept.t).abs() <= 16.0 * f64::EPSILON * kept.t.abs());
        out.append(&mut edges);
        out[from..].sort_by(|a, b| a.t.total_cmp(&b.t));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut best = None;
        self.meet(ray, range, |part, hit| {
            best = Some(Crossing { t: hit.t, part, at: hit.at });
            hit.t
        });
        best
    }

    fn occludes(&self, ray: &Ray, range: Range) -> bool {
        let mut hidden = false;
        self.meet(ray, range, |_, _| {
            hidden = true;
            f64::NEG_INFINITY
        });
        hidden
    }

    fn inside(&self, point: DVec3) -> bool {
        let Some(direction) = self.inside else {
            return false;
        };
        let (odd, grazing) = self.parity(&Ray::new(point, direction));
        if !grazing {
            return odd;
        }
        // Along an edge the count is as good as the corners are exact: a seam whose two sides were
        // computed apart has a gap or overlaps. A direction hardly different decides.
        let aside = direction.any_orthogonal_vector() * ASIDE;
        let around = aside.cross(direction.normalize_or_zero());
        let nearby = [aside + 0.7 * around, 0.6 * aside - around, -aside - 0.4 * around];
        let mut counts =
            nearby.map(|turn| Ray::new(point, direction + turn)).into_iter().map(|ray| self.parity(&ray));
        counts.find(|(_, grazing)| !grazing).map_or(odd, |(odd, _)| odd)
    }

    fn inside_along(&self, point: &[Band; 3]) -> Band {
        let Some(vector) = self.inside else {
            return Band::constant(0.0);
        };
        let rim = self.rim();
        let passes =
            |ray: &Ray, range: Range| self.occludes(ray, range) || rim.is_passed_behind(vector, ray, range);
        uncrossed::inside_unless(self, passes, point)
    }

    fn is_solid(&self) -> bool {
        self.inside.is_some()
    }

    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        match self.indices(&self.normals, crossing.part) {
            Some(indices) => blend(indices.map(|i| self.lists.normals[i as usize]), crossing.at),
            None => self.geometric_normal(point, crossing),
        }
    }

    fn interpolates(&self) -> bool {
        !self.lists.normals.is_empty()
    }

    /// On the side of the interpolated one, where there is one.
    fn geometric_normal(&self, _point: DVec3, crossing: &Crossing) -> DVec3 {
        let normal = face_normal(self.corners(crossing.part));
        let Some(indices) = self.indices(&self.normals, crossing.part) else {
            return normal;
        };
        let smooth = blend(indices.map(|i| self.lists.normals[i as usize]), crossing.at);
        if smooth.dot(normal) < 0.0 { -normal } else { normal }
    }

    fn uv(&self, _point: DVec3, crossing: &Crossing) -> Option<DVec2> {
        let uvs = self.indices(&self.uvs, crossing.part);
        Some(uvs.map_or(DVec2::ZERO, |uv| blend(uv.map(|i| self.lists.uvs[i as usize]), crossing.at)))
    }

    fn textures(&self, _point: DVec3, crossing: &Crossing, found: &mut dyn FnMut(u32, f64)) {
        let [v, w] = crossing.at;
        match self.indices(&self.textures, crossing.part) {
            None => {}
            Some([a, b, c]) if a == b && b == c => found(a, 1.0),
            Some(textures) => {
                for (texture, weight) in textures.into_iter().zip([1.0 - v - w, v, w]) {
                    found(texture, weight);
                }
            }
        }
    }

    fn reproject(&self, _point: DVec3, crossing: &Crossing) -> DVec3 {
        blend(self.corners(crossing.part), crossing.at)
    }
}

#[cfg(test)]
mod tests;
