//! Rays from the eye that a flat surface mirrors: they travel together once more.

use super::mirror;
use super::plain::{Bundle, Plain, Room};
use super::random::Random;
use super::trace::{Path, Tracer};
use crate::math::wide::widest;
use crate::math::{DVec3, Lanes, Rgb};
use crate::world::accel::{Pencil, Within};
use crate::world::hit::Geometry;
use crate::world::{Intersection, Ray, RayKind, Rays};

/// So many mirrors of a pencil are remembered; rays from others travel alone.
const FEW: usize = 4;

/// Points of one plane are no farther from it, in parts of their coordinates: less than the room around pencils.
const FLAT: f64 = 1e-13;

/// What rays from the eye may meet once flat surfaces have mirrored them.
#[derive(Debug, Default)]
pub(super) struct Reflections {
    /// The rays that come from there; `None` where they don't travel together.
    pencil: Option<Pencil>,
    /// The planes of mirrors that they met so far, and what they may meet after it.
    mirrors: Vec<(Plane, Within)>,
    /// How many of these are of this pencil.
    known: usize,
}

/// The plane of a mirror.
#[derive(Clone, Copy, Debug, Default)]
struct Plane {
    normal: DVec3,
    /// Along the normal from the origin.
    distance: f64,
    /// Whether what is seen in it is few enough to be known.
    few: bool,
}

impl Reflections {
    /// Goes on with other rays from the eye.
    pub(super) fn restart(&mut self, pencil: Option<Pencil>) {
        (self.pencil, self.known) = (pencil, 0);
    }

    /// What mirrored rays may meet where the plane of a surface mirrors the pencil; `None` if that is many.
    fn within(&mut self, geometry: &Geometry, surface: &Intersection) -> Option<&Within> {
        let normal = surface.normal;
        let distance = normal.dot(surface.point);
        let room = FLAT * surface.point.abs().max_element();
        let is_it = |plane: &Plane| plane.normal == normal && (plane.distance - distance).abs() <= room;
        let known = self.mirrors[..self.known].iter().position(|(plane, _)| is_it(plane));
        let place = match known {
            Some(place) => place,
            None if self.known == FEW => return None,
            None => {
                let pencil = self.pencil.as_ref()?.mirrored(normal, distance)?;
                if self.known == self.mirrors.len() {
                    self.mirrors.push(Default::default());
                }
                let (plane, within) = &mut self.mirrors[self.known];
                *plane = Plane { normal, distance, few: geometry.within(&pencil, within) };
                self.known += 1;
                self.known - 1
            }
        };
        let (plane, within) = &self.mirrors[place];
        plane.few.then_some(within)
    }
}

/// Up to four rays that one plane mirrors.
struct Mirrored {
    count: usize,
    /// Where they are in the bundle that met the mirror.
    lanes: [usize; Lanes::COUNT],
    /// What of the light they see is mirrored, and by which power.
    shares: [(Rgb, f32); Lanes::COUNT],
    rays: [Ray; Lanes::COUNT],
    randoms: [Random; Lanes::COUNT],
    weight: f32,
    /// How far they have come at the most.
    come: f64,
}

