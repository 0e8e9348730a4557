//! Four rays near each other that come in together, searched as one beam until the surface is near.
//!
//! Over a stretch all four are within a reach of the line through their midst, so what bands say of that line with this
//! reach is true of all of them. Where the function surely crosses zero each ray is a lane of its own from there on.

use std::cell::Cell;

use smallvec::SmallVec;

use super::root::{STEPS, bettered, least_step};
use super::search::{Look, Zone, cell_end, loosened};
use super::{Isosurface, Stretch};
use crate::math::wide::widest;
use crate::math::{Band, Lanes};
use crate::world::shape::Crossing;
use crate::world::{Range, Rays};

/// So many times four stretches of a beam are looked at before its rays go on alone.
const LOOKS: u32 = 6;

/// So many looks at a stretch of each ray bring it down to the accuracy, or the ray goes on alone.
const CLOSER: u32 = 4;

/// Rays as one, in distances from a common one.
struct Beam<'a> {
    surface: &'a Isosurface,
    /// The rays from there; those that are not asked for go where another does.
    rays: Rays,
    /// Their lengths.
    speeds: Lanes,
    /// The line through their midst: its start and direction.
    midst: [[f64; 2]; 3],
    /// How far rays start from its start, and what their directions differ.
    off: [[Lanes; 2]; 3],
    steepest: Cell<f64>,
}

/// What a beam finds of rays that are above the threshold where they come in.
enum Seen {
    /// They stay above it.
    Nothing,
    /// They are above it until the first place, and perhaps not until the second.
    Clear([f64; 2]),
    /// They cross it between two places, and are above it before.
    Certain([f64; 2]),
}

impl Isosurface {
    /// See [`Shape::nearest_together`](crate::world::shape::Shape::nearest_together); for functions of which something
    /// is known.
    pub(super) fn nearest_of_beam(
        &self,
        rays: &Rays,
        asked: u32,
        ends: &Lanes,
        found: &mut [Option<Crossing>; Lanes::COUNT],
    ) {
        let mut stretches = [None; Lanes::COUNT];
        let (mut together, mut alone) = (0, 0);
        let mut begins = Lanes::splat(f64::INFINITY);
        let mut end = f64::NEG_INFINITY;
        for lane in (0..Lanes::COUNT).filter(|lane| asked >> lane & 1 == 1) {
            let stretch = self.container.stretch(&rays.ray(lane));
            let Some(stretch) = stretch.filter(|s| s.enter.t.is_finite() && s.leave.t > 0.0) else {
                continue;
            };
            if stretch.enter.t <= 0.0 {
                alone |= 1 << lane;
            } else if stretch.enter.t <= ends.0[lane] {
                together |= 1 << lane;
                begins.0[lane] = stretch.enter.t;
                end = end.max(stretch.leave.t.min(ends.0[lane]));
                stretches[lane] = Some(stretch);
            }
        }
        if u32::count_ones(together) < 2 {
            self.alone(rays, alone | together, ends, None, found);
            return;
        }
        self.alone(rays, alone, ends, None, found);
        let start = begins.0.into_iter().fold(f64::INFINITY, f64::min);
        let beam = Beam::new(self, rays, start, together);
        let first = beam.first_look(end - start);
        let is_late = begins.bits(|t| t > start + 2.0 * first.halves.0[0]) & together != 0;
        let below = first.starts_below().filter(|_| !is_late);
        if below != Some(false) {
            let inside = if below == Some(true) {
                together
            } else {
                let begins = begins.lesser(Lanes::splat(end)) - start;
                beam.value(begins).bits(|value| value < 0.0) & together
            };
            for lane in (0..Lanes::COUNT).filter(|lane| inside >> lane & 1 == 1) {
                let enter = stretches[lane].filter(|_| !self.open).map(|stretch| stretch.enter);
                found[lane] = enter.map(|enter| Crossing::new(enter.t, enter.part + 1));
            }
            if self.open {
                self.alone(rays, inside, ends, None, found);
            }
            together &= !inside;
        }
        if together != 0 {
            match beam.seen(first) {
                Seen::Nothing => {}
                Seen::Clear(places) => {
                    self.alone(rays, together, ends, Some(places.map(|place| start + place)), found);
                }
                Seen::Certain(places) => {
                    let (roots, mut sure) = beam.roots(places, together);
                    // What a ray crosses before it comes in is none of the surface.
                    sure &= !(begins - start - roots).bits(|early| early > 0.0);
                    for lane in (0..Lanes::COUNT).filter(|lane| sure >> lane & 1 == 1) {
                        let t = start + roots.0[lane];
                        let stretch = stretches[lane].filter(|s| t <= s.leave.t && t <= ends.0[lane]);
                        found[lane] = stretch.map(|stretch| beam.crossing(lane, t, &stretch));
                    }
                    let places = places.map(|place| start + place);
                    self.alone(rays, together & !sure, ends, Some(places), found);
                }
            }
        }
        self.meet(beam.steepest.get());
    }

