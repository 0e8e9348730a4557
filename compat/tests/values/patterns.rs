//! Every pattern at 10^4 points.
//!
//! One bound serves all. Crackle, facets and the fractals could be allowed more, as a rounding error may
//! choose another seed or grow with every iteration; they need nothing: their operations are POV-Ray's in
//! POV-Ray's order, so that there is no error to grow.

use super::probe::{MIXED, Probe, RANDOM, bodies, compare, judge};

/// Points of each pattern.
const POINTS: usize = 10_000;

/// Largest difference of a value.
const BOUND: f64 = 1e-9;

#[test]
fn patterns_have_povrays_values() {
    let probe = |body: &str| Probe {
        name: body.to_owned(),
        function: format!("pattern {{ {body} }}"),
        members: &[""],
        fold: 1.0,
    };
    let probes: Vec<Probe> = bodies(include_str!("patterns.txt")).map(probe).collect();
    judge("patterns", &compare(&probes, MIXED, POINTS), BOUND);
}

/// Half a unit in the last place of a colour component up to 1.
const SINGLE: f64 = 6e-8;

/// The edges of tiles, where the specification leaves open whose value is taken, are not aimed at.
#[test]
fn floors_have_povrays_values() {
    let probe = |body: &str, frequency: f64| {
        let modifier = if frequency == 1.0 { String::new() } else { format!("frequency {frequency}") };
        Probe {
            name: format!("{body} {modifier}"),
            function: format!("pigment {{ {body} {modifier} color_map {{ [0 rgb 0] [1 rgb 1] }} }}"),
            members: &[".red"],
            fold: frequency,
        }
    };
    let list = || bodies(include_str!("floors.txt"));
    let fine: Vec<Probe> = list().map(|body| probe(body, 128.0)).collect();
    judge("floors, folded", &compare(&fine, RANDOM, POINTS), BOUND);
    // What folding hides is which fold it was; that takes few points to tell.
    let coarse: Vec<Probe> = list().map(|body| probe(body, 1.0)).collect();
    judge("floors", &compare(&coarse, RANDOM, POINTS / 10), SINGLE);
}
