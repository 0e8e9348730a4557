//! What a scene really uses. Compounds hand textures and interiors down to members that have their
//! own; what no leaf refers to is never compiled, so that no image is decoded for nothing and
//! nothing unused is called unsupported.

use std::sync::Arc;

use super::flatten::Flat;
use super::texture::TextureCompiler;
use crate::world::object::{LeafFlags, Numbered};
use crate::world::{Interior, Needs};

/// Which of a list are in use, and their numbers after the others are left out.
#[derive(Debug)]
pub(super) struct Used {
    numbers: Vec<Numbered>,
}

impl Used {
    fn new(all: usize, used: impl Iterator<Item = u32>) -> Self {
        let mut numbers = vec![Numbered::NONE; all];
        for number in used {
            if let Some(number) = numbers.get_mut(number as usize) {
                *number = Some(0).into();
            }
        }
        let wanted = numbers.iter_mut().filter(|number| **number != Numbered::NONE);
        wanted.zip(0..).for_each(|(number, next)| *number = Some(next).into());
        Self { numbers }
    }

    /// What is made of those of the whole list that are in use, in no more room than that takes.
    pub(super) fn made_into<T, U>(&self, all: Vec<T>, mut make: impl FnMut(T) -> Option<U>) -> Vec<U> {
        let is_used = |number: &&Numbered| **number != Numbered::NONE;
        let mut made = Vec::with_capacity(self.numbers.iter().filter(is_used).count());
        let used = all.into_iter().zip(&self.numbers).filter(|(_, number)| is_used(number));
        made.extend(used.filter_map(|(item, _)| make(item)));
        made
    }

    /// The new number of one in use.
    pub(super) fn renumbered(&self, number: u32) -> u32 {
        self.numbers.get(number as usize).and_then(|number| number.get()).unwrap_or_default()
    }
}

/// The textures that leaves refer to.
pub(super) fn textures(flat: &Flat) -> Used {
    let used = flat
        .parts
        .leaves
        .iter()
        .flat_map(|leaf| leaf.own_textures().chain(leaf.texture.get()).chain(leaf.interior_texture()));
    Used::new(flat.textures.len(), used)
}

/// The interiors that leaves or objects refer to.
pub(super) fn interiors(flat: &Flat) -> Used {
    let leaves = flat.parts.leaves.iter().map(|leaf| leaf.interior);
    let objects = flat.parts.objects.iter().map(|object| object.interior);
    Used::new(flat.interiors.len(), leaves.chain(objects))
}

/// What compiled surfaces ask for.
pub(super) fn needs(flat: &Flat, textures: &TextureCompiler, interiors: &[Arc<Interior>]) -> Needs {
    let mapped = flat.parts.leaves.iter().any(|leaf| leaf.flags.contains(LeafFlags::UV_MAPPING));
    Needs {
        uv: mapped || textures.uses_uv(),
        normals: textures.uses_normals,
        images: textures.images.iter().map(|images| images.len() as u64).sum(),
        grain: textures.uses_grain,
        media: interiors.iter().any(|interior| !interior.media.is_empty()),
    }
}
