//! The primitives, each as a piece of scene and as equations.

mod csg;
mod flat;
mod polynomial;
mod round;
mod soft;
mod turned;
