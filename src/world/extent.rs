//! Where things are in space, inverted ones too.

use crate::math::Bounds;

/// The part of space where a member is interesting: all its surface is in the box, and outside
/// of it everything is inside, or everything outside, the member.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// The box.
    pub bounds: Bounds,
    /// Whether points beyond the box are inside the member.
    pub beyond: bool,
}

impl Extent {
    /// Of the part common to all.
    pub fn intersection(parts: impl Iterator<Item = Self> + Clone) -> Self {
        // Outside of the box of any part with nothing beyond, nothing is common.
        let limiting = parts.clone().filter(|part| !part.beyond);
        if limiting.clone().next().is_some() {
            let bounds = limiting.fold(Bounds::ALL, |all, part| all.intersection(part.bounds));
            Self { bounds, beyond: false }
        } else {
            Self { bounds: around(parts), beyond: true }
        }
    }

    /// Of everything that is in any.
    pub fn union(parts: impl Iterator<Item = Self> + Clone) -> Self {
        Self { beyond: parts.clone().any(|part| part.beyond), bounds: around(parts) }
    }
}

fn around(parts: impl Iterator<Item = Extent>) -> Bounds {
    parts.fold(Bounds::EMPTY, |all, part| all.union(part.bounds))
}
