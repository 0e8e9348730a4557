//! User functions, compiled (docs/spec/language.md 4). Nothing is allocated when one is called.

mod budget;
mod four;
pub mod internal;
mod number;
pub mod tape;

use std::sync::Arc;

use smallvec::SmallVec;

use super::sample::{Colors, Field, Sample, Samples};
use crate::math::color::{GREY, grey_of};
use crate::math::wide::widest;
use crate::math::{Band, DVec3, Lanes, Slant, Spline, Transform, tally};
pub use budget::Budget;
pub use internal::Internal;
pub(crate) use number::Number;
pub use number::Unary;
pub use tape::Tape;

/// A function of numbers.
#[derive(Clone, Debug)]
pub struct Function {
    /// How many numbers it takes.
    pub parameters: usize,
    /// How many functions deep it calls, itself included.
    pub depth: u32,
    /// What it computes.
    pub body: Body,
    known: bool,
    /// Whether four values at once have the bits of one.
    exact: bool,
    /// Whether values are rounded to single precision.
    single: bool,
}

/// What a [`Function`] computes.
#[derive(Clone, Debug)]
pub enum Body {
    /// An expression.
    Tape(Tape),
    /// `internal(n)`.
    Internal(Internal),
    /// `pattern { … }`.
    Pattern(Arc<dyn Field>),
    /// `pigment { … }`.
    Pigment(Arc<dyn Colors>),
    /// `transform { … }`.
    Transform(Box<Transform>),
    /// `spline { … }`.
    Spline(Box<Spline>),
}

impl Function {
    /// A function of so many numbers that calls functions this deep, itself included.
    pub fn new(parameters: usize, depth: u32, body: Body) -> Self {
        let known = match &body {
            Body::Tape(tape) => tape.is_known(),
            Body::Internal(_) | Body::Transform(_) => true,
            Body::Pattern(pattern) => pattern.is_known(),
            Body::Spline(_) => true,
            Body::Pigment(pigment) => pigment.is_known(),
        };
        let single = match &body {
            Body::Tape(tape) => tape.is_single(),
            Body::Pigment(_) => true,
            _ => false,
        };
        let exact = matches!(&body, Body::Tape(tape) if tape.is_exact());
        Self { parameters, depth, body, known, exact, single }
    }

    /// The value: of functions with several components, the first. Missing arguments count as 0.
    pub fn call(&self, arguments: &[f64]) -> f64 {
        match &self.body {
            Body::Tape(tape) => {
                tally::functions(1);
                tape.run(arguments, &Budget::default())
            }
            Body::Internal(internal) => {
                tally::functions(1);
                internal.call(arguments)
            }
            Body::Pattern(pattern) => pattern.value(&Sample::at(point(arguments))),
            Body::Pigment(_) | Body::Transform(_) | Body::Spline(_) => {
                let mut components = [0.0; 5];
                self.call_vector(arguments, &mut components);
                components[0]
            }
        }
    }

    /// Fills in the components of the value and returns how many there are.
    pub fn call_vector(&self, arguments: &[f64], components: &mut [f64; 5]) -> usize {
        self.call_within(arguments, components, &Budget::default())
    }

    /// The same, spending what is left of a budget. When nothing is left the value is NaN.
    pub fn call_within(&self, arguments: &[f64], components: &mut [f64; 5], budget: &Budget) -> usize {
        match &self.body {
            Body::Tape(tape) => {
                tally::functions(1);
                components[0] = tape.run(arguments, budget);
                1
            }
            Body::Pigment(pigment) => {
                let color = pigment.color(&Sample::at(point(arguments))).to_array();
                for place in 0..5 {
                    components[place] = f64::from(color[place]);
                }
                5
            }
            Body::Transform(transform) => {
                components[..3].copy_from_slice(&transform.point(point(arguments)).to_array());
                3
            }
            Body::Spline(spline) => {
                *components = spline.at(arguments.first().copied().unwrap_or(0.0));
                spline.size()
            }
            _ => {
                components[0] = self.call(arguments);
                1
            }
        }
    }
}

/// Functions of bands.
impl Function {
    /// What holds the values for all arguments that are held by these. Everything, where nothing is known
    /// of the function.
    #[inline(always)]
    pub fn enclose(&self, arguments: &[Band]) -> Band {
        match &self.body {
            Body::Tape(tape) => {
                tally::functions(1);
                tape.enclose(arguments, &Budget::default())
            }
            _ => self.enclose_within(arguments, 0, &Budget::default()),
        }
    }

