//! Compiles normals.

use std::sync::Arc;

use super::Unsupported;
use super::texture::TextureCompiler;
use crate::scene::texture::NormalKind as Kind;
use crate::scene::{self, Pattern};
use crate::world::texture::{Normal, NormalKind};

impl TextureCompiler<'_> {
    /// A normal in the space it was written in.
    ///
    /// # Errors
    /// What it uses that povista lacks, or a file that can't be read.
    pub fn normal(&mut self, normal: &Arc<scene::Normal>) -> Result<Arc<Normal>, Unsupported> {
        if let Some((_, compiled)) = self.normals.get(&Arc::as_ptr(normal)) {
            return Ok(compiled.clone());
        }
        let compiled = Arc::new(Normal {
            kind: self.normal_kind(&normal.kind)?,
            amount: f64::from(normal.amount),
            accuracy: f64::from(normal.accuracy),
            no_bump_scale: normal.no_bump_scale,
        });
        self.normals.insert(Arc::as_ptr(normal), (normal.clone(), compiled.clone()));
        Ok(compiled)
    }

    fn normal_kind(&mut self, kind: &Kind) -> Result<NormalKind, Unsupported> {
        Ok(match kind {
            Kind::Pattern { field, slopes } => match slopes {
                Some(map) if !field.pattern.bends_itself() => {
                    NormalKind::Slopes(self.pattern(field)?, self.map(field, map, |_, slope| Ok(*slope))?)
                }
                _ => NormalKind::Pattern(self.pattern(field)?),
            },
            Kind::Normals { field, map } => {
                let map =
                    self.map(field, map, |this, normal| this.nested(field.span, |this| this.normal(normal)))?;
                match *field.pattern {
                    Pattern::Average => NormalKind::Average(self.warps(field), map),
                    _ => NormalKind::Normals(self.pattern(field)?, map),
                }
            }
            Kind::Bumps { field, map } => {
                NormalKind::Bumps(self.warps(field), Box::new(self.image_map(map, false)?))
            }
            Kind::UvMapped(normal) => {
                self.uses_uv = true;
                NormalKind::UvMapped(self.normal(normal)?)
            }
        })
    }
}
