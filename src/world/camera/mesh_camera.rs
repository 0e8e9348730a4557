//! `mesh_camera`: rays start on the faces of meshes, along their normals
//! (docs/spec/camera-image.md 5).

use std::sync::Arc;

use crate::math::{Bounds, DVec2, DVec3, Transform};
use crate::world::Ray;

/// Cells along an edge of the uv square; a face is looked for in the cell of its place only.
const CELLS: usize = 10;

/// A camera of faces.
#[derive(Clone, Debug)]
pub struct MeshCamera {
    /// Rays that were asked for at each pixel; most distributions have one face for it and so one ray.
    pub rays: u32,
    /// Nothing at or beyond this distance is seen; infinite where none was given.
    pub reach: f64,
    /// Which face serves which pixel.
    pub distribution: Distribution,
}

/// How pixels choose faces.
#[derive(Clone, Debug)]
pub enum Distribution {
    /// 0: ray `n` comes from mesh `n`.
    Each(Vec<Mounted>),
    /// 1: all meshes one after the other.
    All(Vec<Mounted>),
    /// 2: meshes share the picture's columns.
    Columns(Vec<Mounted>),
    /// 3: the face that lies there on the uv square.
    Map(Box<Map>),
}

/// A place in a picture and the picture's size.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Image coordinates; whole numbers are the middles of pixels.
    pub at: DVec2,
    /// Width and height.
    pub size: [u32; 2],
}

impl Place {
    /// Column and row, which lag half a pixel behind: the first two rows are the same.
    fn clamped(self) -> DVec2 {
        let [width, height] = self.size.map(f64::from);
        let (x, y) = ((self.at.x + 0.5).min(width - 1.0), (self.at.y - 0.5).min(height - 1.0));
        DVec2::new(x.max(0.0), y.max(0.0))
    }

    /// Number of the pixel in reading order.
    fn number(self) -> usize {
        let place = self.clamped();
        place.y as usize * self.size[0] as usize + place.x as usize
    }
}

impl MeshCamera {
    /// No place in the picture has more rays.
    pub fn most(&self) -> usize {
        match &self.distribution {
            Distribution::Each(meshes) => meshes.len().min(self.rays as usize),
            _ => 1,
        }
    }

    /// Adds the rays of a place in the picture, in their order; their directions are unit.
    pub fn rays(&self, place: Place, rays: &mut Vec<Ray>) {
        match &self.distribution {
            Distribution::Each(meshes) => {
                let number = place.number();
                for mesh in meshes.iter().take(self.rays as usize) {
                    if let Some(ray) = mesh.ray(number) {
                        rays.push(ray);
                    }
                }
            }
            // Further rays lie beyond all faces.
            Distribution::All(meshes) => {
                let mut number = place.number();
                let mesh = meshes.iter().find(|mesh| {
                    let is_there = number < mesh.faces.len();
                    number -= if is_there { 0 } else { mesh.faces.len() };
                    is_there
                });
                rays.extend(mesh.and_then(|mesh| mesh.ray(number)));
            }
            Distribution::Columns(meshes) => {
                let column = place.clamped();
                let wide = f64::from(place.size[0]) / meshes.len() as f64;
                let face = column.y as usize * wide as usize + column.x as usize;
                rays.extend(meshes.get((column.x / wide) as usize).and_then(|mesh| mesh.ray(face)));
            }
            Distribution::Map(map) => rays.extend(map.ray(place)),
        }
    }

    /// A box around all places where rays start.
    pub fn starts(&self) -> Bounds {
        let meshes = match &self.distribution {
            Distribution::Each(meshes) | Distribution::All(meshes) | Distribution::Columns(meshes) => meshes,
            Distribution::Map(map) => {
                let corners = map.faces.iter().flat_map(|face| face.corners);
                return map.mount.starts(Bounds::of(corners));
            }
        };
        let (mut all, mut last) = (Bounds::EMPTY, None);
        for mesh in meshes {
            let faces = match last {
                // Mostly the same mesh in many places.
                Some((faces, bounds)) if Arc::ptr_eq(faces, &mesh.faces) => bounds,
                _ => Bounds::of(mesh.faces.iter().map(|face| face.origin)),
            };
            last = Some((&mesh.faces, faces));
            all = all.union(mesh.mount.starts(faces));
        }
        all
    }
}

