//! `mesh2 { vertex_vectors { … } … face_indices { … } … }` (docs/spec/primitives.md 4.4).

use std::sync::Arc;

use super::mesh::{inside_vector, mend_normal};
use super::reserve;
use crate::interp::statement::texture;
use crate::interp::{Block, Result, Vm, Word};
use crate::math::DVec3;
use crate::scene::Shape;
use crate::scene::shape::{Face, FaceTextures, Mesh};
use crate::source::Span;

/// Reads the lists and joins them. Every index is checked.
pub(super) fn read(vm: &mut Vm<'_>, block: &Block) -> Result<Shape> {
    let mut mesh = Mesh::default();
    while let Some(word) = vm.peek_word()? {
        let taken = match word {
            Word::VertexVectors => !mesh.vertices.is_empty(),
            Word::NormalVectors => !mesh.normals.is_empty(),
            Word::UvVectors => !mesh.uvs.is_empty(),
            _ => false,
        };
        if taken {
            let place = vm.here()?;
            vm.warn(
                place,
                format!("this mesh2 has `{}` already", word.text()),
                "the first list is forgotten",
            );
        }
        match word {
            Word::VertexVectors => mesh.vertices = list(vm, Vm::read_vector)?,
            Word::NormalVectors => mesh.normals = normals(vm)?,
            Word::UvVectors => mesh.uvs = list(vm, Vm::read_uv)?,
            Word::TextureList => {
                mesh.textures = list(vm, |vm| {
                    if vm.peek_word()? == Some(Word::Texture) {
                        texture::block(vm)
                    } else {
                        Err(vm.expected("`texture { … }`"))
                    }
                })?;
                break;
            }
            _ => break,
        }
    }
    if mesh.vertices.is_empty() {
        let fault = vm.expected("`vertex_vectors`");
        return Err(
            fault.help("a mesh2 begins with its corners: `vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,1,0> }`")
        );
    }
    if vm.peek_word()? != Some(Word::FaceIndices) {
        return Err(vm.expected("`face_indices`"));
    }
    mesh.faces = faces(vm, &mesh)?;
    let (mut has_uvs, mut has_normals) = (false, false);
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::UvIndices => {
                let count = mesh.uvs.len();
                let given = indices(vm, "uv_vectors", count, mesh.faces.len(), &mut |face, i| {
                    mesh.faces[face].uvs = Some(i)
                })?;
                if given != mesh.faces.len() {
                    let message = format!("{given} uv_indices for {} faces", mesh.faces.len());
                    return Err(vm.error(vm.last, message).help("give one entry for each face"));
                }
                has_uvs = true;
            }
            Word::NormalIndices => {
                let count = mesh.normals.len();
                let limit = mesh.faces.len();
                indices(vm, "normal_vectors", count, limit, &mut |face, i| {
                    mesh.faces[face].normals = Some(i)
                })?;
                has_normals = true;
            }
            _ => break,
        }
    }
    if !has_uvs {
        let shared = per_vertex(vm, block, "uv", mesh.uvs.len(), mesh.vertices.len(), true)?;
        share(&mut mesh.faces, shared, |face, indices| face.uvs = Some(indices));
    }
    if !has_normals {
        let shared = per_vertex(vm, block, "normal", mesh.normals.len(), mesh.vertices.len(), false)?;
        share(&mut mesh.faces, shared, |face, indices| face.normals = Some(indices));
    }
    if vm.peek_word()? == Some(Word::InsideVector) {
        mesh.inside_vector = vm.after_word(inside_vector)?;
    }
    Ok(Shape::Mesh(Arc::new(mesh)))
}

/// Reads `word { n, entry, … }`.
fn list<'v, T>(vm: &mut Vm<'v>, mut read: impl FnMut(&mut Vm<'v>) -> Result<T>) -> Result<Vec<T>> {
    let block = vm.enter()?;
    let count = length(vm)?;
    let mut entries = Vec::with_capacity(reserve(count));
    for _ in 0..count {
        vm.comma()?;
        entries.push(read(vm)?);
    }
    vm.comma()?;
    vm.close(block)?;
    Ok(entries)
}

/// Reads the number of entries of a list.
fn length(vm: &mut Vm<'_>) -> Result<usize> {
    let (count, place) = vm.located(Vm::read_int)?;
    if count < 1 {
        return Err(vm.error(place, "this list is empty").help("begin it with the number of its entries"));
    }
    Ok(count as usize)
}

