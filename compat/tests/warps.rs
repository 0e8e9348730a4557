//! Where warps put points, by both programs.

use std::fmt::Write as _;
use std::time::Duration;

use povista_compat::numbers::{FILE, printed};
use povista_compat::program::Program;

/// Points for each list of modifiers.
const POINTS: usize = 10_000;

/// How far a coordinate may be off, against the largest of 1 and itself.
const NEAR: f64 = 1e-9;

/// Processor seconds for one scene.
const LIMIT: Duration = Duration::from_secs(300);

/// What puts x, y and z first: modifiers that are written first act last.
const COORDINATES: [&str; 3] = ["", "matrix <0,1,0,1,0,0,0,0,1,0,0,0>", "matrix <0,0,1,0,1,0,1,0,0,0,0,0>"];

/// Each is asked at [`POINTS`] points; turbulence at fewer, it is slow.
const MODIFIERS: [&str; 34] = [
    "warp{repeat x*.7}",
    "warp{repeat y*1.3 flip <1,1,0> offset <.1,.2,.3>}",
    "warp{repeat z*-.9 flip z}",
    "warp{repeat 2*x flip x offset <.3,0,-.7>} warp{repeat .5*z}",
    "warp{black_hole <.1,.2,.3>, 3.2 strength 1.7 falloff 1.3 inverse}",
    "warp{black_hole 0, 2}",
    "warp{black_hole <-1,0,1>, 2 strength 9 falloff .5}",
    "warp{black_hole 0, 2 falloff 0 strength .3 inverse}",
    "warp{black_hole 0, 2 type 1}",
    "warp{black_hole .6, .5 strength 1.2 repeat <2,3,0> turbulence <.3,.4,.5>}",
    "warp{black_hole .5, .4 repeat 1.2 inverse turbulence .2 falloff 3}",
    "warp{cylindrical}",
    "warp{cylindrical orientation x dist_exp 1}",
    "warp{cylindrical orientation y dist_exp -1}",
    "warp{spherical}",
    "warp{spherical orientation <1,2,3> dist_exp 2.5}",
    "warp{spherical orientation -y dist_exp 1}",
    "warp{toroidal}",
    "warp{toroidal orientation y dist_exp 1 major_radius .8}",
    "warp{toroidal major_radius 2.5 dist_exp -.5 orientation <1,0,1>}",
    "warp{planar}",
    "warp{planar y, .4}",
    "warp{planar <1,2,3>, -.7}",
    "warp{cubic}",
    "rotate <10,20,30> translate <1,2,3> warp{repeat .7*x} scale <2,3,4>",
    "warp{spherical} rotate 40*y warp{repeat .25*x flip x} scale .5",
    "scale <2,1,.5> matrix <1,.3,0,0,1,.2,.1,0,1,3,2,1> warp{cubic} rotate 33",
    "turbulence <.3,.4,.5>",
    "turbulence .5 octaves 3 omega .7 lambda 2.5",
    "warp{turbulence <.3,.4,.5>}",
    "warp{turbulence .4 octaves 2 omega .3 lambda 3} rotate 45",
    "turbulence .2 warp{turbulence .3 octaves 4} scale 2",
    "octaves 1 turbulence x",
    "turbulence .4 warp{black_hole 0, 2} translate .3 warp{cylindrical}",
];

fn scene(modifiers: &str) -> String {
    let mut scene = format!("#version 3.7; global_settings{{assumed_gamma 1}} #fopen OUT \"{FILE}\" write\n");
    for (number, first) in COORDINATES.iter().enumerate() {
        writeln!(
            scene,
            "#declare F{number}=function{{pattern{{marble ramp_wave frequency 0 {first} {modifiers}}}}}"
        )
        .unwrap();
    }
    writeln!(
        scene,
        "#local R=seed(3); #for(I,1,{POINTS}) #local X=6*rand(R)-3; #local Y=6*rand(R)-3; #local Z=6*rand(R)-3;\n\
         #write(OUT,str(F0(X,Y,Z),0,17),\" \",str(F1(X,Y,Z),0,17),\" \",str(F2(X,Y,Z),0,17),\"\\n\") #end\n\
         #fclose OUT camera{{}}"
    )
    .unwrap();
    scene
}

/// How far apart two numbers are, of which negative ones show as the rest above the next lower integer.
fn apart(a: f64, b: f64) -> f64 {
    if a.is_nan() && b.is_nan() {
        return 0.0;
    }
    let direct = (a - b).abs() / a.abs().max(1.0);
    let wrapped = (1.0 - (a - b).abs()).abs();
    if a.min(b) < NEAR { direct.min(wrapped) } else { direct }
}

#[test]
fn warps_move_points_as_povrays_do() {
    let povray = Program::povray().unwrap_or_else(|error| panic!("{error}"));
    let povista = Program::povista().unwrap_or_else(|error| panic!("{error}"));
    let folder = tempfile::tempdir().unwrap();
    let mut wrong = String::new();
    for modifiers in MODIFIERS {
        let numbers = |program| {
            printed(program, folder.path(), &scene(modifiers), LIMIT)
                .unwrap_or_else(|e| panic!("{modifiers}: {e}"))
        };
        let (theirs, ours) = (numbers(&povray), numbers(&povista));
        assert_eq!((theirs.len(), ours.len()), (3 * POINTS, 3 * POINTS), "{modifiers}");
        let differences = theirs.iter().zip(&ours).map(|(&a, &b)| apart(a, b));
        let worst = differences.fold(0.0, |worst: f64, d| if d.is_nan() { f64::NAN } else { worst.max(d) });
        println!("{modifiers}: {worst:e}");
        if worst.is_nan() || worst > NEAR {
            writeln!(wrong, "{modifiers}: {worst:e}").unwrap();
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}
