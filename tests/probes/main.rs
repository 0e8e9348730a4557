//! The probes of the specification: small scenes, and the linear colours POV-Ray gave them.

mod averages;
mod camera;
mod cost;
mod endurance;
mod environment;
mod extremes;
mod media;
mod numerics;
mod quality;
mod shading;
mod table;
