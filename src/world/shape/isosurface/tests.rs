//! What rays meet of isosurfaces.

use super::*;
use crate::world::sample::Sample;
use crate::world::shape::battery::{Dice, Probe, battery, table};

/// x² + y² + z² - 1.
#[derive(Debug)]
struct Ball;

impl Field for Ball {
    fn value(&self, sample: &Sample) -> f64 {
        sample.point.length_squared() - 1.0
    }

    fn enclose(&self, point: &[Band; 3]) -> Band {
        square(point) - 1.0
    }

    fn is_known(&self) -> bool {
        true
    }
}

fn square([x, y, z]: &[Band; 3]) -> Band {
    x.square() + y.square() + z.square()
}

/// The same, of which nothing is known.
#[derive(Debug)]
struct Hidden;

impl Field for Hidden {
    fn value(&self, sample: &Sample) -> f64 {
        Ball.value(sample)
    }
}

/// A shell of the unit sphere, this thick on both sides.
#[derive(Debug)]
struct Shell(f64);

impl Field for Shell {
    fn value(&self, sample: &Sample) -> f64 {
        (sample.point.length() - 1.0).abs() - self.0
    }

    fn enclose(&self, point: &[Band; 3]) -> Band {
        (square(point).sqrt() - 1.0).abs() - self.0
    }

    fn is_known(&self) -> bool {
        true
    }
}

/// A stair that goes up to the right, of cylinders around the x axis.
#[derive(Debug)]
struct Stair;

impl Field for Stair {
    fn value(&self, sample: &Sample) -> f64 {
        let DVec3 { x, y, z } = sample.point;
        (3.0 * x).floor() / 3.0 + y * y + z * z - 0.5
    }
}

fn cube(half: f64) -> Container {
    Container::Box(Cuboid { min: DVec3::splat(-half), max: DVec3::splat(half) })
}

fn ball(container: Container) -> Isosurface {
    Isosurface {
        function: Arc::new(Ball),
        threshold: 0.0,
        container,
        accuracy: 1e-3,
        max_gradient: 4.0,
        adaptive: None,
        most: 1,
        open: false,
        steepest: Steepest::default(),
    }
}

/// The distance from the surface of a ball.
#[derive(Debug)]
struct Distance(f64);

impl Field for Distance {
    fn value(&self, sample: &Sample) -> f64 {
        sample.point.length() - self.0
    }

    fn enclose(&self, point: &[Band; 3]) -> Band {
        square(point).sqrt() - self.0
    }

    fn is_known(&self) -> bool {
        true
    }
}

fn sized(size: f64, half: f64) -> Isosurface {
    Isosurface {
        function: Arc::new(Distance(size)),
        container: cube(half * size),
        accuracy: 1e-6 * size,
        max_gradient: 1.1,
        most: 10,
        ..ball(cube(1.0))
    }
}

battery! {
    whole: |size| sized(size, 1.5);
    cut: |size| sized(size, 0.9);
}

#[track_caller]
fn near(shape: &Isosurface, from: [f64; 3], direction: [f64; 3], point: [f64; 3]) {
    let found = Probe::new(from.into(), direction.into()).hit(shape).unwrap().point;
    // POV-Ray ends up to the accuracy behind the surface.
    assert!(found.abs_diff_eq(point.into(), 1.5e-3), "{found}");
    assert!((found.length_squared() - 1.0 - shape.threshold).abs() < 1e-14, "{found}");
}

#[test]
fn surfaces_are_found_where_povray_finds_them() {
    let all = ball(cube(2.0));
    near(&all, [0.1, 0.2, -5.0], [0.0, 0.0, 1.0], [0.1, 0.2, -0.974609375]);
    near(&all, [0.0; 3], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0005517578125]);
    near(&all, [0.1, 0.2, -5.0], [0.05, 0.1, 1.0], [0.314453125, 0.62890625, -0.7109375]);
    let high = Isosurface { threshold: 0.44, ..all };
    near(&high, [0.1, 0.2, -5.0], [0.0, 0.0, 1.0], [0.1, 0.2, -1.1787109375]);
    table(&high, "inside <0,0,1.1> | 1");
}

#[test]
fn normals_are_differences_by_the_accuracy() {
    let found = Probe::new(DVec3::new(0.1, 0.2, -5.0), DVec3::Z).hit(&ball(cube(2.0))).unwrap();
    let differences = 2.0 * found.point + 1e-3;
    assert!(found.normal.abs_diff_eq(differences.normalize(), 1e-12), "{}", found.normal);
    // POV-Ray has the differences at a point that is less exact.
    let observed = DVec3::new(0.100540748652677, 0.200581294575779, -0.974504336638203);
    assert!(found.normal.abs_diff_eq(observed, 1e-4));
}