impl Tracer<'_> {
    /// What simple surfaces mirror where rays of a bundle from the eye met them; nothing is said of those that have to
    /// look for themselves.
    #[inline(never)]
    pub(super) fn reflections<const N: usize>(
        &mut self,
        path: &Path,
        bundle: &Bundle<N>,
        met: &[Option<Plain>; N],
        surfaces: &[Intersection; N],
        seen: &mut [Option<Rgb>; N],
    ) {
        widest(
            #[inline(always)]
            || self.reflected_together(path, bundle, met, surfaces, seen),
        );
    }

    #[inline(always)]
    fn reflected_together<const N: usize>(
        &mut self,
        path: &Path,
        bundle: &Bundle<N>,
        met: &[Option<Plain>; N],
        surfaces: &[Intersection; N],
        seen: &mut [Option<Rgb>; N],
    ) {
        if self.reflections.pencil.is_none() || !self.quality.reflection {
            return;
        }
        let mut mirrored = Mirrored {
            count: 0,
            lanes: [0; Lanes::COUNT],
            shares: [(Rgb::ZERO, 1.0); Lanes::COUNT],
            rays: [bundle.rays[0]; Lanes::COUNT],
            randoms: [Random::default(); Lanes::COUNT],
            weight: 0.0,
            come: 0.0,
        };
        self.gather(&mut mirrored, bundle, met, surfaces);
        let Mirrored { count, lanes, shares, rays, randoms, weight, come } = &mut mirrored;
        if *count < 2 || path.level >= self.world.settings.max_trace_level {
            return;
        }
        let geometry = &self.world.geometry;
        let Some(within) = self.reflections.within(geometry, &surfaces[lanes[0]]) else { return };
        let (known, missing) = rays.split_at_mut(*count);
        if !known.iter().all(|ray| within.holds(ray.origin)) {
            return;
        }
        missing.fill(known[0]);
        let mut hits = [None; Lanes::COUNT];
        let asked = (1 << *count) - 1;
        geometry.hits(within, &Rays::of(rays), asked, RayKind::REFLECTION, *come, &mut hits);
        self.statistics.reflected_rays += *count as u64;
        let (level, weight, wavelength) = (path.level, *weight, path.wavelength);
        let (kind, inside) = (RayKind::REFLECTION, path.inside.clone());
        let mut path = Path { ray: rays[0], level, weight, kind, wavelength, inside };
        let hits = [hits[0].as_ref(), hits[1].as_ref(), hits[2].as_ref(), hits[3].as_ref()];
        let bundle = Bundle { rays: *rays, weights: [weight; Lanes::COUNT], hits, randoms: Some(randoms) };
        let mut room = Room::NEW;
        self.trace_bundle::<false>(
            &mut path,
            &bundle,
            &mut room,
            asked,
            #[inline(always)]
            |lane, found| {
                let (share, power) = shares[lane];
                let color = if power == 1.0 { found.color } else { found.color.powf(power) };
                seen[lanes[lane]] = Some(share * color);
            },
        );
    }

    /// Gathers the rays that the first mirror of a bundle reflects, if it is flat.
    #[inline(always)]
    fn gather<const N: usize>(
        &self,
        mirrored: &mut Mirrored,
        bundle: &Bundle<N>,
        met: &[Option<Plain>; N],
        surfaces: &[Intersection; N],
    ) {
        let mut first = None;
        for lane in 0..N.min(Lanes::COUNT) {
            let (Some(plain), Some(hit)) = (&met[lane], bundle.hits[lane]) else { continue };
            let reflection = plain.finish.reflection.as_ref().filter(|mirror| !mirror.fresnel);
            let (Some(reflection), Some(randoms)) = (reflection, bundle.randoms) else { continue };
            let (surface, direction) = (&surfaces[lane], bundle.rays[lane].direction);
            let Intersection { point, normal, geometric, .. } = *surface;
            let share = mirror::reflectivity(reflection, -direction.dot(normal), 1.0, plain.color);
            let weight = bundle.weights[lane] * share.weight;
            let (origin, facing, same) = *first.get_or_insert((point, normal, weight));
            let apart = (origin - point).dot(normal).abs();
            let flat = normal == geometric && normal == facing && apart <= FLAT * point.abs().max_element();
            // Of what isn't traced each takes note for itself.
            let traced = share.color != Rgb::ZERO && weight >= self.world.settings.adc_bailout;
            if !flat || !traced || weight != same {
                continue;
            }
            let direction = mirror::mirrored(direction, normal, normal);
            let at = mirrored.count;
            mirrored.lanes[at] = lane;
            mirrored.shares[at] = (share.color, reflection.exponent.recip());
            mirrored.rays[at] = Ray::new(surface.leave(direction), direction);
            mirrored.randoms[at] = randoms[lane];
            mirrored.come = mirrored.come.max(hit.t);
            mirrored.weight = weight;
            mirrored.count += 1;
        }
    }
}
