use super::super::battery::{Probe, battery, table};
use super::*;
use crate::math::dice::numbers;

/// A polynomial from its terms, as of a `polynomial` statement.
fn terms(degree: usize, terms: &[([usize; 3], f64)]) -> Poly {
    let mut coefficients = Vec::new();
    for i in (0..=degree).rev() {
        for j in (0..=degree - i).rev() {
            for k in (0..=degree - i - j).rev() {
                let term = terms.iter().find(|term| term.0 == [i, j, k]);
                coefficients.push(term.map_or(0.0, |term| term.1));
            }
        }
    }
    Poly::new(degree as u32, &coefficients).unwrap()
}

/// x^n + y^n + z^n - 1.
fn powers(n: usize) -> Poly {
    terms(n, &[([n, 0, 0], 1.0), ([0, n, 0], 1.0), ([0, 0, n], 1.0), ([0, 0, 0], -1.0)])
}

fn torus(size: f64) -> Poly {
    let s = size * size;
    #[rustfmt::skip]
    let coefficients = [
        1., 0., 0., 0., 2., 0., 0., 2., 0., -1.25 * s, 0., 0., 0., 0., 0., 0., 0., 0., 0., 0., 1., 0., 0.,
        2., 0., 1.0 * s, 0., 0., 0., 0., 1., 0., -1.25 * s, 0., 0.25 * s * s,
    ];
    Poly::new(4, &coefficients).unwrap()
}

battery! {
    quartic_torus: |size| torus(size);
    sextic: |size| {
        let s = size.powi(-6);
        terms(6, &[([6, 0, 0], s), ([0, 6, 0], s), ([0, 0, 6], s), ([0, 0, 0], -1.0)])
    };
    cubic: |size| terms(3, &[([3, 0, 0], size.powi(-2)), ([0, 1, 0], -1.0), ([1, 0, 2], size.powi(-2))]);
    twentieth: || powers(20);
}

#[test]
fn probes_agree_with_povray() {
    let numbers: Vec<f64> = (1..20).map(f64::from).chain([-20.0]).collect();
    table(
        &Poly::new(3, &numbers).unwrap(),
        "from <-5,0.1,0.2> dir <1,0.05,0.02> | P <0.102152184822835, 0.355107609241142, 0.302043043696457> N <0.291353465818499, 0.618937456916427, 0.729403579907156>
        inside <0,0,0> | 1
        inside <1,1,1> | 0",
    );
    #[rustfmt::skip]
    let ring = [
        1., 0., 0., 0., 2., 0., 0., 2., 0., -2.125, 0., 0., 0., 0., 0., 0., 0., 0., 0., 0., 1., 0., 0., 2.,
        0., 1.875, 0., 0., 0., 0., 1., 0., -2.125, 0., 0.878_906_25,
    ];
    table(
        &Poly::new(4, &ring).unwrap(),
        "from <0.2,0.1,-5> dir <0.05,0.01,1> | P <0.39287952045384, 0.138575904090768, -1.142409590923192> N <0.270677197089868, 0.554303616363276, -0.787071379140524>
        inside <1,0.25,0> | 1
        inside <1,0.2501,0> | 0",
    );
    table(
        &Poly::new(2, &[1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 3.0, 0.0, -1.0]).unwrap(),
        "from <0.1,0.2,-5> dir <0,0,1> | P <0.1, 0.2, -0.550757054728609> N <0.05872202195147, 0.234888087805882, -0.970247035731018>
        from <5,0,0> dir <-1,0,0> | P <1, 0, 0> N <1, 0, 0>
        inside <1,0,0> | 1
        inside <1.00006,0,0> | 0",
    );
    // POV-Ray's solver ends at x = 0.999513534860.
    table(
        &terms(5, &[([5, 0, 0], 1.0), ([0, 5, 0], 1.0), ([0, 0, 0], -1.0)]),
        "from <-5,0.3,0.2> dir <1,0,0> | P <0.999513526918, 0.3, 0.2> N <0.999967068677, 0.008115513652, 0>",
    );
    table(
        &powers(6),
        "from <0.1,0.2,-5> dir <0,0,1> | P <0.1, 0.2, -0.999989166372055> N <0.000010000541186, 0.000320017317965, -0.999999948744451>
        from <0.1,0.2,-5> dir <0.01,0.02,1> | P <0.140000815894669, 0.280001631789339, -0.999918410533064> N <0.000053805833753, 0.001721786680103, -0.99999851627668>",
    );
    let saddle = terms(3, &[([3, 0, 0], 1.0), ([0, 1, 0], -1.0)]);
    table(
        &saddle,
        "from <0.5,-5,0> dir <1e-3,1,0> | P <0.505128886257798, 0.128886257797527, 0> N <0.607830689164191, -0.794066655457957, 0>",
    );
}

