//! Functions at four points at once.

use super::{Body, Budget, Function};
use crate::math::color::{GREY, grey_of};
use crate::math::wide::widest;
use crate::math::{Lanes, tally};
use crate::world::sample::{Samples, one_by_one};

impl Function {
    /// The components of the values at four points, and how many there are: the same bits as
    /// [`Function::call_vector`] gives for each.
    pub fn four_vectors(&self, point: &[Lanes; 3]) -> ([Lanes; 5], usize) {
        let mut components = [Lanes::ZERO; 5];
        let size = match &self.body {
            Body::Pigment(pigment) => {
                let colors = pigment.four_colors(&Samples::at(point)).components;
                for (component, color) in components.iter_mut().zip(&colors) {
                    *component = widened(*color);
                }
                5
            }
            Body::Transform(_) | Body::Spline(_) => {
                let mut size = 0;
                for lane in 0..Lanes::COUNT {
                    let [x, y, z] = point;
                    let mut one = [0.0; 5];
                    size = self.call_vector(&[x.0[lane], y.0[lane], z.0[lane]], &mut one);
                    for (component, one) in components.iter_mut().zip(one) {
                        component.0[lane] = one;
                    }
                }
                size
            }
            Body::Tape(_) | Body::Internal(_) | Body::Pattern(_) => {
                components[0] = self.four_values(point);
                1
            }
        };
        (components, size)
    }

    /// The values at four points, the same bits as one by one.
    pub(super) fn four_values(&self, point: &[Lanes; 3]) -> Lanes {
        let at_once = match &self.body {
            Body::Tape(_) if self.exact => self.four_of_tape(point),
            _ => self.four_of_points(point, 0),
        };
        let [x, y, z] = point;
        at_once.unwrap_or_else(|| one_by_one(|lane| self.call(&[x.0[lane], y.0[lane], z.0[lane]])))
    }

    /// The values of a tape at four points, sines and cosines nearly; `None` where there is no tape or where they
    /// take ways that are too different.
    pub(super) fn four_of_tape(&self, point: &[Lanes; 3]) -> Option<Lanes> {
        let Body::Tape(tape) = &self.body else { return None };
        let found = widest(
            #[inline(always)]
            || tape.run_four(point, &Budget::default()),
        );
        found.inspect(|_| tally::functions(Lanes::COUNT))
    }

    /// A component (or the [`GREY`]) of what a pattern or a pigment gives at four points; `None` of other functions.
    pub(super) fn four_of_points(&self, arguments: &[Lanes], component: u8) -> Option<Lanes> {
        let point: &[Lanes; 3] = arguments.first_chunk()?;
        match &self.body {
            Body::Pattern(pattern) if component == 0 => Some(pattern.four(&Samples::at(point))),
            Body::Pigment(pigment) => {
                let colors = pigment.four_colors(&Samples::at(point));
                let part =
                    |place: usize| colors.components.get(place).map_or(Lanes::ZERO, |part| widened(*part));
                if component == GREY {
                    let [r, g, b] = [part(0), part(1), part(2)];
                    return Some(one_by_one(|lane| grey_of([r.0[lane], g.0[lane], b.0[lane]])));
                }
                Some(part(component.into()))
            }
            _ => None,
        }
    }
}

fn widened([a, b, c, d]: [f32; Lanes::COUNT]) -> Lanes {
    Lanes([a.into(), b.into(), c.into(), d.into()])
}
