//! Compiles `global_settings`.

use crate::math::gamma::Gamma;
use crate::scene;
use crate::world::Settings;

/// The settings the renderer needs.
pub fn settings(settings: &scene::Settings) -> Settings {
    let version = settings.effective_version();
    let working_gamma = settings.assumed_gamma.or((version >= 370).then_some(Gamma::LINEAR));
    Settings {
        version,
        adc_bailout: settings.adc_bailout,
        max_trace_level: settings.max_trace_level,
        ambient_light: settings.ambient_light,
        irid_wavelength: settings.irid_wavelength,
        noise_generator: settings.noise_generator,
        working_gamma,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_without_version_and_gamma_have_no_working_space() {
        let old = settings(&scene::Settings::default());
        assert_eq!((old.version, old.working_gamma), (362, None));
        let new = settings(&scene::Settings { version: Some(370), ..scene::Settings::default() });
        assert_eq!(new.working_gamma, Some(Gamma::LINEAR));
        let assumed_gamma = Some(Gamma::Power(2.2));
        let given = settings(&scene::Settings { assumed_gamma, ..scene::Settings::default() });
        assert_eq!(given.working_gamma, Some(Gamma::Power(2.2)));
    }
}
