//! `internal(n)`: the formulas behind functions.inc (docs/spec/language.md 4.5).

mod noise;
mod solids;
mod surfaces;
mod turned;

use smallvec::SmallVec;

use super::number::{Number, Unary};
use crate::math::{Band, Lanes, Slant};

/// A formula of a point and its parameters, of which there are as many as it asks for.
type Formula<N> = fn(N, N, N, &[N]) -> N;

/// The most parameters a formula has, besides the point.
const PARAMETERS: usize = 10;

/// An entry of the table of internal functions.
#[derive(Clone, Copy, Debug)]
pub struct Internal {
    /// How many numbers it takes, the point among them.
    pub parameters: usize,
    /// Whether four values at once have the bits of one.
    pub(super) exact: bool,
    formula: Formula<f64>,
    lanes: Formula<Lanes>,
    bands: Formula<Band>,
    slants: Formula<Slant>,
    /// The generator of one that is but noise at the point: most functions of noise are made of it.
    generator: Option<u8>,
}

impl Internal {
    /// The function with this number; `generator` is the scene's noise generator.
    /// `None` where there is none.
    pub fn new(number: u8, generator: u8) -> Option<Self> {
        let (parameters, formula) = find(number, generator)?;
        let (_, lanes) = find(number, generator)?;
        let (_, bands) = find(number, generator)?;
        let (_, slants) = find(number, generator)?;
        let exact = noise::find::<f64>(number, generator).is_some();
        let generator = noise::plain(number, generator);
        Some(Self { parameters: parameters + 3, exact, formula, lanes, bands, slants, generator })
    }

    /// The value; missing arguments count as 0.
    pub fn call(&self, arguments: &[f64]) -> f64 {
        self.apply(self.formula, arguments)
    }

    /// What holds the values for all arguments that are held by these.
    pub fn enclose(&self, arguments: &[Band]) -> Band {
        self.apply(self.bands, arguments)
    }

    /// The same with how fast they rise.
    pub fn slant(&self, arguments: &[Slant]) -> Slant {
        self.apply(self.slants, arguments)
    }

    fn apply<N: Number>(&self, formula: Formula<N>, arguments: &[N]) -> N {
        let mut all = [N::constant(0.0); PARAMETERS + 3];
        let given = arguments.len().min(self.parameters);
        all[..given].copy_from_slice(&arguments[..given]);
        let [x, y, z, p @ ..] = all;
        formula(x, y, z, &p)
    }

    /// The value at a point, with all parameters.
    #[inline]
    pub(super) fn number(&self, [x, y, z]: [f64; 3], parameters: &[f64]) -> f64 {
        (self.formula)(x, y, z, parameters)
    }

    /// The values at four points.
    pub(super) fn four(&self, [x, y, z]: [Lanes; 3], parameters: &[Lanes]) -> Lanes {
        if parameters.iter().all(|parameter| parameter.fixed().is_some()) {
            return (self.lanes)(x, y, z, parameters);
        }
        // Formulas take ways that depend on their parameters.
        Lanes([0, 1, 2, 3].map(|i| {
            let one: SmallVec<[f64; PARAMETERS]> = parameters.iter().map(|p| p.0[i]).collect();
            (self.formula)(x.0[i], y.0[i], z.0[i], &one)
        }))
    }

    /// What holds the values at all points that these hold.
    #[inline(always)]
    pub(super) fn band(&self, [x, y, z]: [Band; 3], parameters: &[Band]) -> Band {
        if let Some(generator) = self.generator {
            return Band::noise(generator, [x, y, z]);
        }
        (self.bands)(x, y, z, parameters)
    }

    /// The same with how fast they rise.
    pub(super) fn slanted(&self, [x, y, z]: [Slant; 3], parameters: &[Slant]) -> Slant {
        (self.slants)(x, y, z, parameters)
    }
}

fn find<N: Number>(number: u8, generator: u8) -> Option<(usize, Formula<N>)> {
    surfaces::find(number)
        .or_else(|| turned::find(number))
        .or_else(|| solids::find(number))
        .or_else(|| noise::find(number, generator))
}

