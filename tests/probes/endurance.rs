//! Long ways of light, and the same picture whatever finds the objects.

use povista::options::{Accelerator, RenderOptions};

use crate::table::{picture, scene};

#[test]
fn parallel_mirrors_are_followed_250_levels_deep() {
    let mirror = "pigment{rgb 1} finish{ambient .001 diffuse 0 reflection 1}";
    let sdl = format!(
        "camera{{location 0 direction z+.01*x}} global_settings{{max_trace_level 250 adc_bailout 0}}
        plane{{z,-5 {mirror}}} plane{{-z,-5 {mirror}}}"
    );
    let rendered = picture(&scene(&sdl, "3.7"), &RenderOptions::new(16, 12)).unwrap();
    let statistics = rendered.statistics;
    assert_eq!((statistics.reflected_rays, statistics.too_deep), (250 * 192, 192));
    for [red, green, blue, _] in rendered.image.pixels {
        // Each of 250 mirrors adds a thousandth.
        assert!((red - 0.25).abs() < 1e-4 && red == green && green == blue, "{red} {green} {blue}");
    }
}

#[test]
fn linear_search_octree_and_tree_of_boxes_make_the_same_picture() {
    let sdl = "camera{location <0,3,-12> look_at 0} light_source{<5,9,-8> rgb 1}
        #declare R=seed(4); #declare N=function(x){sin(x*12.9898)*43758.5453-int(sin(x*12.9898)*43758.5453)};
        #macro Place(I) translate 4*<N(I),N(I+.3),N(I+.6)> #end
        #for(I,1,60) sphere{0,.5 pigment{rgbt<1,.7,.2,.3*mod(I,2)>} finish{phong .5 reflection .2} Place(I)} #end
        #for(I,61,90) difference{box{-.5,.5} sphere{.4,.5} cylinder{-y,y,.2} pigment{rgb<.3,.6,1>} Place(I)} #end
        #for(I,91,99) merge{sphere{0,.5} sphere{.4*x,.4} pigment{rgbf<1,1,1,.8>} interior{ior 1.4} Place(I)} #end
        plane{y,-4 pigment{checker rgb 1 rgb .2}}";
    let kinds = [Accelerator::Linear, Accelerator::Octree, Accelerator::Bvh, Accelerator::Auto];
    let [linear, others @ ..] = kinds.map(|accelerator| {
        let options = RenderOptions { accelerator, ..RenderOptions::new(64, 48) };
        picture(&scene(sdl, "3.7"), &options).unwrap().image
    });
    for other in others {
        assert!(other == linear);
    }
}
