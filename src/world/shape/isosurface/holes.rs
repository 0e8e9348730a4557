//! Surfaces of patterns with a `max_gradient` that is far too low: none has a hole.

use std::sync::Arc;

use super::{Container, Isosurface, Steepest};
use crate::math::{DVec2, DVec3};
use crate::world::image::{self, Image, ImageMap, Pixels};
use crate::world::pattern::crackle::{Crackle, Metric};
use crate::world::pattern::{Formula, Pattern, quilted};
use crate::world::sample::Field;
use crate::world::shape::Shape;
use crate::world::shape::battery::Dice;
use crate::world::shape::r#box::Cuboid;
use crate::world::warp::{BlackHole, Mapping, Projection, Repeat, Warp, Warps};
use crate::world::{Range, Ray};

/// Half the side of the container.
const HALF: f64 = 2.0;

/// Places along a ray at which the function is asked.
const PLACES: u32 = 3000;

/// Checks that rays go no farther than to the first place where the function is below the threshold.
#[track_caller]
fn has_no_holes(pattern: Pattern, threshold: f64) {
    let cube = Cuboid { min: DVec3::splat(-HALF), max: DVec3::splat(HALF) };
    let function: Arc<dyn Field> = Arc::new(pattern.clone());
    let surface = Isosurface {
        function: function.clone(),
        threshold,
        container: Container::Box(cube),
        accuracy: 1e-3,
        max_gradient: 1e-3,
        adaptive: None,
        most: 1,
        open: false,
        steepest: Steepest::default(),
    };
    let mut met = 0;
    for number in 0..150 {
        let mut dice = Dice::new(number);
        let origin = dice.cube().normalize() * 6.0;
        let ray = Ray::new(origin, (dice.cube() * HALF - origin).normalize());
        let Some(stretch) = cube.stretch(&ray) else { continue };
        let at = |step: u32| {
            stretch.enter.t + (stretch.leave.t - stretch.enter.t) * f64::from(step) / f64::from(PLACES)
        };
        let first = (0..=PLACES).map(at).find(|t| function.at(ray.at(*t)) < threshold);
        let Some(first) = first else { continue };
        met += 1;
        let found = surface.nearest(&ray, Range::AHEAD);
        assert!(
            found.is_some_and(|hit| hit.t <= first * (1.0 + 1e-9)),
            "{pattern:?} ray {number}: {first}, found {found:?}"
        );
    }
    assert!(met > 30, "{pattern:?}: {met}");
}

#[test]
fn surfaces_of_cells_have_no_holes() {
    let crackle = |form: [f64; 3], metric: f64, solid: Option<u8>| {
        let (form, metric) = (form.into(), Metric::new(metric));
        Formula::Crackle(Box::new(Crackle { form, metric, offset: 0.0, solid }))
    };
    has_no_holes(Pattern::plain(Formula::Cells), 0.3);
    has_no_holes(Pattern::plain(Formula::Checker), 0.5);
    has_no_holes(Pattern::plain(Formula::Quilted(quilted::Quilted { control0: 1.0, control1: 1.0 })), 0.05);
    has_no_holes(Pattern::plain(crackle([1.0, 0.0, 0.0], 2.0, None)), 0.15);
    has_no_holes(Pattern::plain(crackle([-1.0, 1.0, 0.0], 2.0, None)), 0.02);
    has_no_holes(Pattern::plain(crackle([-1.0, 1.0, 0.0], 1.0, None)), 0.05);
    has_no_holes(Pattern::plain(crackle([1.0, 0.0, 0.0], 3.0, None)), 0.15);
    has_no_holes(Pattern::plain(crackle([1.0, 0.0, 0.0], 2.0, Some(2))), 0.4);
}

#[test]
fn surfaces_of_images_have_no_holes() {
    let data = (0..16 * 16).map(|n: u32| if n % 17 == 3 { 0 } else { 200 }).collect();
    let curve = (0..256).map(|v| v as f32 / 255.0).collect();
    let pixels = Pixels::Bytes { channels: 1, data, curve };
    let image = Arc::new(Image { width: 16, height: 16, pixels, premultiplied: false, has_alpha: false });
    for (projection, interpolation) in [
        (image::Projection::Planar, image::Interpolation::None),
        (image::Projection::Planar, image::Interpolation::Bilinear),
        (image::Projection::Spherical, image::Interpolation::Bicubic),
        (image::Projection::Cylindrical, image::Interpolation::NormalizedDistance),
        (image::Projection::Torus, image::Interpolation::Bilinear),
    ] {
        let map = ImageMap {
            image: image.clone(),
            projection,
            interpolation,
            once: false,
            scale: DVec2::splat(16.0),
            offset: DVec2::ZERO,
            clearness: [0.0; 2],
            use_index: false,
            use_alpha: false,
        };
        has_no_holes(Pattern::plain(Formula::Image(Box::new(map))), 0.3);
    }
}

#[test]
fn surfaces_of_warped_patterns_have_no_holes() {
    let hole = BlackHole {
        center: DVec3::splat(0.3),
        radius: 1.5,
        strength: 0.9,
        falloff: 2.0,
        inverse: false,
        repeat: Some(DVec3::splat(2.0)),
        turbulence: DVec3::splat(0.3),
    };
    let repeat = Repeat::new(DVec3::X * 0.3, DVec3::Y * 0.2, DVec3::Z);
    let around = Mapping { projection: Projection::Spherical, orientation: DVec3::Z, dist_exp: 1.0 };
    for warp in [
        Warp::BlackHole(Box::new(hole)),
        Warp::Repeat(Box::new(repeat)),
        Warp::Mapping(Box::new(around)),
        Warp::Cubic,
    ] {
        let finer = Warp::Transform(Box::new(crate::math::Transform::scale(DVec3::splat(0.15))));
        let warps = Warps::new([warp, finer]);
        has_no_holes(Pattern { warps, ..Pattern::plain(Formula::Bozo(2)) }, 0.25);
    }
}
