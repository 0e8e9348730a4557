//! Counts of what ran on the thread at hand, for `--stats`. A count costs one addition to a number of the thread's
//! own; whoever wants to know takes the counts of the work it has just done.

macro_rules! tallies {
    ($($(#[$doc:meta])* $name:ident,)*) => {
        /// What is counted.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct Tally {
            $($(#[$doc])* pub $name: u64,)*
        }

        mod counts {
            use std::cell::Cell;
            thread_local! {
                $(#[expect(non_upper_case_globals, reason = "named like the fields")]
                pub(super) static $name: Cell<u64> = const { Cell::new(0) };)*
            }
        }

        impl Tally {
            /// The counts of this thread since they were last taken.
            pub fn take() -> Self {
                Self { $($name: counts::$name.take(),)* }
            }
        }

        $($(#[$doc])*
        #[inline]
        pub fn $name(times: usize) {
            counts::$name.with(|count| count.set(count.get() + times as u64));
        })*
    };
}

tallies! {
    /// Boxes held against rays.
    boxes,
    /// Primitives asked where rays meet them, triangles of meshes among them.
    primitives,
    /// Values of noise.
    noise,
    /// Values of vector noise.
    vector_noise,
    /// Values of patterns.
    patterns,
    /// Normals bent by bumps.
    bumps,
    /// Texture coordinates of hits.
    texture_coordinates,
    /// Calls of user functions, internal ones among them.
    functions,
    /// Colours looked up in images.
    image_lookups,
    /// Numbers taken by what is random.
    random_numbers,
}
