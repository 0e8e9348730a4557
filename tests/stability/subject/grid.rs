//! Triangles over the grids of height fields and patches.

use super::flat::{Triangles, scaled, vector};
use crate::shoot_at;

/// Steps along each side.
const STEPS: usize = 8;

type Point = [f64; 3];

/// Two triangles of each cell, whose corners are taken as `order` says: first along u, second along v.
fn triangles(size: f64, point: impl Fn(usize, usize) -> Point, order: [[[usize; 2]; 3]; 2]) -> Triangles {
    let cells = (0..STEPS).flat_map(|u| (0..STEPS).map(move |v| (u, v)));
    let faces = cells.flat_map(|(u, v)| order.map(|face| face.map(|[i, j]| point(u + i, v + j))));
    Triangles { corners: faces.map(|face| scaled(face, size)).collect() }
}

#[test]
fn height_field() {
    shoot_at("height_field", |size| {
        let heights = "(5000*mod(floor(8*x)*5 + floor(8*y)*3, 7) + 10000.5)/65535";
        let object = format!(
            "height_field {{ function 9, 9 {{ {heights} }} translate <-0.5,-0.5,-0.5> scale {size:e} }}"
        );
        let point = |x: usize, z: usize| {
            // The first row is the farthest.
            let height = 5000 * ((x * 5 + (STEPS - z) * 3) % 7) + 10000;
            [x as f64 / 8.0 - 0.5, height as f64 / 65536.0 - 0.5, z as f64 / 8.0 - 0.5]
        };
        (object, triangles(size, point, [[[0, 0], [1, 0], [0, 1]], [[1, 1], [1, 0], [0, 1]]]))
    });
}

/// Control points of a patch: multiples of a sixteenth, so that all of its points are exact.
fn control(i: usize, j: usize) -> Point {
    let heights = [[3, -5, 8, 2], [-6, 14, 4, -9], [5, -12, 10, 7], [-2, 6, -8, 1]];
    let across = |i: usize, skew: usize| (4 * (2 * i as i32 - 3) + (skew as i32 % 3)) as f64 / 16.0;
    [across(i, j), f64::from(heights[i][j]) / 16.0, across(j, 2 * i)]
}

fn bernstein(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t]
}

#[test]
fn bicubic_patch() {
    shoot_at("bicubic_patch", |size| {
        let list: Vec<_> = (0..4).flat_map(|i| (0..4).map(move |j| vector(control(i, j)))).collect();
        let object = format!(
            "bicubic_patch {{ type 1 flatness 0 u_steps 3 v_steps 3 {} scale {size:e} }}",
            list.join(", ")
        );
        let point = |u: usize, v: usize| {
            let (in_u, in_v) = (bernstein(u as f64 / 8.0), bernstein(v as f64 / 8.0));
            std::array::from_fn(|axis| {
                let terms = (0..4).flat_map(|i| (0..4).map(move |j| (i, j)));
                terms.map(|(i, j)| in_u[i] * in_v[j] * control(i, j)[axis]).sum()
            })
        };
        (object, triangles(size, point, [[[0, 0], [0, 1], [1, 1]], [[0, 0], [1, 1], [1, 0]]]))
    });
}
