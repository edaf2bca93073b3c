//! Progress on standard error, and Ctrl-C.

use std::io::IsTerminal as _;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

use crate::certify::Observer;

/// Shows stages while they run if standard error is a terminal; asks the work to stop after Ctrl-C.
pub(super) struct Progress {
    bar: Option<ProgressBar>,
    stop: Arc<AtomicBool>,
}

impl Progress {
    /// Takes over Ctrl-C: the first asks the work to stop, a second ends the process at once.
    pub(super) fn new(quiet: bool) -> Self {
        let stop = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&stop);
        // Without a handler Ctrl-C ends the process, which also writes nothing: no reason to give up.
        let _ = ctrlc::set_handler(move || {
            if flag.swap(true, Ordering::Relaxed) {
                std::process::exit(2);
            }
        });
        let visible = !quiet && std::io::stderr().is_terminal();
        Self { bar: visible.then(ProgressBar::new_spinner), stop }
    }

    /// Has Ctrl-C been pressed?
    pub(super) fn interrupted(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

impl Drop for Progress {
    /// Clears the line, also before an error is printed.
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}

impl Observer for Progress {
    fn stage(&self, name: &'static str, total: Option<u64>) {
        let Some(bar) = &self.bar else { return };
        match total {
            Some(total) => {
                bar.set_style(style("{msg:20} {bar:40} {percent:>3} % {elapsed}"));
                bar.set_length(total);
            }
            None => bar.set_style(style("{msg:20} {spinner} {pos} {elapsed}")),
        }
        bar.reset();
        bar.set_message(name);
        bar.enable_steady_tick(Duration::from_millis(100));
    }

    fn advance(&self, units: u64) {
        if let Some(bar) = &self.bar {
            bar.inc(units);
        }
    }

    fn cancelled(&self) -> bool {
        self.interrupted()
    }
}
