//! Maps, lists, averages and default colours: all five components of pigments.

use super::probe::{MIXED, Probe, bodies, compare, judge};

/// Half a unit in the last place of a colour component up to 1.
const SINGLE: f64 = 6e-8;

#[test]
fn pigments_have_povrays_colours() {
    let probe = |body: &str| Probe {
        name: body.to_owned(),
        function: format!("pigment {{ {body} }}"),
        members: &[".red", ".green", ".blue", ".filter", ".transmit"],
        fold: 1.0,
    };
    let probes: Vec<Probe> = bodies(include_str!("pigments.txt")).map(probe).collect();
    judge("pigments", &compare(&probes, MIXED, 2_000), SINGLE);
}
