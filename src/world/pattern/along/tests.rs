use std::sync::Arc;

use super::*;
use crate::math::noise::Octaves;
use crate::math::{DVec2, Lanes, Transform};
use crate::world::image::{self, Image, ImageMap, Pixels};
use crate::world::pattern::crackle::{Crackle, Metric};
use crate::world::pattern::density_file::{self, DensityFile};
use crate::world::pattern::mandel::{Fractal, Iteration};
use crate::world::pattern::pavement::Pavement;
use crate::world::pattern::penrose::Penrose;
use crate::world::pattern::tiling::Tiling;
use crate::world::pattern::{brick, slope, spiral};
use crate::world::sample::{Field, Sample};
use crate::world::shape::battery::Dice;
use crate::world::warp::{BlackHole, Mapping, Projection, Repeat, Warp, Warps};

/// Checks that bands along lines long and short, and those of boxes around them, hold a pattern's values, and that
/// short ones are narrow.
#[track_caller]
fn holds(pattern: &Pattern) {
    holds_lines(pattern);
    holds_boxes(pattern);
}

#[track_caller]
fn holds_boxes(pattern: &Pattern) {
    let mut narrow = 0;
    for n in 0..200 {
        let mut dice = Dice::new(n);
        let (middle, half) = (dice.cube() * 4.0, dice.cube().abs() * 0.5_f64.powi((n % 30) as i32));
        let at = [0, 1, 2].map(|i| Band::between(middle[i] - half[i], middle[i] + half[i]));
        let band = pattern.enclose(&at);
        for _ in 0..20 {
            let value = pattern.value(&Sample::at(middle + dice.cube() * half));
            assert!(
                band.low().0[1] <= value && value <= band.high().0[1],
                "{pattern:?} at {middle} ± {half}: {value}, {band:?}"
            );
        }
        if n % 30 == 29 {
            narrow += u32::from(band.reach.0[1] < 1e-4);
        }
    }
    assert!(narrow >= 4, "{pattern:?}: {narrow}");
}

#[track_caller]
fn holds_lines(pattern: &Pattern) {
    assert!(pattern.is_known());
    let mut narrow = 0;
    for n in 0..300 {
        let middle = DVec3::new(0.017, -0.023, 0.019) * f64::from(n) + DVec3::new(-2.1, 3.2, -2.7);
        let along = DVec3::new(0.6, 0.5, -0.7) * 0.5_f64.powi(n % 30);
        let at = [0, 1, 2].map(|i| Band::line(Lanes::splat(middle[i]), Lanes::splat(along[i])));
        let band = pattern.enclose(&at);
        for step in -8..=8 {
            let s = f64::from(step) / 8.0;
            let value = pattern.value(&Sample::at(middle + s * along));
            let line = band.middle.0[2] + band.slope.0[2] * s;
            let off = (value - line).abs();
            assert!(
                off <= band.reach.0[2] * (1.0 + 1e-12),
                "{pattern:?} at {middle} + {s} {along}: {value}, {band:?}"
            );
        }
        if n % 30 == 29 {
            narrow += u32::from(band.reach.0[2] < 1e-5);
        }
    }
    assert!(narrow >= 6, "{pattern:?}: {narrow}");
}

#[test]
fn bands_of_patterns_hold_their_values() {
    let octaves = Octaves { count: 3, omega: 0.5, lambda: 2.0 };
    let own = agate::OwnTurbulence { amount: DVec3::new(0.4, 0.3, 0.2), octaves, generator: 2 };
    let slope = slope::Slope {
        target: slope::Target::Direction(DVec3::Y),
        range: [0.0, 0.5],
        weights: [0.5; 2],
        altitude: (DVec3::Y, [0.0, 1.0]),
    };
    let formulas = [
        Formula::Agate(agate::Agate { strength: 1.0, octaves, generator: 2 }),
        Formula::Aoi,
        Formula::Boxed,
        Formula::Bozo(1),
        Formula::Bozo(3),
        Formula::Cylindrical,
        Formula::Dents(2),
        Formula::Gradient(DVec3::new(0.6, 0.8, 0.0)),
        Formula::Granite(1),
        Formula::Granite(2),
        Formula::Leopard,
        Formula::Marble(agate::Marble { turbulence: Some(own) }),
        Formula::Onion,
        Formula::Planar,
        Formula::Radial,
        Formula::Slope(Box::new(slope)),
        Formula::Spherical,
        Formula::Spiral1(spiral::Spiral { arms: 3.0, turbulence: None }),
        Formula::Spiral2(spiral::Spiral { arms: -5.0, turbulence: Some(own) }),
        Formula::Wood(wood::Wood { turbulence: None }),
        Formula::Wood(wood::Wood { turbulence: Some(own) }),
        Formula::Wrinkles(2),
    ];
    let turned = Transform::rotate(DVec3::new(20.0, 30.0, 40.0)).then(&Transform::scale(DVec3::splat(1.7)));
    let steps = [Warp::Transform(Box::new(turned)), Warp::Turbulence(DVec3::new(0.3, 0.2, 0.4), octaves)];
    let waves = [Wave::Ramp, Wave::Triangle, Wave::Sine, Wave::Scallop, Wave::Cubic, Wave::Poly(1.5)];
    for (n, formula) in formulas.into_iter().enumerate() {
        holds(&Pattern::plain(formula.clone()));
        let warps = Warps::new(steps.clone());
        holds(&Pattern { warps, frequency: 1.7, phase: 0.2, wave: waves[n % 6], ..Pattern::plain(formula) });
    }
}

