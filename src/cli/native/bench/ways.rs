//! The ways to sample that are measured.

use crate::options::{Antialias, AntialiasMethod, Filter, Sampling};

/// A way to sample with its setting.
#[derive(Clone, Debug)]
pub(super) struct Way {
    pub family: &'static str,
    pub setting: String,
    pub antialias: Option<Antialias>,
    pub sampling: Option<Sampling>,
}

/// Threshold and depth of POV-Ray's first method.
const FIRST_METHOD: [(f32, u32); 5] = [(0.3, 3), (0.1, 3), (0.03, 4), (0.0, 3), (0.0, 6)];

/// Threshold and depth of POV-Ray's second method.
const SECOND_METHOD: [(f32, u32); 5] = [(0.3, 2), (0.1, 3), (0.03, 4), (0.01, 5), (0.0, 3)];

/// How many times as long as one sample for each pixel a budget is.
const BUDGETS: [f32; 3] = [4.0, 16.0, 64.0];

impl Way {
    fn own(family: &'static str, setting: impl ToString, sampling: Sampling) -> Self {
        Self { family, setting: setting.to_string(), antialias: None, sampling: Some(sampling) }
    }

    /// The filter of the converged picture it is held against, where that isn't the box.
    pub(super) fn filter(&self) -> Option<Filter> {
        match self.sampling {
            Some(Sampling::Even { filter, .. }) if filter != Filter::Box => Some(filter),
            _ => None,
        }
    }

    /// The same with budgets in seconds, where one sample for each pixel takes `unit`.
    pub(super) fn within(mut self, unit: f64) -> Self {
        if let Some(Sampling::Budget { seconds, .. }) = &mut self.sampling {
            *seconds *= unit as f32;
        }
        self
    }
}

/// POV-Ray's ways, with the name of each curve.
fn povray(families: [&'static str; 3]) -> Vec<Way> {
    let [centres, first, second] = families;
    let mut ways = vec![Way { family: centres, setting: String::new(), antialias: None, sampling: None }];
    let methods = [
        (first, AntialiasMethod::Neighbours, FIRST_METHOD),
        (second, AntialiasMethod::Adaptive, SECOND_METHOD),
    ];
    for (family, method, settings) in methods {
        ways.extend(settings.map(|(threshold, depth)| Way {
            family,
            setting: format!("+A{threshold} +R{depth}"),
            antialias: Some(Antialias { method, threshold, depth, jitter: 0.0, ..Antialias::default() }),
            sampling: None,
        }));
    }
    ways
}

/// What POV-Ray is asked for.
pub(super) fn theirs() -> Vec<Way> {
    povray(["POV-Ray centres", "POV-Ray method 1", "POV-Ray method 2"])
}

/// What povista is asked for: one sample for each pixel first.
pub(super) fn ours() -> Vec<Way> {
    let mut ways = povray(["centres", "method 1", "method 2"]);
    ways.extend([8, 4, 2].map(|step| Way::own("every", step, Sampling::Every(step))));
    ways.push(Way::own("corners", "", Sampling::Corners));
    ways.extend([32.0_f32, 16.0, 8.0, 4.0, 2.0, 1.0].map(|error| {
        Way::own("adaptive", error, Sampling::Adaptive { error, most: 1024, filter: Filter::Box })
    }));
    ways.extend(
        [16.0_f32, 8.0, 4.0, 2.0, 1.0, 0.7, 0.5, 0.35, 0.25, 0.18]
            .map(|error| Way::own("edges", error, Sampling::Edges { error, most: 1024 })),
    );
    let filters = [
        ("even box", Filter::Box),
        ("even triangle", Filter::Triangle),
        ("even gaussian", Filter::Gaussian),
        ("even Mitchell", Filter::Mitchell),
    ];
    for (family, filter) in filters {
        ways.extend(
            [1, 4, 16, 64].map(|samples| Way::own(family, samples, Sampling::Even { samples, filter })),
        );
    }
    ways.extend(BUDGETS.map(|seconds| {
        Way::own("budget", format!("{seconds} times"), Sampling::Budget { seconds, filter: Filter::Box })
    }));
    ways
}
