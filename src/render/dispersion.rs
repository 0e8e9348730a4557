//! Light split into its colours (docs/spec/shading.md 13).

use crate::math::Rgb;

/// The shortest wavelength, in nanometres.
const SHORTEST: f64 = 380.0;
/// From the shortest to the longest.
const SPREAD: f64 = 350.0;
/// The wavelength that takes the index as written.
const MIDDLE: f64 = 555.0;

/// Wavelength of the first entry of the table, and from one to the next.
const TABLE_START: f64 = 375.0;
const TABLE_STEP: f64 = 5.0;

/// How much of each channel lies at wavelengths up to an entry's: red, green and blue.
const CUMULATIVE: [[f32; 74]; 3] = [
    [
        0.0000, 0.0009, 0.0029, 0.0058, 0.0094, 0.0135, 0.0178, 0.0223, 0.0267, 0.0308, 0.0344, 0.0374,
        0.0394, 0.0404, 0.0404, 0.0404, 0.0404, 0.0404, 0.0404, 0.0404, 0.0404, 0.0404, 0.0404, 0.0404,
        0.0404, 0.0404, 0.0404, 0.0404, 0.0404, 0.0404, 0.0404, 0.0404, 0.0404, 0.0404, 0.0404, 0.0404,
        0.0404, 0.0404, 0.0404, 0.0404, 0.0429, 0.0502, 0.0620, 0.0780, 0.0979, 0.1215, 0.1483, 0.1781,
        0.2105, 0.2454, 0.2823, 0.3210, 0.3611, 0.4024, 0.4446, 0.4873, 0.5302, 0.5731, 0.6155, 0.6573,
        0.6982, 0.7377, 0.7756, 0.8116, 0.8454, 0.8767, 0.9052, 0.9306, 0.9525, 0.9707, 0.9849, 0.9947,
        0.9998, 1.0,
    ],
    [
        0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000,
        0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000,
        0.0000, 0.0045, 0.0131, 0.0256, 0.0417, 0.0612, 0.0839, 0.1095, 0.1378, 0.1684, 0.2013, 0.2360,
        0.2724, 0.3102, 0.3492, 0.3891, 0.4297, 0.4707, 0.5119, 0.5530, 0.5937, 0.6340, 0.6733, 0.7117,
        0.7487, 0.7841, 0.8178, 0.8494, 0.8786, 0.9054, 0.9293, 0.9501, 0.9677, 0.9817, 0.9919, 0.9981, 1.0,
        1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    ],
    [
        0.0000, 0.0038, 0.0113, 0.0222, 0.0363, 0.0534, 0.0734, 0.0960, 0.1210, 0.1482, 0.1775, 0.2085,
        0.2412, 0.2753, 0.3106, 0.3470, 0.3841, 0.4219, 0.4600, 0.4984, 0.5368, 0.5750, 0.6128, 0.6500,
        0.6864, 0.7218, 0.7560, 0.7888, 0.8200, 0.8494, 0.8768, 0.9020, 0.9248, 0.9449, 0.9623, 0.9767,
        0.9878, 0.9956, 0.9997, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
        1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    ],
];

/// A share of the spectrum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Band {
    /// Its middle, in nanometres.
    pub(super) wavelength: f64,
    /// Its share of white light.
    pub(super) share: Rgb,
}

/// The spectrum in `count` equal bands.
pub(super) fn bands(count: u32) -> impl Iterator<Item = Band> {
    let width = SPREAD / f64::from(count);
    (0..count).map(move |index| {
        let wavelength = SHORTEST + width * (f64::from(index) + 0.5);
        let share = cumulative(wavelength + width / 2.0) - cumulative(wavelength - width / 2.0);
        Band { wavelength, share }
    })
}

/// The ratio of refractive indices for light of a wavelength, `dispersion` being the ratio of the
/// dispersions.
pub(super) fn ratio(ratio: f64, dispersion: f64, wavelength: f64) -> f64 {
    ratio * dispersion.powf(-(wavelength - MIDDLE) / SPREAD)
}

fn cumulative(wavelength: f64) -> Rgb {
    let place = ((wavelength - TABLE_START) / TABLE_STEP).clamp(0.0, 73.0);
    let (index, share) = (place as usize, place.fract() as f32);
    let at = |table: &[f32; 74]| table[index] + share * (table[(index + 1).min(73)] - table[index]);
    Rgb::new(at(&CUMULATIVE[0]), at(&CUMULATIVE[1]), at(&CUMULATIVE[2]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The visible range cuts off the ends of the table, so a little red and blue is missing.
    #[test]
    fn bands_add_up_to_the_same_near_white_however_many_there_are() {
        let whole: Rgb = bands(1).map(|band| band.share).sum();
        assert!(whole.min_element() > 0.98 && whole.max_element() <= 1.0, "{whole}");
        for count in [2, 3, 7, 20] {
            let sum: Rgb = bands(count).map(|band| band.share).sum();
            assert!(sum.abs_diff_eq(whole, 1e-6), "{count}: {sum}, all at once {whole}");
        }
    }

    #[test]
    fn blue_bends_more_than_red() {
        let at = |wavelength| ratio(1.0 / 1.5, 1.0 / 1.1, wavelength);
        assert!(at(400.0) < at(555.0) && at(555.0) < at(700.0));
        assert_eq!(at(555.0), 1.0 / 1.5);
    }
}
