//! A parametric surface around a point of its parameters: the plane that touches it, and what it leaves that by.

use super::piece::Part;
use super::{Description, Parametric};
use crate::math::{Band, DVec2, DVec3, Lanes};

/// The stretch that slopes are taken over, as a share of all parameters: where bands tell them exactly, and where
/// only differences do.
const STEPS: [f64; 2] = [1e-9, 1e-6];

/// What terms of the third order and higher may be, in what those of the second are by bands times how much of the
/// slopes these are.
const BEYOND: f64 = 4.0;

/// A part of a surface as a plane, with what it may be beside it.
pub(super) struct Local {
    /// In the middle.
    pub(super) point: DVec3,
    /// From the middle to either side.
    pub(super) slopes: [DVec3; 2],
    /// How far the terms of the second order reach: of one side, of the other, of both.
    pub(super) bends: [DVec3; 3],
    /// The same along the four lines through the middle: to the sides and the corners.
    lines: [DVec3; 4],
}

impl Local {
    fn new(point: DVec3, slopes: [DVec3; 2], lines: [DVec3; 4]) -> Self {
        let [u, v, rising, falling] = lines;
        Self { point, slopes, bends: [u, v, 0.5 * (rising + falling)], lines }
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
        if self.known { self.by_bands(part.middle, part.sides) } else { self.by_differences(part) }
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
        Local::new(point, slopes, lines)
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
        Local::new(point, [rise_u, rise_v], bends)
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
        if !self.known {
            return local;
        }
        let (point, told) = self.bends(part, local.slopes);
        let [u, v] = local.slopes.map(DVec3::length);
        let speeds = [u, v, u.max(v), u.max(v)];
        let lines = [0, 1, 2, 3].map(|i| {
            let share = local.lines[i].length() / speeds[i];
            local.lines[i].min(told[i] + local.lines[i] * (BEYOND * share))
        });
        Local::new(point, local.slopes, lines)
    }
}
