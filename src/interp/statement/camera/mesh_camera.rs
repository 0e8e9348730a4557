//! `mesh_camera { … }` (docs/spec/camera-image.md 5).

use crate::interp::statement::object;
use crate::interp::{Experimental, Result, Vm, Word};
use crate::scene::Shape;
use crate::scene::camera::MeshCamera;

/// Reads the block; its keyword comes next.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<MeshCamera> {
    let block = vm.enter()?;
    vm.note_experimental(Experimental::MeshCamera);
    // There are no commas between these numbers.
    let (rays, rays_place) = vm.located(Vm::read_count)?;
    let (distribution, place) = vm.located(Vm::read_int)?;
    if !(0..=3).contains(&distribution) {
        return Err(vm
            .error(place, format!("there is no mesh_camera of type {distribution}"))
            .help("types are 0 to 3"));
    }
    let max_distance = if vm.at_number()? { vm.read_float()? } else { 0.0 };
    let mut camera = MeshCamera {
        rays_per_pixel: rays,
        distribution: distribution as u32,
        max_distance,
        meshes: Vec::new(),
        smooth: false,
    };
    vm.comma()?;
    while let Some(object) = object::any(vm)? {
        let Shape::Mesh(mesh) = &object.shape else {
            return Err(vm.error(object.span, "a mesh_camera takes meshes only"));
        };
        camera.meshes.push((mesh.clone(), object.transform.clone()));
        vm.comma()?;
    }
    if vm.accept(Word::Smooth)? {
        if distribution != 3 {
            return Err(vm.error(vm.last, "only a mesh_camera of type 3 can be `smooth`"));
        }
        camera.smooth = true;
    }
    vm.close(block)?;
    let too_many = match distribution {
        0 => rays as usize > camera.meshes.len(),
        1 => false,
        _ => rays != 1,
    };
    if rays < 1 || too_many {
        return Err(vm
            .error(
                rays_place,
                format!("{rays} rays per pixel don't fit a mesh_camera of type {distribution}"),
            )
            .help("type 0 takes at most one for each mesh, types 2 and 3 take exactly one"));
    }
    Ok(camera)
}
