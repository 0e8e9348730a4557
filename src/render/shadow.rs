//! What of a lamp's light comes through to a surface (docs/spec/shading.md 15 and 17).

mod grid;
mod shafts;

pub(super) use grid::Places;
use shafts::Between;
pub(super) use shafts::Shafts;

use super::refract::Inside;
use super::textures;
use super::trace::Tracer;
use crate::math::wide::widest;
use crate::math::{DVec3, Rgb};
use crate::world::hit::{Among, Hit};
use crate::world::light::{Incident, is_dark};
use crate::world::object::LeafFlags;
use crate::world::sample::Sample;
use crate::world::screen::{OPEN, SHUT, UNKNOWN, Verdict};
use crate::world::texture::Layer;
use crate::world::umbra::{Shade, Umbra};
use crate::world::{Intersection, Light, Range, Ray};

/// The last part of the way to a light, where the surface that it lies on is not in its way.
const LAST: f64 = 1e-9;

/// What lamps shine on: a surface, or a point in media.
#[derive(Clone, Copy)]
pub(super) struct Target<'a> {
    pub(super) surface: &'a Intersection,
    /// Where a ray met it; `None` in media.
    pub(super) hit: Option<&'a Hit>,
    /// What is around it.
    pub(super) inside: &'a Inside,
    /// The only objects that may be in the way, where that is known.
    pub(super) among: Option<Among<'a>>,
}

/// The way to a light from a point that rounding may have moved by `error`.
#[inline]
pub(super) fn way(from: DVec3, error: f64, incident: &Incident) -> (Ray, Range) {
    let range = Range { min: 0.0, max: incident.distance * (1.0 - LAST) - error };
    (Ray::new(from, incident.direction), range)
}

/// Whether objects are in the way of light from a lamp to a surface of one of them; those that only their surfaces
/// can decide on are `near`.
#[inline(always)]
fn sift(
    umbras: &[Umbra],
    surface: &Intersection,
    object: u32,
    lamp: DVec3,
    to_lamp: &DVec3,
    near: &mut Vec<u32>,
) -> Verdict {
    near.clear();
    let outside = !surface.inside && to_lamp.dot(surface.geometric) > 0.0;
    let is_left = |umbra: &Umbra| umbra.object == object && outside && umbra.left_for_good;
    if umbras.iter().all(is_left) {
        return OPEN;
    }
    let way = surface.leave(*to_lamp) - lamp;
    let mut found = OPEN;
    for umbra in umbras {
        if is_left(umbra) {
            continue;
        }
        let verdict = umbra.verdict(way);
        if verdict == SHUT {
            return SHUT;
        }
        if verdict == UNKNOWN {
            near.push(umbra.object);
            found = UNKNOWN;
        }
    }
    found
}

