//! Surfaces of patterns with a `max_gradient` that is far too low: none has a hole.

use std::sync::Arc;

use super::{Container, Isosurface, Steepest};
use crate::math::{Band, DVec2, DVec3};
use crate::world::image::{self, Image, ImageMap, Pixels};
use crate::world::pattern::crackle::{Crackle, Metric};
use crate::world::pattern::density_file::{self, DensityFile};
use crate::world::pattern::mandel::{Fractal, Iteration};
use crate::world::pattern::pavement::Pavement;
use crate::world::pattern::penrose::Penrose;
use crate::world::pattern::spiral::Spiral;
use crate::world::pattern::tiling::Tiling;
use crate::world::pattern::{Formula, Pattern, Wave, brick, quilted};
use crate::world::sample::{Field, Inside};
use crate::world::shape::Shape;
use crate::world::shape::battery::Dice;
use crate::world::shape::r#box::Cuboid;
use crate::world::shape::curve::{Curve, Segment};
use crate::world::shape::height_field::HeightField;
use crate::world::shape::lathe::Lathe;
use crate::world::shape::prism::Prism;
use crate::world::shape::sor::Sor;
use crate::world::shape::torus::Torus;
use crate::world::warp::{BlackHole, Mapping, Projection, Repeat, Warp, Warps};
use crate::world::{Range, Ray};

/// Half the side of the container.
const HALF: f64 = 2.0;

/// Places along a ray at which the function is asked.
const PLACES: u32 = 3000;

/// Where a function is at a threshold in a cube, searched for so exactly and with a gradient that is far too low.
fn at_threshold(function: Arc<dyn Field>, threshold: f64, cube: Cuboid, accuracy: f64) -> Isosurface {
    Isosurface {
        function,
        threshold,
        container: Container::Box(cube),
        accuracy,
        max_gradient: 1e-3,
        adaptive: None,
        most: 1,
        open: false,
        steepest: Steepest::default(),
    }
}

/// Checks that rays go no farther than to the first place where the function is below the threshold.
#[track_caller]
fn has_no_holes(pattern: Pattern, threshold: f64) {
    let cube = Cuboid { min: DVec3::splat(-HALF), max: DVec3::splat(HALF) };
    let function: Arc<dyn Field> = Arc::new(pattern.clone());
    let surface = at_threshold(function.clone(), threshold, cube, 1e-3);
    let mut met = 0;
    for number in 0..150 {
        let mut dice = Dice::new(number);
        let origin = dice.cube().normalize() * 6.0;
        let ray = Ray::new(origin, (dice.cube() * HALF - origin).normalize());
        let Some(stretch) = cube.stretch(&ray) else { continue };
        let at = |step: u32| {
            stretch.enter.t + (stretch.leave.t - stretch.enter.t) * f64::from(step) / f64::from(PLACES)
        };
        // What is thinner than the accuracy may be missed where a function jumps to and fro.
        let is_below = |t: f64| t < stretch.leave.t && function.at(ray.at(t)) < threshold;
        let first = (0..=PLACES).map(at).find(|t| (0..=4).all(|part| is_below(t + 3e-4 * f64::from(part))));
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
    has_no_holes(Pattern::plain(crackle([-1.0, 1.0, 0.0], 0.7, None)), 0.05);
    has_no_holes(Pattern::plain(Formula::Cubic), 1.5);
    has_no_holes(Pattern::plain(Formula::Brick(brick::Brick::new(DVec3::new(0.8, 0.3, 0.5), 0.02))), 0.5);
}

#[test]
fn surfaces_of_floors_have_no_holes() {
    has_no_holes(Pattern::plain(Formula::Hexagon), 0.5);
    has_no_holes(Pattern::plain(Formula::Triangular), 1.5);
    has_no_holes(Pattern::plain(Formula::Tiling(Tiling::new(7).unwrap())), 0.3);
    has_no_holes(Pattern::plain(Formula::Tiling(Tiling::new(11).unwrap())), 0.4);
    has_no_holes(Pattern::plain(Formula::Penrose(Penrose::new(25).unwrap())), 0.3);
    has_no_holes(Pattern::plain(Formula::Penrose(Penrose::new(27).unwrap())), 0.1);
    for (floor, threshold) in [([3, 4, 2], 0.05), ([4, 5, 10], 0.03), ([6, 3, 1], 0.05)] {
        let pavement = Pavement::new(floor, 2, 1, 2).unwrap();
        has_no_holes(Pattern::plain(Formula::Pavement(Box::new(pavement))), threshold);
    }
}

#[test]
fn surfaces_of_spirals_have_no_holes() {
    let spiral = Spiral { arms: 5.0, turbulence: None };
    has_no_holes(Pattern { frequency: 3.0, ..Pattern::plain(Formula::Spiral1(spiral)) }, 0.05);
    has_no_holes(Pattern { frequency: 3.0, ..Pattern::plain(Formula::Spiral2(spiral)) }, 0.05);
}

#[test]
fn surfaces_of_fractals_have_no_holes() {
    for (iteration, julia) in [
        (Iteration::power(2), None),
        (Iteration::power(2), Some(DVec2::new(-0.75, 0.1))),
        (Iteration::power(3), None),
        (Iteration::Magnet1, None),
    ] {
        let fractal = Fractal { iteration, julia, iterations: 30, interior: (0, 0.0), exterior: (1, 1.0) };
        has_no_holes(Pattern::plain(Formula::Fractal(Box::new(fractal))), 0.02);
    }
}

#[derive(Debug)]
struct Solid<S>(S);

impl<S: Shape> Inside for Solid<S> {
    fn inside(&self, point: DVec3) -> bool {
        self.0.inside(point)
    }

    fn enclose(&self, point: &[Band; 3]) -> Band {
        self.0.inside_along(point)
    }
}

/// A pattern that is 0 inside a solid, as inside is what is below the threshold.
fn outside<S: Shape + 'static>(solid: S) -> Pattern {
    let solid = Formula::Object(Arc::new(Solid(solid)));
    Pattern { frequency: 0.5, phase: 0.5, wave: Wave::Triangle, ..Pattern::plain(solid) }
}

