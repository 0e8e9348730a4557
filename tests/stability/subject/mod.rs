//! The primitives, each as a piece of scene and as equations.

mod csg;
mod flat;
mod function;
mod grid;
mod julia;
mod polynomial;
mod round;
mod soft;
mod spline;
mod sweep;
mod text;
mod turned;
