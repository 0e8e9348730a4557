use std::f64::consts::{PI, TAU};

use super::*;
use crate::math::Slant;
use crate::world::shape::battery::{Probe, battery};
use crate::world::shape::sphere::Sphere;

/// A coordinate by its formula.
#[derive(Debug)]
struct Formula(fn(f64, f64) -> f64);

impl Field for Formula {
    fn value(&self, sample: &Sample) -> f64 {
        (self.0)(sample.point.x, sample.point.y)
    }
}

fn make(formulas: [fn(f64, f64) -> f64; 3], to: DVec2, from: DVec2, container: Container) -> Parametric {
    let functions = formulas.map(|formula| Arc::new(Formula(formula)) as Arc<dyn Field>);
    let description = Description { functions, from, to, container, accuracy: 1e-4, max_gradient: 2.0 };
    Parametric::new(description).unwrap()
}

fn ball() -> Parametric {
    make(
        [|u, v| u.sin() * v.cos(), |u, v| u.sin() * v.sin(), |u, _| u.cos()],
        DVec2::new(TAU, PI),
        DVec2::ZERO,
        Container::Sphere(Sphere { center: DVec3::ZERO, radius: 1.1 }),
    )
}

fn saddle() -> Parametric {
    let half = DVec3::splat(1.1);
    let container = Container::Box(Cuboid { min: -half, max: half });
    make([|u, _| u, |_, v| v, |u, v| u * v], DVec2::ONE, DVec2::NEG_ONE, container)
}

battery! {
    round: || ball(), surface;
    saddled: || saddle(), surface;
}

/// POV-Ray's points are short of the surface by up to the accuracy.
#[test]
fn surfaces_are_found_where_povray_finds_them() {
    let near =
        |shape: &Parametric, from: [f64; 3], direction: [f64; 3], point: [f64; 3], normal: [f64; 3]| {
            let hit = Probe::new(from.into(), direction.into()).hit(shape).unwrap();
            assert!(hit.point.abs_diff_eq(point.into(), 3e-4), "{}", hit.point);
            assert!(hit.normal.abs_diff_eq(normal.into(), 1e-3), "{}", hit.normal);
        };
    let ahead = [0.0, 0.0, 1.0];
    near(
        &ball(),
        [0.1, 0.2, -5.0],
        ahead,
        [0.1, 0.2, -0.974868664083149],
        [0.100020842249008, 0.200019702881127, -0.974673252723775],
    );
    near(
        &saddle(),
        [0.3, 0.4, -5.0],
        [0.01, 0.02, 1.0],
        [0.351771216800005, 0.503542433600009, 0.177121680000457],
        [-0.429067144587172, -0.299744366034327, 0.852088434651293],
    );
}

#[test]
fn rays_meet_both_sides_exactly() {
    let ray = Ray::new(DVec3::new(0.1, 0.2, -5.0), DVec3::Z);
    let mut all = Vec::new();
    ball().crossings(&ray, Range::AHEAD, &mut all);
    let half = (1.0_f64 - 0.05).sqrt();
    let distances: Vec<_> = all.iter().map(|crossing| crossing.t - 5.0).collect();
    assert_eq!(distances.len(), 2, "{distances:?}");
    assert!((distances[0] + half).abs() < 1e-13 && (distances[1] - half).abs() < 1e-13, "{distances:?}");
}

#[test]
fn what_is_outside_the_container_is_not_there() {
    let half = DVec3::new(1.1, 1.1, 0.5);
    let container = Container::Box(Cuboid { min: -half, max: half });
    let cut = Parametric::new(Description { container, ..saddle().description }).unwrap();
    let at = |x: f64, y: f64| cut.nearest(&Ray::new(DVec3::new(x, y, -5.0), DVec3::Z), Range::AHEAD);
    assert!(at(0.9, 0.9).is_none());
    assert_eq!(at(0.5, 0.5).map(|crossing| crossing.at), Some([0.5, 0.5]));
    let nothing = Parametric::new(Description { to: cut.description.from, ..cut.description });
    assert!(nothing.is_none());
}

