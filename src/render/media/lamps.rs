//! The light of lamps at a point in media.

use super::intervals::{Beam, Between};
use super::{March, transmittance};
use crate::math::{DVec3, Rgb};
use crate::render::shadow::{self, Target};
use crate::render::trace::Tracer;
use crate::world::hit::Among;
use crate::world::light::Incident;
use crate::world::screen::{OPEN, SHUT, UNKNOWN};
use crate::world::{Intersection, Light};

impl Tracer<'_> {
    /// The light of lamps at a point of a march, each weighted by its share that goes to the eye.
    pub(super) fn lamps(&mut self, march: &March, point: DVec3, s: f64) -> Rgb {
        let stretch = march.stretch;
        let error = Intersection::rounding(point);
        let mut sum = Rgb::ZERO;
        for beam in &march.beams {
            if s < beam.reach.min || beam.reach.max < s {
                continue;
            }
            let light = &self.world.lights[beam.light as usize];
            let incident = light.reaching(point);
            if incident.is_dark() {
                self.statistics.lights_dark += 1;
                continue;
            }
            let cosine = stretch.ray.direction.dot(incident.direction);
            let mut shares = 0.0;
            for media in &stretch.media {
                shares += media.phase.share(cosine);
            }
            let share = shares / stretch.media.len() as f32;
            if share == 0.0 {
                continue;
            }
            sum += share
                * match &beam.among {
                    Some(among) if beam.simple => {
                        let between = &march.between[among.clone()];
                        self.past_objects(march, (between, s), beam, light, (point, error), &incident)
                    }
                    Some(among) => {
                        let mut screens = std::mem::take(&mut self.screens);
                        screens.clear();
                        let between = march.between[among.clone()].iter();
                        let between = between.filter(|between| between.shade.contains(s));
                        screens.extend(between.map(|between| between.screen));
                        let among = Some(Among::Screens(&screens));
                        let color = self.in_space(march, point, beam, &incident, among);
                        self.screens = screens;
                        color
                    }
                    None => self.in_space(march, point, beam, &incident, None),
                };
        }
        sum
    }

    /// What comes from any lamp.
    fn in_space(
        &mut self,
        march: &March,
        point: DVec3,
        beam: &Beam,
        incident: &Incident,
        among: Option<Among>,
    ) -> Rgb {
        let surface = Intersection::in_space(point);
        let target = Target { surface: &surface, hit: None, inside: march.stretch.inside, among };
        self.unblocked(&target, beam.light, incident)
    }

    /// What comes from a simple lamp past the objects between.
    #[inline]
    fn past_objects(
        &mut self,
        march: &March,
        (between, s): (&[Between], f64),
        beam: &Beam,
        light: &Light,
        (point, error): (DVec3, f64),
        incident: &Incident,
    ) -> Rgb {
        let geometry = &self.world.geometry;
        let way = (point - light.location).to_array();
        let (ray, range) = shadow::way(point, error, incident);
        let mut near = std::mem::take(&mut self.near);
        near.clear();
        let (mut shut, mut last) = (false, None);
        for between in between {
            if !between.shade.contains(s) {
                continue;
            }
            let object = between.screen.object;
            let mut verdict = between.shadow.as_ref().map_or(UNKNOWN, |shadow| shadow.verdict(s));
            if verdict == UNKNOWN {
                verdict = between.view.verdict(way);
                if let Some(shadow) = &between.shadow {
                    if verdict == UNKNOWN {
                        let among = Among::Near(std::slice::from_ref(&object));
                        let blocker = geometry.occluders_among(among, &ray, range, &mut self.occluders);
                        verdict = if blocker.is_some() { SHUT } else { OPEN };
                    }
                    shadow.note(s, verdict);
                }
            }
            if verdict == SHUT {
                shut = true;
                break;
            }
            if verdict == UNKNOWN {
                near.push(object);
                last = between.shell;
            }
        }
        let color = if shut {
            self.statistics.shadow_rays += 1;
            Rgb::ZERO
        } else if near.is_empty() {
            self.statistics.lights_open += 1;
            match beam.air {
                Some(depth) => incident.color * transmittance(depth * range.max as f32),
                None => incident.color,
            }
        } else if let (Some(depth), [object]) = (last, &near[..])
            && let Some(length) = geometry.way_out(*object, &ray, range)
        {
            self.statistics.shadow_rays += 1;
            incident.color * transmittance(depth * length as f32)
        } else {
            self.statistics.shadow_rays += 1;
            let among = Some(Among::Near(&near));
            self.coming_through(among, march.stretch.inside, light, incident.color, (&ray, range))
        };
        self.near = near;
        color
    }
}