/// Where rays start on a mesh and where they go.
#[derive(Clone, Debug)]
pub struct Mount {
    /// From the mesh to the world.
    pub transform: Transform,
    /// How far along the normal they start.
    pub offset: f64,
    /// Whether they go against the normal.
    pub reversed: bool,
}

impl Mount {
    /// The ray of a point of the mesh and a unit normal there.
    #[inline]
    pub fn ray(&self, point: DVec3, normal: DVec3) -> Ray {
        let direction = if self.reversed { -normal } else { normal };
        Ray::new(
            self.transform.point(point + self.offset * normal),
            self.transform.normal(direction).normalize_or_zero(),
        )
    }

    /// A box around where rays start whose points of the mesh are in another.
    fn starts(&self, points: Bounds) -> Bounds {
        // Rounding makes no more of a unit normal.
        let room = DVec3::splat(self.offset.abs() * 1.001);
        Bounds { min: points.min - room, max: points.max + room }.transformed(&self.transform)
    }
}

/// A mesh in its place.
#[derive(Clone, Debug)]
pub struct Mounted {
    /// The middles of its faces and their unit normals, as the mesh was written; shared, for a camera may have the same
    /// mesh in a hundred places.
    pub faces: Arc<[Ray]>,
    /// Where it is.
    pub mount: Mount,
}

impl Mounted {
    /// The ray of a face.
    #[inline]
    fn ray(&self, face: usize) -> Option<Ray> {
        self.faces.get(face).map(|face| self.mount.ray(face.origin, face.direction))
    }
}

/// The middle of a face and its unit normal.
pub fn middle(corners: [DVec3; 3]) -> Ray {
    Ray::new((corners[0] + corners[1] + corners[2]) / 3.0, normal(corners))
}

/// The normal of a face by its corners; zero where they are in line.
pub fn normal(corners: [DVec3; 3]) -> DVec3 {
    (corners[2] - corners[0]).cross(corners[1] - corners[0]).normalize_or_zero()
}

/// A face on the uv square.
#[derive(Clone, Copy, Debug)]
pub struct UvFace {
    /// Its corners there.
    pub uvs: [DVec2; 3],
    /// Its corners.
    pub corners: [DVec3; 3],
    /// Unit normals at the corners.
    pub normals: [DVec3; 3],
}

/// Faces by their places on the uv square.
#[derive(Clone, Debug)]
pub struct Map {
    faces: Vec<UvFace>,
    /// For each cell the faces that may be there, by number.
    cells: Vec<Vec<u32>>,
    mount: Mount,
}

impl Map {
    /// The faces of a mesh.
    pub fn new(faces: Vec<UvFace>, mount: Mount) -> Self {
        let mut cells = vec![Vec::new(); CELLS * CELLS];
        for (face, number) in faces.iter().zip(0..) {
            let low = face.uvs.into_iter().reduce(DVec2::min).unwrap_or_default();
            let high = face.uvs.into_iter().reduce(DVec2::max).unwrap_or_default();
            for v in cell(low.y)..=cell(high.y) {
                for u in cell(low.x)..=cell(high.x) {
                    cells[v * CELLS + u].push(number);
                }
            }
        }
        Self { faces, cells, mount }
    }

