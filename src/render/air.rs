//! What lies between surfaces: media inside objects, rainbows, media of the air, fog
//! (docs/spec/atmosphere-gi.md 1.2 and 1.8).

use super::media::{Stretch, depth_of_a_unit, mix, transmittance};
use super::refract::Inside;
use super::trace::{Path, Tracer};
use crate::math::Rgb;
use crate::world::Ray;
use crate::world::atmosphere::{FAR, Veil};
use crate::world::hit::Hit;

/// The light set of the lamps that reach everything.
const GLOBAL: usize = 0;

impl Tracer<'_> {
    /// Whether anything but clear air may be on a path that ends at a hit, or goes on for ever.
    #[inline]
    pub(super) fn is_airy(&self, path: &Path, hits: bool) -> bool {
        let filled = self.world.needs.media && hits && !path.inside.is_empty();
        self.quality.atmosphere && (filled || !self.world.atmosphere.is_clear())
    }

    /// What the air does to light that comes along a path from `hit`, or from the sky.
    pub(super) fn air(&mut self, path: &Path, hit: Option<&Hit>) -> Veil {
        let world = self.world;
        let filled = world.needs.media && hit.is_some() && !path.inside.is_empty();
        let clear = world.atmosphere.is_clear();
        if !path.inside.is_hollow(&world.interiors) {
            return Veil::NONE;
        }
        let length = hit.map_or(FAR, |hit| hit.t);
        let lights = hit.map_or(GLOBAL, |hit| world.geometry.parts().leaf(hit.leaf).lights as usize);
        let lights = Some(&world.light_sets[lights]);
        let mut veil = Veil::NONE;
        if filled {
            let media = mix(world, &path.inside);
            if !media.is_empty() {
                veil = self.media(&Stretch { ray: path.ray, length, inside: &path.inside, media, lights });
            }
        }
        if clear {
            return veil;
        }
        let atmosphere = &world.atmosphere;
        veil = veil.behind(atmosphere.rainbow(&path.ray, length, &mut || self.random.next()));
        if !atmosphere.media.is_empty() {
            let media = atmosphere.media.iter().collect();
            let air = Stretch { ray: path.ray, length, inside: &path.inside, media, lights };
            veil = veil.behind(self.media(&air));
        }
        veil.behind(atmosphere.fog(&path.ray, length))
    }

    /// What media inside objects leave of a lamp's light on a piece of its way that ends on a surface.
    pub(super) fn filling_shadow(&mut self, ray: &Ray, length: f64, inside: &Inside) -> Rgb {
        let world = self.world;
        if !world.needs.media || !self.quality.atmosphere || inside.is_empty() {
            return Rgb::ONE;
        }
        // A loop, once: this is asked at every surface on the way to every lamp.
        let (mut dims, mut even, mut depth) = (false, true, Rgb::ZERO);
        for number in inside.numbers() {
            for media in &world.interiors[number as usize].media {
                dims |= media.dims();
                even &= media.density.is_uniform();
                depth += media.density.uniform * media.extinction;
            }
        }
        if !dims {
            return Rgb::ONE;
        }
        if even {
            return transmittance(depth * length as f32);
        }
        let media = mix(world, inside);
        self.media_shadow(&Stretch { ray: *ray, length, inside, media, lights: None })
    }

    /// What the air leaves of a lamp's light; fog only around `hollow` objects.
    pub(super) fn air_shadow(&mut self, ray: &Ray, length: f64, inside: &Inside, hollow: bool) -> Rgb {
        let atmosphere = &self.world.atmosphere;
        let fog = if hollow { atmosphere.fog(ray, length).factor } else { Rgb::ONE };
        if atmosphere.media.is_empty() {
            return fog;
        }
        let media = atmosphere.media.iter().collect();
        fog * self.media_shadow(&Stretch { ray: *ray, length, inside, media, lights: None })
    }

    /// The optical depth of a unit of the air on the way to a lamp, if it is the same everywhere.
    pub(super) fn even_air(&self) -> Option<Rgb> {
        let atmosphere = &self.world.atmosphere;
        let even =
            atmosphere.fogs.is_empty() && atmosphere.media.iter().all(|media| media.density.is_uniform());
        even.then(|| depth_of_a_unit(&atmosphere.media))
    }
}
