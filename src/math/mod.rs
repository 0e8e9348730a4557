//! Numbers, vectors and colours: what every other layer is built on. No I/O, no state but counts.

pub mod band;
pub mod bounds;
pub mod color;
pub mod confidence;
#[cfg(test)]
pub(crate) mod dice;
pub mod double;
pub mod gamma;
pub mod hyperbolic;
pub mod lanes;
pub mod noise;
pub mod pages;
mod power;
pub mod roots;
pub mod slant;
pub mod spline;
pub mod tally;
pub mod transform;
mod unit;
pub mod wide;

pub use band::Band;
pub use bounds::Bounds;
pub use color::{Rgb, Rgbft};
pub use gamma::Gamma;
pub use glam::{DAffine3, DMat2, DMat3, DVec2, DVec3, DVec4};
pub use lanes::Lanes;
pub use slant::Slant;
pub use spline::Spline;
pub use transform::Transform;
pub use unit::unit;
