//! The three noise generators, vector noise, turbulence and the wave sources at 10^5 points.

use super::probe::{Probe, RANDOM, compare, judge};

/// Bodies of patterns that show a source of noise with nothing added. `marble ramp_wave frequency 0`
/// is the x coordinate of the point it sees; the matrices bring y and z there.
const BODIES: [&str; 11] = [
    "bozo noise_generator 1",
    "bozo noise_generator 2",
    "bozo noise_generator 3",
    "marble ramp_wave frequency 0 warp { turbulence 1 octaves 1 }",
    "marble ramp_wave frequency 0 matrix <0,1,0, 1,0,0, 0,0,1, 0,0,0> warp { turbulence 1 octaves 1 }",
    "marble ramp_wave frequency 0 matrix <0,0,1, 0,1,0, 1,0,0, 0,0,0> warp { turbulence <0.3,0.4,0.5> }",
    "marble ramp_wave frequency 0 turbulence x octaves 6 noise_generator 1",
    "marble ramp_wave frequency 0 turbulence x octaves 4 omega 0.7 lambda 2.3 noise_generator 2",
    "marble ramp_wave frequency 0 turbulence x octaves 10 noise_generator 3",
    "ripples",
    "waves",
];

#[test]
fn noise_is_povrays_to_the_last_digits() {
    let probe = |body: &&str| Probe {
        name: (*body).to_owned(),
        function: format!("pattern {{ {body} }}"),
        members: &[""],
        fold: 1.0,
    };
    let probes: Vec<Probe> = BODIES.iter().map(probe).collect();
    judge("noise", &compare(&probes, RANDOM, 100_000), 1e-12);
}
