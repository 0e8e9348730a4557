//! The povista command.

use std::io;
use std::process::ExitCode;

/// A scene is made of many small parts, all kept to the end: this allocator reads one a quarter faster.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    // A panic is povista's fault, whatever the scene; say so, and what to do about it.
    let report = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        eprintln!("povista: a mistake of povista's own, not of the scene; please report it with the scene");
        report(panic);
    }));
    // Without a handler the program ends as well, only with less to say about it.
    let _ = ctrlc::set_handler(|| std::process::exit(i32::from(povista::cli::stop(&mut io::stderr()))));
    ExitCode::from(povista::cli::main(std::env::args_os(), &mut io::stdout(), &mut io::stderr()))
}
