//! How the system hands memory out, and how much: a small scene asks for pages that are soon cleared, a large one for
//! huge ones, of which few are needed.

/// From so many bytes on huge pages pay: the system clears each as a whole, however little of it is used.
pub const MANY: usize = 16 << 20;

/// The memory the program uses at present, in bytes; 0 where the system does not tell.
pub fn used() -> u64 {
    memory_stats::memory_stats().map_or(0, |stats| stats.physical_mem as u64)
}

/// Has memory handed out in small pages from now on, where the system lets a program choose.
pub fn small() {
    choose(true);
}

/// Has much memory handed out in huge pages again, where the system does so.
pub fn huge() {
    choose(false);
}

#[cfg(target_os = "linux")]
fn choose(small: bool) {
    // Where the system has no such choice, all is as well.
    let _ = nix::sys::prctl::set_thp_disable(small);
}

#[cfg(not(target_os = "linux"))]
fn choose(_small: bool) {}
