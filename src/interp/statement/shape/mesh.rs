//! `mesh { triangle { … } … }` (docs/spec/primitives.md 4.3).

use std::sync::Arc;

use rustc_hash::FxHashMap;

use super::{triangle, uvs};
use crate::interp::value::Value;
use crate::interp::{Block, Result, Vm, Word};
use crate::math::{DVec2, DVec3};
use crate::scene::shape::{Face, FaceTextures, Mesh};
use crate::scene::{Shape, Texture};
use crate::source::Span;

/// Reads the triangles. Degenerate ones are dropped silently.
pub(super) fn read(vm: &mut Vm<'_>, block: &Block) -> Result<Shape> {
    let mut build = Build::default();
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::Triangle | Word::SmoothTriangle => face(vm, &mut build, word == Word::SmoothTriangle)?,
            Word::InsideVector => build.mesh.inside_vector = vm.after_word(inside_vector)?,
            _ => break,
        }
    }
    if build.mesh.faces.is_empty() {
        return Err(vm
            .error(block.span, "this mesh has no triangle with an area")
            .help("give it some, such as `triangle { <0,0,0>, <1,0,0>, <0,1,0> }`"));
    }
    Ok(Shape::Mesh(Arc::new(build.mesh)))
}

/// Reads the direction that decides what is inside; zero is none.
pub(super) fn inside_vector(vm: &mut Vm<'_>) -> Result<Option<DVec3>> {
    let vector = vm.read_vector()?;
    Ok((vector.length() > 0.0).then_some(vector))
}

/// A normal without a direction is replaced by the x axis, with one warning for each mesh.
pub(super) fn mend_normal(vm: &mut Vm<'_>, normal: DVec3, warned: &mut bool, place: Span) -> DVec3 {
    const LEAST: f64 = 1e-10;
    if normal.abs().max_element() >= LEAST {
        return normal;
    }
    if !std::mem::replace(warned, true) {
        vm.warn(place, "a normal of this mesh has no length", "`x` is taken for such normals");
    }
    DVec3::X
}

fn face(vm: &mut Vm<'_>, build: &mut Build, smooth: bool) -> Result<()> {
    let block = vm.enter()?;
    let (corners, normals) = if smooth {
        let (corners, normals) = triangle::smooth_corners(vm)?;
        (corners, Some(normals.map(|n| mend_normal(vm, n, &mut build.warned, block.span))))
    } else {
        (triangle::corners(vm)?, None)
    };
    let mut textures = FaceTextures::Inherited;
    let texture_coordinates = if vm.accept(Word::UvVectors)? { Some(uvs::<3>(vm)?) } else { None };
    if let Some(word) = vm.peek_word()? {
        match word {
            Word::Texture => {
                let inner = vm.enter()?;
                textures = FaceTextures::One(build.texture(vm)?);
                vm.close(inner)?;
            }
            Word::TextureList => {
                let inner = vm.enter()?;
                let mut list = [0; 3];
                for texture in &mut list {
                    *texture = build.texture(vm)?;
                    vm.comma()?;
                }
                textures = FaceTextures::Three(list);
                vm.close(inner)?;
            }
            _ => {}
        }
    }
    vm.close(block)?;
    if !triangle::is_degenerate(&corners) {
        build.push(corners, normals, texture_coordinates, textures);
    }
    Ok(())
}

/// A mesh in the making: equal corners, normals and textures are kept once.
#[derive(Default)]
struct Build {
    mesh: Mesh,
    vertices: FxHashMap<[u64; 3], u32>,
    normals: FxHashMap<[u64; 3], u32>,
    uvs: FxHashMap<[u64; 2], u32>,
    /// By the identity of what the texture shares.
    textures: FxHashMap<[usize; 2], u32>,
    warned: bool,
}

impl Build {
    /// Reads the name of a texture.
    fn texture(&mut self, vm: &mut Vm<'_>) -> Result<u32> {
        let texture = vm.accept_value(|value| match value {
            Value::Texture(texture) => Some(Texture::clone(texture)),
            _ => None,
        })?;
        let Some(texture) = texture else {
            return Err(vm
                .expected("the name of a texture")
                .help("in a mesh, declare the texture before: `#declare T = texture { … }`"));
        };
        let transform = texture.transform.as_ref().map_or(0, |t| Arc::as_ptr(t) as usize);
        let textures = &mut self.mesh.textures;
        Ok(*self.textures.entry([Arc::as_ptr(&texture.body) as usize, transform]).or_insert_with(|| {
            textures.push(texture);
            textures.len() as u32 - 1
        }))
    }

    fn push(
        &mut self,
        corners: [DVec3; 3],
        normals: Option<[DVec3; 3]>,
        uvs: Option<[DVec2; 3]>,
        textures: FaceTextures,
    ) {
        let key = |v: DVec3| v.to_array().map(f64::to_bits);
        let vertices = corners.map(|v| intern(&mut self.vertices, &mut self.mesh.vertices, key(v), v));
        let normals =
            normals.map(|n| n.map(|v| intern(&mut self.normals, &mut self.mesh.normals, key(v), v)));
        let uvs = uvs.map(|uvs| {
            uvs.map(|v| intern(&mut self.uvs, &mut self.mesh.uvs, v.to_array().map(f64::to_bits), v))
        });
        self.mesh.faces.push(Face { vertices, normals, uvs, textures });
    }
}

/// The place of a value in a list that keeps each once.
fn intern<K: std::hash::Hash + Eq, V>(
    known: &mut FxHashMap<K, u32>,
    list: &mut Vec<V>,
    key: K,
    value: V,
) -> u32 {
    *known.entry(key).or_insert_with(|| {
        list.push(value);
        list.len() as u32 - 1
    })
}
