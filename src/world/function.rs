//! User functions, compiled (docs/spec/language.md 4). Nothing is allocated when one is called.

mod budget;
pub mod internal;
pub mod tape;

use std::sync::Arc;

use super::sample::{Colors, Field, Sample};
use crate::math::{DVec3, Spline, Transform, tally};
pub use budget::Budget;
pub use internal::Internal;
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
                *components = pigment.color(&Sample::at(point(arguments))).to_array().map(f64::from);
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

/// The point that the first three arguments are.
fn point(arguments: &[f64]) -> DVec3 {
    let at = |i: usize| arguments.get(i).copied().unwrap_or(0.0);
    DVec3::new(at(0), at(1), at(2))
}

/// The `function` pattern: a function of a point.
impl Field for Function {
    fn value(&self, sample: &Sample) -> f64 {
        match &self.body {
            Body::Pattern(pattern) => pattern.value(&Sample::at(sample.point)),
            _ => self.call(&sample.point.to_array()),
        }
    }
}
