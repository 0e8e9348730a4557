//! A parametric surface around a point of its parameters: the plane that touches it, and what it leaves that by.

use super::piece::Part;
use super::{Description, Parametric};
use crate::math::{Band, DVec2, DVec3, Lanes, Slant};

/// The stretch that slopes are taken over, as a share of all parameters: where bands tell them exactly, and where
/// only differences do.
const STEPS: [f64; 2] = [1e-9, 1e-6];

/// The lane in which derivatives are taken in the middle of a part alone.
const MIDDLE: usize = 2;

/// What terms of the third order and higher may be, in what those of the second are by bands times how much of the
/// slopes these are.
const BEYOND: f64 = 4.0;

/// What is known of a part along four lines through its middle, to the middles of the sides (u, v) and to the corners
/// (their mean: m), times this holds for all of it, but for terms of the fourth order in the part's size.
///
/// With s and t as shares of the sides, terms of the second order are a s² + b s t + c t², and those of the third
/// A (s³ - s t²) + D (t³ - s² t) + R (s² t + s t²)/2 + F (s t² - s² t)/2, of which A and D are the values at the
/// middles of sides and R and F those at corners. At the two ends of a line even and odd terms add up and cancel each
/// other, so the larger end is as far from the plane as both together. Hence |a| + |A| ≤ u, |c| + |D| ≤ v and
/// |b| + (|R| + |F|)/2 ≤ m, and no term in brackets is above 1, or 2 for those over 2: all terms are at most
/// u + v + 2 m. Their derivatives by s are at most 2 u + m and 3 u + 2 v + 3 m, those by t the same with u and v
/// exchanged.
const SAFETY: f64 = 2.0;

/// A part of a surface as a plane, with what it may be beside it.
pub(super) struct Local {
    /// In the middle.
    pub(super) point: DVec3,
    /// From the middle to either side.
    pub(super) slopes: [DVec3; 2],
    /// How far anything of the part may be from the plane.
    pub(super) room: DVec3,
    /// What of this is the point's rounding.
    pub(super) rounding: DVec3,
    /// By how much the slopes may be others elsewhere in the part.
    pub(super) turns: [DVec3; 2],
    /// By how much they change along one side, and along the other.
    pub(super) along: [[DVec3; 2]; 2],
    /// Where derivatives aren't known, how far the part is from the plane along the four lines through the middle: to
    /// the sides and the corners.
    lines: Option<[DVec3; 4]>,
}

impl Local {
    /// From what a function's bands or values tell along four lines.
    fn by_lines(point: DVec3, slopes: [DVec3; 2], lines: [DVec3; 4]) -> Self {
        let [u, v, rising, falling] = lines;
        let mixed = 0.5 * (rising + falling);
        let both = 2.0 * (u + v) + 3.0 * mixed;
        Self {
            point,
            slopes,
            room: SAFETY * (u + v + mixed),
            rounding: DVec3::ZERO,
            turns: [u + both, v + both],
            along: [[2.0 * u, mixed], [mixed, 2.0 * v]],
            lines: Some(lines),
        }
    }

    /// The direction in which the part goes as near as it can along `direction`, by shares of its sides.
    pub(super) fn way(&self, direction: DVec3) -> DVec2 {
        let [u, v] = self.slopes;
        let (uu, uv, vv) = (u.dot(u), u.dot(v), v.dot(v));
        let (along_u, along_v) = (u.dot(direction), v.dot(direction));
        DVec2::new(vv * along_u - uv * along_v, uu * along_v - uv * along_u)
    }
}

impl Parametric {
    /// A part of the surface.
    pub(super) fn local(&self, part: &Part) -> Local {
        if !self.known {
            return self.by_differences(part);
        }
        self.by_slants(part).unwrap_or_else(|| self.by_bands(part.middle, part.sides))
    }

    /// How fast the point goes along u and v.
    pub(super) fn slopes(&self, at: DVec2) -> [DVec3; 2] {
        let Description { from, to, .. } = self.description;
        let step = STEPS[usize::from(!self.known)] * (to - from);
        if self.known {
            let [u, v] = self.by_bands(at, [step * DVec2::X, step * DVec2::Y]).slopes;
            return [u / step.x, v / step.y];
        }
        [DVec2::X, DVec2::Y].map(|axis| {
            let (before, after) = ((at - step * axis).max(from), (at + step * axis).min(to));
            (self.point(after) - self.point(before)) / (after - before).dot(axis)
        })
    }