/// Keeps a surface's value within ±10, as POV-Ray does for surfaces of high degree.
fn cl<N: Number>(v: N) -> N {
    cl_to(v, N::constant(10.0))
}

/// Keeps a value within ±`limit`, the lower end first: a negative limit wins.
fn cl_to<N: Number>(v: N, limit: N) -> N {
    v.max(-limit).min(limit)
}

/// Distance in the plane from a cross-section of the given shape: 1 a circle, 0 a square, others between and beyond.
fn section<N: Number>(x: N, z: N, shape: N) -> N {
    if shape.fixed() == Some(1.0) {
        (x * x + z * z).sqrt()
    } else if shape.fixed() == Some(0.0) {
        x.abs().max(z.abs())
    } else {
        let power = N::constant(2.0) / shape;
        (x.abs().powf(power) + z.abs().powf(power)).powf(shape * 0.5)
    }
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering;

    use super::*;
    use crate::math::Lanes;

    /// Number, parameters and value at (0.3, 0.4, 0.5) with the parameters of docs/spec/language.md 4.5.
    const PROBES: [(u8, usize, f64); 72] = [
        (0, 5, 0.009904467),
        (1, 5, 0.01614244),
        (2, 5, -0.228133785),
        (3, 5, -0.7),
        (4, 2, -0.15851),
        (5, 2, -0.17028),
        (6, 5, -0.900138822),
        (7, 4, 0.234225806),
        (8, 2, -10.0),
        (9, 1, -0.073677151),
        (10, 4, 0.676783006),
        (11, 1, -0.41525),
        (12, 1, 0.5907),
        (13, 1, 0.01925),
        (14, 1, -0.10736),
        (15, 6, -0.114009102),
        (16, 6, 0.64816202),
        (17, 3, 0.624339651),
        (18, 1, 0.005907789),
        (19, 4, -0.558795969),
        (20, 3, 0.38203),
        (21, 6, -0.184324666),
        (22, 1, -0.4452085),
        (23, 1, 0.0990506),
        (24, 10, 0.283095189),
        (25, 7, 0.983095189),
        (26, 7, 0.020443692),
        (27, 1, 0.496410162),
        (28, 1, 0.059807621),
        (30, 1, 10.0),
        (31, 3, -0.4576),
        (32, 4, 0.683724094),
        (33, 3, -0.483076),
        (34, 6, -0.17604171),
        (35, 1, 3.5343),
        (36, 1, -0.57123),
        (37, 4, 0.447249),
        (38, 1, -0.36091),
        (39, 6, -0.175537506),
        (40, 5, 0.365478522),
        (41, 1, -0.09416),
        (42, 1, 1.1121),
        (43, 1, 0.01925),
        (44, 4, 0.051128),
        (45, 1, 0.066),
        (46, 3, -0.71137),
        (47, 0, 0.96953211),
        (48, 1, -0.44418),
        (49, 1, 0.43021),
        (50, 7, -0.184307439),
        (51, 5, -1.039464811),
        (52, 6, 0.87961954),
        (53, 1, 1.199750699),
        (54, 1, 0.36234),
        (55, 1, 0.49984),
        (56, 3, 0.07381),
        (57, 0, std::f64::consts::FRAC_1_SQRT_2),
        (60, 4, -0.130465029),
        (61, 1, -0.392893219),
        (62, 5, 1.57689125),
        (63, 4, -0.222651891),
        (64, 6, -0.192893219),
        (65, 1, -0.15059),
        (66, 4, -0.10329),
        (67, 7, -0.152005923),
        (68, 2, 0.351917956),
        (69, 0, 0.5404195),
        (70, 2, -0.046401818),
        (71, 3, 0.6974),
        (72, 1, -9.16531),
        (73, 1, 0.011),
        (74, 2, 0.3124),
    ];

    #[test]
    fn internal_functions_are_povrays() {
        const P: [f64; 10] = [1.1, 0.7, 0.9, 1.3, 0.6, 0.8, 0.5, 1.2, 0.4, 0.3];
        let mut wrong = Vec::new();
        for (number, parameters, expected) in PROBES.into_iter().chain([(75, 6, 0.774325875)]) {
            let internal = Internal::new(number, 2).unwrap();
            assert_eq!(internal.parameters, parameters + 3, "internal({number})");
            let arguments: Vec<f64> = [0.3, 0.4, 0.5].into_iter().chain(P).take(parameters + 3).collect();
            let found = internal.call(&arguments);
            if found.is_nan() || (found - expected).abs() >= 1e-8 {
                wrong.push(format!("internal({number}) is {found}, not {expected}"));
            }
        }
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    }

    #[test]
    fn noise_functions_are_povrays() {
        let probes: [(u8, &[f64], f64); 7] = [
            (78, &[1.3, 2.7, 3.1, 0.0], 0.315280502678),
            (78, &[1.3, 2.7, 3.1, 2.0], 0.425048141254),
            (78, &[1.3, 2.7, 3.1, 3.0], 0.594674075620),
            (76, &[1.3, 2.7, 3.1], 0.425048141254),
            (29, &[0.3, 0.4, 0.5, 0.8, 2.1, 3.5, 0.6, 2.0, 2.0], 0.899652435753),
            (58, &[0.3, 0.4, 0.5, 2.0, 3.25, 0.5, 0.4, 0.6, 1.0], -0.247250436117),
            (59, &[0.3, 0.4, 0.5, 0.8, 2.1, 4.0, 1.0, 2.0, 1.0], 1.076694432881),
        ];
        for (number, arguments, expected) in probes {
            let internal = Internal::new(number, 2).unwrap();
            assert_eq!(internal.parameters, arguments.len());
            let found = internal.call(arguments);
            assert!((found - expected).abs() < 1e-11, "internal({number}) is {found}, not {expected}");
        }
        assert!(Internal::new(77, 2).is_none());
        assert!(Internal::new(79, 2).is_none());
    }

    #[test]
    fn bands_hold_what_formulas_give() {
        const P: [f64; 10] = [1.1, 0.7, 0.9, 1.3, 0.6, 0.8, 0.5, 1.2, 0.4, 0.3];
        let (mut wide, mut all) = (Vec::new(), 0);
        for number in 0..=78 {
            let Some(internal) = Internal::new(number, 2) else { continue };
            let mut reach: f64 = 0.0;
            for n in 0..200_u32 {
                let at = |by: f64| (f64::from(n) * by).fract() * 2.0 - 1.0;
                let half = 0.6_f64.powi((n % 20) as i32);
                let middle = [at(0.754_877_666), at(0.569_840_290_9), at(0.430_159_709)];
                let slope = [at(0.123_456) * half, at(0.377_1) * half, at(0.918_27) * half];
                let point = |i: usize| Band::line(Lanes::splat(middle[i]), Lanes::splat(slope[i]));
                let parameters = P.map(Band::constant);
                let found = internal.enclose(&[&[point(0), point(1), point(2)], &parameters[..]].concat());
                for step in -4..=4 {
                    let s = f64::from(step) / 4.0;
                    let arguments: Vec<f64> = (0..3).map(|i| middle[i] + slope[i] * s).chain(P).collect();
                    let expected = internal.call(&arguments);
                    let off = (expected - found.middle.0[1] - found.slope.0[1] * s).abs();
                    assert!(
                        off.partial_cmp(&found.reach.0[1]) != Some(Ordering::Greater),
                        "internal({number}) is {off:e} off at {s} of {found:?}"
                    );
                }
                if n % 20 == 19 {
                    reach = reach.max(found.reach.0[1]);
                }
            }
            all += 1;
            if reach.is_nan() || reach >= 0.01 {
                wide.push(number);
            }
        }
        // Where angles jump, and beside the kinks of powers, a stretch may be as short as it likes.
        assert!(wide.len() <= 6 && all > 70, "{wide:?} of {all}");
    }
}
