//! What a ray sees: surfaces one behind the other as far as it goes straight, then the sky
//! (docs/spec/shading.md 4).

use super::ahead::Ahead;
use super::layered::{Foreseen, Layered};
use super::media::{Beam, Between, Parts};
use super::plain::{Bundle, Room};
use super::quality::Quality;
use super::random::Random;
use super::reflections::Reflections;
use super::refract::Inside;
use super::sampling::Sample;
use super::shade::Mirror;
use super::shadow::{Places, Shafts};
use super::stats::Statistics;
use crate::math::{DVec3, Lanes, Rgb};
use crate::world::accel::Within;
use crate::world::atmosphere::{Alpha, Sky};
use crate::world::hit::Hit;
use crate::world::object::LeafFlags;
use crate::world::screen::Screen;
use crate::world::{Light, Range, Ray, RayKind, World};

/// A ray and what it brings along.
#[derive(Clone, Debug)]
pub(super) struct Path {
    /// Where it goes; unit direction.
    pub(super) ray: Ray,
    /// Bends and mirrors before it.
    pub(super) level: u32,
    /// The most it can add to the pixel.
    pub(super) weight: f32,
    /// From the camera, or by way of a mirror.
    pub(super) kind: RayKind,
    /// Its only colour in nanometres; `None` for light of all colours.
    pub(super) wavelength: Option<f64>,
    /// What it is inside of.
    pub(super) inside: Inside,
}

/// What a ray sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Seen {
    /// Colour, multiplied by its opacity.
    pub(super) color: Rgb,
    /// Transparency of the picture there.
    pub(super) transmit: f32,
}

impl Seen {
    /// What a ray sees that isn't traced.
    pub(super) const NOTHING: Self = Self { color: Rgb::ZERO, transmit: 0.0 };

    fn of(sky: Sky) -> Self {
        Self { color: sky.color, transmit: sky.transmit }
    }

    /// The sample that is.
    #[inline]
    pub(super) fn sample(self) -> Sample {
        let [red, green, blue] = self.color.to_array();
        [red, green, blue, self.transmit]
    }
}

/// Follows rays; one for each thread.
#[derive(Debug)]
pub(super) struct Tracer<'w> {
    pub(super) world: &'w World,
    pub(super) quality: Quality,
    /// Whether the picture has an alpha channel.
    pub(super) alpha: Alpha,
    pub(super) statistics: Statistics,
    pub(super) random: Random,
    /// Lights of the hits being shaded, those of the innermost last.
    pub(super) arrivals: Vec<super::direct::Arrival>,
    /// Reflections of the layers being shaded, those of the innermost last.
    pub(super) mirrors: Vec<Mirror>,
    /// Transparent surfaces on the way of the shadow ray at hand.
    pub(super) occluders: Vec<Hit>,
    /// What was in the way of the last shadow ray, and so probably is in that of the next.
    pub(super) blocker: Option<u32>,
    /// The same for each lamp.
    pub(super) blockers: Vec<Option<u32>>,
    /// The lamps of a march through media, and what stands before them.
    pub(super) beams: Vec<Beam>,
    pub(super) between: Vec<Between>,
    /// The parts of the stretch of media at hand.
    pub(super) parts: Parts,
    /// Pixels that were looked at before somebody asks for them.
    pub(super) ahead: Ahead,
    /// What is known of surfaces that bundles met, that of the innermost last, and of how many bundles it is kept.
    pub(super) layered: Vec<Layered>,
    pub(super) bundles: usize,
    /// The one of them that is shaded next.
    pub(super) foreseen: Option<Foreseen>,
    /// What the rays through the lens at hand may meet.
    pub(super) within: Within,
    /// The pixels for which that was found, by image coordinates of the first, and whether it is known.
    pub(super) row: Option<([f64; 2], bool)>,
    /// What they may meet after flat mirrors.
    pub(super) reflections: Reflections,
    /// What may be in the way of the light at hand.
    pub(super) near: Vec<u32>,
    pub(super) screens: Vec<Screen>,
    /// What the places of the area light at hand show.
    pub(super) places: Places,
    /// What may be in the way between cells of space and lamps.
    pub(super) shafts: Shafts,
    /// The size of a pixel at distance 1, roughly.
    pub(super) pixel: f64,
    /// Whether anything may be shaded as what is [`plain`](Self::plain).
    pub(super) plain: bool,
    /// Whether anything may be shaded as what is [`clear`](Self::clear): no interior splits light.
    pub(super) clear: bool,
    /// Whether no ray of the camera takes random numbers before it is bent or mirrored: there is nothing in the air, and
    /// no lamp is a grid. Nor is any ray of the camera left out.
    pub(super) calm: bool,
    /// Whether rays may go on together through what is [`clear`](Self::clear): none takes random numbers at all, and there
    /// are so few objects that four rays ask for all of them at once.
    pub(super) glassy: bool,
    /// What other rays see of a sky of one colour, and rays from the camera.
    even_sky: Option<[Seen; 2]>,
}

