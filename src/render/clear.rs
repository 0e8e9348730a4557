//! What most of glass is: a surface of one transparent layer of one colour, that has no bumps and wears no film, where
//! no light is split into colours. What is seen there is what [`Tracer::shade`] would say, on a shorter way.

use super::finish::Surface;
use super::mirror;
use super::refract::{self, Passage};
use super::shade::{Onward, Shaded};
use super::shadow::Target;
use super::trace::{Path, Tracer};
use crate::math::color::grey;
use crate::math::{Rgb, Rgbft};
use crate::world::hit::Hit;
use crate::world::light::set::Numbers;
use crate::world::object::{Leaf, LeafFlags};
use crate::world::texture::Finish;
use crate::world::{Intersection, Ray};

impl<'w> Tracer<'w> {
    /// The finish and the colour of the layer which is all there is to a leaf, if it is that simple.
    #[inline]
    pub(super) fn even_layer(&self, leaf: &Leaf) -> Option<(&'w Finish, Rgbft)> {
        let (layer, _) = self.only_layer(leaf)?;
        Some((&layer.finish, layer.paint.even()?))
    }

    /// The same of a leaf that light may go through.
    #[inline]
    pub(super) fn clear_layer(&self, leaf: &Leaf) -> Option<(&'w Finish, Rgbft)> {
        // What is never seen at all has a way of its own.
        if !self.clear || leaf.flags.intersects(LeafFlags::OPAQUE | LeafFlags::INVISIBLE) {
            return None;
        }
        self.even_layer(leaf)
    }

    /// Shades the surface that a ray met, if it is that simple.
    pub(super) fn clear(&mut self, path: &Path, hit: &Hit) -> Option<Shaded> {
        let world = self.world;
        let leaf = world.geometry.parts().leaf(hit.leaf);
        let (finish, color) = self.clear_layer(leaf)?;
        self.statistics.texture_evaluations += 1;
        let surface = &world.geometry.surface(&path.ray, hit);
        let (normal, direction) = (&surface.normal, path.ray.direction);
        let reflectivity = self.reflectivity(path, leaf, finish, normal, color.rgb);
        let mut through = color.through();
        if let Some(reflectivity) = reflectivity.filter(|_| finish.conserve_energy) {
            through *= (Rgb::ONE - reflectivity.color).min(Rgb::ONE);
        }
        let mut shaded = Shaded {
            color: self.own_light((path, hit), surface, finish, &color),
            transmit: 0.0,
            onward: None,
        };
        let share = grey(through).abs().min(1.0);
        let mut mirrors = true;
        if self.quality.transmission && share > world.settings.adc_bailout {
            let weight = path.weight * through.abs().max_element();
            let attenuation = self.attenuation(path, hit, leaf);
            let (left, clear) = (attenuation * through, grey(attenuation) * share);
            let passage = path.inside.pass(leaf.interior, &world.interiors);
            let straight = passage.is_straight();
            let Passage { ratio, inside, .. } = passage;
            if straight {
                let ray = Ray::new(surface.leave(direction), direction);
                shaded.onward = (weight > 0.0).then_some(Onward { ray, weight, inside, left, clear });
            } else if let Some(bent) = refract::refracted(direction, *normal, ratio) {
                self.statistics.refracted_rays += 1;
                let ray = Ray::new(surface.leave(bent), bent);
                let Path { level, kind, wavelength, .. } = *path;
                let seen = self.trace(&mut Path { ray, level, weight, kind, wavelength, inside });
                shaded.color += left * seen.color;
                shaded.transmit = clear * seen.transmit;
            } else {
                // All that is mirrored is seen by total reflection already.
                mirrors = false;
                let back = mirror::mirrored(direction, *normal, *normal);
                let seen = self.mirrored((path, surface), back, weight, path.wavelength);
                shaded.color += attenuation * seen.color;
            }
        }
        if let (true, Some(reflection), Some(reflectivity)) = (mirrors, &finish.reflection, reflectivity)
            && reflectivity.color != Rgb::ZERO
        {
            let back = mirror::mirrored(direction, *normal, *normal);
            let weight = path.weight * reflectivity.weight;
            let mut seen = self.mirrored((path, surface), back, weight, path.wavelength).color;
            if reflection.exponent != 1.0 {
                seen = seen.powf(reflection.exponent.recip());
            }
            shaded.color += reflectivity.color * seen;
        }
        Some(shaded)
    }

    /// What a surface that is that simple gives off, and scatters and mirrors of the light of lamps.
    #[inline(always)]
    fn own_light(
        &mut self,
        (path, hit): (&Path, &Hit),
        surface: &Intersection,
        finish: &Finish,
        color: &Rgbft,
    ) -> Rgb {
        let world = self.world;
        let leaf = world.geometry.parts().leaf(hit.leaf);
        let opacity = self.opacity(color);
        let own = finish.ambient * world.settings.ambient_light + finish.emission;
        let mut direct = Rgb::ZERO;
        let scatters = opacity != 0.0 && (finish.diffuse > 0.0 || finish.diffuse_back > 0.0);
        if scatters || finish.specular > 0.0 || finish.phong > 0.0 {
            let (normal, direction) = (&surface.normal, &path.ray.direction);
            let lit = Surface { finish, color: color.rgb, opacity, normal, direction };
            let at = Target { surface, hit: Some(hit), inside: &path.inside, among: None };
            let mut room = Numbers::new();
            for &number in self.lamps_near(leaf, surface.point, &mut room) {
                let incident = world.lights[number as usize].reaching(surface.point);
                direct += self.plain_light(&at, leaf, &lit, (number, false), &incident);
            }
        }
        color.rgb * own * opacity + direct
    }
}