    /// Asks for rays one by one of which `asked` has the bits; see [`Asked::clear`](super::Asked).
    fn alone(
        &self,
        rays: &Rays,
        asked: u32,
        ends: &Lanes,
        clear: Option<[f64; 2]>,
        found: &mut [Option<Crossing>; Lanes::COUNT],
    ) {
        for lane in (0..Lanes::COUNT).filter(|lane| asked >> lane & 1 == 1) {
            let range = Range { min: 0.0, max: ends.0[lane].next_up() };
            found[lane] = self.nearest_beyond(&rays.ray(lane), range, clear);
        }
    }
}

impl<'a> Beam<'a> {
    /// Of the rays of which `asked` has the bits, from `start` on.
    fn new(surface: &'a Isosurface, rays: &Rays, start: f64, asked: u32) -> Self {
        let mut all = *rays;
        let first = asked.trailing_zeros() as usize % Lanes::COUNT;
        let (mut midst, mut off) = ([[0.0; 2]; 3], [[Lanes::ZERO; 2]; 3]);
        for axis in 0..3 {
            let (origin, direction) = (&mut all.origin[axis], &mut all.direction[axis]);
            for lane in (0..Lanes::COUNT).filter(|lane| asked >> lane & 1 == 0) {
                (origin.0[lane], direction.0[lane]) = (origin.0[first], direction.0[first]);
            }
            *origin = *origin + *direction * start;
            let middle = |v: &Lanes| 0.25 * (v.0[0] + v.0[1] + v.0[2] + v.0[3]);
            midst[axis] = [middle(origin), middle(direction)];
            off[axis] = [*origin - midst[axis][0], *direction - midst[axis][1]];
        }
        let speeds = Lanes::dot(&all.direction, &all.direction).sqrt();
        Self { surface, rays: all, speeds, midst, off, steepest: Cell::new(0.0) }
    }

    /// A look at the quarters of the whole way.
    fn first_look(&self, end: f64) -> Look {
        widest(
            #[inline(always)]
            || self.look(0.0, end),
        )
    }

    /// What the rays that come in above the threshold come to, given the first look. Where the beam is below it
    /// those that do so have not come in yet.
    fn seen(&self, first: Look) -> Seen {
        widest(
            #[inline(always)]
            || {
                let mut waiting: SmallVec<[Zone; 32]> = SmallVec::new();
                let (mut look, mut looks) = (first, 1);
                loop {
                    let from = look.middles.0[0] - look.halves.0[0];
                    if look.divide(1.0, &mut waiting, |gradient| self.meet(gradient)) {
                        return Seen::Clear([from, from]);
                    }
                    let Some(zone) = waiting.pop() else { return Seen::Nothing };
                    let places = [zone.from, zone.to];
                    if zone.certain {
                        return Seen::Certain(places);
                    }
                    if zone.unknown || looks == LOOKS {
                        return Seen::Clear(places);
                    }
                    looks += 1;
                    look = self.look(zone.from, zone.to);
                }
            },
        )
    }

    /// The function's values at the rays' places, less the threshold.
    #[inline(always)]
    fn value(&self, t: Lanes) -> Lanes {
        let Rays { origin: o, direction: d } = &self.rays;
        let along = |axis: usize| t * d[axis] + o[axis];
        self.surface.function.at_four(&[along(0), along(1), along(2)]) - self.surface.threshold
    }

    /// Meets a gradient by the distance of rays.
    fn meet(&self, gradient: f64) {
        let speed = self.speeds.0.into_iter().fold(0.0, f64::max);
        self.steepest.set(self.steepest.get().max(gradient / speed));
    }

    /// A look at the quarters of a stretch of all rays.
    #[inline(always)]
    fn look(&self, from: f64, to: f64) -> Look {
        let half = 0.125 * (to - from);
        let middles = Lanes([1.0, 3.0, 5.0, 7.0]) * half + from;
        let ends = [middles - half, middles + half];
        let mut point = [Band::constant(0.0); 3];
        for (axis, point) in point.iter_mut().enumerate() {
            let ([origin, direction], [off, turn]) = (self.midst[axis], &self.off[axis]);
            let mut reach = Lanes::ZERO;
            for lane in 0..Lanes::COUNT {
                for end in &ends {
                    reach = (*end * turn.0[lane] + off.0[lane]).abs().greater(reach);
                }
            }
            let middle = middles * direction + origin;
            *point = Band { middle, slope: Lanes::splat(half * direction), reach }.loose();
        }
        Look { middles, halves: Lanes::splat(half), band: self.enclose(&point) }
    }