#[test]
fn four_sheets_are_found_one_by_one() {
    let c = [([4, 0, 0], 1.0), ([3, 0, 0], -10.0), ([2, 0, 0], 35.0), ([1, 0, 0], -50.0), ([0, 0, 0], 24.0)];
    table(
        &terms(4, &c),
        "from <-5,0,0> dir <1,0,0> | P <1, 0, 0> N <-1, 0, 0>
        from <1.5,0,0> dir <1,0,0> | P <2, 0, 0> N <1, 0, 0>
        from <3.5,0,0> dir <1,0,0> | P <4, 0, 0> N <1, 0, 0>
        from <4.5,0,0> dir <-1,0,0> | P <4, 0, 0> N <1, 0, 0>",
    );
    table(
        &terms(4, &[([4, 0, 0], 1e-8), ([1, 0, 0], 1.0), ([0, 0, 0], -1.0)]),
        "from <-5,0,0> dir <1,0,0> | P <0.999999990000276, 0, 0> N <1, 0, 0>",
    );
}

#[test]
fn where_roots_are_looked_for_first_changes_none_of_them() {
    let (free, gate) = (torus(1.0), Cuboid { min: DVec3::splat(-0.6), max: DVec3::new(1.1, 0.4, 1.1) });
    let ball = free.at_home_in(DVec3::new(0.3, 0.0, 0.1), 0.7).unwrap();
    let gated = free.behind_gate(gate).unwrap();
    let mut number = numbers(7);
    let (mut met, mut kept_out) = (0, 0);
    for _ in 0..10_000 {
        let mut point = || 2.0 * DVec3::new(number(), number(), number());
        let (ray, range) = (Ray::new(point(), point()), Range { min: 0.0, max: 3.0 });
        let all = |shape: &dyn Shape| {
            let mut all = Vec::new();
            shape.crossings(&ray, range, &mut all);
            all
        };
        let found = all(&free);
        let agree = |others: Vec<Crossing>| {
            others.len() == found.len() && found.iter().zip(others).all(|(a, b)| (a.t - b.t).abs() < 1e-7)
        };
        assert!(agree(all(&*ball)), "{ray:?}");
        let passes = gate.stretch(&ray).is_some_and(|stretch| stretch.leave.t >= 0.0);
        assert!(if passes { agree(all(&*gated)) } else { all(&*gated).is_empty() }, "{ray:?}");
        for shape in [&free, &*ball, &*gated] as [&dyn Shape; 3] {
            assert_eq!(shape.occludes(&ray, range), !all(shape).is_empty(), "{ray:?}");
        }
        met += u32::from(!found.is_empty());
        kept_out += u32::from(!passes && !found.is_empty());
    }
    assert!(met > 1000 && kept_out > 10, "{met} {kept_out}");
}

#[test]
fn a_ray_along_which_the_equation_is_linear_hits() {
    // POV-Ray misses.
    table(
        &terms(3, &[([3, 0, 0], 1.0), ([0, 1, 0], -1.0)]),
        "from <0.5,-5,0> dir <0,1,0> | P <0.5, 0.125, 0> N <0.6, -0.8, 0>",
    );
}

#[test]
fn a_small_constant_term_is_not_thrown_away() {
    // POV-Ray answers <0.00018, 0.01, 0>.
    let hit = Probe::new(DVec3::new(-1.000_09, 0.0, 0.0), DVec3::new(1.0, 0.01, 0.0));
    let found = hit.hit(&terms(3, &[([3, 0, 0], 1.0), ([1, 0, 0], -1.0)])).unwrap();
    assert!((found.point.x + 1.0).abs() < 1e-15, "{}", found.point);
}

#[test]
fn sheets_that_only_touch_zero_are_hit_where_they_are() {
    // POV-Ray misses the first, and finds the second at x = -2.6.
    let double = terms(4, &[([4, 0, 0], 1.0), ([2, 0, 0], -2.0), ([0, 0, 0], 1.0)]);
    let triple = terms(6, &[([6, 0, 0], 1.0), ([4, 0, 0], -2.0), ([2, 0, 0], 1.0)]);
    for shape in [double, triple] {
        let slanted = Probe::new(DVec3::new(-5.0, 0.3, 0.1), DVec3::new(1.0, 0.01, 0.02));
        assert!((slanted.hit(&shape).unwrap().point.x + 1.0).abs() < 1e-7);
    }
}
