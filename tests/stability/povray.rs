//! The same rays, the nearest hit of each, put to POV-Ray's `trace()`: by hand, since it takes minutes.
//!
//! ```text
//! POVISTA_STABILITY_POVRAY=1000 cargo test --profile testing --test stability subject -- --nocapture
//! ```
//!
//! shoots so many rays at every size and place and writes `povray.txt`.

use std::fmt::Write;
use std::process::Command;

use crate::model::Model;
use crate::shoot::{Score, Target};

/// How many rays to ask about, if any.
pub(crate) fn rays() -> Option<u64> {
    std::env::var("POVISTA_STABILITY_POVRAY").ok()?.parse().ok()
}

/// POV-Ray's score; `None` where it refuses the object.
pub(crate) fn score<M: Model>(target: &Target<M>, object: &str, rays: u64) -> Option<Score> {
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
