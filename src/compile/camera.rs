//! Compiles the camera.

use std::collections::HashMap;
use std::sync::Arc;

use super::Unsupported;
use super::texture::TextureCompiler;
use crate::math::{DVec3, Transform};
use crate::scene;
use crate::scene::shape::{Face, Mesh};
use crate::world::Camera;
use crate::world::Ray;
use crate::world::camera::focal_blur::Lens;
use crate::world::camera::mesh_camera::{Distribution, Map, Mount, Mounted, UvFace, middle, normal};
use crate::world::camera::{
    Cylinder, Fisheye, FocalBlur, Frame, MeshCamera, Omnimax, Orthographic, Panoramic, Perspective,
    Projection, Spherical, UltraWideAngle,
};

/// Field of view in degrees of the wide-angle cameras that were given none.
const ANGLE: f64 = 90.0;

/// The camera of a world. What can't be compiled goes to `lacking`.
pub fn camera(
    camera: &scene::Camera,
    textures: &mut TextureCompiler,
    lacking: &mut Vec<Unsupported>,
) -> Camera {
    let frame =
        Frame { location: camera.location, right: camera.right, up: camera.up, direction: camera.direction };
    let angle = camera.angle.unwrap_or(ANGLE);
    let projection = match &camera.projection {
        scene::camera::Projection::Perspective => Projection::Perspective(Perspective { frame }),
        scene::camera::Projection::Orthographic => Projection::Orthographic(Orthographic { frame }),
        scene::camera::Projection::Fisheye => Projection::Fisheye(Fisheye::new(&frame, angle)),
        scene::camera::Projection::UltraWideAngle => {
            Projection::UltraWideAngle(UltraWideAngle::new(&frame, angle))
        }
        scene::camera::Projection::Omnimax => Projection::Omnimax(Omnimax::new(&frame)),
        scene::camera::Projection::Panoramic => Projection::Panoramic(Panoramic { frame }),
        &scene::camera::Projection::Spherical { horizontal, vertical } => {
            Projection::Spherical(Spherical::new(&frame, horizontal, vertical))
        }
        &scene::camera::Projection::Cylinder(kind) => {
            Projection::Cylinder(Cylinder::new(&frame, kind, angle))
        }
        scene::camera::Projection::Mesh(_) => Projection::Perspective(Perspective { frame }),
    };
    let mesh = match &camera.projection {
        scene::camera::Projection::Mesh(mesh) => Some(mesh_camera(mesh, camera)),
        _ => None,
    };
    let normal = camera
        .normal
        .as_ref()
        .and_then(|normal| textures.normal(normal).map_err(|unsupported| lacking.push(unsupported)).ok());
    let blur = camera.blur.as_ref().map(|written| blur(written, camera, &frame, textures, lacking));
    Camera { projection, blur, mesh, normal }
}

fn blur(
    blur: &scene::camera::FocalBlur,
    camera: &scene::Camera,
    frame: &Frame,
    textures: &mut TextureCompiler,
    lacking: &mut Vec<Unsupported>,
) -> FocalBlur {
    let bokeh = blur.bokeh.as_ref();
    let bokeh =
        bokeh.and_then(|bokeh| textures.pigment(bokeh).map_err(|unsupported| lacking.push(unsupported)).ok());
    let lens = Lens {
        aperture: blur.aperture,
        distance: camera.focal_distance,
        samples: [blur.min_samples, blur.max_samples.max(1)],
        confidence: blur.confidence,
        variance: blur.variance,
    };
    FocalBlur::new(frame, &lens, bokeh.as_deref())
}

/// Distances nearer to zero than this are none.
const UNLIMITED: f64 = 1e-10;

fn mesh_camera(written: &scene::camera::MeshCamera, camera: &scene::Camera) -> MeshCamera {
    let mount = |transform: &Option<Arc<Transform>>| Mount {
        transform: transform.as_deref().copied().unwrap_or_default(),
        offset: camera.location.z,
        reversed: camera.direction.z < -UNLIMITED,
    };
    // A mesh that is written once may be in many places.
    let mut known = HashMap::new();
    let mut mounted = |(mesh, transform): &(Arc<Mesh>, Option<Arc<Transform>>)| {
        let middles = || mesh.faces.iter().map(|face| middle(corners(mesh, face))).collect();
        let faces: &Arc<[Ray]> = known.entry(Arc::as_ptr(mesh)).or_insert_with(middles);
        Mounted { faces: faces.clone(), mount: mount(transform) }
    };
    let meshes = &written.meshes;
    let distribution = match (written.distribution, meshes.first()) {
        (0, _) | (_, None) => Distribution::Each(meshes.iter().map(&mut mounted).collect()),
        (1, _) => Distribution::All(meshes.iter().map(&mut mounted).collect()),
        (2, _) => Distribution::Columns(meshes.iter().map(&mut mounted).collect()),
        (_, Some((mesh, transform))) => {
            let faces = mesh.faces.iter().filter_map(|face| uv_face(mesh, face, written.smooth));
            Distribution::Map(Box::new(Map::new(faces.collect(), mount(transform))))
        }
    };
    MeshCamera {
        rays: written.rays_per_pixel,
        reach: if written.max_distance < UNLIMITED { f64::INFINITY } else { written.max_distance },
        distribution,
    }
}

fn corners(mesh: &Mesh, face: &Face) -> [DVec3; 3] {
    face.vertices.map(|number| mesh.vertices[number as usize])
}

/// A face on the uv square; `None` for those without texture coordinates.
fn uv_face(mesh: &Mesh, face: &Face, smooth: bool) -> Option<UvFace> {
    let uvs = face.uvs?.map(|number| mesh.uvs[number as usize]);
    let corners = corners(mesh, face);
    let normals = match face.normals {
        Some(normals) if smooth => normals.map(|number| mesh.normals[number as usize].normalize_or_zero()),
        _ => [normal(corners); 3],
    };
    Some(UvFace { uvs, corners, normals })
}