#[test]
fn bands_of_cells_hold_their_values() {
    let crackle = |form: [f64; 3], metric: f64, offset: f64, solid: Option<u8>| {
        let (form, metric) = (form.into(), Metric::new(metric));
        Formula::Crackle(Box::new(Crackle { form, metric, offset, solid }))
    };
    for formula in [
        Formula::Cells,
        Formula::Checker,
        Formula::Square,
        Formula::Quilted(quilted::Quilted { control0: 1.0, control1: 1.0 }),
        Formula::Quilted(quilted::Quilted { control0: 0.3, control1: -0.7 }),
        crackle([1.0, 0.0, 0.0], 2.0, 0.0, None),
        crackle([-1.0, 1.0, 0.0], 2.0, 0.0, None),
        crackle([0.3, -0.8, 0.9], 2.0, 0.2, None),
        crackle([-1.0, 1.0, 0.0], 1.0, 0.1, None),
        crackle([0.0, 0.0, 0.6], 3.0, 0.1, None),
        crackle([-1.0, 1.0, 0.0], 2.5, 0.0, None),
        crackle([1.0, 0.0, 0.0], 2.0, 0.0, Some(2)),
        crackle([-1.0, 1.0, 0.0], 0.7, 0.0, None),
        crackle([0.3, 0.2, 0.1], 0.5, 0.1, None),
        crackle([1.0, 0.0, 0.0], 0.8, 0.0, Some(2)),
        crackle([0.5, 0.0, 0.5], -1.0, 0.0, None),
        crackle([1.0, 0.0, 0.0], 1.0, -0.1, None),
        Formula::Cubic,
        Formula::Brick(brick::Brick::new(DVec3::new(0.9, 0.4, 0.5), 0.06)),
        Formula::Hexagon,
        Formula::Triangular,
    ] {
        holds(&Pattern::plain(formula.clone()));
        let turned = Warp::Transform(Box::new(Transform::rotate(DVec3::new(20.0, 30.0, 40.0))));
        holds(&Pattern { warps: Warps::new([turned]), ..Pattern::plain(formula) });
    }
}

#[test]
fn bands_of_tilings_hold_their_values() {
    for number in 1..=24 {
        holds(&Pattern::plain(Formula::Tiling(Tiling::new(number).unwrap())));
    }
    for number in 25..=27 {
        holds(&Pattern::plain(Formula::Penrose(Penrose::new(number).unwrap())));
    }
}

#[test]
fn bands_of_pavements_hold_their_values() {
    let floors = [[3, 1, 1], [3, 4, 2], [3, 6, 5], [4, 3, 2], [4, 5, 10], [6, 3, 1], [6, 4, 2]];
    for (n, floor) in (0..).zip(floors) {
        for shape in 0..3 {
            let pavement = Pavement::new(floor, shape, (shape + n) % 3, (shape + 2 * n) % 4).unwrap();
            holds(&Pattern::plain(Formula::Pavement(Box::new(pavement))));
        }
    }
}

#[test]
fn bands_of_voxels_hold_their_values() {
    let voxels: Arc<[u8]> = (0..5 * 4 * 3).map(|n: u32| (n * n * 37 % 251) as u8).collect();
    for interpolation in [
        density_file::Interpolation::Nearest,
        density_file::Interpolation::Trilinear,
        density_file::Interpolation::Tricubic,
    ] {
        let file = DensityFile { size: [5, 4, 3], width: 1, voxels: voxels.clone(), interpolation };
        let larger = Transform::scale(DVec3::splat(5.0)).then(&Transform::translate(DVec3::splat(-2.5)));
        let warps = Warps::new([Warp::Transform(Box::new(larger))]);
        holds(&Pattern { warps, ..Pattern::plain(Formula::DensityFile(Box::new(file))) });
    }
}

