//! Internal functions made of noise (docs/spec/language.md 4.5, at the end).

use super::{Formula, Number};

/// Octaves that are summed up at most: long before, there is nothing left of their coordinates.
const MOST_OCTAVES: f64 = 10_000.0;

/// Parameters besides the point, and the formula. `generator` is the scene's.
pub(super) fn find<N: Number>(number: u8, generator: u8) -> Option<(usize, Formula<N>)> {
    let by_scene: Formula<N> = match generator {
        1 => |x, y, z, _| N::noise(1, [x, y, z]),
        3 => |x, y, z, _| N::noise(3, [x, y, z]),
        _ => |x, y, z, _| N::noise(2, [x, y, z]),
    };
    Some(match number {
        29 => (6, hetero_mf),
        58 => (6, ridge),
        59 => (6, ridged_mf),
        76 => (0, by_scene),
        78 => {
            (1, |x, y, z, p| p[0].fixed().map_or_else(N::unknown, |g| N::noise(generator_of(g), [x, y, z])))
        }
        _ => return None,
    })
}

/// The generator of the function that is noise of the scene's.
pub(super) fn plain(number: u8, generator: u8) -> Option<u8> {
    (number == 76).then_some(if matches!(generator, 1 | 3) { generator } else { 2 })
}

fn generator_of(parameter: f64) -> u8 {
    (parameter as i32 & 3) as u8
}

/// The parameters, if they are numbers: they say how often something is done.
fn settings<N: Number>(p: &[N]) -> Option<[f64; 6]> {
    let mut settings = [0.0; 6];
    for (setting, parameter) in settings.iter_mut().zip(p) {
        *setting = parameter.fixed()?;
    }
    Some(settings)
}

fn scaled<N: Number>([x, y, z]: [N; 3], by: f64) -> [N; 3] {
    [x * by, y * by, z * by]
}

fn hetero_mf<N: Number>(x: N, y: N, z: N, p: &[N]) -> N {
    let Some([h, lacunarity, octaves, offset, t, generator]) = settings(p) else { return N::unknown() };
    let octaves = octaves.min(MOST_OCTAVES);
    let height = |q| N::noise(generator_of(generator), q) * 2.0 - 1.0 + offset;
    let mut q = [x, y, z];
    let mut sum = height(q);
    let step = lacunarity.powf(-h);
    let mut strength = step;
    q = scaled(q, lacunarity);
    let mut i = 1.0;
    while i < octaves {
        sum = sum + height(q) * strength * sum.powi(t as i32);
        q = scaled(q, lacunarity);
        strength *= step;
        i += 1.0;
    }
    let rest = octaves.fract();
    if rest == 0.0 { sum } else { sum + height(q) * rest * strength * sum }
}

fn ridge<N: Number>(x: N, y: N, z: N, p: &[N]) -> N {
    let Some([lambda, octaves, omega, offset, ridge, generator]) = settings(p) else { return N::unknown() };
    let octaves = octaves.min(MOST_OCTAVES);
    let start = [x, y, z];
    let span = ridge.max(1.0 - ridge);
    let height = |q| (N::noise(generator_of(generator), q) - ridge).abs() / span - offset;
    let (mut sum, mut total) = (height(start), 1.0);
    let (mut frequency, mut strength) = (lambda, omega);
    for _ in 2..=octaves as i32 {
        sum = sum + height(scaled(start, frequency)) * strength;
        total += strength;
        frequency *= lambda;
        strength *= omega;
    }
    let rest = octaves.fract();
    if rest != 0.0 {
        sum = sum + height(scaled(start, frequency)) * (rest * strength);
        total += rest * strength;
    }
    sum / (total * offset.max(1.0 - offset))
}

fn ridged_mf<N: Number>(x: N, y: N, z: N, p: &[N]) -> N {
    let Some([h, lacunarity, octaves, offset, gain, generator]) = settings(p) else { return N::unknown() };
    let octaves = octaves.min(MOST_OCTAVES);
    let mut q = [x, y, z];
    let height = |q| {
        let crest = -(N::noise(generator_of(generator), q) * 2.0 - 1.0).abs() + offset;
        crest * crest
    };
    let mut signal = height(q);
    let mut sum = signal;
    let mut i = 1.0;
    while i < octaves {
        q = scaled(q, lacunarity);
        signal = (signal * gain).max(N::constant(0.0)).min(N::constant(1.0)) * height(q);
        sum = sum + signal * lacunarity.powf(-h * i);
        i += 1.0;
    }
    sum
}
