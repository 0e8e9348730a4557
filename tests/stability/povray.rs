//! The same rays, the nearest hit of each, put to POV-Ray's `trace()`: by hand, since it takes minutes.
//!
//! ```text
//! cargo test --profile testing --test stability povrays -- --ignored --nocapture
//! ```
//!
//! writes `povray.txt`. `POVISTA_STABILITY_POVRAY=1000` in the environment does it for the tests that run.

use std::fmt::Write;
use std::process::Command;

use crate::model::Subject;
use crate::shoot::{Score, Target};

/// How many rays to ask about, if any.
pub(crate) fn rays() -> Option<u64> {
    std::env::var("POVISTA_STABILITY_POVRAY").ok()?.parse().ok()
}

/// POV-Ray's score; `None` where it refuses the object.
pub(crate) fn score<M: Subject>(target: &Target<M>, object: &str, rays: u64) -> Option<Score> {
    let folder = tempfile::tempdir().ok()?;
    let mut text = format!(
        "#version 3.7; global_settings {{ assumed_gamma 1 }}\n#declare Thing = {object}\n\
         #fopen Out \"out.txt\" write\n\
         #macro Ask(From, To)\n\
         #declare Normal = <0,0,0>; #local Hit = trace(Thing, From, To, Normal);\n\
         #if (vlength(Normal) = 0) #write(Out, \"miss\\n\")\n\
         #else #write(Out, str(vdot(Hit - From, To)/{:e}, 0, 17), \"\\n\") #end\n\
         #end\n",
        target.size
    );
    for number in 0..rays {
        let ray = target.ray(number);
        let [from, to] = [ray.origin, ray.direction].map(|v| format!("<{:e},{:e},{:e}>", v.x, v.y, v.z));
        writeln!(text, "Ask({from}, {to})").ok()?;
    }
    std::fs::write(folder.path().join("ask.pov"), text).ok()?;
    let arguments = ["+Iask.pov", "+Oout.png", "+W4", "+H4", "-D"];
    Command::new("povray").current_dir(folder.path()).args(arguments).output().ok()?;
    let answers = std::fs::read_to_string(folder.path().join("out.txt")).ok()?;
    let mut all = Score::default();
    for (number, answer) in (0..).zip(answers.lines()) {
        let found = answer.trim().parse().ok().map(|t: f64| t * target.size);
        all.add(&target.judge_nearest(number, found));
    }
    (all.rays == rays).then_some(all)
}

/// Rays to a size or place that POV-Ray is asked about.
const RAYS: &str = "300";

#[test]
#[ignore = "asks POV-Ray, which takes some minutes, and writes its table"]
fn povrays_table_is_written() {
    let this = std::env::current_exe().expect("the tests have a program");
    let status =
        Command::new(this).args(["subject", "--nocapture"]).env("POVISTA_STABILITY_POVRAY", RAYS).status();
    assert!(status.is_ok_and(|status| status.success()));
}
