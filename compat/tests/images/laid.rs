//! How images are laid over space and read between pixels.

use super::{Cases, HEIGHT, Noise, WIDTH};

/// So many points for each way to lay an image.
const POINTS: usize = 400;

/// Points in a cube and on the edges of the unit square.
fn points() -> String {
    format!(
        "#local R=seed(7); #for(I,1,{POINTS}) #local X=5*rand(R)-2.5; #local Y=5*rand(R)-2.5; #local Z=5*rand(R)-2.5;\n\
         PRINT #local X=rand(R); #local Y=rand(R); PRINT #end\n\
         #for(J,-3,3) #for(I,-3,3) #local X=I/3; #local Y=J/2; #local Z=.1; PRINT #end #end"
    )
}

fn image(cases: &mut Cases) -> String {
    let mut noise = Noise(10);
    let mut bytes = b"P6\n7 5\n255\n".to_vec();
    bytes.extend(noise.bytes(7 * 5 * 3));
    cases.file("ppm", &bytes)
}

#[test]
fn every_projection_and_interpolation_has_povrays_numbers() {
    let mut cases = Cases::at(&points());
    let name = image(&mut cases);
    for map_type in [0, 1, 2, 5] {
        for interpolate in ["", "interpolate 2", "interpolate 3", "interpolate 4"] {
            for placed in ["", "once", "repeat <2,3> offset <.3,.1>", "once repeat <.7,.4> offset <-.2,.3>"] {
                let after = format!("map_type {map_type} {interpolate} {placed}");
                cases.colors(&after, &format!("ppm \"{name}\" {after}"));
            }
            cases.values(
                &format!("pattern {map_type} {interpolate}"),
                &format!("ppm \"{name}\" once map_type {map_type} {interpolate}"),
            );
        }
    }
    for after in
        ["filter all .3 transmit all .2 interpolate 3", "map_type 1 once interpolate 2 transmit all 1.5"]
    {
        cases.colors(after, &format!("ppm \"{name}\" {after}"));
    }
    cases.add(
        "warped",
        format!("pigment{{image_map{{ppm \"{name}\" interpolate 2}} turbulence .2 scale <.5,.7,1> rotate 30 warp{{spherical}}}}"),
        &[".red", ".green", ".blue"],
    );
    cases.compare(1e-9);
}

#[test]
fn images_of_functions_have_povrays_numbers() {
    let mut cases = Cases::at(&points());
    for body in [
        "function 7,5{x*.77+y*.1}",
        "function 3,9{pattern{bozo scale .2}} interpolate 2",
        "function 6,6{pigment{granite color_map{[0 rgb 0][1 rgbt <1,.5,.2,.6>]}}} interpolate 3",
    ] {
        cases.colors(body, body);
        cases.values(body, body);
    }
    cases.compare(1e-9);
}

/// Files of every kind of curve under every way to say what the scene's colours are.
#[test]
fn every_curve_and_assumed_gamma_has_povrays_numbers() {
    let mut noise = Noise(11);
    for header in [
        "#version 3.7; global_settings{assumed_gamma 2.2}",
        "#version 3.7; global_settings{assumed_gamma srgb}",
        "#version 3.7; global_settings{assumed_gamma 1.8}",
        "#version 3.7;",
        "#version 3.6; global_settings{assumed_gamma 2.2}",
        "#version 3.6; global_settings{assumed_gamma 1}",
        "#version 3.6;",
        "global_settings{assumed_gamma 1}",
        "",
    ] {
        let mut cases = Cases::at_pixels().under(header);
        let mut ppm = format!("P6\n{WIDTH} {HEIGHT}\n255\n").into_bytes();
        ppm.extend(noise.bytes(WIDTH * HEIGHT * 3));
        let odd = format!("P5\n{WIDTH} {HEIGHT}\n100\n").into_bytes();
        let odd = [odd, noise.below(101, WIDTH * HEIGHT)].concat();
        let tga = [
            &[0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, WIDTH as u8, 0, HEIGHT as u8, 0, 32, 0][..],
            &noise.bytes(WIDTH * HEIGHT * 4),
        ]
        .concat();
        for (keyword, bytes) in [("ppm", ppm), ("pgm", odd), ("tga", tga)] {
            let name = cases.file(keyword, &bytes);
            for gamma in ["", "gamma 1", "gamma 2.2", "gamma srgb", "gamma 1.5"] {
                cases
                    .colors(&format!("{header} {keyword} {gamma}"), &format!("{keyword} \"{name}\" {gamma}"));
                cases.values(
                    &format!("{header} {keyword} {gamma} pattern"),
                    &format!("{keyword} \"{name}\" {gamma}"),
                );
            }
        }
        cases.compare(2e-16);
    }
}