    /// By bands of the derivatives; `None` where these aren't known in the middle.
    ///
    /// They are taken twice: along lines in the direction of one side with all of the other beside them, and the other
    /// way round. With a derivative within e of c + k s, s along the line, the way to any place of the part is within
    /// e + |k| / 2 of c times its share of the side.
    fn by_slants(&self, part: &Part) -> Option<Local> {
        let (middle, [u, v]) = (part.middle, part.sides);
        let at = [0, 1].map(|axis| {
            let lines = Band::line(Lanes::splat(middle[axis]), Lanes([u[axis], v[axis], 0.0, 0.0]));
            let beside = Lanes([v[axis].abs(), u[axis].abs(), 0.0, 0.0]);
            let value = Band { reach: lines.reach + beside, ..lines }.loose();
            Slant { value, rises: [u, v].map(|side| Band::constant(side[axis])) }
        });
        let at = [at[0], at[1], Slant::constant(0.0)];
        let slants = self.description.functions.each_ref().map(|function| function.slant(&at));
        let each = |of: &dyn Fn(&Slant) -> f64| DVec3::from_array(slants.each_ref().map(of));
        let slopes = [0, 1].map(|side| each(&|slant| slant.rises[side].middle.0[MIDDLE]));
        if !slants.iter().flat_map(|slant| slant.rises).all(|rise| rise.reach.0[MIDDLE].is_finite()) {
            return None;
        }
        let off = |side: usize, share: f64| {
            each(&|slant| {
                let Band { middle, slope, reach } = slant.rises[side];
                let [one, other] = [0, 1].map(|line| {
                    let off = (middle.0[line] - middle.0[MIDDLE]).abs();
                    off + share * slope.0[line].abs() + reach.0[line]
                });
                one.min(other)
            })
        };
        let rounding = each(&|slant| slant.value.reach.0[MIDDLE]);
        let along = |line: usize| [0, 1].map(|side| each(&|slant| slant.rises[side].slope.0[line].abs()));
        Some(Local {
            point: each(&|slant| slant.value.middle.0[MIDDLE]),
            slopes,
            room: off(0, 0.5) + off(1, 0.5) + rounding,
            rounding,
            turns: [off(0, 1.0), off(1, 1.0)],
            along: [along(0), along(1)],
            lines: None,
        })
    }

    /// By bands along the sides and both diagonals: they hold what the functions do between.
    fn by_bands(&self, middle: DVec2, [u, v]: [DVec2; 2]) -> Local {
        let lines = [u, v, u + v, u - v];
        let x = Band::line(Lanes::splat(middle.x), Lanes(lines.map(|line| line.x)));
        let y = Band::line(Lanes::splat(middle.y), Lanes(lines.map(|line| line.y)));
        let at = [x, y, Band::constant(0.0)];
        let bands = self.description.functions.each_ref().map(|function| function.enclose(&at));
        let each = |of: &dyn Fn(&Band) -> f64| DVec3::from_array(bands.each_ref().map(of));
        let point = each(&|band| band.middle.0[0]);
        let slopes = [0, 1].map(|i| each(&|band| band.slope.0[i]));
        let straight = [slopes[0], slopes[1], slopes[0] + slopes[1], slopes[0] - slopes[1]];
        let lines = [0, 1, 2, 3].map(|i| {
            each(&|band| band.reach.0[i])
                + (each(&|band| band.middle.0[i]) - point).abs()
                + (each(&|band| band.slope.0[i]) - straight[i]).abs()
        });
        Local::by_lines(point, slopes, lines)
    }

    /// By what the functions are at the ends of the same lines.
    fn by_differences(&self, part: &Part) -> Local {
        let Description { from, to, .. } = self.description;
        let [u, v] = part.sides;
        // Beside the parameters' ends they may be no numbers.
        let half = u.abs() + v.abs();
        let part = Part { middle: part.middle.clamp(from + half, (to - half).max(from + half)), ..*part };
        let [rise_u, rise_v] = [DVec2::X, DVec2::Y].map(|way| self.rise(&part, way));
        let (point, bends) = self.bends(&part, [rise_u, rise_v]);
        Local::by_lines(point, [rise_u, rise_v], bends)
    }

    /// Half the way between the points at both ends of a line through the middle.
    fn rise(&self, part: &Part, way: DVec2) -> DVec3 {
        0.5 * (self.point(part.at(way)) - self.point(part.at(-way)))
    }

    /// The point in the middle, and how far the ends of the four lines are from the plane.
    fn bends(&self, part: &Part, [u, v]: [DVec3; 2]) -> (DVec3, [DVec3; 4]) {
        let point = self.point(part.middle);
        let ends = [(DVec2::X, u), (DVec2::Y, v), (DVec2::ONE, u + v), (DVec2::new(1.0, -1.0), u - v)];
        let bends = ends.map(|(way, slope)| {
            let [ahead, behind] = [way, -way].map(|way| self.point(part.at(way)) - point);
            (ahead - slope).abs().max((behind + slope).abs())
        });
        (point, bends)
    }

    /// The same part, more exactly: what bands say is bent, terms that cancel each other included, shows whether
    /// terms of higher order matter; those of the second are as the ends of lines tell.
    pub(super) fn closer(&self, part: &Part, local: Local) -> Local {
        let Some(lines) = local.lines.filter(|_| self.known) else { return local };
        let (point, told) = self.bends(part, local.slopes);
        let [u, v] = local.slopes.map(DVec3::length);
        let speeds = [u, v, u.max(v), u.max(v)];
        let lines = [0, 1, 2, 3].map(|i| {
            let share = lines[i].length() / speeds[i];
            lines[i].min(told[i] + lines[i] * (BEYOND * share))
        });
        Local::by_lines(point, local.slopes, lines)
    }
}
