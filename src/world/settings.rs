//! What holds for the whole world (docs/spec/shading.md 22).

use crate::math::Rgb;
use crate::math::gamma::Gamma;

/// Settings of the renderer.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The language version whose rules of shading hold, in hundredths.
    pub version: u32,
    /// Weight under which rays are not traced.
    pub adc_bailout: f32,
    /// Depth of the ray tree.
    pub max_trace_level: u32,
    /// Multiplies every `ambient`.
    pub ambient_light: Rgb,
    /// Thin film wavelengths in micrometres.
    pub irid_wavelength: Rgb,
    /// 1, 2 or 3.
    pub noise_generator: u8,
    /// The space of the world's colours; `None` in old scenes, which have none.
    pub working_gamma: Option<Gamma>,
}
