//! Pixels of a mesh camera: the rays of each travel together, four at a time.

use super::plain::Room;
use super::sampling::Sample;
use super::trace::{Path, Tracer};
use super::{Eye, NOWHERE};
use crate::math::{Bounds, DVec2, DVec3, Lanes};
use crate::world::accel::Pencil;
use crate::world::camera::MeshCamera;
use crate::world::camera::mesh_camera::Place;
use crate::world::{Ray, RayKind, Rays};

impl Eye<'_> {
    /// The mean of what the rays see that start on faces of meshes.
    pub(super) fn through_mesh(&self, tracer: &mut Tracer, mesh: &MeshCamera, x: f64, y: f64) -> Sample {
        let place = Place { at: DVec2::new(x, y), size: [self.options.width, self.options.height] };
        let mut rays = Vec::with_capacity(mesh.most());
        mesh.rays(place, &mut rays);
        for ray in &mut rays {
            self.world.camera.bend(ray, DVec2::ZERO);
        }
        if rays.is_empty() {
            return NOWHERE;
        }
        let mut sum = [0.0; 4];
        let mut add = |seen: Sample| {
            for component in 0..4 {
                sum[component] += seen[component];
            }
        };
        if mesh.reach < f64::INFINITY || !self.together(tracer, &rays, (x, y), &mut add) {
            for &ray in &rays {
                add(self.seen(tracer, ray, (x, y), mesh.reach));
            }
        }
        sum.map(|component| component / rays.len() as f32)
    }

    /// Shows what rays through image coordinates see that travel together; whether they do.
    fn together(
        &self,
        tracer: &mut Tracer,
        rays: &[Ray],
        place: (f64, f64),
        show: &mut impl FnMut(Sample),
    ) -> bool {
        let mut within = std::mem::take(&mut tracer.within);
        let pencil = pencil(rays).filter(|pencil| self.world.geometry.within(pencil, &mut within));
        if pencil.is_some() {
            tracer.reflections.restart(pencil);
            let (kind, inside) = (RayKind::IMAGE, self.inside.clone().unwrap_or_default());
            let mut path = Path { ray: rays[0], level: 0, weight: 1.0, kind, wavelength: None, inside };
            let (mut hits, mut room) = ([None; Lanes::COUNT], Room::NEW);
            for some in rays.chunks(Lanes::COUNT) {
                let mut four = [some[0]; Lanes::COUNT];
                four[..some.len()].copy_from_slice(some);
                let four = Rays::of(&four);
                let asked = (1 << some.len()) - 1;
                self.world.geometry.hits(&within, &four, asked, path.kind, 0.0, &mut hits);
                let (path, hits) = ((&mut path, &mut room), &hits[..some.len()]);
                self.four_seen(tracer, path, &four, &[place; Lanes::COUNT], hits, &mut *show);
            }
        }
        tracer.within = within;
        pencil.is_some()
    }
}

/// What encloses rays, if they are worth to be followed together.
fn pencil(rays: &[Ray]) -> Option<Pencil> {
    let sound = |ray: &Ray| ray.origin.is_finite() && ray.direction != DVec3::ZERO;
    if rays.len() < Lanes::COUNT || !rays.iter().all(sound) {
        return None;
    }
    let starts = Bounds::of(rays.iter().map(|ray| ray.origin));
    Pencil::along(starts, Bounds::of(rays.iter().map(|ray| ray.direction)))
}
