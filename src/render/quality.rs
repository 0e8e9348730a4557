//! What `+Q` leaves out (docs/spec/shading.md 20).

/// The machinery that a quality level allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Quality {
    /// Surfaces show their plain colour.
    pub(super) flat: bool,
    /// `quick_color` replaces pigments.
    pub(super) quick_colors: bool,
    /// Lights are blocked.
    pub(super) shadows: bool,
    /// Area lights are more than points.
    pub(super) area_lights: bool,
    /// Transparent surfaces show what is behind.
    pub(super) transmission: bool,
    /// Mirrors and bumps.
    pub(super) reflection: bool,
    /// Fog, rainbows, media.
    pub(super) atmosphere: bool,
}

impl Quality {
    /// Of `+Q level`; from 9 on nothing is left out.
    pub(super) fn new(level: u8) -> Self {
        Self {
            flat: level <= 1,
            quick_colors: level <= 5,
            shadows: level >= 4,
            area_lights: level >= 5,
            transmission: level >= 6,
            reflection: level >= 8,
            atmosphere: level >= 9,
        }
    }
}
