//! Media along a stretch of a ray (docs/spec/atmosphere-gi.md 2): what they add to the light from
//! behind and what they leave of it.

mod adaptive;
mod halves;
mod intervals;
mod lamps;
mod sample;
mod shade;
mod strata;

use smallvec::SmallVec;

use super::refract::Inside;
use super::trace::Tracer;
use crate::math::color::grey;
use crate::math::{Bounds, DVec3, Rgb};
use crate::world::accel::{Hull, Points};
use crate::world::atmosphere::Veil;
use crate::world::light::set::Numbers;
use crate::world::media::{Method, Sampling};
use crate::world::{Light, LightSet, Media, Range, Ray, World};
pub(super) use halves::Parts;
pub(super) use intervals::{Beam, Between};
use intervals::{Interval, Shadow, intervals};
use sample::Sample;

/// When no more than this is left of the light from behind, what lies behind isn't looked at.
const NOTHING: f32 = 1e-7;

/// The part of a stretch at its ends that is without samples.
const END: f64 = 1e-9;

/// Media at one place: those of all interiors around it, or of the air.
pub(super) type Mix<'w> = SmallVec<[&'w Media; 4]>;

/// A stretch of a ray through the same media.
#[derive(Debug)]
pub(super) struct Stretch<'a> {
    /// Starts where the stretch does; unit direction.
    pub(super) ray: Ray,
    /// Its length.
    pub(super) length: f64,
    /// What is around it.
    pub(super) inside: &'a Inside,
    /// At least one.
    pub(super) media: Mix<'a>,
    /// The lamps that may light it; `None` where that isn't asked.
    pub(super) lights: Option<&'a LightSet>,
}

/// A stretch being walked along.
struct March<'s, 'w> {
    stretch: &'s Stretch<'w>,
    /// The rule of the medium with the most intervals.
    rule: &'w Sampling,
    /// The least `aa_threshold` of all.
    threshold: f32,
    beams: Vec<Beam>,
    between: Vec<Between>,
    /// Whether lamps make a difference.
    scatters: bool,
    /// What a unit does, where it is the same everywhere but for lamps.
    uniform: Option<Sample>,
    /// What a unit scatters, where that is the same everywhere.
    scattered: Rgb,
}

/// The media of all interiors around a ray.
pub(super) fn mix<'w>(world: &'w World, inside: &Inside) -> Mix<'w> {
    let mut mix = Mix::new();
    for number in inside.numbers() {
        for media in &world.interiors[number as usize].media {
            mix.push(media);
        }
    }
    mix
}

impl Tracer<'_> {
    /// What media do to the light that comes along a stretch.
    pub(super) fn media(&mut self, stretch: &Stretch) -> Veil {
        self.statistics.media_stretches += 1;
        let scatters = stretch.media.iter().any(|media| media.scattering != Rgb::ZERO);
        let glows = scatters || stretch.media.iter().any(|media| media.emission != Rgb::ZERO);
        let mut march = March::new(stretch, scatters);
        if let (Some(uniform), false) = (march.uniform, glows) {
            return veil(Rgb::ZERO, transmittance(uniform.depth * stretch.length as f32));
        }
        // The lists of the last march have room.
        march.beams = std::mem::take(&mut self.beams);
        march.beams.clear();
        march.between = std::mem::take(&mut self.between);
        march.between.clear();
        self.look_for_lamps(&mut march);
        let (mut added, mut depth, mut left) = (Rgb::ZERO, Rgb::ZERO, Rgb::ONE);
        for interval in &intervals(march.rule, &march.beams, stretch.length) {
            let seen = match march.uniform {
                Some(unit) if !(scatters && interval.lit) => self.uniform(&march, interval, unit),
                _ => self.interval(&march, interval),
            };
            added += left * seen.source;
            depth += seen.depth;
            left = transmittance(depth);
            if left.max_element() < NOTHING {
                left = Rgb::ZERO;
                break;
            }
        }
        self.beams = march.beams;
        self.between = march.between;
        veil(added, left)
    }

    /// What media leave of a lamp's light on a stretch of its way (docs/spec/atmosphere-gi.md 2.10).
    pub(super) fn media_shadow(&mut self, stretch: &Stretch) -> Rgb {
        if !stretch.media.iter().any(|media| media.dims()) {
            return Rgb::ONE;
        }
        let march = March::new(stretch, false);
        if let Some(uniform) = march.uniform {
            return transmittance(uniform.depth * stretch.length as f32);
        }
        let intervals = intervals(march.rule, &[], stretch.length);
        let depth = intervals.iter().map(|interval| match march.rule.method {
            Method::Adaptive { .. } => self.adaptive_depth(&march, interval),
            Method::Random(_) | Method::Even(_) => self.stratified_depth(&march, interval),
        });
        transmittance(depth.sum())
    }

    /// Samples an interval by the rule of its media.
    fn interval(&mut self, march: &March, interval: &Interval) -> Sample {
        match &march.rule.method {
            Method::Random(extra) => self.stratified(march, interval, extra, false),
            Method::Even(extra) => self.stratified(march, interval, extra, true),
            Method::Adaptive { level, .. } => self.adaptive(march, interval, *level),
        }
    }

    /// An interval that is the same everywhere and unlit.
    fn uniform(&mut self, march: &March, interval: &Interval, unit: Sample) -> Sample {
        match &march.rule.method {
            Method::Adaptive { .. } => {
                adaptive::uniform(unit.scaled(interval.length), march.rule.min_samples)
            }
            _ => self.interval(march, interval),
        }
    }

    /// The optical depth of a unit of an object's filling, if the object is a clear, convex shell that
    /// alone is around a stretch, and its filling takes light the same way everywhere.
    fn shell(&self, object: u32, inside: &Inside) -> Option<Rgb> {
        let leaf = self.world.geometry.shell(object)?;
        let interior = &self.world.interiors[leaf.interior as usize];
        let plain = interior.caustics == 0.0 && interior.fade.is_none() && interior.hollow;
        let even = interior.media.iter().all(|media| media.density.is_uniform());
        let alone = inside.is_only(leaf.interior);
        (plain && even && alone).then(|| depth_of_a_unit(&interior.media))
    }

    /// The lamps that reach a stretch, and where (docs/spec/atmosphere-gi.md 2.5).
    fn look_for_lamps(&mut self, march: &mut March) {
        let (stretch, geometry) = (march.stretch, &self.world.geometry);
        let mut screens = std::mem::take(&mut self.screens);
        let (even_air, mut room) = (self.even_air(), Numbers::new());
        for &number in stretch.lights.map_or(&[][..], |lights| lights.beside(&stretch.ray, &mut room)) {
            let light = &self.world.lights[number as usize];
            if !light.media_interaction || light.shadowless {
                continue;
            }
            let Some(reach) = light.reach(&stretch.ray, stretch.length) else { continue };
            let margin = stretch.length * march.rule.jitter.abs();
            let one_place = light.area.is_none() && !light.runs_parallel();
            let simple = one_place && light.projected_through.is_none();
            let dims = self.dims(light);
            let air = even_air.filter(|_| dims);
            let simple = simple && self.quality.shadows && (!dims || air.is_some());
            let mut points = Points::new();
            let few = march.scatters
                && bundle(stretch, march.rule, light, reach, &mut points)
                && geometry.between(&Hull::new(&points), &mut screens);
            let among = few.then(|| {
                let first = march.between.len();
                for screen in &screens {
                    let mut shade = Range::LINE;
                    if one_place {
                        let bounds = geometry.bounds(screen.object);
                        match shade::shade(&bounds, &stretch.ray, light.location) {
                            Some(found)
                                if !(found.max < reach.min - margin || found.min > reach.max + margin) =>
                            {
                                shade = found;
                            }
                            _ => continue,
                        }
                    }
                    let whole = simple && geometry.hides_a_stretch(screen.object, light.location);
                    march.between.push(Between {
                        screen: *screen,
                        shade,
                        view: screen.from(light.location),
                        shadow: whole.then(Shadow::default),
                        shell: if simple && !dims { self.shell(screen.object, stretch.inside) } else { None },
                    });
                }
                first..march.between.len()
            });
            march.beams.push(Beam { light: number, reach, among, simple, air });
        }
        self.screens = screens;
    }
}

