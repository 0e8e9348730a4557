//! Area lights: which places of a grid are asked, and what they make together
//! (docs/spec/shading.md 17).

use super::Target;
use crate::math::wide::widest;
use crate::math::{DVec2, DVec3, Rgb};
use crate::render::trace::Tracer;
use crate::world::accel::{Hull, Points};
use crate::world::hit::Among;
use crate::world::light::{AreaLight, Incident};
use crate::world::outline::{Caster, Outlines, Sight};
use crate::world::screen::{Cone, OPEN, SHUT, Screen, UNKNOWN, Verdict, View, sift};
use crate::world::{Intersection, Light};

/// Difference between corners of an area light's grid above which the part between is refined.
const UNEVEN: f32 = 0.1;

/// From so many rays to an area light on it is worth while to look first what may be in their way.
const MANY_RAYS: u32 = 4;

/// From so many rays to an area light on it is worth while to look again what may be in the way of
/// those from one point.
const VERY_MANY_RAYS: u32 = 16;

/// So many objects' shadows are known at a time.
const CASTERS: usize = 128;

/// What is known of a place of a grid: that it is seen, hidden, or seen through something.
const NOT_ASKED: u8 = 0;
const SEEN: u8 = 1;
const HIDDEN: u8 = 2;
const TINTED: u8 = 3;

/// What the places of a grid show, and the room to find that out.
#[derive(Debug, Default)]
pub(in crate::render) struct Places {
    /// What is known of each place.
    known: Vec<u8>,
    /// The light of those seen through something.
    colors: Vec<Rgb>,
    /// Where the places are, in parts of the axes.
    moved: Vec<DVec2>,
    /// The ways to them, by coordinate.
    ways: [Vec<f64>; 3],
    verdicts: Vec<Verdict>,
    /// What may be in the way, as seen from where the rays start.
    around: Vec<(Screen, View)>,
    /// The same, as seen on the light.
    outlines: Outlines,
    /// What is known of the shadows of objects: of each remainder of their numbers the last one.
    casters: Vec<Option<(u32, Option<Caster>)>>,
    /// What may be in the way to the place at hand.
    near: Vec<u32>,
}

/// A rectangle of an area light's grid, by the indices of its corners.
#[derive(Clone, Copy)]
struct Part {
    u: [u32; 2],
    v: [u32; 2],
}

/// An area light as one hit sees it.
struct Grid<'a> {
    light: &'a Light,
    area: &'a AreaLight,
    axes: [DVec3; 2],
    /// How far places may be from the middle, in units of the axes.
    reach: [f64; 2],
    center: &'a Incident,
    /// Whether the outlines say what is in the way.
    outlined: bool,
    /// Whether they only say so of places on the viewer's side of the surface, as others are behind it.
    straddles: bool,
}

