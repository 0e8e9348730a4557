//! How much room is taken by what scenes have millions of (benches/README.md, "Memory of many objects").

use crate::compile::flatten::{InteriorUse, TextureUse};
use crate::scene;
use crate::world::{Leaf, Texture, parts};

#[test]
fn what_scenes_have_millions_of_is_small() {
    assert!(size_of::<scene::Object>() <= 104);
    assert!(size_of::<scene::texture::TextureBody>() <= 56);
    assert!(size_of::<TextureUse>() <= 24);
    assert!(size_of::<InteriorUse>() <= 8);
    assert!(size_of::<Leaf>() <= 96);
    assert!(size_of::<parts::Object>() <= 16);
    assert!(size_of::<Texture>() <= 40);
}
