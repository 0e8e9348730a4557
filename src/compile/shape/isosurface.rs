//! The function and container of an `isosurface` (docs/spec/primitives.md 5.2).

use super::Compiled;
use crate::compile::Unsupported;
use crate::compile::texture::TextureCompiler;
use crate::scene::shape as scene;
use crate::world::shape::r#box::Cuboid;
use crate::world::shape::isosurface::{Container, Isosurface, Steepest};
use crate::world::shape::sphere::Sphere;

/// The most crossings that `max_trace` and `all_intersections` stand for.
const MOST: u32 = 10;

/// Compiles an isosurface. Only where it is part of a solid, whose points inside are `asked` for, `max_trace` counts:
/// elsewhere POV-Ray asks again for what is behind a crossing, as often as a ray goes on.
///
/// # Errors
/// A function that uses what povista lacks.
pub fn isosurface(
    surface: &scene::Isosurface,
    asked: bool,
    functions: &mut TextureCompiler,
) -> Result<Compiled, Unsupported> {
    let positive = |value: f64, default: f64| if value > 0.0 { value } else { default };
    Ok(Compiled::rare(Some(Isosurface {
        function: functions.function(&surface.function)?,
        threshold: surface.threshold,
        container: container(&surface.container),
        accuracy: positive(surface.accuracy, 0.001),
        max_gradient: positive(surface.max_gradient, 1.1),
        adaptive: surface.evaluate.map(|[_, share, _]| share.max(1.0)),
        most: if asked { surface.max_trace.unwrap_or(MOST).clamp(1, MOST) as usize } else { usize::MAX },
        open: surface.open,
        steepest: Steepest::default(),
    })))
}

/// Where a surface is looked for.
pub(super) fn container(container: &scene::Container) -> Container {
    match *container {
        scene::Container::Box { min, max } => Container::Box(Cuboid { min, max }),
        scene::Container::Sphere { center, radius } => Container::Sphere(Sphere { center, radius }),
    }
}
