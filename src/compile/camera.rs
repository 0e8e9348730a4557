//! Compiles the camera.

use super::Unsupported;
use crate::scene;
use crate::world::Camera;
use crate::world::camera::{
    Cylinder, Fisheye, Frame, Omnimax, Orthographic, Panoramic, Perspective, Projection, Spherical,
    UltraWideAngle,
};

/// Field of view in degrees of the wide-angle cameras that were given none.
const ANGLE: f64 = 90.0;

/// The camera of a world.
///
/// # Errors
/// `mesh_camera`, focal blur and a camera `normal` are not supported yet.
pub fn camera(camera: &scene::Camera) -> Result<Camera, Unsupported> {
    let lacking = |feature: &str| Err(Unsupported::new(camera.span, feature));
    if camera.blur.is_some() {
        return lacking("focal blur");
    }
    if camera.normal.is_some() {
        return lacking("a camera's `normal`");
    }
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
        scene::camera::Projection::Mesh(_) => return lacking("`mesh_camera`"),
    };
    Ok(Camera { projection })
}
