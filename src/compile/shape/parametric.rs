//! The functions and container of a `parametric` surface (docs/spec/primitives.md 4.6).

use std::sync::Arc;

use super::Compiled;
use super::isosurface::container;
use crate::compile::Unsupported;
use crate::compile::texture::TextureCompiler;
use crate::scene::shape as scene;
use crate::world::sample::Field;
use crate::world::shape::parametric::{Description, Parametric};

/// Compiles a parametric surface. `precompute` needs no heed: what it asks for is always done.
///
/// # Errors
/// A function that uses what povista lacks.
pub fn parametric(
    surface: &scene::Parametric,
    functions: &mut TextureCompiler,
) -> Result<Compiled, Unsupported> {
    let positive = |value: f64, default: f64| if value > 0.0 { value } else { default };
    let mut function = |at: usize| -> Result<Arc<dyn Field>, Unsupported> {
        functions.function(&surface.functions[at]).map(|function| function as Arc<dyn Field>)
    };
    Ok(Compiled::rare(Parametric::new(Description {
        functions: [function(0)?, function(1)?, function(2)?],
        from: surface.from,
        to: surface.to,
        container: container(&surface.container),
        accuracy: positive(surface.accuracy, 0.001),
        max_gradient: positive(surface.max_gradient, 1.0),
    })))
}
