//! From a compiled scene to a picture.

mod ahead;
mod air;
mod budget;
mod clear;
mod direct;
mod dispersion;
pub mod film;
mod finish;
mod glass;
mod jitter;
mod lamps;
mod layered;
mod lens;
mod media;
mod mesh_camera;
mod mirror;
mod plain;
mod quality;
mod random;
mod reflections;
mod refract;
mod sampling;
mod shade;
mod shadow;
mod stats;
mod textures;
mod tiles;
mod trace;

use std::ops::Range;

pub use film::Image;
pub use sampling::Sample;
pub use stats::Statistics;

use crate::math::tally::Tally;
use crate::math::wide::widest;
use crate::math::{DVec2, Lanes};
use crate::options::{Antialias, AntialiasMethod, Region, RenderOptions, Sampling};
use crate::world::accel::Hull;
use crate::world::atmosphere::Alpha;
use crate::world::camera::{Straight, film};
use crate::world::hit::Hit;
use crate::world::{Ray, RayKind, World};
use quality::Quality;
use random::Random;
use refract::Inside;
use sampling::Look;
use trace::{Path, Tracer};

/// No sample is so many pixels off the film.
const BESIDE: f64 = 8.0;

/// What a pixel shows where the camera has no ray.
const NOWHERE: Sample = [0.0, 0.0, 0.0, 1.0];

/// Watches a rendering; called from its threads.
pub trait Progress: Sync {
    /// `done` of `total` pixels are finished. Calls may arrive out of order.
    fn advance(&self, done: u64, total: u64);

    /// The pixels of a block that an earlier rendering of the same picture gave to
    /// [`keep`](Self::keep), so that it isn't rendered again.
    fn known(&self, _block: &Region) -> Option<Vec<Sample>> {
        None
    }

    /// A block is rendered: its pixels, row by row.
    fn keep(&self, _block: &Region, _pixels: &[Sample]) {}
}

/// Watches nothing.
impl Progress for () {
    fn advance(&self, _done: u64, _total: u64) {}
}

/// A picture and what it took.
#[derive(Clone, Debug, PartialEq)]
pub struct Rendered {
    /// The picture, in the scene's working space.
    pub image: Image,
    /// What ran.
    pub statistics: Statistics,
}

/// Renders a world. The picture doesn't depend on the number of threads.
pub fn render(world: &World, options: &RenderOptions, progress: &dyn Progress) -> Rendered {
    let eye = Eye::new(world, options);
    let mut rendered = match options.sampling {
        Some(Sampling::Budget { seconds, filter }) => budget::render(&eye, seconds, filter, progress),
        _ => tiles::render(options, progress, |block| eye.block(block)),
    };
    rendered.statistics.images = world.needs.images;
    rendered
}

/// The camera with what all its rays share.
struct Eye<'w> {
    world: &'w World,
    options: &'w RenderOptions,
    /// What rays start inside of, where they all start at one point.
    inside: Option<Inside>,
    /// The projection, where rays of samples near each other may travel together.
    straight: Option<Straight<'w>>,
    /// Whether samples are mostly the middles of pixels in a row.
    in_rows: bool,
}

/// An eye, and what it follows rays with.
struct Looking<'e, 'w> {
    eye: &'e Eye<'w>,
    tracer: Tracer<'w>,
}

impl Look for Looking<'_, '_> {
    fn at(&mut self, place: DVec2) -> Sample {
        self.eye.sample(&mut self.tracer, place.x, place.y)
    }

    fn four(&mut self, places: &[DVec2; Lanes::COUNT]) -> [Sample; Lanes::COUNT] {
        self.eye.four(&mut self.tracer, places)
    }

    fn row(&mut self, columns: Range<u32>, row: u32, seen: &mut Vec<Sample>) {
        self.eye.row(&mut self.tracer, columns, row, seen);
    }
}