impl<'w> Tracer<'w> {
    /// A tracer without any history.
    pub(super) fn new(world: &'w World, quality: Quality, alpha: Alpha, pixel: f64) -> Self {
        // Who lights place by place, or looks at nothing or at what is behind opaque layers, is another matter.
        let by_place = |light: &Light| light.area.as_ref().is_some_and(|area| area.area_illumination);
        let bailout = world.settings.adc_bailout;
        let plain = !quality.flat && (0.0..1.0).contains(&bailout) && !world.lights.iter().any(by_place);
        let airy = !world.atmosphere.is_clear() || world.needs.media;
        let calm = !airy && world.lights.iter().all(|light| light.area.is_none());
        let version = world.settings.version;
        let clear = plain && world.interiors.iter().all(|interior| interior.dispersion == 1.0);
        let sky = |eye| Seen::of(world.atmosphere.sky(DVec3::Y, alpha, eye, version));
        Self {
            plain,
            clear,
            glassy: clear && calm && !world.needs.grain && world.geometry.is_little(),
            calm: calm && world.settings.max_trace_level > 0 && bailout <= 1.0,
            even_sky: world.atmosphere.is_even().then(|| [false, true].map(sky)),
            world,
            quality,
            alpha,
            statistics: Statistics::default(),
            random: Random::default(),
            arrivals: Vec::new(),
            mirrors: Vec::new(),
            occluders: Vec::new(),
            blocker: None,
            blockers: vec![None; world.lights.len()],
            beams: Vec::new(),
            between: Vec::new(),
            parts: Parts::default(),
            ahead: Ahead::default(),
            layered: Vec::new(),
            bundles: 0,
            foreseen: None,
            within: Within::default(),
            row: None,
            reflections: Reflections::default(),
            near: Vec::new(),
            screens: Vec::new(),
            places: Places::default(),
            shafts: Shafts::default(),
            pixel,
        }
    }

    /// Traces a ray to its end. The tree of bent and mirrored rays is as deep as `max_trace_level`;
    /// straight transmission uses up no level, so it is a loop.
    pub(super) fn trace(&mut self, path: &mut Path) -> Seen {
        self.trace_within(path, f64::INFINITY)
    }

    /// The same for a ray that misses what is not nearer than `reach`.
    pub(super) fn trace_within(&mut self, path: &mut Path, reach: f64) -> Seen {
        if !self.allowed(path) {
            return Seen::NOTHING;
        }
        let hit = self.world.geometry.hit(&path.ray, Range { min: 0.0, max: reach }, path.kind);
        self.follow(path, &hit)
    }

    /// The same for a ray of which it is known what it meets first.
    pub(super) fn trace_from(&mut self, path: &mut Path, hit: &Option<Hit>) -> Seen {
        if self.allowed(path) { self.follow(path, hit) } else { Seen::NOTHING }
    }

    /// The same for those rays of a bundle whose bits are `asked`, where the air is [`calm`](Self::calm); whether they come
    /// from the `EYE` as far as they are known. Each is shown with its lane.
    #[inline(always)]
    pub(super) fn trace_bundle<const EYE: bool>(
        &mut self,
        path: &mut Path,
        bundle: &Bundle<{ Lanes::COUNT }>,
        room: &mut Room<{ Lanes::COUNT }>,
        asked: u32,
        mut show: impl FnMut(usize, Seen),
    ) {
        path.level += 1;
        let plain = self.plain::<_, EYE>(path, bundle, room);
        let mut open = 0u32;
        for (lane, (color, hit)) in plain.iter().zip(&bundle.hits).enumerate() {
            open |= u32::from(color.is_none() && hit.is_some()) << lane;
        }
        let (mut clear, mut told) = ([Seen::NOTHING; Lanes::COUNT], 0);
        if self.glassy && open.count_ones() > 1 {
            told = self.clear_together(path, bundle, open, room, &mut clear);
            open &= !told;
        }
        path.level -= 1;
        let several = open.count_ones() > 1;
        if several {
            self.look_at_layers(bundle, open);
        }
        for lane in 0..Lanes::COUNT {
            if asked >> lane & 1 == 0 {
                continue;
            }
            // Shown where it is known: what comes together from several places goes through memory.
            match (plain[lane], bundle.hits[lane]) {
                (Some(color), _) => show(lane, Seen { color, transmit: 0.0 }),
                _ if told >> lane & 1 == 1 => show(lane, clear[lane]),
                (None, None) => {
                    path.ray.direction = bundle.rays[lane].direction;
                    show(lane, self.sky(path));
                }
                (None, hit) => {
                    (path.ray, path.weight) = (bundle.rays[lane], bundle.weights[lane]);
                    self.random = bundle.randoms.map_or(self.random, |randoms| randoms[lane]);
                    self.foreseen = if several { self.foresee(lane) } else { None };
                    show(lane, self.follow(&mut path.clone(), &hit.copied()));
                }
            }
        }
        if several {
            self.forget();
        }
    }

