//! The camera.

use super::block::Block;
use super::texture;
use super::value::{number, switch, vec3};
use crate::scene::Camera;
use crate::scene::camera::Projection;

pub(super) fn dump(camera: &Camera) -> Block {
    let mut block = Block::new("camera");
    block = match &camera.projection {
        Projection::Perspective => block.line("perspective"),
        Projection::Orthographic => block.line("orthographic"),
        Projection::Fisheye => block.line("fisheye"),
        Projection::UltraWideAngle => block.line("ultra_wide_angle"),
        Projection::Omnimax => block.line("omnimax"),
        Projection::Panoramic => block.line("panoramic"),
        Projection::Spherical { horizontal, vertical } => {
            block.line(format!("spherical angle {}, {}", number(*horizontal), number(*vertical)))
        }
        Projection::Cylinder(kind) => block.field("cylinder", kind),
        Projection::Mesh(mesh) => block.block(
            Block::new("mesh_camera")
                .field("rays", mesh.rays_per_pixel)
                .field("distribution", mesh.distribution)
                .field("max_distance", number(mesh.max_distance))
                .field("meshes", mesh.meshes.len())
                .field("smooth", switch(mesh.smooth)),
        ),
    };
    block = block
        .field("location", vec3(camera.location))
        .field("direction", vec3(camera.direction))
        .field("up", vec3(camera.up))
        .field("right", vec3(camera.right))
        .optional("angle", camera.angle.map(number))
        .field("focal_distance", number(camera.focal_distance));
    if let Some(blur) = &camera.blur {
        block = block
            .field("aperture", number(blur.aperture))
            .line(format!("blur_samples {}, {}", blur.min_samples, blur.max_samples))
            .field("confidence", number(blur.confidence))
            .field("variance", number(blur.variance))
            .blocks(
                blur.bokeh
                    .as_deref()
                    .map(|bokeh| Block::new("bokeh").block(texture::pigment("pigment", bokeh))),
            );
    }
    block.blocks(camera.normal.as_deref().map(texture::normal))
}