impl Tracer<'_> {
    /// Finds the objects that may be in the way of an area light that takes many rays; tells whether that is worth
    /// while, and they are few.
    pub(super) fn between(
        &self,
        at: &Target,
        light: &Light,
        incident: &Incident,
        found: &mut Vec<Screen>,
    ) -> bool {
        let Some(area) = &light.area else { return false };
        if !self.quality.area_lights || light.runs_parallel() || area.least_rays() < MANY_RAYS {
            return false;
        }
        let Intersection { point, geometric, error, .. } = *at.surface;
        let axes = area.axes_towards(incident.direction);
        let mut points = Points::new();
        match origin(at.surface, light, axes, [area.reach(0), area.reach(1)]) {
            (origin, false) => points.push(origin),
            (_, true) => points.extend([point + error * geometric, point - error * geometric]),
        }
        points.extend(area.corners(axes).map(|corner| light.location + corner));
        let known = points.iter().all(|point| point.is_finite());
        known && self.world.geometry.between(&Hull::new(&points), found)
    }

    /// The light that arrives from an area light.
    pub(super) fn area_light(
        &mut self,
        at: &Target,
        light: &Light,
        area: &AreaLight,
        center: &Incident,
    ) -> Rgb {
        let axes = area.axes_towards(center.direction);
        let reach = [area.reach(0), area.reach(1)];
        let mut grid = Grid { light, area, axes, reach, center, outlined: false, straddles: false };
        let plain = light.projected_through.is_none() && !light.runs_parallel() && !self.dims(light);
        if let (Some(Among::Screens(among)), true) = (at.among, plain) {
            let (origin, straddles) = origin(at.surface, light, axes, reach);
            grid.straddles = straddles;
            match self.look_around(at, &grid, among, origin) {
                OPEN if !straddles => {
                    self.statistics.lights_open += 1;
                    return center.color;
                }
                SHUT if !straddles => {
                    self.statistics.shadow_rays += 1;
                    return Rgb::ZERO;
                }
                SHUT => {}
                _ if !area.plan.shares.is_empty() && !straddles => return self.whole(at, &grid, origin),
                _ => grid.outlined = true,
            }
        }
        self.places.known.clear();
        self.places.known.resize((area.size[0] * area.size[1]) as usize, NOT_ASKED);
        let whole = Part { u: [0, area.size[0] - 1], v: [0, area.size[1] - 1] };
        self.part(at, &grid, whole, 0)
    }

    /// The verdict on all ways to a grid on one side of the surface, if it is the same; else what decides about
    /// them is noted.
    fn look_around(&mut self, at: &Target, grid: &Grid, among: &[Screen], origin: DVec3) -> Verdict {
        let geometry = &self.world.geometry;
        let middle = grid.light.location - origin;
        // Where all places are asked it is balls that they are held against.
        let plan = !grid.area.plan.shares.is_empty() && !grid.straddles;
        let outside = !at.surface.inside && (grid.straddles || middle.dot(at.surface.geometric) > 0.0);
        let left = at.hit.map(|hit| hit.object).filter(|&own| outside && geometry.is_left_for_good(own));
        let cone = Cone::new(middle, grid.area.radius());
        let Places { around, outlines, casters, .. } = &mut self.places;
        let sight = Sight { from: origin, middle, axes: grid.axes, reach: grid.reach };
        around.clear();
        outlines.clear(&sight);
        casters.resize_with(CASTERS, || None);
        for screen in among {
            if left == Some(screen.object) {
                continue;
            }
            let view = screen.from(origin);
            match cone.as_ref().map_or(UNKNOWN, |cone| view.verdict_on_all(cone)) {
                OPEN => {}
                SHUT => return SHUT,
                _ => {
                    let caster = &mut casters[screen.object as usize % CASTERS];
                    if caster.as_ref().is_none_or(|(object, _)| *object != screen.object) {
                        *caster = Some((screen.object, geometry.caster(screen.object)));
                    }
                    let caster = caster.as_ref().and_then(|(_, caster)| caster.as_ref());
                    match caster.and_then(|caster| outlines.add(screen.object, caster, &sight)) {
                        Some(OPEN) => {}
                        Some(SHUT) => return SHUT,
                        Some(_) if !plan => {}
                        _ => around.push((*screen, view)),
                    }
                }
            }
        }
        if !around.is_empty() {
            let points = grid.points(origin);
            around.retain(|(screen, _)| !geometry.is_apart_from(screen.object, &points));
        }
        if grid.area.least_rays() >= VERY_MANY_RAYS && !around.is_empty() {
            let points = grid.points(origin);
            let hull = Hull::new(&points);
            around.retain(|(screen, _)| hull.meets(&geometry.bounds(screen.object)));
        }
        if plan {
            return if around.is_empty() { OPEN } else { UNKNOWN };
        }
        for (screen, view) in around {
            outlines.add_balls(screen.object, view);
        }
        if outlines.is_empty() { OPEN } else { UNKNOWN }
    }

    /// The light of a grid every place of which is asked, from a point with few objects around.
    fn whole(&mut self, at: &Target, grid: &Grid, origin: DVec3) -> Rgb {
        let middle = grid.light.location - origin;
        let mut places = std::mem::take(&mut self.places);
        if grid.area.jitter {
            places.moved.clear();
            for index in 0..grid.area.plan.shares.len() as u32 {
                let shift = self.grid_shift(grid.area);
                places
                    .moved
                    .push(grid.area.place((index % grid.area.size[0], index / grid.area.size[0]), shift));
            }
        } else {
            places.moved.clone_from(&grid.area.plan.places);
        }
        self.statistics.shadow_rays += places.moved.len() as u64;
        places.look(middle, grid.axes);
        // The sum of the shares is 1 but for rounding.
        let all = places.verdicts.iter().all(|&verdict| verdict == OPEN);
        let (moved, verdicts) = (std::mem::take(&mut places.moved), std::mem::take(&mut places.verdicts));
        self.places = places;
        let mut open = 0.0;
        let mut sum = Rgb::ZERO;
        for ((&share, &verdict), &place) in grid.area.plan.shares.iter().zip(&verdicts).zip(&moved) {
            if verdict == OPEN {
                open += share;
            } else if verdict != SHUT {
                let offset = grid.axes[0] * place.x + grid.axes[1] * place.y;
                sum += share * self.through(at, grid, middle, offset);
            }
        }
        (self.places.moved, self.places.verdicts) = (moved, verdicts);
        if all { grid.center.color } else { sum + grid.center.color * open }
    }

    /// The mean light from a part of an area light.
    fn part(&mut self, at: &Target, grid: &Grid, part: Part, level: u32) -> Rgb {
        let Part { u, v } = part;
        let places = [(u[0], v[0]), (u[1], v[0]), (u[0], v[1]), (u[1], v[1])];
        // Loops: closures for arrays are not compiled together with what is around them.
        let mut shown = [NOT_ASKED; 4];
        for (shown, place) in shown.iter_mut().zip(places) {
            *shown = self.place(at, grid, place);
        }
        let coarse = u[1] - u[0] > 1 || v[1] - v[0] > 1;
        let fine = !coarse || level >= grid.area.adaptive;
        let tinted = shown.contains(&TINTED);
        if fine && !tinted && (!coarse || shown == [shown[0]; 4]) {
            let seen = shown.iter().filter(|&&shown| shown == SEEN).count();
            return grid.center.color * (0.25 * seen as f32);
        }
        let mut corners = [Rgb::ZERO; 4];
        for ((corner, shown), (u, v)) in corners.iter_mut().zip(shown).zip(places) {
            *corner = match shown {
                SEEN => grid.center.color,
                HIDDEN => Rgb::ZERO,
                _ => self.places.colors[(v * grid.area.size[0] + u) as usize],
            };
        }
        let unlike = |a: usize, b: usize| (corners[a] - corners[b]).abs().element_sum() > UNEVEN;
        let uneven = || unlike(0, 1) || unlike(2, 3) || unlike(0, 2) || unlike(1, 3);
        if coarse && (!fine || uneven()) {
            for (quarter, [u, v]) in corners.iter_mut().zip(AreaLight::quarters(u, v)) {
                *quarter = self.part(at, grid, Part { u, v }, level + 1);
            }
        }
        let [a, b, c, d] = corners;
        (a + b + c + d) / 4.0
    }

    /// How one place of the grid is seen, found out once for each hit.
    #[inline(always)]
    fn place(&mut self, at: &Target, grid: &Grid, (u, v): (u32, u32)) -> u8 {
        let index = (v * grid.area.size[0] + u) as usize;
        match self.places.known[index] {
            NOT_ASKED => self.ask(at, grid, (u, v), index),
            known => known,
        }
    }

    /// Finds out how a place is seen, whose number is `index`.
    #[inline(never)]
    fn ask(&mut self, at: &Target, grid: &Grid, place: (u32, u32), index: usize) -> u8 {
        let DVec2 { x, y } = grid.area.place(place, self.grid_shift(grid.area));
        let offset = grid.axes[0] * x + grid.axes[1] * y;
        self.statistics.shadow_rays += 1;
        let seen_from = |surface: &Intersection| {
            (grid.light.location + offset - surface.point).dot(surface.geometric) > 0.0
        };
        let outlined = grid.outlined && (!grid.straddles || seen_from(at.surface));
        let mut near = std::mem::take(&mut self.places.near);
        let verdict = if outlined { self.places.outlines.verdict(x, y, &mut near) } else { UNKNOWN };
        let shown = match verdict {
            OPEN => SEEN,
            SHUT => HIDDEN,
            _ => {
                let among = if outlined { Some(Among::Near(&near)) } else { at.among };
                let color = self.towards(&Target { among, ..*at }, grid, offset);
                if color == Rgb::ZERO {
                    HIDDEN
                } else if color == grid.center.color {
                    SEEN
                } else {
                    let count = self.places.known.len();
                    self.places.colors.resize(count, Rgb::ZERO);
                    self.places.colors[index] = color;
                    TINTED
                }
            }
        };
        self.places.near = near;
        self.places.known[index] = shown;
        shown
    }

    /// The light from a place this far from the middle of the grid past the objects around.
    fn through(&mut self, at: &Target, grid: &Grid, middle: DVec3, offset: DVec3) -> Rgb {
        let mut near = std::mem::take(&mut self.places.near);
        let seen = self.places.around.iter().map(|(screen, view)| (screen, Some(view)));
        let color = match sift(seen, middle + offset, &mut near) {
            OPEN => grid.center.color,
            SHUT => Rgb::ZERO,
            _ => self.towards(&Target { among: Some(Among::Near(&near)), ..*at }, grid, offset),
        };
        self.places.near = near;
        color
    }

    /// The light from a place this far from the middle of the grid.
    fn towards(&mut self, at: &Target, grid: &Grid, offset: DVec3) -> Rgb {
        let (direction, distance) = grid.light.way_to_grid(at.surface.point, offset);
        self.shadow_ray(at, grid.light, &Incident { direction, distance, ..*grid.center })
    }

    /// How far a light of a grid is moved, in cells.
    pub(in crate::render) fn grid_shift(&mut self, area: &AreaLight) -> DVec2 {
        if area.jitter { DVec2::from_array(self.random.next_two()) - 0.5 } else { DVec2::ZERO }
    }
}