fn normals(vm: &mut Vm<'_>) -> Result<Vec<DVec3>> {
    let mut warned = false;
    list(vm, |vm| {
        let (normal, place) = vm.located(Vm::read_vector)?;
        Ok(mend_normal(vm, normal, &mut warned, place))
    })
}

fn faces(vm: &mut Vm<'_>, mesh: &Mesh) -> Result<Vec<Face>> {
    let (corners, textures) = (mesh.vertices.len(), mesh.textures.len());
    let read = |vm: &mut Vm<'_>| {
        let vertices = three(vm, "vertex_vectors", corners)?;
        let mut chosen = FaceTextures::Inherited;
        if textures > 0 {
            chosen = face_textures(vm, textures)?;
        }
        Ok(Face { vertices, normals: None, uvs: None, textures: chosen })
    };
    let block = vm.enter()?;
    let count = length(vm)?;
    let mut faces = Vec::with_capacity(reserve(count));
    for _ in 0..count {
        vm.comma()?;
        faces.push(read(vm)?);
    }
    vm.comma()?;
    vm.close(block)?;
    Ok(faces)
}

/// Reads the texture numbers after a face: none, one, or one for each corner.
fn face_textures(vm: &mut Vm<'_>, count: usize) -> Result<FaceTextures> {
    let mut numbers = [0; 3];
    let mut given = 0;
    vm.comma()?;
    while given < 3 && vm.at_float()? {
        let (number, place) = vm.located(Vm::read_int)?;
        numbers[given] = check(vm, "texture_list", count, number, place)?;
        given += 1;
        vm.comma()?;
    }
    Ok(match given {
        0 => FaceTextures::Inherited,
        1 => FaceTextures::One(numbers[0]),
        _ => FaceTextures::Three(numbers),
    })
}

/// Reads `word { n, <i,i,i>, … }`, gives each entry to `set` and returns how many there were.
fn indices(
    vm: &mut Vm<'_>,
    what: &str,
    count: usize,
    limit: usize,
    set: &mut dyn FnMut(usize, [u32; 3]),
) -> Result<usize> {
    let block = vm.enter()?;
    let (given, place) = vm.located(length)?;
    if given > limit {
        let fault = vm.error(place, format!("{given} entries for {limit} faces"));
        return Err(fault.help("give one entry for each face"));
    }
    for face in 0..given {
        vm.comma()?;
        let indices = three(vm, what, count)?;
        set(face, indices);
    }
    vm.comma()?;
    vm.close(block)?;
    Ok(given)
}

fn three(vm: &mut Vm<'_>, what: &str, count: usize) -> Result<[u32; 3]> {
    let start = vm.here()?;
    let vector = vm.read_vector()?;
    let mut indices = [0; 3];
    for (index, value) in indices.iter_mut().zip(vector.to_array()) {
        *index = check(vm, what, count, value as i32, start)?;
    }
    Ok(indices)
}

fn check(vm: &Vm<'_>, what: &str, count: usize, index: i32, start: Span) -> Result<u32> {
    match u32::try_from(index) {
        Ok(index) if (index as usize) < count => Ok(index),
        _ => Err(vm.error(start.to(vm.last), format!("there is no entry {index} in `{what}`")).help(
            match count {
                0 => format!("this mesh2 has no `{what}`"),
                _ => format!("it has entries 0 to {}", count - 1),
            },
        )),
    }
}

/// How a list without indices belongs to the corners: `None` where there is no list, and whether
/// there is one entry for each. A single one may serve all, where `shared` says so.
fn per_vertex(
    vm: &Vm<'_>,
    block: &Block,
    what: &str,
    count: usize,
    vertices: usize,
    shared: bool,
) -> Result<Option<bool>> {
    match count {
        0 => Ok(None),
        _ if count == vertices => Ok(Some(true)),
        1 if shared => Ok(Some(false)),
        _ => Err(vm
            .error(block.span, format!("this mesh2 has {count} {what} vectors for {vertices} vertices"))
            .help(format!("give as many as vertices, or say with `{what}_indices` which belongs where"))),
    }
}

fn share(faces: &mut [Face], shared: Option<bool>, set: impl Fn(&mut Face, [u32; 3])) {
    let Some(by_vertex) = shared else { return };
    for face in faces {
        let indices = if by_vertex { face.vertices } else { [0; 3] };
        set(face, indices);
    }
}
