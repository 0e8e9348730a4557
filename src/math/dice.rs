//! Numbers for tests that look random and are the same on every machine.

/// Numbers evenly spread over -0.5 … 0.5 (a linear congruential generator, from `seed` on).
pub(crate) fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (state >> 33) as f64 / f64::from(1_u32 << 31) - 0.5
    }
}
