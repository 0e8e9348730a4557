//! JPEG, whose decoders may differ in how they round.

use super::{Cases, HEIGHT, WIDTH};

/// Greatest difference of a sample, in 255ths, from the decoder that POV-Ray uses: where colours are
/// stored at every pixel, and where at every second or fourth.
const FULL: f64 = 2.0;
const SHARED: f64 = 3.0;

fn compare(names: &[&str], most: f64) {
    let mut cases = Cases::at_pixels();
    for name in names {
        let file = format!("{}/tests/images/files/{name}.jpg", env!("CARGO_MANIFEST_DIR"));
        let name = cases.file("jpg", &std::fs::read(file).unwrap());
        cases.colors(&name, &format!("jpeg \"{name}\" gamma 1"));
    }
    cases.compare((most + 0.001) / 255.0);
}

#[test]
fn jpegs_are_near_povrays() {
    assert_eq!((WIDTH, HEIGHT), (16, 12), "the files have this size");
    compare(&["grey", "grey-progressive", "full", "full-progressive"], FULL);
}

#[test]
fn jpegs_with_shared_colours_are_near_povrays() {
    compare(&["shared", "shared-progressive"], SHARED);
}
