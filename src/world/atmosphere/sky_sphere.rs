//! `sky_sphere`: pigments seen behind everything (docs/spec/atmosphere-gi.md 1.5).

use std::sync::Arc;

use crate::math::{DVec3, Rgb, Rgbft};
use crate::world::sample::Sample;
use crate::world::texture::Pigment;

/// Pigments at the ray's direction.
#[derive(Debug)]
pub struct SkySphere {
    /// Layers, the lowest first.
    pub pigments: Vec<Arc<Pigment>>,
    /// Multiplies everything.
    pub emission: Rgb,
}

impl SkySphere {
    /// Whether it is of one colour.
    pub(super) fn is_even(&self) -> bool {
        self.pigments.iter().all(|pigment| matches!(**pigment, Pigment::Color(_)))
    }

    /// The sky's own light in a direction, and the share of the background's it lets through.
    pub(super) fn color(&self, direction: DVec3) -> (Rgb, Rgb) {
        let start = (Rgb::ZERO, Rgb::ONE);
        self.layers(direction).fold(start, |(color, through), layer| {
            let light = layer.rgb * layer.opacity() * self.emission;
            (color + light * through, through * layer.through())
        })
    }

    /// The sky before the background by the rule of versions below 3.7.
    pub(super) fn before_37(&self, direction: DVec3, background: Rgb) -> Rgb {
        let mut color = Rgb::ZERO;
        let (mut filter_color, mut filter, mut transmit) = (Rgb::ONE, 1.0, 1.0);
        let mut left = 1.0;
        for layer in self.layers(direction) {
            color += layer.rgb * (left * layer.opacity());
            filter_color *= layer.rgb;
            filter *= layer.filter;
            transmit *= layer.transmit;
            left = f32::abs(filter) + f32::abs(transmit);
        }
        color * self.emission + background * (filter_color * filter + Rgb::splat(transmit))
    }

    /// The layers' colours from the top one down.
    fn layers(&self, direction: DVec3) -> impl Iterator<Item = Rgbft> {
        let sample = Sample::at(direction);
        self.pigments.iter().rev().filter_map(move |pigment| pigment.color(&sample))
    }
}
