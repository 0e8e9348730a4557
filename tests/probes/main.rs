//! The probes of the specification: small scenes, and the linear colours POV-Ray gave them.

mod camera;
mod cost;
mod environment;
mod media;
mod quality;
mod shading;
mod table;