#[test]
fn bands_of_fractals_hold_their_values() {
    let fractal = |iteration, julia: Option<[f64; 2]>, interior, exterior| {
        let fractal =
            Fractal { iteration, julia: julia.map(DVec2::from), iterations: 60, interior, exterior };
        holds(&Pattern::plain(Formula::Fractal(Box::new(fractal))));
    };
    fractal(Iteration::power(2), None, (0, 1.0), (1, 1.0));
    fractal(Iteration::power(2), None, (1, 0.7), (6, 0.2));
    fractal(Iteration::power(2), Some([-0.4, 0.3]), (6, 1.0), (7, 3.0));
    fractal(Iteration::power(3), None, (2, 1.0), (3, 0.5));
    fractal(Iteration::power(4), Some([0.3, 0.2]), (4, 1.0), (8, 4.0));
    fractal(Iteration::power(6), None, (3, 1.0), (0, 0.2));
    fractal(Iteration::Magnet1, None, (0, 1.0), (1, 1.0));
    fractal(Iteration::Magnet1, Some([0.2, 0.1]), (0, 1.0), (2, 0.3));
    fractal(Iteration::Magnet2, None, (1, 1.0), (1, 1.0));
    fractal(Iteration::Magnet2, Some([1.4, -0.2]), (5, 1.0), (7, 2.0));
}

#[test]
fn orbits_that_are_drawn_to_a_cycle_need_not_be_followed() {
    let endless = Fractal {
        iteration: Iteration::power(2),
        julia: None,
        iterations: u32::MAX,
        interior: (0, 0.3),
        exterior: (1, 1.0),
    };
    let place = [Band::between(-1.01, -0.99), Band::between(0.05, 0.06), ZERO];
    let band = endless.along(&place);
    assert!((band.middle.0[0], band.reach.0[0]) == (0.3, 0.0), "{band:?}");
}

#[test]
fn bands_of_images_hold_what_they_show() {
    let data = (0..5 * 4 * 3).map(|n: u32| (n * n * 37 % 251) as u8).collect();
    let curve = (0..256).map(|v| v as f32 / 255.0).collect();
    let pixels = Pixels::Bytes { channels: 3, data, curve };
    let image = Image { width: 5, height: 4, pixels, premultiplied: false, has_alpha: false };
    let image = Arc::new(image);
    for projection in [
        image::Projection::Planar,
        image::Projection::Spherical,
        image::Projection::Cylindrical,
        image::Projection::Torus,
    ] {
        for interpolation in [
            image::Interpolation::None,
            image::Interpolation::Bilinear,
            image::Interpolation::Bicubic,
            image::Interpolation::NormalizedDistance,
        ] {
            for once in [false, true] {
                holds(&Pattern::plain(Formula::Image(Box::new(ImageMap {
                    image: image.clone(),
                    projection,
                    interpolation,
                    once,
                    scale: DVec2::new(5.0, 4.0),
                    offset: DVec2::new(0.3, 0.0),
                    clearness: [0.0; 2],
                    use_index: false,
                    use_alpha: false,
                }))));
            }
        }
    }
}

#[test]
fn bands_go_through_warps() {
    let repeat = |width: [f64; 3], offset: [f64; 3], flip: [f64; 3]| {
        Warp::Repeat(Box::new(Repeat::new(width.into(), offset.into(), flip.into())))
    };
    let hole = BlackHole {
        center: DVec3::new(0.3, 0.2, -0.4),
        radius: 1.3,
        strength: 0.8,
        falloff: 2.0,
        inverse: false,
        repeat: None,
        turbulence: DVec3::ZERO,
    };
    let holes = BlackHole {
        inverse: true,
        falloff: 1.5,
        repeat: Some(DVec3::new(1.5, 0.0, 2.0)),
        turbulence: DVec3::splat(0.2),
        ..hole.clone()
    };
    let backwards = BlackHole { falloff: -0.4, strength: -0.5, ..holes.clone() };
    let mapping = |projection: Projection, orientation: DVec3, dist_exp: f64| {
        Warp::Mapping(Box::new(Mapping { projection, orientation, dist_exp }))
    };
    for warp in [
        repeat([0.7, 0.0, 0.0], [0.0, 0.2, -0.1], [0.0; 3]),
        repeat([0.0, -0.9, 0.0], [0.0; 3], [1.0, 1.0, 0.0]),
        Warp::BlackHole(Box::new(hole)),
        Warp::BlackHole(Box::new(holes)),
        Warp::BlackHole(Box::new(backwards)),
        mapping(Projection::Cylindrical, DVec3::Z, 0.0),
        mapping(Projection::Cylindrical, DVec3::X, 1.0),
        mapping(Projection::Spherical, DVec3::Z, 0.0),
        mapping(Projection::Spherical, DVec3::Y, 0.5),
        mapping(Projection::Toroidal(1.4), DVec3::Z, 1.0),
        mapping(Projection::Planar(0.3), DVec3::X, 0.0),
        Warp::Cubic,
    ] {
        let warps = Warps::new([warp]);
        holds(&Pattern { warps, ..Pattern::plain(Formula::Bozo(2)) });
    }
}
