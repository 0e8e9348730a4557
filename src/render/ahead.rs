//! Four places of a picture are looked at together where they are near each other: their rays travel together, and what
//! those of a tile of pixels may meet is found once. Pixels of a row are looked at ahead of who asks for them.

use std::ops::Range;

use super::Eye;
use super::plain::{Bundle, Room};
use super::random::Random;
use super::reflections::Reflections;
use super::sampling::Sample;
use super::trace::{Path, Tracer};
use crate::math::wide::widest;
use crate::math::{DVec2, Lanes};
use crate::world::accel::{Pencil, Within};
use crate::world::camera::{Straight, film, film_of_four};
use crate::world::hit::Hit;
use crate::world::{RayKind, Rays};

/// So many pixels are looked at together.
const FOUR: i32 = Lanes::COUNT as i32;

/// Pixels along each side of a tile.
const TILE: i32 = 8;

/// Rays of a tile stay within this of the middles of its pixels, along both axes.
const EDGE: f64 = 0.55;

/// So many tiles next to each other are remembered: those of a block.
const TILES: usize = 4;

/// Pixels that nobody has asked for yet.
#[derive(Debug, Default)]
pub(super) struct Ahead {
    /// The column and row of the first.
    first: Option<[i32; 2]>,
    samples: [Sample; Lanes::COUNT],
    tiles: [Tile; TILES],
}

/// What rays through a square of pixels may meet.
#[derive(Debug, Default)]
struct Tile {
    /// The column and row of its upper left pixel.
    place: Option<[i32; 2]>,
    /// Whether that is known.
    known: bool,
    /// What all of them see, where they meet nothing and the sky is the same everywhere.
    sky: Option<Sample>,
    within: Within,
    reflections: Reflections,
}

