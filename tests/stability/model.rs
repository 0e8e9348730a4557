//! What a surface is, as equations that any kind of number can be put into.

use povista::math::DVec3;
use povista::world::Ray;

use crate::certify::{Along, Cell, Cells, Limits, Zeros, isolate};
use crate::double::Double;
use crate::form::{self, Form};
use crate::interval::{Interval, Scalar};
use crate::real::{Jet, Moved, Real, Ring};

/// A surface made of pieces: each where an equation is zero and a limit, if there is one, negative.
pub(crate) trait Model: Sync {
    fn pieces(&self) -> usize {
        1
    }

    fn equation<T: Real>(&self, piece: usize, p: &[T; 3]) -> T;

    fn limit<T: Real>(&self, _piece: usize, _p: &[T; 3]) -> Option<T> {
        None
    }

    /// Half the side of a cube about the origin that holds the surface, or what is looked at of it.
    fn reach(&self) -> f64;

    /// The same where it is a polynomial whose zeros are found by its form.
    fn polynomial<T: Ring>(&self, _piece: usize, _p: &[T; 3]) -> Option<T> {
        None
    }

    /// A ball that holds a piece, if there is need to pass over it quickly.
    fn ball(&self, _piece: usize) -> Option<(DVec3, f64)> {
        None
    }
}

/// What is shot at: a [`Model`], or a surface whose crossings are found in a way of its own.
pub(crate) trait Subject: Sync {
    /// Half the side of a cube about the origin that holds the surface, or what is looked at of it.
    fn reach(&self) -> f64;

    /// All crossings of a line within a little more than the reach.
    fn meet(&self, line: &Line) -> Meeting;

    /// All crossings of a line moved aside by no more than its room, with what is known of it: their distances may be
    /// rough.
    fn meet_beside(&self, line: &Line, _known: &Meeting, by: DVec3) -> Meeting {
        self.meet(&line.moved(by))
    }

    /// A function that is zero on the surface: its sensitivity to the inputs and its gradient at a crossing.
    fn sensitivity(&self, line: &Line, at: &Exact) -> Moved;

    /// By how much a line has to be moved to be on a piece at this distance, to the first order.
    fn moves_onto(&self, _line: &Line, _t: Double) -> Vec<DVec3> {
        Vec::new()
    }
}

/// A ray in the space of a model, from where it passes the origin.
pub(crate) struct Line {
    pub(crate) origin: [Double; 3],
    pub(crate) direction: [Double; 3],
    /// Distance from the ray's own start to here.
    pub(crate) shift: f64,
    /// How far rounding of the ray's and the place's numbers by four units may move it.
    pub(crate) room: f64,
}

impl Line {
    /// The ray relative to a place.
    pub(crate) fn new(ray: &Ray, place: DVec3, reach: f64) -> Self {
        let from = ray.origin - place;
        let shift = -from.dot(ray.direction) / ray.direction.length_squared();
        let origin = std::array::from_fn(|i| {
            Double::of(ray.origin[i]) - Double::of(place[i])
                + Double::of(shift) * Double::of(ray.direction[i])
        });
        let size = [ray.origin, place, shift * ray.direction].map(|v| v.abs().max_element());
        let room = 4.0 * f64::EPSILON * size.iter().fold(reach, |a, b| a.max(*b));
        Self { origin, direction: ray.direction.to_array().map(Double::of), shift, room }
    }

    /// The same moved aside.
    pub(crate) fn moved(&self, by: DVec3) -> Self {
        let origin = std::array::from_fn(|i| self.origin[i] + Double::of(by[i]));
        Self { origin, ..*self }
    }

    fn at<S: Scalar>(&self, t: Interval<S>, start: impl Fn(Double) -> Interval<S>) -> [Jet<S>; 3] {
        std::array::from_fn(|i| {
            let slope = S::around(self.direction[i]);
            Jet { value: start(self.origin[i]) + t * slope, slope }
        })
    }

    fn rough(&self, t: Interval<f64>) -> [Jet<f64>; 3] {
        self.at(t, |x| self.loosely(x))
    }

    fn loosely(&self, x: Double) -> Interval<f64> {
        Interval::point(x.to_f64()).widened(self.room)
    }

    /// The coordinates over a stretch.
    fn forms<S: Scalar>(&self, t: Interval<S>, start: impl Fn(Double) -> Interval<S>) -> [Form<S>; 3] {
        std::array::from_fn(|i| {
            let at = |t: S| start(self.origin[i]) + Interval::point(t) * S::around(self.direction[i]);
            Form::line(at(t.low), at(t.high))
        })
    }

    fn fine(&self, t: Interval<Double>) -> [Jet<Double>; 3] {
        self.at(t, Interval::point)
    }

    /// The point nearest to the exact one.
    pub(crate) fn point(&self, t: Double) -> DVec3 {
        DVec3::from_array(std::array::from_fn(|i| (self.origin[i] + t * self.direction[i]).to_f64()))
    }

    pub(crate) fn direction(&self) -> DVec3 {
        DVec3::from_array(self.direction.map(Double::to_f64))
    }
}

struct Piece<'a, M> {
    model: &'a M,
    number: usize,
    line: &'a Line,
}

impl<M: Model> Piece<'_, M> {
    fn cells<S: Scalar>(
        &self,
        range: Interval<S>,
        limits: Limits,
        start: impl Fn(Double) -> Interval<S>,
        jet: impl Fn(Interval<S>) -> Jet<S>,
        found: &mut dyn FnMut(Cell<S>),
    ) {
        let form = |over| self.model.polynomial(self.number, &self.line.forms(over, &start));
        match form(range) {
            Some(whole) => {
                let over = |part| form(part).expect("it is a polynomial everywhere");
                form::isolate(whole, over, range, limits, found);
            }
            None => isolate(jet, |t| self.is_beyond(t), range, limits, found),
        }
    }
}