impl Tracer<'_> {
    /// The light that arrives from `light`, given what would arrive if nothing were in the way.
    pub(super) fn unblocked(&mut self, at: &Target, number: u32, incident: &Incident) -> Rgb {
        widest(
            #[inline(always)]
            || self.found_unblocked(at, number, incident),
        )
    }

    #[inline(always)]
    fn found_unblocked(&mut self, at: &Target, number: u32, incident: &Incident) -> Rgb {
        let light = &self.world.lights[number as usize];
        if !self.quality.shadows || (light.shadowless && light.projected_through.is_none()) {
            self.statistics.lights_shadowless += 1;
            return incident.color;
        }
        let Some(hit) = at.hit.filter(|_| at.among.is_none()) else {
            return self.known_unblocked(at, light, incident);
        };
        let geometry = &self.world.geometry;
        let shaft = self.shafts.find(geometry, (number, light), at.surface, hit.t, self.pixel);
        if let Some(shaft) = shaft {
            match self.shafts.among(shaft) {
                Some(Between::Shade(Shade::Dark)) => {
                    self.statistics.shadow_rays += 1;
                    return Rgb::ZERO;
                }
                Some(Between::Shade(Shade::Among(umbras))) => {
                    let (surface, way) = (at.surface, &incident.direction);
                    let found = sift(umbras, surface, hit.object, light.location, way, &mut self.near);
                    return self.past(at, found, light, incident);
                }
                _ => {}
            }
            let screens = self.shafts.lend(shaft);
            let among = Some(Among::Screens(&screens));
            let color = self.known_unblocked(&Target { among, ..*at }, light, incident);
            self.shafts.back(shaft, screens);
            return color;
        }
        let mut screens = std::mem::take(&mut self.screens);
        let few = self.between(at, light, incident, &mut screens);
        let among = few.then_some(Among::Screens(&screens));
        let color = self.known_unblocked(&Target { among, ..*at }, light, incident);
        self.screens = screens;
        color
    }

    /// The same where objects in front of a lamp of one place were sifted, and the near ones kept.
    #[inline]
    fn past(&mut self, at: &Target, found: Verdict, light: &Light, incident: &Incident) -> Rgb {
        match found {
            SHUT => {
                self.statistics.shadow_rays += 1;
                Rgb::ZERO
            }
            OPEN if !self.dims(light) => {
                self.statistics.lights_open += 1;
                incident.color
            }
            _ => {
                let near = std::mem::take(&mut self.near);
                let among = Some(Among::Near(&near));
                let color = self.known_unblocked(&Target { among, ..*at }, light, incident);
                self.near = near;
                color
            }
        }
    }

    /// The same where what may be in the way was looked for.
    fn known_unblocked(&mut self, at: &Target, light: &Light, incident: &Incident) -> Rgb {
        let nothing = at.among.is_some_and(|among| among.is_empty());
        if nothing && light.projected_through.is_none() && !self.dims(light) {
            self.statistics.lights_open += 1;
            return incident.color;
        }
        match &light.area {
            Some(area) if self.quality.area_lights => self.area_light(at, light, area, incident),
            _ => {
                self.statistics.shadow_rays += 1;
                self.shadow_ray(at, light, incident)
            }
        }
    }

    /// Follows a straight ray towards a light.
    fn shadow_ray(&mut self, at: &Target, light: &Light, incident: &Incident) -> Rgb {
        let from = at.surface.leave(incident.direction);
        let (ray, mut range) = way(from, at.surface.error, incident);
        if let Some(object) = light.projected_through {
            match self.world.geometry.object_distance(object, &ray, range) {
                // What light goes through is not in its own way.
                Some(distance) => range.max = distance * (1.0 - LAST),
                None => return Rgb::ZERO,
            }
            if light.shadowless {
                return incident.color;
            }
        }
        self.coming_through(at.among, at.inside, light, incident.color, (&ray, range))
    }

    /// Light of a `color` after what is in its way to a point, where nothing but `among` may be if that is known.
    #[inline]
    pub(super) fn coming_through(
        &mut self,
        among: Option<Among>,
        inside: &Inside,
        light: &Light,
        color: Rgb,
        (ray, range): (&Ray, Range),
    ) -> Rgb {
        let geometry = &self.world.geometry;
        let mut occluders = std::mem::take(&mut self.occluders);
        self.blocker = match among {
            Some(among) => geometry.occluders_among(among, ray, range, &mut occluders),
            None => geometry.occluders(ray, range, self.blocker, &mut occluders),
        };
        let color = if self.blocker.is_some() {
            Rgb::ZERO
        } else {
            self.filtered(inside, light, color, ray, range.max, &occluders)
        };
        self.occluders = occluders;
        color
    }

    /// Light after the transparent surfaces in its way and the air between them.
    fn filtered(
        &mut self,
        inside: &Inside,
        light: &Light,
        mut color: Rgb,
        ray: &Ray,
        distance: f64,
        occluders: &[Hit],
    ) -> Rgb {
        let airy = self.dims(light);
        if occluders.is_empty() && !airy {
            return color;
        }
        let mut inside = inside.clone();
        let mut start = 0.0;
        for hit in occluders {
            let piece = Ray::new(ray.at(start), ray.direction);
            let length = hit.t - start;
            color *= self.surface_filter(ray, hit, length, &inside);
            if is_dark(color) {
                return Rgb::ZERO;
            }
            let hollow = inside.is_hollow(&self.world.interiors);
            if hollow {
                color *= self.filling_shadow(&piece, length, &inside);
            }
            if airy {
                color *= self.air_shadow(&piece, length, &inside, hollow);
            }
            inside.toggle(self.world.geometry.parts().leaf(hit.leaf).interior);
            start = hit.t;
        }
        if airy && inside.is_hollow(&self.world.interiors) {
            let piece = Ray::new(ray.at(start), ray.direction);
            color *= self.air_shadow(&piece, distance - start, &inside, true);
        }
        color
    }

    /// Whether the air takes of a lamp's light.
    pub(super) fn dims(&self, light: &Light) -> bool {
        self.quality.atmosphere
            && light.media_attenuation
            && light.media_interaction
            && !self.world.atmosphere.is_clear()
    }

    /// What a transparent surface lets through, after `length` of the way to it.
    fn surface_filter(&mut self, ray: &Ray, hit: &Hit, length: f64, inside: &Inside) -> Rgb {
        let world = self.world;
        let leaf = world.geometry.parts().leaf(hit.leaf);
        let interior = &world.interiors[leaf.interior as usize];
        let fade = interior.fade.as_ref().filter(|_| inside.contains(leaf.interior));
        let fading = fade.map_or(Rgb::ONE, |fade| fade.shadow_attenuation(length));
        if leaf.flags.contains(LeafFlags::CLEAR) && interior.caustics == 0.0 {
            return fading;
        }
        self.statistics.shadow_textures += 1;
        if self.plain
            && let Some((_, color)) = self.even_layer(leaf)
        {
            if interior.caustics == 0.0 {
                return color.through() * fading;
            }
            let normal = world.geometry.surface(ray, hit).normal;
            return color.through() * interior.focus(normal.dot(ray.direction)) * fading;
        }
        // Where no pattern asks for normals, the inside and the outside of one texture are the same to light.
        let one_texture = leaf.texture.get().is_some() && leaf.interior_texture().is_none();
        let surface = if one_texture && interior.caustics == 0.0 && !world.needs.normals {
            Intersection::in_space(world.geometry.textured(ray, hit))
        } else {
            world.geometry.surface(ray, hit)
        };
        let bumpy = self.quality.reflection;
        let mut filter = Rgb::ZERO;
        let mut add = |weight, layers: &[Layer], sample: &mut Sample| {
            let mut through = Rgb::ONE;
            for layer in layers {
                if let Some(color) = layer.paint.color(sample) {
                    through *= color.through();
                }
                if interior.caustics != 0.0 {
                    let normal = if bumpy { layer.bend(sample) } else { sample.normal };
                    through *= interior.focus(normal.dot(ray.direction));
                }
            }
            filter += through * weight;
        };
        // Only normals have to know the way there.
        let placed = textures::placed_layers(world, leaf, &surface)
            .filter(|(_, place)| place.is_none() || interior.caustics == 0.0);
        match placed {
            Some((layers, place)) => {
                let mut sample = textures::sample(world, ray, hit, &surface);
                if let Some(place) = place {
                    sample.point = place.point(sample.point);
                }
                add(1.0, layers, &mut sample);
            }
            None => textures::resolve(world, ray, hit, &surface, &mut add),
        }
        filter * fading
    }
}
