//! The povista command.

use std::io;
use std::process::ExitCode;

/// A scene is made of many small parts, all kept to the end: this allocator reads one a quarter faster.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    give_back_at_once();
    // A panic is povista's fault, whatever the scene; say so, and what to do about it.
    let report = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        eprintln!("povista: a mistake of povista's own, not of the scene; please report it with the scene");
        report(panic);
    }));
    heed_stops();
    ExitCode::from(povista::cli::main(std::env::args_os(), &mut io::stdout(), &mut io::stderr()))
}

/// Has memory that is freed go back to the system at once: what reading a scene leaves behind would otherwise be
/// kept while its picture is traced (benches/README.md, "Solids").
fn give_back_at_once() {
    // `mi_option_purge_delay` of mimalloc.h, in milliseconds; the crate has no name for it.
    const PURGE_DELAY: libmimalloc_sys::mi_option_t = 15;
    // SAFETY: any option may be set at any time; a number mimalloc doesn't have is ignored.
    #[expect(unsafe_code, reason = "the crate has no safe way to set an option")]
    unsafe {
        libmimalloc_sys::mi_option_set(PURGE_DELAY, 0);
    }
}

/// Ends the program as a stop asks for when the user, or the system, wishes it to stop.
///
/// Where that cannot be heeded the program ends as well, only with less to say about it.
#[cfg(unix)]
fn heed_stops() {
    use signal_hook::consts::{SIGINT, SIGQUIT, SIGTERM};

    if let Ok(mut signals) = signal_hook::iterator::Signals::new([SIGINT, SIGQUIT, SIGTERM]) {
        std::thread::spawn(move || {
            if signals.forever().next().is_some() {
                stop();
            }
        });
    }
}

/// Ends the program as a stop asks for when the user wishes it to stop.
#[cfg(not(unix))]
fn heed_stops() {
    let _ = ctrlc::set_handler(stop);
}

fn stop() {
    std::process::exit(i32::from(povista::cli::stop(&mut io::stderr())));
}
