//! Exit codes, POV-Ray's own (docs/spec/camera-image.md 21).

/// Everything asked for was done.
pub(super) const SUCCESS: u8 = 0;
/// Something was wrong: options, scene, picture.
pub(super) const FAILURE: u8 = 1;
/// The user stopped the program, or nobody reads what it writes.
pub(super) const ABANDONED: u8 = 2;