#[test]
fn the_container_closes_the_solid() {
    table(
        &ball(cube(0.9)),
        "from <0.1,0.2,-5> dir <0,0,1> | P <0.1, 0.2, -0.9> N <0, 0, -1>
        from <0.8,0.8,-5> dir <0,0,1> | miss
        from <0.1,0.2,0> dir <0,0,1> | P <0.1, 0.2, 0.9> N <0, 0, 1>",
    );
    table(
        &ball(Container::Sphere(Sphere { center: DVec3::ZERO, radius: 0.5 })),
        "from <0.1,0.2,-5> dir <0,0,1> | P <0.1, 0.2, -0.447213595499957> N <0.2, 0.4, -0.894427190999916>
        from <0.1,0.2,0> dir <0,0,1> | P <0.1, 0.2, 0.447213595499958> N <0.2, 0.4, 0.894427190999916>
        extent | <-0.5, -0.5, -0.5> .. <0.5, 0.5, 0.5>",
    );
    let open = Isosurface { open: true, most: 10, ..ball(cube(0.9)) };
    table(&open, "from <0.1,0.2,-5> dir <0,0,1> | miss");
    near(&open, [0.8, 0.4, -5.0], [0.0, 0.0, 1.0], [0.8, 0.4, -0.446484375]);
}

#[test]
fn crossings_end_at_the_number_asked_for() {
    let ray = Ray::new(DVec3::new(0.1, 0.2, -5.0), DVec3::Z);
    let count = |most| {
        let mut all = Vec::new();
        Isosurface { most, ..ball(cube(2.0)) }.crossings(&ray, Range::AHEAD, &mut all);
        all.len()
    };
    assert_eq!([count(1), count(2), count(10)], [1, 2, 2]);
}

#[test]
fn a_gradient_said_too_small_makes_no_holes_and_is_remarked_on() {
    let flat = Isosurface { max_gradient: 0.2, ..ball(cube(2.0)) };
    near(&flat, [0.1, 0.2, -5.0], [0.0, 0.0, 1.0], [0.1, 0.2, -0.974609375]);
    let Some(Remark::TooSteep { found, said: 0.2, holes: false }) = flat.remark() else {
        panic!("{:?}", flat.remark());
    };
    assert!((1.0..4.0).contains(&found), "{found}");
    let right = ball(cube(2.0));
    near(&right, [0.1, 0.2, -5.0], [0.0, 0.0, 1.0], [0.1, 0.2, -0.974609375]);
    assert_eq!(right.remark(), None);
}

#[test]
fn of_functions_of_which_nothing_is_known_the_gradient_must_be_right() {
    let ray = Ray::new(DVec3::new(0.1, 0.2, -5.0), DVec3::Z);
    let hidden = |max_gradient| Isosurface { function: Arc::new(Hidden), max_gradient, ..ball(cube(2.0)) };
    let found = hidden(4.0).nearest(&ray, Range::AHEAD).unwrap().t;
    assert_eq!(found, ball(cube(2.0)).nearest(&ray, Range::AHEAD).unwrap().t);
    assert!(hidden(0.2).nearest(&ray, Range::AHEAD).is_none());
}

#[test]
fn what_is_thinner_than_the_accuracy_is_found() {
    let thin = Isosurface { function: Arc::new(Shell(1e-5)), accuracy: 0.01, ..ball(cube(2.0)) };
    for n in 0..200 {
        let ray = Ray::new(DVec3::new(f64::from(n) * 0.004, 0.13, -5.0), DVec3::Z);
        let found = thin.nearest(&ray, Range::AHEAD).map(|crossing| ray.at(crossing.t).length());
        assert!(found.is_some_and(|length| (length - 1.00001).abs() < 1e-14), "{n}: {found:?}");
    }
}

#[test]
fn both_sides_of_what_is_thinner_than_the_accuracy_are_found() {
    let function = Arc::new(Shell(1e-5));
    let thin = Isosurface { function, accuracy: 0.01, most: 10, ..ball(cube(2.0)) };
    let mut all = Vec::new();
    thin.crossings(&Ray::new(DVec3::new(0.3, 0.13, -5.0), DVec3::Z), Range::AHEAD, &mut all);
    assert_eq!(all.len(), 4);
    let inner = thin.nearest(&Ray::new(DVec3::new(0.0, 0.0, 1.00001), DVec3::NEG_Z), Range::AHEAD);
    assert!(inner.is_some_and(|crossing| (crossing.t - 2e-5).abs() < 1e-15));
}

