//! The rule that says whether povista's picture of a scene is POV-Ray's.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::picture::Difference;

/// Share of pixels that must be near, when POV-Ray's own picture is always the same.
const NEAR_SHARE: f64 = 0.995;

/// Mean absolute difference allowed then, in steps of 1/255.
const MEAN: f64 = 0.5;

/// RMSE always allowed where POV-Ray's own picture varies, in steps of 1/255.
const VARYING_RMSE: f64 = 2.0;

/// RMSE allowed there, as a multiple of POV-Ray's own spread.
const SPREADS: f64 = 2.0;

/// What a comparison came to; the order is from best to worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// The pictures are the same as far as anybody can tell.
    Match,
    /// povista made another picture.
    Differs,
    /// povista made no picture and said why.
    Refused,
    /// povista did not end within the limit.
    Timeout,
    /// povista ended without picture and without error.
    Crashed,
    /// POV-Ray itself makes no picture, so there is nothing to compare.
    Excluded,
}

impl Verdict {
    /// Every verdict, best first.
    pub const ALL: [Verdict; 6] = [
        Verdict::Match,
        Verdict::Differs,
        Verdict::Refused,
        Verdict::Timeout,
        Verdict::Crashed,
        Verdict::Excluded,
    ];
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.pad(match self {
            Verdict::Match => "match",
            Verdict::Differs => "differs",
            Verdict::Refused => "refused",
            Verdict::Timeout => "timeout",
            Verdict::Crashed => "crashed",
            Verdict::Excluded => "excluded",
        })
    }
}

/// Whether a difference alone makes a match, where POV-Ray is taken to be deterministic.
pub fn same(difference: &Difference) -> bool {
    difference.near >= NEAR_SHARE && difference.mean <= MEAN
}

/// Whether povista is as near to POV-Ray as POV-Ray, run with another number of threads, is to
/// itself. `spread` is that difference; a picture that doesn't vary gets no such leave.
pub fn same_within_spread(difference: &Difference, spread: &Difference) -> bool {
    spread.worst > 0 && difference.rmse <= VARYING_RMSE.max(SPREADS * spread.rmse)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn difference(near: f64, mean: f64, rmse: f64) -> Difference {
        Difference { worst: 255, near, mean, rmse }
    }

    #[test]
    fn a_match_needs_both_the_share_and_the_mean() {
        assert!(same(&difference(0.995, 0.5, 30.0)));
        assert!(!same(&difference(0.9949, 0.1, 1.0)));
        assert!(!same(&difference(1.0, 0.51, 0.6)));
    }

    #[test]
    fn a_varying_scene_is_measured_by_its_own_spread() {
        let noisy = difference(0.3, 3.0, 5.0);
        assert!(same_within_spread(&difference(0.2, 4.0, 10.0), &noisy));
        assert!(!same_within_spread(&difference(0.2, 4.0, 10.1), &noisy));
    }

    #[test]
    fn a_hardly_varying_scene_may_still_be_two_apart() {
        let calm = difference(0.99, 0.01, 0.1);
        assert!(same_within_spread(&difference(0.5, 1.5, 2.0), &calm));
        assert!(!same_within_spread(&difference(0.5, 1.5, 2.1), &calm));
    }

    #[test]
    fn a_scene_that_never_varies_gets_no_leave() {
        let still = Difference { worst: 0, near: 1.0, mean: 0.0, rmse: 0.0 };
        assert!(!same_within_spread(&difference(0.99, 0.4, 1.0), &still));
    }
}