/// The product of both parameters, steeply scaled down again.
#[derive(Debug)]
struct Product;

impl Field for Product {
    fn value(&self, sample: &Sample) -> f64 {
        (40.0 * sample.point.x * sample.point.y).sin()
    }

    fn enclose(&self, [u, v, _]: &[Band; 3]) -> Band {
        (*u * *v * 40.0).sin_cos().0
    }

    fn is_known(&self) -> bool {
        true
    }
}

/// One of the parameters.
#[derive(Debug)]
struct Parameter(usize);

impl Field for Parameter {
    fn value(&self, sample: &Sample) -> f64 {
        sample.point[self.0]
    }

    fn enclose(&self, at: &[Band; 3]) -> Band {
        at[self.0]
    }

    fn slant(&self, at: &[Slant; 3]) -> Slant {
        at[self.0]
    }

    fn is_known(&self) -> bool {
        true
    }
}

#[test]
fn a_gradient_said_too_small_makes_no_holes() {
    let functions: [Arc<dyn Field>; 3] = [Arc::new(Parameter(0)), Arc::new(Parameter(1)), Arc::new(Product)];
    let steep = Description { functions, max_gradient: 0.01, ..saddle().description };
    let steep = Parametric::new(steep).unwrap();
    for n in 0..400 {
        let at = |by: f64| (f64::from(n) * by).fract() * 1.96 - 0.98;
        let (x, y) = (at(0.754_877_666), at(0.569_840_290_9));
        let found = steep.nearest(&Ray::new(DVec3::new(x, y, -5.0), DVec3::Z), Range::AHEAD);
        let expected = 5.0 + (40.0 * x * y).sin();
        assert!(found.is_some_and(|crossing| (crossing.t - expected).abs() < 1e-12), "{x} {y}: {found:?}");
    }
}

/// u² - v², with its derivatives.
#[derive(Debug)]
struct Saddle;

impl Field for Saddle {
    fn value(&self, sample: &Sample) -> f64 {
        sample.point.x * sample.point.x - sample.point.y * sample.point.y
    }

    fn enclose(&self, [u, v, _]: &[Band; 3]) -> Band {
        u.square() - v.square()
    }

    fn slant(&self, [u, v, _]: &[Slant; 3]) -> Slant {
        u.square() - v.square()
    }

    fn is_known(&self) -> bool {
        true
    }
}

#[test]
fn rays_that_graze_a_fold_meet_it_twice() {
    let functions: [Arc<dyn Field>; 3] = [Arc::new(Parameter(0)), Arc::new(Saddle), Arc::new(Parameter(1))];
    let surface = Parametric::new(Description { functions, ..saddle().description }).unwrap();
    for (from, along, expected) in [
        (
            [17.560680402291773, 13.335533328174822, -18.596319531110623],
            [-0.6049455066560087, -0.46006349991957907, 0.6499096168071776],
            [1.1556292538347297, 1.1556455054410615],
        ),
        (
            [610.9051154516782, -204.53114836473222, -763.3136712048788],
            [-0.6118503840929888, 0.20503669654844425, 0.7639365553197224],
            [1.157858920785703, 1.1578733664391063],
        ),
        (
            [20.0267490826016, -12.607674809359878, 20.089060932456732],
            [-0.6505928885196791, 0.4058187784836549, -0.6419034292147493],
            [-1.040955351365881, -1.0409030737961802],
        ),
    ] {
        let (from, along) = (DVec3::from(from), DVec3::from(along));
        let mut found = Vec::new();
        surface.crossings(&Ray::new(from, along), Range::AHEAD, &mut found);
        let middle = -from.dot(along) / along.length_squared();
        let off = found.iter().zip(expected).all(|(hit, t)| (hit.t - middle - t).abs() < 1e-7);
        assert!(found.len() == 2 && off, "{found:?}");
    }
}
