//! What of a lamp's light comes through to a surface (docs/spec/shading.md 15 and 17).

use super::refract::Inside;
use super::textures;
use super::trace::Tracer;
use crate::math::{DVec2, DVec3, Rgb};
use crate::world::accel::{Hull, Points};
use crate::world::hit::{Hit, Nearby};
use crate::world::light::{AreaLight, Incident, is_dark};
use crate::world::object::LeafFlags;
use crate::world::{Intersection, Light, Range, Ray};

/// Difference between corners of an area light's grid above which the part between is refined.
const UNEVEN: f32 = 0.1;

/// From so many rays to an area light on it is worth while to look first what may be in their way.
const MANY_RAYS: u32 = 64;

/// What lamps shine on: a surface, or a point in media.
#[derive(Clone, Copy)]
pub(super) struct Target<'a> {
    pub(super) surface: &'a Intersection,
    /// What is around it.
    pub(super) inside: &'a Inside,
    /// The only objects that may be in the way, where that is known.
    pub(super) among: Option<&'a [u32]>,
}

/// A rectangle of an area light's grid, by the indices of its corners.
#[derive(Clone, Copy)]
struct Part {
    u: [u32; 2],
    v: [u32; 2],
}

/// An area light as one hit sees it.
struct Grid<'a> {
    light: &'a Light,
    area: &'a AreaLight,
    axes: [DVec3; 2],
    center: Incident,
}

impl Tracer<'_> {
    /// The light that arrives from `light`, given what would arrive if nothing were in the way.
    pub(super) fn unblocked(&mut self, at: &Target, light: &Light, incident: &Incident) -> Rgb {
        if !self.quality.shadows || (light.shadowless && light.projected_through.is_none()) {
            self.statistics.lights_shadowless += 1;
            return incident.color;
        }
        let among = if at.among.is_none() { self.between(at, light, incident) } else { None };
        let at = &Target { among: among.as_deref().or(at.among), ..*at };
        let nothing = at.among.is_some_and(<[u32]>::is_empty);
        if nothing && light.projected_through.is_none() && !self.dims(light) {
            self.statistics.lights_open += 1;
            return incident.color;
        }
        match &light.area {
            Some(area) if self.quality.area_lights => {
                self.grid.clear();
                self.grid.resize((area.size[0] * area.size[1]) as usize, None);
                let axes = area.axes_towards(incident.direction);
                let grid = Grid { light, area, axes, center: *incident };
                let whole = Part { u: [0, area.size[0] - 1], v: [0, area.size[1] - 1] };
                self.part(at, &grid, whole, 0)
            }
            _ => self.shadow_ray(at, light, incident),
        }
    }

    /// The objects that may be in the way of an area light that takes many rays; `None` where finding
    /// them isn't worth while, or they are many.
    fn between(&self, at: &Target, light: &Light, incident: &Incident) -> Option<Nearby> {
        let area = light.area.as_ref().filter(|_| self.quality.area_lights && !light.runs_parallel())?;
        if area.least_rays() < MANY_RAYS {
            return None;
        }
        let Intersection { point, geometric, error, .. } = *at.surface;
        let mut points = Points::new();
        points.push(point + error * geometric);
        points.extend(area.corners(area.axes_towards(incident.direction)).map(|c| light.location + c));
        points.push(point - error * geometric);
        let known = points.iter().all(|point| point.is_finite());
        known.then(|| Hull::new(points)).and_then(|hull| self.world.geometry.between(&hull))
    }

    /// The mean light from a part of an area light.
    fn part(&mut self, at: &Target, grid: &Grid, part: Part, level: u32) -> Rgb {
        let Part { u, v } = part;
        let corners =
            [(u[0], v[0]), (u[1], v[0]), (u[0], v[1]), (u[1], v[1])].map(|place| self.place(at, grid, place));
        let coarse = u[1] - u[0] > 1 || v[1] - v[0] > 1;
        let unlike = |a: usize, b: usize| (corners[a] - corners[b]).abs().element_sum() > UNEVEN;
        let uneven = || unlike(0, 1) || unlike(2, 3) || unlike(0, 2) || unlike(1, 3);
        let values = if coarse && (level < grid.area.adaptive || uneven()) {
            let low = |[a, b]: [u32; 2]| [a, (a + b) / 2];
            let high = |[a, b]: [u32; 2]| [(a + b).div_ceil(2), b];
            [(low(u), low(v)), (high(u), low(v)), (low(u), high(v)), (high(u), high(v))]
                .map(|(u, v)| self.part(at, grid, Part { u, v }, level + 1))
        } else {
            corners
        };
        values.into_iter().sum::<Rgb>() / 4.0
    }

    /// The light from one place of the grid, traced once for each hit.
    fn place(&mut self, at: &Target, grid: &Grid, (u, v): (u32, u32)) -> Rgb {
        let index = (v * grid.area.size[0] + u) as usize;
        if let Some(known) = self.grid[index] {
            return known;
        }
        let offset = grid.area.offset(grid.axes, (u, v), self.grid_shift(grid.area));
        let mut incident = grid.light.reaching_from_grid(at.surface.point, offset);
        incident.color = grid.center.color;
        let color = self.shadow_ray(at, grid.light, &incident);
        self.grid[index] = Some(color);
        color
    }

    /// How far a light of a grid is moved, in cells.
    pub(super) fn grid_shift(&mut self, area: &AreaLight) -> DVec2 {
        if area.jitter { DVec2::new(self.random.next() - 0.5, self.random.next() - 0.5) } else { DVec2::ZERO }
    }

    /// Follows a straight ray towards a light.
    fn shadow_ray(&mut self, at: &Target, light: &Light, incident: &Incident) -> Rgb {
        let ray = Ray::new(at.surface.leave(incident.direction), incident.direction);
        let mut range = Range { min: 0.0, max: incident.distance - at.surface.error };
        if let Some(object) = light.projected_through {
            match self.world.geometry.object_distance(object, &ray, range) {
                Some(distance) => range.max = distance,
                None => return Rgb::ZERO,
            }
            if light.shadowless {
                return incident.color;
            }
        }
        self.statistics.shadow_rays += 1;
        let geometry = &self.world.geometry;
        if self.blocker.is_some_and(|object| geometry.is_blocked_by(object, &ray, range)) {
            return Rgb::ZERO;
        }
        let mut occluders = std::mem::take(&mut self.occluders);
        self.blocker = match at.among {
            Some(among) => geometry.occluders_among(among, &ray, range, &mut occluders),
            None => geometry.occluders(&ray, range, &mut occluders),
        };
        let color = if self.blocker.is_some() {
            Rgb::ZERO
        } else {
            self.filtered(at, light, incident.color, &ray, range.max, &occluders)
        };
        self.occluders = occluders;
        color
    }

    /// Light after the transparent surfaces in its way and the air between them.
    fn filtered(
        &mut self,
        at: &Target,
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
        let mut inside = at.inside.clone();
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
    fn dims(&self, light: &Light) -> bool {
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
        let surface = world.geometry.surface(ray, hit);
        let bumpy = self.quality.reflection;
        let mut filter = Rgb::ZERO;
        textures::resolve(world, ray, hit, &surface, &mut |weight, layers, sample| {
            let mut through = Rgb::ONE;
            for layer in layers {
                if let Some(color) = layer.pigment.color(sample) {
                    through *= color.through();
                }
                if interior.caustics != 0.0 {
                    let normal = if bumpy { layer.bend(sample) } else { sample.normal };
                    through *= interior.focus(normal.dot(ray.direction));
                }
            }
            filter += through * weight;
        });
        filter * fading
    }
}
