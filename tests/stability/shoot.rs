//! Rays at a subject, and what is wrong with the answers.

use povista::math::DVec3;
use povista::world::{Geometry, Range, Ray, RayKind};

use crate::double::Double;
use crate::model::{Exact, Line, Meeting, Subject, half_length};
use crate::real::Moved;

/// What to shoot at.
pub(crate) struct Target<'a, M> {
    pub(crate) model: &'a M,
    pub(crate) geometry: &'a Geometry,
    /// Its size, and where it is.
    pub(crate) size: f64,
    pub(crate) place: DVec3,
}

/// More crossings than any subject has.
const MOST: usize = 5000;

/// By so many units a distance may be off.
const LEAP: f64 = 8.0;

/// How the answers were.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Score {
    pub(crate) rays: u64,
    pub(crate) hits: u64,
    pub(crate) false_hits: u64,
    pub(crate) missed: u64,
    pub(crate) undecidable: u64,
    /// Worst error of a distance, in units of the last place times the condition of the hit.
    pub(crate) ulps: f64,
    /// Worst error of a normal.
    pub(crate) degrees: f64,
}

impl Score {
    pub(crate) fn add(&mut self, other: &Self) {
        self.rays += other.rays;
        self.hits += other.hits;
        self.false_hits += other.false_hits;
        self.missed += other.missed;
        self.undecidable += other.undecidable;
        self.ulps = self.ulps.max(other.ulps);
        self.degrees = self.degrees.max(other.degrees);
    }
}

/// Numbers evenly spread that depend on nothing but a counter.
pub(crate) struct Dice(u64);

impl Dice {
    pub(crate) fn new(number: u64) -> Self {
        Self(number.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5851_f42d_4c95_7f2d)
    }

    /// From 0 to 1.
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (x ^ (x >> 31)) as f64 / u64::MAX as f64
    }

    /// In the cube from -1 to 1.
    pub(crate) fn cube(&mut self) -> DVec3 {
        DVec3::new(self.unit(), self.unit(), self.unit()) * 2.0 - 1.0
    }
}