    #[inline(always)]
    fn enclose(&self, point: &[Band; 3]) -> Band {
        self.surface.function.enclose(point) - Band::constant(self.surface.threshold)
    }

    /// Where rays that cross zero between two places do so, and the bits of those that surely find it there.
    fn roots(&self, [from, to]: [f64; 2], asked: u32) -> (Lanes, u32) {
        widest(
            #[inline(always)]
            || {
                let accuracy = self.accuracies() / self.speeds;
                let (mut from, mut to) = (Lanes::splat(from), Lanes::splat(to));
                let (mut slope, mut sure) = (Lanes::ZERO, asked);
                for look in 0..CLOSER {
                    let long = (to - from - accuracy).bits(|longer| longer > 0.0) & sure;
                    if sure == 0 || long == 0 && look > 0 {
                        break;
                    }
                    let half = (to - from) * 0.5;
                    let middle = from + half;
                    let Rays { origin: o, direction: d } = &self.rays;
                    let along = |axis: usize| Band::line(middle * d[axis] + o[axis], half * d[axis]);
                    let Band { middle: c, slope: k, reach } = self.enclose(&[along(0), along(1), along(2)]);
                    for lane in 0..Lanes::COUNT {
                        let (c, k) = (c.0[lane], k.0[lane]);
                        let reach = loosened(reach.0[lane], c, k);
                        if k < 0.0 && c + reach < -k {
                            let (a, b) = (((c - reach) / -k).max(-1.0), ((c + reach) / -k).max(-1.0));
                            let (middle, half) = (middle.0[lane], half.0[lane]);
                            from.0[lane] = from.0[lane].max(middle + half * a);
                            to.0[lane] = to.0[lane].min(middle + half * b);
                            slope.0[lane] = k / half;
                        } else {
                            sure &= !(1 << lane);
                        }
                    }
                }
                sure &= !(to - from - accuracy).bits(|longer| longer > 0.0);
                self.straight_to_roots([from, to], slope, sure)
            },
        )
    }

    /// The lengths of stretches that are not divided any more.
    fn accuracies(&self) -> Lanes {
        self.speeds.lesser(Lanes::splat(1.0)) * self.surface.accuracy
    }

    /// Steps with the slopes known and then by the secant method, as [`Zone`]s go to their roots one by one.
    #[inline(always)]
    fn straight_to_roots(&self, [from, to]: [Lanes; 2], mut slope: Lanes, mut sure: u32) -> (Lanes, u32) {
        let mut roots = (from + to) * 0.5;
        if sure == 0 {
            return (roots, sure);
        }
        let (mut t, mut here) = (roots, self.value(roots));
        let ([mut last, mut before], mut found) = ([to - from, Lanes::ZERO], 0);
        let Rays { origin: [x, y, z], .. } = &self.rays;
        let far = x.abs().greater(y.abs()).greater(z.abs()) / self.speeds;
        for _ in 0..STEPS {
            let next = t - here / slope;
            let step = (next - t).abs();
            for lane in 0..Lanes::COUNT {
                let (place, step) = (next.0[lane], step.0[lane]);
                if found >> lane & 1 == 1 {
                    continue;
                }
                if !(from.0[lane] <= place && place <= to.0[lane]) {
                    sure &= !(1 << lane);
                }
                // Each step is the product of both before it times how much the function bends.
                let rest = step * (step / before.0[lane]).min(1.0);
                let is_least = step <= least_step(far.0[lane] + to.0[lane]);
                if here.0[lane] == 0.0 || rest <= 0.25 * f64::EPSILON * place.abs() || is_least {
                    roots.0[lane] = place;
                    found |= 1 << lane;
                }
            }
            if found & sure == sure {
                break;
            }
            let there = self.value(next);
            slope = slope.zip((there - here) / (next - t), bettered);
            (before, last) = (last, step);
            (t, here) = (next, there);
        }
        (roots, sure & found)
    }

    /// The crossing of a ray, and how far behind it POV-Ray finds it.
    fn crossing(&self, lane: usize, t: f64, stretch: &Stretch) -> Crossing {
        let (speed, begin) = (self.speeds.0[lane], stretch.enter.t);
        let [root, end] = [t, stretch.leave.t].map(|t| (t - begin) * speed);
        let after = cell_end(self.accuracies().0[lane], [0.0, end], root);
        Crossing { at: [(after - root) / speed, 0.0], ..Crossing::new(t, 0) }
    }
}
