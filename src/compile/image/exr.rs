//! `exr` images.

use std::io::Cursor;

use exr::image::read::read as reader;
use exr::meta::MetaData;
use exr::prelude::{FlatSamples, ReadChannels, ReadLayers};

use super::file::{Decoded, Fault, Native, Raw, room};
use crate::math::Gamma;

/// Decodes the first layer of an EXR: R, G, B and A, or Y for grey. A colour that is missing is 0.
pub(super) fn read(bytes: &[u8]) -> Result<Decoded, Fault> {
    let meta = MetaData::read_from_buffered(Cursor::new(bytes), false)?;
    for header in &meta.headers {
        let size = [header.layer_size.width(), header.layer_size.height()];
        room(size, header.channels.bytes_per_pixel.max(size_of::<[f32; 4]>()))?;
    }
    let image = reader()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_buffered(Cursor::new(bytes))?;
    let layer = &image.layer_data;
    let size = [layer.size.width(), layer.size.height()];
    let channel = |name: &str| {
        let mut channels = layer.channel_data.list.iter();
        channels.find(|channel| channel.name.eq(name)).map(|channel| &channel.sample_data)
    };
    let value = |samples: Option<&FlatSamples>, at: usize, missing: f32| match samples {
        Some(samples) if at < samples.len() => samples.value_by_flat_index(at).to_f32(),
        _ => missing,
    };
    let grey = channel("Y");
    let [r, g, b] = ["R", "G", "B"].map(|name| channel(name).or(grey));
    let alpha = channel("A");
    let pixels = (0..room(size, size_of::<[f32; 4]>())?)
        .map(|at| [value(r, at, 0.0), value(g, at, 0.0), value(b, at, 0.0), value(alpha, at, 1.0)]);
    let raw = Raw::Floats(pixels.collect());
    Ok(Decoded {
        premultiplied: true,
        has_alpha: true,
        ..Decoded::new(size, raw, Native::Known(Gamma::LINEAR))
    })
}
