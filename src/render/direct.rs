//! Light that lamps send to a surface (docs/spec/shading.md 8).

use std::ops::Range as Span;

use super::finish::{Surface, iridescence};
use super::shade::At;
use super::shadow::Target;
use super::trace::Tracer;
use crate::math::{DVec3, Rgb};
use crate::world::light::set::Numbers;
use crate::world::light::{AreaLight, Incident, is_dark};
use crate::world::{Leaf, Light};

/// A lamp's light at a hit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arrival {
    /// Number of the light.
    light: u32,
    /// What arrives if nothing is in the way.
    incident: Incident,
    /// What arrives; `None` until somebody asks.
    unblocked: Option<Rgb>,
}

impl<'w> Tracer<'w> {
    /// The light a layer sends to the eye from all lamps.
    pub(super) fn direct(&mut self, at: &mut At, surface: &Surface) -> Rgb {
        let finish = surface.finish;
        // What lets all light pass has highlights only.
        let scatters = (surface.opacity != 0.0 || finish.crand != 0.0)
            && (finish.diffuse > 0.0 || finish.diffuse_back > 0.0);
        let answers = scatters || finish.specular > 0.0 || finish.phong > 0.0;
        if !answers {
            return Rgb::ZERO;
        }
        let mut sum = Rgb::ZERO;
        if at.plain {
            // Nobody else asks for these arrivals.
            let mut room = Numbers::new();
            for &light in self.lamps_near(at.leaf, at.surface.point, &mut room) {
                let mut arrival = Arrival { light, incident: self.incident(at, light), unblocked: None };
                if !self.is_out_of_reach(&arrival) {
                    sum += self.lamp(at, &mut arrival, surface);
                }
            }
            return sum;
        }
        for index in self.arrivals(at) {
            let mut arrival = self.arrivals[index];
            sum += self.lamp(at, &mut arrival, surface);
            self.arrivals[index] = arrival;
        }
        sum
    }

    /// The numbers of the lamps that may light a point of a leaf, which `room` is for.
    #[inline(always)]
    pub(super) fn lamps_near<'a>(&mut self, leaf: &Leaf, point: DVec3, room: &'a mut Numbers) -> &'a [u32]
    where
        'w: 'a,
    {
        let lamps = &self.world.light_sets[leaf.lights as usize];
        let near = lamps.lighting(point, room);
        self.statistics.lights_dark += (lamps.all().len() - near.len()) as u64;
        near
    }

    /// What a lamp sends to the hit if nothing is in the way.
    #[inline]
    fn incident(&self, at: &At, number: u32) -> Incident {
        let light = &self.world.lights[number as usize];
        let mut incident = light.reaching(at.surface.point);
        if self.illuminating(light).is_some() {
            // Each place of the grid has its own attenuation.
            incident.color = light.color;
        }
        incident
    }

    /// Whether a lamp is too dark or too far away to count.
    #[inline]
    fn is_out_of_reach(&mut self, arrival: &Arrival) -> bool {
        let dark = arrival.incident.is_dark();
        self.statistics.lights_dark += u64::from(dark);
        dark
    }

    /// The lamps that reach the hit, found once for all its layers.
    fn arrivals(&mut self, at: &mut At) -> Span<usize> {
        if let Some(known) = &at.arrivals {
            return known.clone();
        }
        let first = self.arrivals.len();
        let mut room = Numbers::new();
        for &light in self.lamps_near(at.leaf, at.surface.point, &mut room) {
            let arrival = Arrival { light, incident: self.incident(at, light), unblocked: None };
            if !self.is_out_of_reach(&arrival) {
                self.arrivals.push(arrival);
            }
        }
        let found = first..self.arrivals.len();
        at.arrivals = Some(found.clone());
        found
    }

    /// The light one lamp makes a layer send to the eye.
    #[inline]
    fn lamp(&mut self, at: &At, arrival: &mut Arrival, surface: &Surface) -> Rgb {
        let Arrival { light: number, incident, unblocked } = arrival;
        let light = &self.world.lights[*number as usize];
        let grid = self.illuminating(light);
        let mut back = false;
        if grid.is_none() && !surface.faces(at.leaf, &incident.direction) {
            if surface.finish.diffuse_back <= 0.0 {
                self.statistics.lights_behind += 1;
                return Rgb::ZERO;
            }
            back = true;
        }
        if grid.is_none() && !surface.answers(&incident.direction, back) {
            self.statistics.lights_unseen += 1;
            return Rgb::ZERO;
        }
        let unblocked = match *unblocked {
            Some(known) => known,
            None => *unblocked.insert(self.arriving(&at.target(), *number, incident)),
        };
        if is_dark(unblocked) {
            return Rgb::ZERO;
        }
        let answer = match grid {
            Some(area) => {
                self.illuminate(at, light, area, surface, &Incident { color: unblocked, ..*incident })
            }
            None => self.answer(surface, &incident.direction, unblocked, back, light.shadowless),
        };
        match &surface.finish.irid {
            Some(irid) => {
                let settings = &self.world.settings;
                let film = iridescence(
                    irid,
                    settings.irid_wavelength,
                    at.surface.textured,
                    *surface.normal,
                    incident.direction,
                    *surface.direction,
                    settings.noise_generator,
                );
                answer * film
            }
            None => answer,
        }
    }

    /// What arrives of a lamp's light; what was in the way of it last is asked first.
    #[inline]
    pub(super) fn arriving(&mut self, at: &Target, number: u32, incident: &Incident) -> Rgb {
        self.blocker = self.blockers[number as usize];
        let found = self.unblocked(at, number, incident);
        self.blockers[number as usize] = self.blocker;
        found
    }

    /// The grid of a light whose places light one by one.
    #[inline]
    fn illuminating<'l>(&self, light: &'l Light) -> Option<&'l AreaLight> {
        light.area.as_ref().filter(|area| area.area_illumination && self.quality.area_lights)
    }

    /// What a layer makes of the light `color` from one place.
    #[inline(always)]
    pub(super) fn answer(
        &mut self,
        surface: &Surface,
        to_light: &DVec3,
        color: Rgb,
        back: bool,
        shadowless: bool,
    ) -> Rgb {
        let grain = if surface.finish.crand > 0.0 { self.random.next() as f32 } else { 0.0 };
        let diffuse = surface.diffuse(to_light, color, back, grain);
        if back || shadowless { diffuse } else { diffuse + surface.highlights(to_light, color) }
    }

    /// `area_illumination`: what a layer makes of the light from every place of the grid.
    fn illuminate(
        &mut self,
        at: &At,
        light: &Light,
        area: &AreaLight,
        surface: &Surface,
        center: &Incident,
    ) -> Rgb {
        let axes = area.axes_towards(center.direction);
        let [columns, rows] = area.size;
        let share = center.color / (columns * rows) as f32;
        let mut sum = Rgb::ZERO;
        for (v, u) in (0..rows).flat_map(|v| (0..columns).map(move |u| (v, u))) {
            let offset = area.offset(axes, (u, v), self.grid_shift(area));
            let incident = light.reaching_from_grid(at.surface.point, offset);
            let color = share * incident.attenuation;
            let facing = surface.faces(at.leaf, &incident.direction);
            if facing || surface.finish.diffuse_back > 0.0 {
                sum += self.answer(surface, &incident.direction, color, !facing, light.shadowless);
            }
        }
        sum
    }
}
