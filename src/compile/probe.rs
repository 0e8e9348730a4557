//! Single objects for the language's `trace`, `inside`, `min_extent` and `max_extent`.

use std::sync::Arc;

use super::Unsupported;
use super::flatten::Flattener;
use super::object::ShapeCache;
use crate::math::{Band, Bounds, DVec3};
use crate::options::Accelerator;
use crate::scene::settings::Settings;
use crate::scene::{Object, Shape};
use crate::world::{Geometry, Inside, Range, Ray, RayKind};

/// An object that can be asked about its geometry, in the space it is written in.
#[derive(Debug)]
pub struct Probe {
    geometry: Geometry,
    extent: Bounds,
}

/// The big primitives of objects that were asked about while their scene was read: who compiles the scene need not make
/// them again.
#[derive(Debug, Default)]
pub struct Known {
    /// What holds for all of them.
    settings: Option<Settings>,
    shapes: ShapeCache,
}

impl Known {
    /// Hands out what was made with these settings.
    pub(super) fn take(&mut self, settings: &Settings) -> ShapeCache {
        let shapes = std::mem::take(&mut self.shapes);
        if self.settings.as_ref() == Some(settings) { shapes } else { ShapeCache::default() }
    }

    /// Keeps what was made with these settings, but for what takes note of the rays that ask it.
    fn keep(&mut self, settings: &Settings, mut shapes: ShapeCache) {
        shapes.retain(|_, (shape, _)| !matches!(shape, Shape::Isosurface(_) | Shape::Parametric(_)));
        self.shapes = shapes;
        if self.settings.as_ref() != Some(settings) {
            self.settings = Some(settings.clone());
        }
    }
}

/// Nearer surfaces are not traced (docs/spec/primitives.md 1.2).
const NEAREST: f64 = 1e-4;

impl Probe {
    /// Compiles the geometry of an object, and nothing else of it. The settings are for its functions.
    ///
    /// # Errors
    /// The parts that povista can't compile yet.
    pub fn new(object: &Arc<Object>, settings: &Settings) -> Result<Self, Vec<Unsupported>> {
        Self::knowing(object, settings, &mut Known::default())
    }

    /// The same with what is known from objects before, to which what is new is added.
    ///
    /// # Errors
    /// The parts that povista can't compile yet.
    pub fn knowing(
        object: &Arc<Object>,
        settings: &Settings,
        known: &mut Known,
    ) -> Result<Self, Vec<Unsupported>> {
        let mut flattener = Flattener::new(settings, Accelerator::Auto, false);
        flattener.shapes = known.take(settings);
        flattener.add_whole(object);
        let extent = flattener.reported_extent(object);
        known.keep(settings, std::mem::take(&mut flattener.shapes));
        let flat = flattener.finish();
        if flat.unsupported.is_empty() {
            Ok(Self { geometry: Geometry::new(flat.parts, Accelerator::Auto), extent })
        } else {
            Err(flat.unsupported)
        }
    }

    /// The nearest surface from `origin` towards `direction`, which need not be unit: the point
    /// and the unit normal, outward.
    pub fn trace(&self, origin: DVec3, direction: DVec3) -> Option<(DVec3, DVec3)> {
        let ray = Ray::new(origin, direction.try_normalize()?);
        let range = Range { min: NEAREST.next_down(), max: f64::INFINITY };
        let hit = self.geometry.hit(&ray, range, RayKind::empty())?;
        let surface = self.geometry.surface(&ray, &hit);
        let outward = if surface.inside { -surface.normal } else { surface.normal };
        Some((surface.textured, outward))
    }

    /// Whether `point` is inside.
    pub fn inside(&self, point: DVec3) -> bool {
        !self.geometry.containers(point).is_empty()
    }

    /// The box that `min_extent` and `max_extent` tell of (docs/spec/primitives.md 8).
    pub fn bounds(&self) -> Bounds {
        self.extent
    }
}

/// How patterns ask for the inside of an object.
///
/// # Errors
/// The first part that povista can't compile yet.
pub fn inside_of(object: &Arc<Object>, settings: &Settings) -> Result<Arc<dyn Inside>, Unsupported> {
    match Probe::new(object, settings) {
        Ok(probe) => Ok(Arc::new(probe)),
        Err(lacking) => Err(lacking
            .into_iter()
            .next()
            .unwrap_or_else(|| Unsupported::new(object.span, "this object in a pattern"))),
    }
}

impl Inside for Probe {
    fn inside(&self, point: DVec3) -> bool {
        Probe::inside(self, point)
    }

    fn enclose(&self, point: &[Band; 3]) -> Band {
        self.geometry.inside_along(point)
    }
}