impl<M: Model> Along for Piece<'_, M> {
    fn rough(&self, t: Interval<f64>) -> Jet<f64> {
        self.model.equation(self.number, &self.line.rough(t))
    }

    fn fine(&self, t: Interval<Double>) -> Jet<Double> {
        self.model.equation(self.number, &self.line.fine(t))
    }

    fn is_beyond(&self, t: Interval<f64>) -> bool {
        let limit = self.model.limit(self.number, &self.line.rough(t));
        limit.is_some_and(|limit| limit.value.is_positive())
    }

    fn rough_cells(&self, range: Interval<f64>, limits: Limits, found: &mut dyn FnMut(Cell<f64>)) {
        self.cells(range, limits, |x| self.line.loosely(x), |t| self.rough(t), found);
    }

    fn fine_cells(&self, range: Interval<Double>, limits: Limits, found: &mut dyn FnMut(Cell<Double>)) {
        self.cells(range, limits, Interval::point, |t| self.fine(t), found);
    }

    fn counts(&self, t: Interval<Double>) -> Option<bool> {
        let Some(limit) = self.model.limit(self.number, &self.line.fine(t)) else { return Some(true) };
        (!limit.value.has_zero()).then(|| limit.value.is_negative())
    }
}

/// A crossing, exactly.
#[derive(Clone, Copy)]
pub(crate) struct Exact {
    /// From where the line passes the origin.
    pub(crate) t: Double,
    pub(crate) piece: usize,
    /// Where on the piece, if that is a curve.
    pub(crate) w: Double,
}

/// Everything known about a line and a model.
#[derive(Default)]
pub(crate) struct Meeting {
    pub(crate) crossings: Vec<Exact>,
    pub(crate) doubtful: Vec<f64>,
    /// Whether a change of the ray by four units in the last place may change the count.
    pub(crate) close: bool,
    /// Where on each piece crossings are of this line and all others within its room.
    cells: Vec<(usize, Cells)>,
}

impl Meeting {
    fn add(&mut self, piece: usize, Zeros { at, doubtful, close }: Zeros) {
        self.crossings.extend(at.into_iter().map(|t| Exact { t, piece, w: Double::of(0.0) }));
        self.doubtful.extend(doubtful);
        self.close |= close;
    }

    pub(crate) fn sorted(mut self) -> Self {
        self.crossings.sort_by(|a, b| a.t.partial_cmp(&b.t).expect("crossings are at numbers"));
        self
    }
}

/// Half the length of the line that is looked at; `None` of one that passes far away.
pub(crate) fn half_length(model: &impl Subject, line: &Line) -> Option<f64> {
    // More than the way from the middle of the cube to its corners.
    let reach = 1.8 * model.reach();
    let beside = line.point(Double::of(0.0)).abs().max_element();
    (beside <= reach).then(|| reach / line.direction().length())
}

impl<M: Model> Subject for M {
    fn reach(&self) -> f64 {
        Model::reach(self)
    }

    fn meet(&self, line: &Line) -> Meeting {
        let mut out = Meeting::default();
        let Some(half) = half_length(self, line) else { return out };
        let (from, speed) = (line.point(Double::of(0.0)), line.direction().length());
        let along = line.direction() / speed;
        for number in 0..self.pieces() {
            let (mut low, mut high) = (-half, half);
            if let Some((center, radius)) = self.ball(number) {
                let radius = radius * 1.001 + 10.0 * line.room;
                let square = radius * radius - along.cross(center - from).length_squared();
                if square < 0.0 {
                    continue;
                }
                let (middle, chord) = (along.dot(center - from), square.sqrt());
                // Never through the middle, where symmetric shapes have their roots.
                (low, high) = ((middle - chord) / speed, (middle + 1.03 * chord) / speed);
            }
            let piece = Piece { model: self, number, line };
            let cells = Cells::new(&piece, low, high);
            out.add(number, cells.zeros(&piece, true));
            out.cells.push((number, cells));
        }
        out.sorted()
    }

    fn meet_beside(&self, line: &Line, known: &Meeting, by: DVec3) -> Meeting {
        let (mut out, line) = (Meeting::default(), &line.moved(by));
        for (number, cells) in &known.cells {
            let piece = Piece { model: self, number: *number, line };
            out.add(*number, cells.zeros(&piece, false));
        }
        out.sorted()
    }

    fn sensitivity(&self, line: &Line, at: &Exact) -> Moved {
        let p = line.point(at.t);
        let point = std::array::from_fn(|i| {
            let slope = std::array::from_fn(|j| f64::from(u8::from(i == j)));
            Moved { value: p[i], by: p[i].abs() + line.room / (4.0 * f64::EPSILON), slope }
        });
        self.equation(at.piece, &point)
    }

    fn moves_onto(&self, line: &Line, t: Double) -> Vec<DVec3> {
        let onto = |piece| {
            let value = self.equation(piece, &line.fine(Interval::point(t))).value.middle().to_f64();
            let rise =
                DVec3::from_array(self.sensitivity(line, &Exact { t, piece, w: Double::of(0.0) }).slope);
            rise * (-value / rise.length_squared())
        };
        (0..self.pieces()).map(onto).collect()
    }
}