impl<'w> Eye<'w> {
    fn new(world: &'w World, options: &'w RenderOptions) -> Self {
        let eye = world.camera.eye().or_else(|| {
            // Where no surface is near the places where rays start, they are all inside of the same.
            let starts = world.camera.starts(BESIDE / f64::from(options.width.min(options.height)))?;
            let first = *starts.first()?;
            let finite = starts.iter().all(|start| start.is_finite());
            (finite && world.geometry.is_free(&Hull::new(&starts))).then_some(first)
        });
        let in_rows =
            matches!(&options.antialias, None | Some(Antialias { method: AntialiasMethod::Neighbours, .. }))
                && options.sampling.is_none();
        let camera = &world.camera;
        let simple = camera.blur.is_none() && camera.mesh.is_none() && camera.normal.is_none();
        let straight = camera.projection.straight().filter(|_| simple);
        let inside = eye.map(|point| Inside::of(world.interiors_around(point)));
        Self { world, options, straight, in_rows, inside }
    }

    fn block(&self, block: &Region) -> (Vec<Sample>, Statistics) {
        let working = self.world.settings.working_gamma;
        self.sampled(|look| sampling::block(block, self.options, working, look))
    }

    /// Pixels made of samples at image coordinates, and what they took.
    fn sampled(&self, pixels: impl FnOnce(&mut dyn Look) -> Vec<Sample>) -> (Vec<Sample>, Statistics) {
        let quality = Quality::new(self.options.quality);
        let alpha = if self.options.output_alpha { Alpha::Stored } else { Alpha::None };
        let pixel = f64::from(self.options.width.max(self.options.height)).recip();
        let tracer = Tracer::new(self.world, quality, alpha, pixel);
        // What the thread counted before belongs to other work.
        Tally::take();
        let mut looking = Looking { eye: self, tracer };
        let pixels = pixels(&mut looking);
        let mut tracer = looking.tracer;
        tracer.statistics.pixels += pixels.len() as u64;
        tracer.statistics.add(Tally::take());
        (pixels, tracer.statistics)
    }

    /// The colour and transmit at image coordinates.
    fn sample(&self, tracer: &mut Tracer, x: f64, y: f64) -> Sample {
        tracer.statistics.samples += 1;
        let camera = &self.world.camera;
        if let Some(mesh) = &camera.mesh {
            return self.through_mesh(tracer, mesh, x, y);
        }
        if let Some(blur) = &camera.blur {
            return widest(
                #[inline(always)]
                || self.through_lens(tracer, blur, x, y),
            );
        }
        if let Some(straight) = self.straight.filter(|_| self.in_rows)
            && let Some(sample) = self.looked_ahead(tracer, straight, x, y)
        {
            return sample;
        }
        match camera.ray(film(x, y, self.options.width, self.options.height)) {
            Some(ray) => self.seen(tracer, ray, (x, y), f64::INFINITY),
            None => NOWHERE,
        }
    }

    /// The colour and transmit along a ray through image coordinates, up to some distance.
    #[inline]
    fn seen(&self, tracer: &mut Tracer, ray: Ray, (x, y): (f64, f64), reach: f64) -> Sample {
        let mut path = self.set_off(tracer, ray, (x, y));
        tracer.trace_within(&mut path, reach).sample()
    }

    /// The same along a ray of which it is known what it meets first.
    #[inline]
    fn met(&self, tracer: &mut Tracer, ray: Ray, place: (f64, f64), hit: &Option<Hit>) -> Sample {
        let mut path = self.set_off(tracer, ray, place);
        tracer.trace_from(&mut path, hit).sample()
    }

    /// A ray of the camera, about to be traced.
    #[inline]
    fn set_off(&self, tracer: &mut Tracer, ray: Ray, (x, y): (f64, f64)) -> Path {
        tracer.statistics.camera_rays += 1;
        tracer.random = Random::of_sample(x, y, self.options.seed);
        let inside = match &self.inside {
            Some(inside) => inside.clone(),
            None => Inside::of(self.world.interiors_around(ray.origin)),
        };
        Path { ray, level: 0, weight: 1.0, kind: RayKind::IMAGE, wavelength: None, inside }
    }
}
