//! Compiles pigments and densities.

use std::sync::Arc;

use super::Unsupported;
use super::texture::TextureCompiler;
use crate::scene::pigment::PigmentKind;
use crate::scene::{self, Pattern};
use crate::world::texture::Pigment;

impl TextureCompiler<'_> {
    /// A pigment or a density in the space it was written in.
    ///
    /// # Errors
    /// What it uses that povista lacks, or a file that can't be read.
    pub fn pigment(&mut self, pigment: &Arc<scene::Pigment>) -> Result<Arc<Pigment>, Unsupported> {
        if let Some((_, compiled)) = self.pigments.get(&Arc::as_ptr(pigment)) {
            return Ok(compiled.clone());
        }
        let compiled = Arc::new(self.new_pigment(pigment)?);
        if Arc::strong_count(pigment) > 1 {
            self.pigments.insert(Arc::as_ptr(pigment), (pigment.clone(), compiled.clone()));
        }
        Ok(compiled)
    }

    fn new_pigment(&mut self, pigment: &scene::Pigment) -> Result<Pigment, Unsupported> {
        if let Some(color) = self.quick_color(pigment) {
            return Ok(Pigment::Color(color));
        }
        Ok(match &pigment.kind {
            PigmentKind::Color(color) => Pigment::Color(*color),
            PigmentKind::Colors { field, map } => {
                let own;
                let map = match map {
                    Some(map) => &**map,
                    None => {
                        own = field.pattern.default_colors();
                        &own
                    }
                };
                Pigment::Colors(Box::new(self.pattern(field)?), self.map(field, map, |_, color| Ok(*color))?)
            }
            PigmentKind::Pigments { field, map } => {
                let map = self
                    .map(field, map, |this, pigment| this.nested(field.span, |this| this.pigment(pigment)))?;
                match *field.pattern {
                    Pattern::Average => Pigment::Average(self.warps(field), map),
                    _ => Pigment::Pigments(Box::new(self.pattern(field)?), map),
                }
            }
            PigmentKind::Image { field, map } => {
                Pigment::Image(self.warps(field), Box::new(self.image_map(map, true)?))
            }
            PigmentKind::UvMapped(pigment) => {
                self.uses_uv = true;
                Pigment::UvMapped(self.pigment(pigment)?)
            }
        })
    }
}
