//! Exit codes, POV-Ray's own (docs/spec/camera-image.md 21).

/// Everything asked for was done.
pub const SUCCESS: u8 = 0;
/// Something was wrong: options, scene, picture.
pub const FAILURE: u8 = 1;
/// The user stopped the program, or nobody reads what it writes.
pub const ABANDONED: u8 = 2;