#[test]
fn rays_that_all_but_touch_the_surface_meet_it() {
    for depth in [1e-3, 1e-6, 1e-9] {
        let ray = Ray::new(DVec3::new(0.0, 1.0 - depth, -5.0), DVec3::Z);
        let half = (depth * (2.0 - depth)).sqrt();
        let found = ball(cube(2.0)).nearest(&ray, Range::AHEAD).map(|crossing| crossing.t);
        assert!(found.is_some_and(|t| (t - 5.0 + half).abs() < 1e-14 / half), "{depth}: {found:?}");
        let beside = Ray::new(DVec3::new(0.0, 1.0 + depth, -5.0), DVec3::Z);
        assert!(ball(cube(2.0)).nearest(&beside, Range::AHEAD).is_none());
    }
}

#[test]
fn a_ray_that_leaves_the_surface_does_not_meet_it_again() {
    let surface = ball(cube(2.0));
    let from = Probe::new(DVec3::new(0.1, 0.2, -5.0), DVec3::Z).hit(&surface).unwrap().point;
    assert!(!surface.occludes(&Ray::new(from, DVec3::new(0.3, 0.1, -1.0)), Range::AHEAD));
    let through = surface.nearest(&Ray::new(from, DVec3::Z), Range::AHEAD).unwrap();
    assert!((through.t - 2.0 * 0.95f64.sqrt()).abs() < 1e-14);
}

#[test]
fn rays_that_travel_together_meet_what_each_of_them_meets() {
    let round = Container::Sphere(Sphere { center: DVec3::ZERO, radius: 0.8 });
    let surfaces = [
        ball(cube(2.0)),
        ball(cube(0.9)),
        ball(round),
        Isosurface { open: true, most: 10, ..ball(cube(0.9)) },
        Isosurface { function: Arc::new(Shell(0.05)), ..ball(cube(1.02)) },
        Isosurface { threshold: -0.2, max_gradient: 0.1, ..ball(cube(2.0)) },
    ];
    let mut met = 0;
    for number in 0..3000 {
        let mut dice = Dice::new(number);
        let surface = &surfaces[number as usize % surfaces.len()];
        let (origin, target, beside) = (dice.cube().normalize() * 5.0, dice.cube() * 1.2, dice.cube() * 0.05);
        let far = if number % 7 == 0 { 1.0 } else { 3.0 };
        let rays = [0.0, 1.0, 2.0, 3.0].map(|lane| {
            let direction = target + lane * beside - origin;
            Ray::new(origin, if number % 2 == 0 { direction } else { direction.normalize() })
        });
        let ends = Lanes([f64::INFINITY, f64::INFINITY, far, 5.0]);
        let (asked, mut found) = (15 - (number % 5) as u32, [None; Lanes::COUNT]);
        assert!(surface.nearest_together(&Rays::of(&rays), asked, &ends, &mut found));
        for lane in 0..Lanes::COUNT {
            let alone = surface.nearest(&rays[lane], Range { min: 0.0, max: ends.0[lane].next_up() });
            let alone = alone.filter(|_| asked >> lane & 1 == 1);
            let same = match (found[lane], alone) {
                (Some(a), Some(b)) => {
                    a.part == b.part && (a.t - b.t).abs() < 1e-12 && (a.at[0] - b.at[0]).abs() < 1e-12
                }
                (a, b) => a.is_none() && b.is_none(),
            };
            assert!(same, "{number} {lane}: {:?} {alone:?}", found[lane]);
            met += u32::from(alone.is_some());
        }
    }
    assert!(met > 4000, "{met}");
}

#[test]
fn a_jump_has_its_normal_from_both_of_its_sides() {
    let stair = Isosurface { function: Arc::new(Stair), ..ball(cube(1.0)) };
    for x in [-1.0_f64 / 3.0, 0.0, 1.0 / 3.0] {
        for beside in [-1e-9, 1e-9] {
            let normal = stair.normal(DVec3::new(x + beside, 0.4, 0.5), &Crossing::new(1.0, 0));
            assert!(normal.x > 0.99, "{normal} at {x} {beside:+e}");
        }
    }
}

#[test]
fn the_normal_of_a_point_the_accuracy_behind_the_surface_is_that_of_povray() {
    let stair = Isosurface { function: Arc::new(Stair), ..ball(cube(1.0)) };
    let step = stair.accuracy;
    for behind in [0.0, step] {
        let z = 0.5f64.sqrt() - behind;
        let normal = stair.normal(DVec3::new(0.1, 0.0, z), &Crossing::new(1.0, 0));
        // Differences forwards: y² changes by the step's square.
        let povray = DVec3::new(0.0, step * step, 2.0 * z * step + step * step).normalize();
        assert!((normal - povray).length() < 1e-9, "{normal} {povray}");
    }
}