impl Grid<'_> {
    /// A point and corners around all places.
    fn points(&self, point: DVec3) -> [DVec3; 5] {
        let [a, b, c, d] = self.area.corners(self.axes);
        let middle = self.light.location;
        [point, middle + a, middle + b, middle + c, middle + d]
    }
}

/// Where rays to an area light start that leave on the side of the surface where its middle is, and whether
/// some leave on the other side: then it is where those start that leave on the side of the viewer.
fn origin(surface: &Intersection, light: &Light, axes: [DVec3; 2], reach: [f64; 2]) -> (DVec3, bool) {
    let normal = surface.geometric;
    let (way, [a, b]) = (light.location - surface.point, axes);
    let across = a.dot(normal).abs() * reach[0] + b.dot(normal).abs() * reach[1];
    // A point in space has no sides.
    let straddles = way.dot(normal).abs() <= across && normal != DVec3::ZERO;
    (surface.leave(if straddles { normal } else { way }), straddles)
}

impl Places {
    /// Finds out which places the objects around leave open, as far as that is seen without the surfaces.
    fn look(&mut self, middle: DVec3, [a, b]: [DVec3; 2]) {
        let Self { moved, ways, verdicts, around, .. } = self;
        let count = moved.len();
        let [x, y, z] = ways.each_mut().map(|way| {
            way.resize(count, 0.0);
            &mut way[..count]
        });
        verdicts.clear();
        verdicts.resize(count, OPEN);
        widest(
            #[inline(always)]
            || {
                for (((place, x), y), z) in moved.iter().zip(&mut *x).zip(&mut *y).zip(&mut *z) {
                    *x = middle.x + a.x * place.x + b.x * place.y;
                    *y = middle.y + a.y * place.x + b.y * place.y;
                    *z = middle.z + a.z * place.x + b.z * place.y;
                }
                for (_, view) in &*around {
                    for (((verdict, &x), &y), &z) in verdicts.iter_mut().zip(&*x).zip(&*y).zip(&*z) {
                        *verdict = verdict.max(view.verdict([x, y, z]));
                    }
                }
            },
        );
    }
}
