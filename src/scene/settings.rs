//! `global_settings` (docs/spec/language.md 6.16).

use crate::math::{Gamma, Rgb};
use crate::source::Span;

/// Settings of the whole scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// `#version` in hundredths at the end of the scene, such as 370; `None` where none was written:
    /// the renderer then behaves as 362 (docs/spec/language.md 2.11).
    pub version: Option<u32>,
    /// `assumed_gamma`, where written.
    pub assumed_gamma: Option<Gamma>,
    /// Weight under which rays are not traced.
    pub adc_bailout: f32,
    /// Multiplies every `ambient`.
    pub ambient_light: Rgb,
    /// Thin film wavelengths in micrometres.
    pub irid_wavelength: Rgb,
    /// Depth of the ray tree, 1 … 256.
    pub max_trace_level: u32,
    /// Sources of `waves` and `ripples`.
    pub number_of_waves: u32,
    /// 1, 2 or 3.
    pub noise_generator: u8,
    /// Millimetres per unit, for subsurface light.
    pub mm_per_unit: f32,
    /// `subsurface { … }`.
    pub subsurface: Option<SubsurfaceSettings>,
    /// `radiosity { … }`.
    pub radiosity: Option<RadiositySettings>,
    /// `photons { … }`.
    pub photons: Option<PhotonSettings>,
}

/// `global_settings { subsurface { … } }`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SubsurfaceSettings {
    /// Where it was written.
    pub span: Span,
    /// Diffuse and single scattering samples.
    pub samples: [u32; 2],
    /// Uses radiosity.
    pub radiosity: bool,
}

/// `global_settings { radiosity { … } }` (docs/spec/atmosphere-gi.md 3.1).
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "the language's own words")]
pub struct RadiositySettings {
    pub span: Span,
    pub adc_bailout: f32,
    pub always_sample: bool,
    pub brightness: f32,
    pub count: u32,
    pub direction_pool: u32,
    pub error_bound: f32,
    pub gray_threshold: f32,
    pub low_error_factor: f32,
    pub max_sample: f32,
    pub maximum_reuse: f32,
    pub minimum_reuse: f32,
    pub media: bool,
    pub nearest_count: u32,
    pub adaptive_count: u32,
    pub normal: bool,
    pub pretrace_start: f32,
    pub pretrace_end: f32,
    pub recursion_limit: u32,
    pub subsurface: bool,
}

/// `global_settings { photons { … } }` (docs/spec/atmosphere-gi.md 4.1).
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "the language's own words")]
pub struct PhotonSettings {
    pub span: Span,
    pub spacing: f32,
    pub count: Option<u32>,
    pub gather: [u32; 2],
    /// Surface radius and multiplier, media radius and multiplier; a radius ≤ 0 is automatic.
    pub radius: [f32; 4],
    pub expand_tolerance: f32,
    pub expand_minimum: u32,
    pub jitter: f32,
    pub autostop: f32,
    pub adc_bailout: Option<f32>,
    pub max_trace_level: Option<u32>,
    pub media_steps: u32,
    pub media_factor: f32,
    pub load_file: Option<String>,
    pub save_file: Option<String>,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            version: None,
            assumed_gamma: None,
            adc_bailout: 1.0 / 255.0,
            ambient_light: Rgb::ONE,
            irid_wavelength: Rgb::new(0.70, 0.52, 0.48),
            max_trace_level: 5,
            number_of_waves: 10,
            noise_generator: 2,
            mm_per_unit: 10.0,
            subsurface: None,
            radiosity: None,
            photons: None,
        }
    }
}

impl Settings {
    /// The version that renderer-side compatibility asks for, in hundredths: 362 where no
    /// `#version` was written.
    pub fn effective_version(&self) -> u32 {
        self.version.unwrap_or(362)
    }
}

impl Default for RadiositySettings {
    fn default() -> Self {
        Self {
            span: Span::default(),
            adc_bailout: 0.01,
            always_sample: false,
            brightness: 1.0,
            count: 35,
            direction_pool: 1600,
            error_bound: 1.8,
            gray_threshold: 0.0,
            low_error_factor: 0.5,
            max_sample: -1.0,
            maximum_reuse: 0.2,
            minimum_reuse: 0.015,
            media: false,
            nearest_count: 5,
            adaptive_count: 0,
            normal: false,
            pretrace_start: 0.08,
            pretrace_end: 0.04,
            recursion_limit: 2,
            subsurface: false,
        }
    }
}

impl Default for PhotonSettings {
    fn default() -> Self {
        Self {
            span: Span::default(),
            spacing: 1.0,
            count: None,
            gather: [20, 100],
            radius: [-1.0, 1.0, -1.0, 1.0],
            expand_tolerance: 0.2,
            expand_minimum: 35,
            jitter: 0.4,
            autostop: 0.5,
            adc_bailout: None,
            max_trace_level: None,
            media_steps: 0,
            media_factor: 1.0,
            load_file: None,
            save_file: None,
        }
    }
}
