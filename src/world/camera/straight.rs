//! Projections whose rays through places near each other may travel together.

use super::{Film, Orthographic, Perspective};
use crate::math::{Bounds, Lanes};
use crate::world::Rays;
use crate::world::accel::Pencil;

/// Such a projection.
#[derive(Clone, Copy, Debug)]
#[expect(missing_docs, reason = "named and described by the files")]
pub enum Straight<'a> {
    Perspective(&'a Perspective),
    Orthographic(&'a Orthographic),
}

impl Straight<'_> {
    /// All rays through places on the film that are between four.
    pub fn pencil(self, corners: [Film; 4]) -> Option<Pencil> {
        match self {
            Self::Perspective(perspective) => {
                let eye = perspective.frame.location;
                let through = corners.map(|corner| eye + perspective.direction(corner));
                Pencil::new(Bounds::of([eye]), Bounds::of(through))
            }
            Self::Orthographic(orthographic) => {
                let direction = orthographic.direction();
                Pencil::along(
                    Bounds::of(corners.map(|corner| orthographic.origin(corner))),
                    Bounds { min: direction, max: direction },
                )
            }
        }
    }

    /// The unit rays through four places on the film.
    #[inline(always)]
    pub fn rays(self, [x, y]: [Lanes; 2]) -> Rays {
        match self {
            Self::Perspective(perspective) => {
                let origin = perspective.frame.location.to_array().map(Lanes::splat);
                let mut rays = Rays { origin, direction: perspective.directions(x, y) };
                rays.normalize();
                rays
            }
            Self::Orthographic(orthographic) => {
                let direction = orthographic.direction().to_array().map(Lanes::splat);
                Rays { origin: orthographic.origins(x, y), direction }
            }
        }
    }
}