    /// Follows a ray from what it meets first.
    fn follow(&mut self, path: &mut Path, first: &Option<Hit>) -> Seen {
        let mut hit = first;
        let mut beyond;
        let mut room = Room::NEW;
        // For the surface that is met first, and for no ray that it sends out.
        let mut foreseen = self.foreseen.take();
        let (mut color, mut transmit) = (Rgb::ZERO, 0.0);
        // What the way so far leaves of the light and of the transparency behind.
        let (mut left, mut clear) = (Rgb::ONE, 1.0);
        path.level += 1;
        loop {
            let known = foreseen.take();
            if self.is_airy(path, hit.is_some()) {
                let veil = self.air(path, hit.as_ref());
                color += left * veil.added;
                left *= veil.factor;
                clear *= veil.transmit;
            }
            // By reference: copying what was only just written would wait for it.
            let Some(met) = hit else {
                let sky = self.sky(path);
                color += left * sky.color;
                transmit += clear * sky.transmit;
                break;
            };
            let shaded = if self.world.geometry.parts().leaf(met.leaf).flags.contains(LeafFlags::OPAQUE) {
                let (rays, weights) = ([path.ray], [path.weight]);
                let alone = Bundle { rays, weights, hits: [Some(met)], randoms: None };
                if let [Some(seen)] = self.plain::<1, false>(path, &alone, &mut room) {
                    color += left * seen;
                    break;
                }
                self.shade(path, met, known)
            } else if let Some(shaded) = self.clear(path, met) {
                shaded
            } else {
                self.shade(path, met, known)
            };
            color += left * shaded.color;
            transmit += clear * shaded.transmit;
            let Some(onward) = shaded.onward else { break };
            self.statistics.transmitted_rays += 1;
            left *= onward.left;
            clear *= onward.clear;
            path.ray = onward.ray;
            path.weight = onward.weight;
            path.inside = onward.inside;
            if !self.allowed(path) {
                break;
            }
            beyond = self.world.geometry.hit(&path.ray, Range::AHEAD, path.kind);
            hit = &beyond;
        }
        Seen { color, transmit }
    }

    /// Whether a ray is neither too deep nor too faint.
    #[inline]
    fn allowed(&mut self, path: &Path) -> bool {
        self.is_allowed(path.level, path.weight)
    }

    /// The same for a ray at a level with a weight.
    #[inline]
    pub(super) fn is_allowed(&mut self, level: u32, weight: f32) -> bool {
        let settings = &self.world.settings;
        let (deep, faint) = (level >= settings.max_trace_level, weight < settings.adc_bailout);
        self.statistics.too_deep += u64::from(deep);
        self.statistics.bailed_out += u64::from(faint && !deep);
        !deep && !faint
    }

    /// What rays from the camera see that meet nothing, where that is the same for all.
    #[inline]
    pub(super) fn open_sky(&self) -> Option<Sample> {
        self.even_sky.filter(|_| self.calm).map(|[_, eye]| eye.sample())
    }

    #[inline]
    fn sky(&mut self, path: &Path) -> Seen {
        self.statistics.sky_evaluations += 1;
        let (direction, eye) = (path.ray.direction, path.kind == RayKind::IMAGE);
        match &self.even_sky {
            Some(even) => even[usize::from(eye)],
            None => {
                let version = self.world.settings.version;
                Seen::of(self.world.atmosphere.sky(direction, self.alpha, eye, version))
            }
        }
    }
}