impl<M: Subject> Target<'_, M> {
    /// Ray `number`: from inside the shape to 10^5 sizes away, every third aimed at the silhouette, past
    /// it by 10^-3 to 10^-12 of the size.
    pub(crate) fn ray(&self, number: u64) -> Ray {
        let mut dice = Dice::new(number);
        let ray = self.random(number, &mut dice);
        if !number.is_multiple_of(3) {
            return ray;
        }
        let range = Range { min: f64::NEG_INFINITY, max: f64::INFINITY };
        let Some(hit) = self.geometry.hit(&ray, range, RayKind::empty()) else { return ray };
        let on = self.geometry.surface(&ray, &hit);
        let (u, v) = on.geometric.any_orthonormal_pair();
        let (sin, cos) = (dice.unit() * std::f64::consts::TAU).sin_cos();
        let past =
            self.size * 10f64.powf(-3.0 - 9.0 * dice.unit()) * if dice.unit() < 0.5 { -1.0 } else { 1.0 };
        let distance = self.size * [2.0, 30.0, 1e3][number as usize / 3 % 3];
        let along = u * cos + v * sin;
        let through = on.point + past * on.geometric;
        Ray::new(through - distance * along, along)
    }

    fn random(&self, number: u64, dice: &mut Dice) -> Ray {
        let distance = [1.0, 3.0, 30.0, 1e3, 1e5][number as usize % 5];
        let origin = self.place + self.size * distance * dice.cube();
        let target = self.place + self.size * dice.cube();
        Ray::new(origin, (target - origin).normalize())
    }

    /// Every crossing povista finds within the stretch that is looked at.
    fn found(&self, ray: &Ray, line: &Line) -> Vec<(f64, DVec3)> {
        let Some(half) = half_length(self.model, line) else { return Vec::new() };
        let mut range = Range { min: line.shift - half, max: line.shift + half };
        let mut found = Vec::new();
        while let Some(hit) = self.geometry.hit(ray, range, RayKind::empty()) {
            let normal = self.geometry.surface(ray, &hit).geometric;
            found.push((hit.t, normal));
            // The same root may come out a few bits larger when asked for from another start.
            let slant = normal.dot(ray.direction).abs().max(f64::EPSILON.sqrt());
            range.min = hit.t + 4.0 * f64::EPSILON * (hit.t.abs() + self.size) / slant;
            if found.len() > MOST {
                break;
            }
        }
        found
    }

    /// What there is to say about a ray: where it runs, and the crossings found and exact.
    pub(crate) fn story(&self, number: u64) -> String {
        let ray = self.ray(number);
        let line = Line::new(&ray, self.place, self.model.reach());
        let found: Vec<_> = self.found(&ray, &line).iter().map(|(t, _)| t - line.shift).collect();
        let exact = self.model.meet(&line);
        let crossings: Vec<_> = exact.crossings.iter().map(|crossing| crossing.t.to_f64()).collect();
        format!(
            "ray {number}: {ray:?}\n  found {found:?}\n  exact {crossings:?}, doubtful {:?}",
            exact.doubtful
        )
    }

    pub(crate) fn shoot(&self, number: u64) -> Score {
        let ray = self.ray(number);
        let line = Line::new(&ray, self.place, self.model.reach());
        let found = self.found(&ray, &line);
        let exact = self.model.meet(&line);
        let mut score = Score { rays: 1, hits: exact.crossings.len() as u64, ..Score::default() };
        let same = found.len() == exact.crossings.len();
        if exact.close || !exact.doubtful.is_empty() || !same {
            let hits: Vec<_> = found.iter().map(|(t, _)| t - line.shift).collect();
            let undecidable = !exact.doubtful.is_empty() || self.is_undecidable(&line, &exact, &hits);
            if undecidable {
                score.undecidable = 1;
                return score;
            }
        }
        if !same {
            let (found, exact) = (found.len() as u64, exact.crossings.len() as u64);
            score.false_hits = found.saturating_sub(exact);
            score.missed = exact.saturating_sub(found);
            return score;
        }
        for ((t, normal), crossing) in found.iter().zip(&exact.crossings) {
            let (ulps, degrees) = self.errors(&line, *t, *normal, crossing);
            if ulps.is_nan() || ulps >= 1e9 {
                score.false_hits += 1;
                score.missed += 1;
            } else {
                score.ulps = score.ulps.max(ulps);
                score.degrees = score.degrees.max(degrees);
            }
        }
        score
    }

    /// What is wrong with the nearest hit that another program finds: the distance, or none.
    pub(crate) fn judge_nearest(&self, number: u64, found: Option<f64>) -> Score {
        let ray = self.ray(number);
        let line = Line::new(&ray, self.place, self.model.reach());
        let exact = self.model.meet(&line);
        let nearest = exact.crossings.iter().find(|crossing| crossing.t.to_f64() + line.shift > 0.0);
        let mut score = Score { rays: 1, hits: u64::from(nearest.is_some()), ..Score::default() };
        let unclear = exact.close || !exact.doubtful.is_empty();
        if unclear && (!exact.doubtful.is_empty() || self.is_undecidable(&line, &exact, &[])) {
            score.undecidable = 1;
            return score;
        }
        match (found, nearest) {
            (None, None) => {}
            (None, Some(_)) => score.missed = 1,
            (Some(_), None) => score.false_hits = 1,
            (Some(t), Some(crossing)) => {
                let error = (t - crossing.t.to_f64() - line.shift).abs();
                if error > 1e-3 * self.size {
                    // Another crossing than the nearest, or none.
                    (score.missed, score.false_hits) = (1, 1);
                } else {
                    score.ulps = self.errors(&line, t, DVec3::X, crossing).0;
                }
            }
        }
        score
    }

    /// The errors of a distance and a normal.
    fn errors(&self, line: &Line, t: f64, normal: DVec3, crossing: &Exact) -> (f64, f64) {
        let t_exact = Double::of(line.shift) + crossing.t;
        let error = (Double::of(t) - t_exact).abs().to_f64();
        let moved = self.model.sensitivity(line, crossing);
        let gradient = DVec3::from_array(moved.slope);
        // Sine and cosine, since the cosine alone loses half the digits.
        let (sine, cosine) = (gradient.cross(normal).length(), gradient.dot(normal).abs());
        (error / unit(line, &moved, t), sine.atan2(cosine).to_degrees())
    }

    /// Whether some move of the line by four units in the last place of its numbers changes the count, or puts a
    /// crossing on another piece and farther away than a distance may be off.
    ///
    /// The condition of a hit is the slope of its distance as the line moves. That tells nothing of a line which
    /// runs along a wall, nearer to it than it is known itself: the line leaves the solid where the wall begins or,
    /// moved by no more than its rounding, at the other end of the wall, and has as many crossings either way.
    ///
    /// A line that all but lies in a plane crosses it only when it is moved by just the distance between them, so the
    /// moves that put it on a piece where hits were found are tried as well.
    fn is_undecidable(&self, line: &Line, exact: &Meeting, hits: &[f64]) -> bool {
        let mut dice = Dice::new(exact.crossings.len() as u64);
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        let aside = axes.into_iter().chain((0..4).map(|_| dice.cube().normalize()));
        let aside = aside.flat_map(|to| [to, -to]).map(|to| to * line.room);
        let onto = hits.iter().flat_map(|t| self.model.moves_onto(line, Double::of(*t)));
        aside.chain(onto.filter(|by| by.length() <= line.room)).any(|by| {
            let changes = |moved: &Meeting| {
                !moved.doubtful.is_empty() || moved.crossings.len() != exact.crossings.len()
            };
            let beside = self.model.meet_beside(line, exact, by);
            let elsewhere = |(one, other): (&Exact, &Exact)| one.piece != other.piece;
            if changes(&beside) || !exact.crossings.iter().zip(&beside.crossings).any(elsewhere) {
                return changes(&beside);
            }
            let moved = self.model.meet(&line.moved(by));
            let leaps = |(one, other): (&Exact, &Exact)| {
                one.piece != other.piece && {
                    let away = (one.t - other.t).abs().to_f64();
                    let moved = self.model.sensitivity(line, one);
                    away > LEAP * unit(line, &moved, one.t.to_f64() + line.shift)
                }
            };
            changes(&moved) || exact.crossings.iter().zip(&moved.crossings).any(leaps)
        })
    }
}

/// What a distance is off by when all inputs are off by one unit in the last place.
fn unit(line: &Line, moved: &Moved, t: f64) -> f64 {
    let slope = DVec3::from_array(moved.slope).dot(line.direction()).abs();
    f64::EPSILON * (moved.by / slope + t.abs())
}
