//! Runs hot code compiled for the registers the processor at hand has.

/// Calls `f`, compiled for AVX2 and FMA where the processor has them, and as it stands elsewhere:
/// the same operations in the same order, so the same bits.
///
/// Only what is inlined into `f` gains; write `#[inline(always)] || …`.
#[inline(always)]
pub fn widest<R>(f: impl FnOnce() -> R) -> R {
    #[cfg(target_arch = "x86_64")]
    {
        #[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
        fn wide<R>(f: impl FnOnce() -> R) -> R {
            f()
        }
        if is_wide() {
            // SAFETY: all features of `wide` were found on this processor.
            #[expect(unsafe_code, reason = "the one door to wide registers; measured in benches/README.md")]
            return unsafe { wide(f) };
        }
    }
    f()
}

/// Whether the processor has all that `widest` asks for: looked up once, asked at every ray.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
fn is_wide() -> bool {
    use std::sync::atomic::{AtomicU8, Ordering};

    /// 0 until it is known, then 1 for no and 2 for yes.
    static WIDE: AtomicU8 = AtomicU8::new(0);

    #[cold]
    fn look() -> bool {
        let wide = is_x86_feature_detected!("avx2")
            && is_x86_feature_detected!("fma")
            && is_x86_feature_detected!("bmi1")
            && is_x86_feature_detected!("bmi2")
            && is_x86_feature_detected!("lzcnt")
            && is_x86_feature_detected!("popcnt");
        WIDE.store(1 + u8::from(wide), Ordering::Relaxed);
        wide
    }

    match WIDE.load(Ordering::Relaxed) {
        0 => look(),
        known => known == 2,
    }
}