#[test]
fn surfaces_of_solids_have_no_holes() {
    has_no_holes(outside(Torus { major: 1.2, minor: 0.4 }), 0.5);
}

/// How thick solids are that are much thinner than the accuracy.
const THIN: f64 = 1e-4;

/// Checks that rays meet what is inside a solid where they meet the surface of the same with all its walls.
#[track_caller]
fn is_met_however_thin<S: Shape + 'static>(solid: S, walls: &dyn Shape, ray: impl Fn(&mut Dice) -> Ray) {
    let cube = Cuboid { min: DVec3::splat(-HALF), max: DVec3::splat(HALF) };
    let surface = at_threshold(Arc::new(outside(solid)), 0.5, cube, 1e-2);
    let mut met = 0;
    for number in 0..2000 {
        let ray = ray(&mut Dice::new(number));
        let Some(expected) = walls.nearest(&ray, Range::AHEAD) else { continue };
        met += 1;
        let found = surface.nearest(&ray, Range::AHEAD);
        assert!(
            found.is_some_and(|hit| (hit.t - expected.t).abs() < 1e-7),
            "{number}: {expected:?}, found {found:?}"
        );
    }
    assert!(met > 200, "{met}");
}

fn from_around(dice: &mut Dice) -> Ray {
    let origin = dice.cube().normalize() * 6.0;
    Ray::new(origin, (dice.cube() * HALF - origin).normalize())
}

fn outline(points: &[(f64, f64)]) -> Vec<Segment> {
    let points: Vec<_> = points.iter().map(|(x, y)| DVec2::new(*x, *y)).collect();
    points.windows(2).map(|ends| Segment::linear(ends[0], ends[1])).collect()
}

/// A frame of thin walls, with thin ends, or without.
#[test]
fn thin_walls_that_only_crossings_tell_are_met() {
    let square = |s: f64| outline(&[(-s, -s), (s, -s), (s, s), (-s, s), (-s, -s)]);
    let walls = Curve::new([square(1.0), square(1.0 - THIN)].concat());
    let frame = Prism { outline: walls, heights: [-0.8, 0.7], conic: false, open: false };
    is_met_however_thin(frame.clone(), &frame, from_around);
    let conic = Prism { heights: [0.4, 1.5], conic: true, ..frame.clone() };
    is_met_however_thin(Prism { open: true, ..frame.clone() }, &frame, from_around);
    is_met_however_thin(Prism { open: true, ..conic.clone() }, &conic, from_around);
}