/// Finds the corners of what encloses all ways from a stretch to a lamp; tells whether that is known.
fn bundle(stretch: &Stretch, rule: &Sampling, light: &Light, reach: Range, points: &mut Points) -> bool {
    // Jitter may take samples out of their interval. Without it none lies on the very end, where a
    // surface is.
    let margin = stretch.length * if rule.jitter == 0.0 { -END } else { rule.jitter.abs() };
    let ends = [reach.min - margin, reach.max + margin].map(|s| stretch.ray.at(s));
    points.extend(ends);
    match &light.area {
        Some(_) if light.parallel => return false,
        Some(area) if !area.orient => {
            points.push(light.location);
            points.extend(area.corners(area.axes).map(|corner| light.location + corner));
        }
        Some(area) => {
            points.push(light.location);
            let radius = DVec3::splat(area.radius());
            points.extend(Bounds::new(light.location - radius, light.location + radius).corners());
        }
        // All ways lead there.
        None if !light.runs_parallel() => points.insert(0, light.location),
        None => points.extend(ends.map(|end| {
            let incident = light.reaching(end);
            end + incident.distance * incident.direction
        })),
    }
    points.iter().all(|point| point.is_finite())
}

impl<'s, 'w> March<'s, 'w> {
    fn new(stretch: &'s Stretch<'w>, scatters: bool) -> Self {
        let mut rule = &stretch.media[0].sampling;
        let mut threshold = f32::INFINITY;
        for media in &stretch.media {
            if media.sampling.intervals > rule.intervals {
                rule = &media.sampling;
            }
            if let Method::Adaptive { threshold: own, .. } = media.sampling.method {
                threshold = threshold.min(own);
            }
        }
        let same = stretch.media.iter().all(|media| media.density.is_uniform());
        let uniform = same.then(|| {
            stretch.media.iter().fold(Sample::NOTHING, |sum, media| {
                let density = media.density.uniform;
                sum + Sample { source: density * media.emission, depth: density * media.extinction }
            })
        });
        let scattered = stretch.media.iter().map(|media| media.density.uniform * media.scattering).sum();
        Self {
            stretch,
            rule,
            threshold,
            beams: Vec::new(),
            between: Vec::new(),
            scatters,
            uniform,
            scattered,
        }
    }
}

/// The optical depth of a unit of media that are the same everywhere.
pub(super) fn depth_of_a_unit<'m>(media: impl IntoIterator<Item = &'m Media>) -> Rgb {
    media.into_iter().map(|media| media.density.uniform * media.extinction).sum()
}

fn veil(added: Rgb, factor: Rgb) -> Veil {
    Veil { added, factor, transmit: grey(factor) }
}

/// The share of light left after an optical depth; depths below 0 brighten, but not without end.
pub(super) fn transmittance(depth: Rgb) -> Rgb {
    let exponent = (-depth).min(Rgb::splat(80.0));
    let grey = exponent.x == exponent.y && exponent.y == exponent.z;
    if grey { Rgb::splat(exponent.x.exp()) } else { exponent.exp() }
}
