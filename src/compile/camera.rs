//! Compiles the camera.

use super::Unsupported;
use super::texture::TextureCompiler;
use crate::scene;
use crate::world::Camera;
use crate::world::camera::focal_blur::Lens;
use crate::world::camera::{
    Cylinder, Fisheye, FocalBlur, Frame, Omnimax, Orthographic, Panoramic, Perspective, Projection,
    Spherical, UltraWideAngle,
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
        scene::camera::Projection::Mesh(_) => {
            lacking.push(Unsupported::new(camera.span, "`mesh_camera`"));
            Projection::Perspective(Perspective { frame })
        }
    };
    let normal = camera
        .normal
        .as_ref()
        .and_then(|normal| textures.normal(normal).map_err(|unsupported| lacking.push(unsupported)).ok());
    let blur = camera.blur.as_ref().map(|written| blur(written, camera, &frame, lacking));
    Camera { projection, blur, normal }
}

fn blur(
    blur: &scene::camera::FocalBlur,
    camera: &scene::Camera,
    frame: &Frame,
    lacking: &mut Vec<Unsupported>,
) -> FocalBlur {
    if blur.bokeh.is_some() {
        lacking.push(Unsupported::new(camera.span, "`bokeh`"));
    }
    let lens = Lens {
        aperture: blur.aperture,
        distance: camera.focal_distance,
        samples: [blur.min_samples, blur.max_samples.max(1)],
        confidence: blur.confidence,
        variance: blur.variance,
    };
    FocalBlur::new(frame, &lens)
}