impl Eye<'_> {
    /// What is seen at image coordinates in the middle of a pixel, where it belongs to four that travel together.
    #[inline]
    pub(super) fn looked_ahead(
        &self,
        tracer: &mut Tracer,
        straight: Straight,
        x: f64,
        y: f64,
    ) -> Option<Sample> {
        let [column, row] = [x as i32, y as i32];
        if f64::from(column) != x || f64::from(row) != y {
            return None;
        }
        let lane = column & (FOUR - 1);
        let first = [column - lane, row];
        if tracer.ahead.first != Some(first) && (lane != 0 || !self.look_ahead(tracer, straight, first)) {
            return None;
        }
        Some(tracer.ahead.samples[lane as usize])
    }

    /// Adds what is seen in the middles of the pixels of a row.
    pub(super) fn row(&self, tracer: &mut Tracer, columns: Range<u32>, row: u32, seen: &mut Vec<Sample>) {
        let y = f64::from(row);
        let mut column = columns.start;
        while column < columns.end {
            let x = f64::from(column);
            if let Some(straight) = self.straight
                && column.is_multiple_of(FOUR as u32)
                && column + FOUR as u32 <= columns.end
                && let Some(tile) =
                    self.tile(tracer, straight, [column, row].map(|along| along as i32 & !(TILE - 1)))
            {
                tracer.statistics.samples += Lanes::COUNT as u64;
                let places = [(x, y), (x + 1.0, y), (x + 2.0, y), (x + 3.0, y)];
                seen.extend_from_slice(&self.look(tracer, straight, tile, &places));
                column += FOUR as u32;
            } else {
                seen.push(self.sample(tracer, x, y));
                column += 1;
            }
        }
    }

    /// What is seen at four image coordinates near each other.
    pub(super) fn four(&self, tracer: &mut Tracer, places: &[DVec2; Lanes::COUNT]) -> [Sample; Lanes::COUNT] {
        if let Some(straight) = self.straight
            && let Some(tile) = self.tile_around(tracer, straight, places)
        {
            tracer.statistics.samples += Lanes::COUNT as u64;
            return self.look(tracer, straight, tile, &places.map(Into::into));
        }
        places.map(|place| self.sample(tracer, place.x, place.y))
    }

    /// The tile in which four places are, where it is known what its rays may meet.
    fn tile_around(
        &self,
        tracer: &mut Tracer,
        straight: Straight,
        places: &[DVec2; Lanes::COUNT],
    ) -> Option<usize> {
        let pixel = (places[0] + 0.5).floor();
        let corner = [pixel.x, pixel.y].map(|along| along as i32 & !(TILE - 1));
        let [left, top] = corner.map(f64::from);
        let span = f64::from(TILE - 1) + EDGE;
        let within = |place: &DVec2| {
            let (x, y) = (place.x - left, place.y - top);
            -EDGE <= x && x <= span && -EDGE <= y && y <= span
        };
        if places.iter().all(within) { self.tile(tracer, straight, corner) } else { None }
    }

    /// The tile with an upper left pixel, where it is known what its rays may meet.
    fn tile(&self, tracer: &mut Tracer, straight: Straight, place: [i32; 2]) -> Option<usize> {
        let number = (place[0] / TILE) as usize % TILES;
        if tracer.ahead.tiles[number].place != Some(place) {
            let sky = tracer.open_sky();
            let tile = &mut tracer.ahead.tiles[number];
            tile.place = Some(place);
            let pencil = self.pencil_of(straight, place.map(f64::from));
            let geometry = &self.world.geometry;
            tile.known = pencil.is_some_and(|pencil| geometry.within(&pencil, &mut tile.within));
            tile.reflections.restart(pencil.filter(|_| tile.known));
            let open = tile.known && self.inside.is_some() && geometry.meets_nothing(&tile.within);
            tile.sky = sky.filter(|_| open);
        }
        tracer.ahead.tiles[number].known.then_some(number)
    }

    /// Looks at four pixels from one on; whether that is worth while.
    fn look_ahead(&self, tracer: &mut Tracer, straight: Straight, first: [i32; 2]) -> bool {
        let [column, row] = first;
        if i64::from(column) + i64::from(FOUR) > i64::from(self.options.region.columns.end) {
            return false;
        }
        let corner = first.map(|along| along & !(TILE - 1));
        let Some(tile) = self.tile(tracer, straight, corner) else { return false };
        let mut places = [(f64::from(column), f64::from(row)); Lanes::COUNT];
        for (lane, place) in places.iter_mut().enumerate() {
            place.0 += lane as f64;
        }
        let samples = self.look(tracer, straight, tile, &places);
        (tracer.ahead.first, tracer.ahead.samples) = (Some(first), samples);
        true
    }

    /// What is seen at four places of a tile.
    fn look(
        &self,
        tracer: &mut Tracer,
        straight: Straight,
        tile: usize,
        places: &[(f64, f64); Lanes::COUNT],
    ) -> [Sample; Lanes::COUNT] {
        if let Some(sky) = tracer.ahead.tiles[tile].sky {
            tracer.statistics.camera_rays += Lanes::COUNT as u64;
            tracer.statistics.sky_evaluations += Lanes::COUNT as u64;
            return [sky; Lanes::COUNT];
        }
        widest(
            #[inline(always)]
            || self.look_at_objects(tracer, straight, tile, places),
        )
    }

    #[inline(always)]
    fn look_at_objects(
        &self,
        tracer: &mut Tracer,
        straight: Straight,
        tile: usize,
        places: &[(f64, f64); Lanes::COUNT],
    ) -> [Sample; Lanes::COUNT] {
        let rays = self.rays_of_four(straight, places);
        let (mut hits, kind) = ([None; Lanes::COUNT], RayKind::IMAGE);
        let within = &tracer.ahead.tiles[tile].within;
        self.world.geometry.hits(within, &rays, (1 << Lanes::COUNT) - 1, kind, 0.0, &mut hits);
        let inside = self.inside.clone().unwrap_or_default();
        let mut path = Path { ray: rays.ray(0), level: 0, weight: 1.0, kind, wavelength: None, inside };
        let mut samples = [Sample::default(); Lanes::COUNT];
        let (mut lane, mut room) = (0, Room::NEW);
        std::mem::swap(&mut tracer.reflections, &mut tracer.ahead.tiles[tile].reflections);
        self.four_seen(
            tracer,
            (&mut path, &mut room),
            &rays,
            places,
            &hits,
            #[inline(always)]
            |sample| {
                samples[lane] = sample;
                lane += 1;
            },
        );
        std::mem::swap(&mut tracer.reflections, &mut tracer.ahead.tiles[tile].reflections);
        samples
    }

    /// All rays through the pixels of a tile.
    #[cold]
    fn pencil_of(&self, straight: Straight, [left, top]: [f64; 2]) -> Option<Pencil> {
        let corner = |x: f64, y: f64| film(left + x, top + y, self.options.width, self.options.height);
        let (first, last) = (-EDGE, f64::from(TILE - 1) + EDGE);
        straight.pencil([corner(first, first), corner(last, first), corner(first, last), corner(last, last)])
    }

    /// The rays through four image coordinates.
    #[inline]
    fn rays_of_four(&self, straight: Straight, places: &[(f64, f64); Lanes::COUNT]) -> Rays {
        let (mut x, mut y) = (Lanes::ZERO, Lanes::ZERO);
        for (lane, place) in places.iter().enumerate() {
            (x.0[lane], y.0[lane]) = *place;
        }
        widest(
            #[inline(always)]
            || straight.rays(film_of_four(x, y, self.options.width, self.options.height)),
        )
    }

    /// Shows what up to four rays see of which it is known what they meet first; `path` is that of a ray before.
    #[inline(always)]
    pub(super) fn four_seen(
        &self,
        tracer: &mut Tracer,
        (path, room): (&mut Path, &mut Room<{ Lanes::COUNT }>),
        rays: &Rays,
        places: &[(f64, f64); Lanes::COUNT],
        hits: &[Option<Hit>],
        mut show: impl FnMut(Sample),
    ) {
        if !tracer.calm || self.inside.is_none() {
            for (lane, hit) in hits.iter().enumerate() {
                show(self.met(tracer, rays.ray(lane), places[lane], hit));
            }
            return;
        }
        tracer.statistics.camera_rays += hits.len() as u64;
        // Loops: closures given to methods of arrays are not compiled together with what is around them. The bundle is
        // filled where it stays: a copy of what was only just written would wait for it.
        let mut randoms = [Random::default(); Lanes::COUNT];
        for (random, &(x, y)) in randoms.iter_mut().zip(places) {
            *random = Random::of_sample(x, y, self.options.seed);
        }
        let (apart, met) = ([rays.ray(0); Lanes::COUNT], [None; Lanes::COUNT]);
        let mut bundle =
            Bundle { rays: apart, weights: [path.weight; Lanes::COUNT], hits: met, randoms: Some(&randoms) };
        for (lane, hit) in hits.iter().enumerate() {
            bundle.hits[lane] = hit.as_ref();
            bundle.rays[lane] = rays.ray(lane);
        }
        tracer.trace_bundle::<true>(
            path,
            &bundle,
            room,
            (1 << hits.len()) - 1,
            #[inline(always)]
            |_, seen| show(seen.sample()),
        );
    }
}