    fn ray(&self, place: Place) -> Option<Ray> {
        let [width, height] = place.size.map(f64::from);
        let at = place.clamped();
        let uv = DVec2::new((at.x - 0.5) / width, 1.0 - (at.y + 0.5) / height);
        let faces = &self.cells[cell(uv.y) * CELLS + cell(uv.x)];
        let (face, shares) = faces.iter().find_map(|&number| {
            let face = &self.faces[number as usize];
            Some((face, shares(face.uvs, uv)?))
        })?;
        let mix = |corners: [DVec3; 3]| corners.into_iter().zip(shares).map(|(c, share)| share * c).sum();
        let normal: DVec3 = mix(face.normals);
        Some(self.mount.ray(mix(face.corners), normal.normalize_or_zero()))
    }
}

fn cell(coordinate: f64) -> usize {
    ((coordinate * CELLS as f64) as usize).min(CELLS - 1)
}

/// The barycentric coordinates of a place in a triangle, which may lie on its edge.
fn shares(corners: [DVec2; 3], place: DVec2) -> Option<[f64; 3]> {
    let (first, second) = (corners[1] - corners[0], corners[2] - corners[0]);
    let whole = first.perp_dot(second);
    let from = place - corners[0];
    let (b, c) = (from.perp_dot(second) / whole, first.perp_dot(from) / whole);
    let a = 1.0 - b - c;
    (a >= 0.0 && b >= 0.0 && c >= 0.0).then_some([a, b, c])
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOUNT: Mount = Mount { transform: Transform::IDENTITY, offset: 0.25, reversed: false };

    fn place(x: u32, y: u32) -> Place {
        Place { at: DVec2::new(f64::from(x), f64::from(y)), size: [3, 3] }
    }

    /// Rendered by POV-Ray, 3x3, before a sky that shows directions.
    #[test]
    fn faces_serve_pixels_in_reading_order_from_the_second_row_on() {
        let o = DVec3::ZERO;
        let corners = [
            [o, DVec3::X, DVec3::new(0.0, 1.0, 0.3)],
            [o, DVec3::new(0.0, 1.0, 0.3), DVec3::X],
            [o, DVec3::Z, DVec3::X],
            [o, DVec3::X, DVec3::Y],
        ];
        let faces = vec![Mounted { faces: corners.map(middle).into(), mount: MOUNT }];
        let camera = MeshCamera { rays: 1, reach: f64::INFINITY, distribution: Distribution::Each(faces) };
        let direction = |x, y| {
            let mut rays = Vec::new();
            camera.rays(place(x, y), &mut rays);
            rays.first().map(|ray| ray.direction)
        };
        for y in [0, 1] {
            assert!(direction(0, y).unwrap().abs_diff_eq(DVec3::new(0.0, 0.2874, -0.9578), 1e-4));
            assert!(direction(1, y).unwrap().abs_diff_eq(DVec3::new(0.0, -0.2874, 0.9578), 1e-4));
        }
        assert_eq!(direction(0, 2), Some(-DVec3::Z));
        assert_eq!(direction(1, 2), None);
    }

    #[test]
    fn smooth_maps_interpolate_unit_normals() {
        let at = |x: f64, y: f64| DVec3::new(4.0 * x, 4.0 * y, 0.0);
        let tilted = DVec3::new(0.0, 0.3, -1.0).normalize();
        let face = UvFace {
            uvs: [DVec2::ZERO, DVec2::X, DVec2::Y],
            corners: [at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0)],
            normals: [-DVec3::Z, DVec3::new(-0.3, 0.0, -1.0).normalize(), tilted],
        };
        let map = Map::new(vec![face], MOUNT);
        let ray = map.ray(place(0, 0)).unwrap();
        assert!(ray.direction.abs_diff_eq(DVec3::new(0.0, 0.2408, -0.9706), 1e-4), "{ray:?}");
        let start = at(0.0, 5.0 / 6.0) + 0.25 * ray.direction;
        assert!(ray.origin.abs_diff_eq(start, 1e-9), "{ray:?}");
        assert_eq!(map.ray(place(2, 0)), None);
    }
}