/// A slab that lacks both large walls, and discs without ends.
#[test]
fn thin_solids_that_are_open_are_met() {
    let [front, back] = [-0.5 * THIN, 0.5 * THIN];
    let sides = [outline(&[(-1.0, front), (-1.0, back)]), outline(&[(1.0, front), (1.0, back)])].concat();
    let slab = Prism { outline: Curve::new(sides), heights: [-0.8, 0.7], conic: false, open: false };
    let cuboid = Cuboid { min: DVec3::new(-1.0, -0.8, front), max: DVec3::new(1.0, 0.7, back) };
    is_met_however_thin(slab, &cuboid, from_around);

    let rim = Lathe { profile: Curve::new(outline(&[(1.2, front), (1.2, back)])) };
    let disc =
        Lathe { profile: Curve::new(outline(&[(0.0, front), (1.2, front), (1.2, back), (0.0, back)])) };
    is_met_however_thin(rim, &disc, from_around);

    let points = [(1.0, 3.0 * front), (1.2, front), (1.2, back), (1.0, 3.0 * back)];
    let disc = |open: bool| Sor::new(&points.map(|(x, y)| DVec2::new(x, y)), open).unwrap();
    is_met_however_thin(disc(true), &disc(false), from_around);
}

/// A ridge of one row of samples.
#[test]
fn thin_ridges_of_height_fields_are_met() {
    const SAMPLES: usize = 10_001;
    let height = |i: usize| if i % SAMPLES == SAMPLES / 2 { 60_000 } else { 0 };
    let heights: Vec<u16> = (0..2 * SAMPLES).map(height).collect();
    let ridge = HeightField::new([SAMPLES, 2], Arc::new(heights), 0.0, false).unwrap();
    is_met_however_thin(ridge.clone(), &ridge, |dice| {
        let within = |v: DVec3| v * 0.3 + 0.5;
        let (from, to) = (within(dice.cube()).with_x(-1.5), within(dice.cube()).with_x(2.0));
        Ray::new(from, to - from)
    });
}

#[test]
fn surfaces_of_voxels_have_no_holes() {
    let voxels: Arc<[u8]> = (0..8 * 8 * 8).map(|n: u32| if n % 17 == 3 { 0 } else { 200 }).collect();
    for (interpolation, threshold) in [
        (density_file::Interpolation::Nearest, 0.5),
        (density_file::Interpolation::Trilinear, 0.6),
        (density_file::Interpolation::Tricubic, 0.6),
    ] {
        let file = DensityFile { size: [8; 3], width: 1, voxels: voxels.clone(), interpolation };
        let whole = crate::math::Transform::scale(DVec3::splat(4.0))
            .then(&crate::math::Transform::translate(DVec3::splat(-2.0)));
        let warps = Warps::new([Warp::Transform(Box::new(whole))]);
        let file = Formula::DensityFile(Box::new(file));
        has_no_holes(Pattern { warps, ..Pattern::plain(file) }, threshold);
    }
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
    let abrupt = |falloff: f64, radius: f64, strength: f64| {
        Warp::BlackHole(Box::new(BlackHole { falloff, radius, strength, ..hole.clone() }))
    };
    for warp in [
        abrupt(0.0, 1.2, 0.6),
        abrupt(-0.7, 1.2, 0.3),
        abrupt(0.0, 1.2, -0.6),
        abrupt(-0.3, 1.2, -0.6),
        abrupt(2.0, 0.0, 0.9),
        abrupt(2.0, -1.0, 0.9),
        Warp::BlackHole(Box::new(hole.clone())),
        Warp::Repeat(Box::new(repeat)),
        Warp::Mapping(Box::new(around)),
        Warp::Cubic,
    ] {
        let finer = Warp::Transform(Box::new(crate::math::Transform::scale(DVec3::splat(0.15))));
        let warps = Warps::new([warp, finer]);
        has_no_holes(Pattern { warps, ..Pattern::plain(Formula::Bozo(2)) }, 0.25);
    }
}