    /// The same of one component, spending what is left of a budget.
    pub fn enclose_within(&self, arguments: &[Band], component: u8, budget: &Budget) -> Band {
        let at = |i: usize| arguments.get(i).copied().unwrap_or(Band::constant(0.0));
        match &self.body {
            Body::Pigment(pigment) => pigment.enclose(&[at(0), at(1), at(2)], component),
            _ if component == GREY => {
                let of = |component: u8| {
                    let mut share = [0.0; 3];
                    share[usize::from(component)] = 1.0;
                    self.enclose_within(arguments, component, budget) * grey_of(share)
                };
                of(0) + of(1) + of(2)
            }
            Body::Tape(tape) => {
                tally::functions(1);
                tape.enclose(arguments, budget)
            }
            Body::Internal(internal) => {
                tally::functions(1);
                internal.enclose(arguments)
            }
            Body::Transform(transform) if component < 3 => {
                let [axes @ .., origin] = [DVec3::X, DVec3::Y, DVec3::Z, DVec3::ZERO]
                    .map(|p| transform.point(p)[usize::from(component)]);
                let [x, y, z] = axes.map(|v| v - origin);
                at(0) * x + at(1) * y + at(2) * z + origin
            }
            Body::Pattern(pattern) => pattern.enclose(&[at(0), at(1), at(2)]),
            Body::Spline(spline) => spline.along(at(0), component.into()),
            Body::Transform(_) => Band::UNKNOWN,
        }
    }

    /// What holds the values of one component and how fast they rise, spending what is left of a budget. Of
    /// patterns and pigments it isn't known how fast.
    pub fn slant_within(&self, arguments: &[Slant], component: u8, budget: &Budget) -> Slant {
        let at = |i: usize| arguments.get(i).copied().unwrap_or(Slant::constant(0.0));
        match &self.body {
            Body::Tape(tape) if component != GREY => {
                tally::functions(1);
                tape.slant(arguments, budget)
            }
            Body::Internal(internal) if component != GREY => {
                tally::functions(1);
                internal.slant(arguments)
            }
            Body::Transform(transform) if component < 3 => {
                let component = usize::from(component);
                let origin = transform.point(DVec3::ZERO)[component];
                let share = |axis: DVec3| transform.point(axis)[component] - origin;
                at(0) * share(DVec3::X) + at(1) * share(DVec3::Y) + at(2) * share(DVec3::Z) + origin
            }
            Body::Spline(spline) if component != GREY => at(0).spline(spline, component.into()),
            _ => {
                let values: SmallVec<[Band; 8]> = arguments.iter().map(|argument| argument.value).collect();
                Slant::unknown_rise(self.enclose_within(&values, component, budget))
            }
        }
    }

    /// Whether [`Self::enclose`] knows the function, so that bands of short stretches are narrow wherever
    /// it is continuous.
    pub fn is_known(&self) -> bool {
        self.known
    }
}

/// The point that the first three arguments are.
fn point(arguments: &[f64]) -> DVec3 {
    let at = |i: usize| arguments.get(i).copied().unwrap_or(0.0);
    DVec3::new(at(0), at(1), at(2))
}

/// The `function` pattern: a function of a point.
impl Field for Function {
    fn value(&self, sample: &Sample) -> f64 {
        self.at(sample.point)
    }

    fn at(&self, point: DVec3) -> f64 {
        self.call(&point.to_array())
    }

    fn four(&self, samples: &Samples) -> Lanes {
        self.four_values(&samples.point)
    }

    fn at_four(&self, point: &[Lanes; 3]) -> Lanes {
        self.four_of_tape(point).unwrap_or_else(|| self.four_values(point))
    }

    fn enclose(&self, point: &[Band; 3]) -> Band {
        widest(
            #[inline(always)]
            || self.enclose(point),
        )
    }

    fn slant(&self, point: &[Slant; 3]) -> Slant {
        widest(
            #[inline(always)]
            || self.slant_within(point, 0, &Budget::default()),
        )
    }

    fn is_known(&self) -> bool {
        self.is_known()
    }

    fn is_single(&self) -> bool {
        self.single
    }
}
