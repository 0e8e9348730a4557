//! `global_settings`.

use super::block::Block;
use super::value::{self, number, rgb, switch};
use crate::scene::Settings;
use crate::scene::settings::{PhotonSettings, RadiositySettings};

pub(super) fn dump(settings: &Settings) -> Block {
    let gamma = settings.assumed_gamma.map(value::gamma);
    let mut block = Block::new("global_settings")
        .field(
            "version",
            settings.version.map_or("unset".to_owned(), |version| number(f64::from(version) / 100.0)),
        )
        .field("assumed_gamma", gamma.as_deref().unwrap_or("unset"))
        .field("adc_bailout", number(settings.adc_bailout))
        .field("ambient_light", rgb(settings.ambient_light))
        .field("irid_wavelength", rgb(settings.irid_wavelength))
        .field("max_trace_level", settings.max_trace_level)
        .field("number_of_waves", settings.number_of_waves)
        .field("noise_generator", settings.noise_generator)
        .field("mm_per_unit", number(settings.mm_per_unit));
    if let Some(subsurface) = &settings.subsurface {
        let [diffuse, single] = subsurface.samples;
        let inner = Block::new("subsurface").line(format!("samples {diffuse}, {single}"));
        block = block.block(inner.field("radiosity", switch(subsurface.radiosity)));
    }
    block.blocks(settings.radiosity.as_ref().map(radiosity)).blocks(settings.photons.as_ref().map(photons))
}

fn radiosity(r: &RadiositySettings) -> Block {
    Block::new("radiosity")
        .line(format!("count {}, {}", r.count, r.direction_pool))
        .line(format!("nearest_count {}, {}", r.nearest_count, r.adaptive_count))
        .field("error_bound", number(r.error_bound))
        .field("low_error_factor", number(r.low_error_factor))
        .field("recursion_limit", r.recursion_limit)
        .field("pretrace_start", number(r.pretrace_start))
        .field("pretrace_end", number(r.pretrace_end))
        .field("brightness", number(r.brightness))
        .field("gray_threshold", number(r.gray_threshold))
        .field("minimum_reuse", number(r.minimum_reuse))
        .field("maximum_reuse", number(r.maximum_reuse))
        .field("adc_bailout", number(r.adc_bailout))
        .field("max_sample", number(r.max_sample))
        .field("always_sample", switch(r.always_sample))
        .field("normal", switch(r.normal))
        .field("media", switch(r.media))
        .field("subsurface", switch(r.subsurface))
}

fn photons(p: &PhotonSettings) -> Block {
    Block::new("photons")
        .field("spacing", number(p.spacing))
        .optional("count", p.count)
        .line(format!("gather {}, {}", p.gather[0], p.gather[1]))
        .field("radius", p.radius.map(number).join(", "))
        .line(format!("expand_thresholds {}, {}", number(p.expand_tolerance), p.expand_minimum))
        .field("jitter", number(p.jitter))
        .field("autostop", number(p.autostop))
        .optional("adc_bailout", p.adc_bailout.map(number))
        .optional("max_trace_level", p.max_trace_level)
        .line(format!("media {}, {}", p.media_steps, number(p.media_factor)))
        .optional("load_file", p.load_file.as_ref().map(|name| format!("{name:?}")))
        .optional("save_file", p.save_file.as_ref().map(|name| format!("{name:?}")))
}
