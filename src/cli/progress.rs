//! Progress on standard error, and Ctrl-C.

use std::io::{IsTerminal as _, Write as _};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

use super::output;
use crate::certify::Observer;

/// How often `plain` progress says something.
const PERIOD: Duration = Duration::from_secs(3);

/// How progress is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Style {
    /// A line that is overwritten if standard error is a terminal, else nothing
    #[default]
    Auto,
    /// A line for every new stage and every three seconds, on whatever standard error is
    Plain,
}

/// Shows stages while they run; asks the work to stop after Ctrl-C.
pub(super) struct Progress {
    bar: Option<ProgressBar>,
    stop: Arc<AtomicBool>,
    state: Arc<State>,
    /// Ends when the sender is dropped.
    plain: Option<(Sender<()>, JoinHandle<()>)>,
}

/// What is going on.
struct State {
    start: Instant,
    /// 0 before the first count.
    prisms: AtomicU64,
    stages: Mutex<Stages>,
}

/// Seconds of the stages so far, and the current one with its beginning.
#[derive(Default)]
struct Stages {
    past: Vec<(&'static str, f64)>,
    current: Option<(&'static str, Instant)>,
}

impl Stages {
    /// Ends the current stage; is the next one new?
    fn begin(&mut self, next: Option<&'static str>) -> bool {
        let now = Instant::now();
        if let Some((name, since)) = self.current.take() {
            let seconds = now.duration_since(since).as_secs_f64();
            match self.past.iter_mut().find(|(known, _)| *known == name) {
                Some((_, sum)) => *sum += seconds,
                None => self.past.push((name, seconds)),
            }
        }
        self.current = next.map(|name| (name, now));
        next.is_some_and(|name| self.past.iter().all(|(known, _)| *known != name))
    }
}

impl State {
    /// Stage, number of prisms, seconds.
    fn words(&self) -> String {
        let stage = self.stages.lock().unwrap_or_else(PoisonError::into_inner).current.map_or("", |c| c.0);
        format!(
            "{}, {} s",
            message(stage, self.prisms.load(Ordering::Relaxed)),
            self.start.elapsed().as_secs()
        )
    }
}

fn message(stage: &str, prisms: u64) -> String {
    // Reading is no stage of the work.
    let stage = if stage.is_empty() { "reading" } else { stage };
    if prisms == 0 { stage.to_owned() } else { format!("{stage}, {prisms} prisms") }
}

impl Progress {
    /// Takes over Ctrl-C: the first asks the work to stop, a second ends the process at once.
    pub(super) fn new(quiet: bool) -> Self {
        Self::styled(quiet, Style::Auto)
    }

    /// The same, shown in another way.
    pub(super) fn styled(quiet: bool, style: Style) -> Self {
        let stop = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&stop);
        // Without a handler Ctrl-C ends the process, which also writes nothing: no reason to give up.
        let _ = ctrlc::set_handler(move || {
            if flag.swap(true, Ordering::Relaxed) {
                output::end_at_once(2);
            }
        });
        let state = Arc::new(State {
            start: Instant::now(),
            prisms: AtomicU64::new(0),
            stages: Mutex::new(Stages::default()),
        });
        let plain = (!quiet && style == Style::Plain).then(|| speak(Arc::clone(&state)));
        let visible = !quiet && style == Style::Auto && std::io::stderr().is_terminal();
        Self { bar: visible.then(ProgressBar::new_spinner), stop, state, plain }
    }

    /// Has Ctrl-C been pressed?
    pub(super) fn interrupted(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// The stages so far with their seconds, in the order in which they began; a stage that is begun again adds up.
    pub(super) fn stages(&self) -> Vec<(&'static str, f64)> {
        let mut stages = self.state.stages.lock().unwrap_or_else(PoisonError::into_inner);
        stages.begin(None);
        stages.past.clone()
    }
}

/// Says a line every few seconds until the sender is dropped.
fn speak(state: Arc<State>) -> (Sender<()>, JoinHandle<()>) {
    let (sender, receiver) = mpsc::channel();
    let work = move || {
        while receiver.recv_timeout(PERIOD) == Err(RecvTimeoutError::Timeout) {
            let _ = writeln!(std::io::stderr(), "homeo: {}", state.words());
        }
    };
    (sender, std::thread::spawn(work))
}

impl Drop for Progress {
    /// Clears the line, also before an error is printed.
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
        if let Some((sender, thread)) = self.plain.take() {
            drop(sender);
            let _ = thread.join();
        }
    }
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}

impl Observer for Progress {
    fn stage(&self, name: &'static str, total: Option<u64>) {
        let is_new = self.state.stages.lock().unwrap_or_else(PoisonError::into_inner).begin(Some(name));
        if is_new && self.plain.is_some() {
            let _ = writeln!(std::io::stderr(), "homeo: {}", self.state.words());
        }
        let Some(bar) = &self.bar else { return };
        match total {
            Some(total) => {
                bar.set_style(style("{msg:30} {bar:40} {percent:>3} % {elapsed}"));
                bar.set_length(total);
            }
            None => bar.set_style(style("{msg:30} {spinner} {pos} {elapsed}")),
        }
        // Not `reset`: the time shown is that of the whole run.
        bar.set_position(0);
        bar.set_message(message(name, self.state.prisms.load(Ordering::Relaxed)));
        bar.enable_steady_tick(Duration::from_millis(100));
    }

    fn advance(&self, units: u64) {
        if let Some(bar) = &self.bar {
            bar.inc(units);
        }
    }

    fn prisms(&self, count: u64) {
        if self.state.prisms.swap(count, Ordering::Relaxed) == count {
            return;
        }
        if let Some(bar) = &self.bar {
            let stages = self.state.stages.lock().unwrap_or_else(PoisonError::into_inner);
            bar.set_message(message(stages.current.map_or("", |c| c.0), count));
        }
    }

    fn cancelled(&self) -> bool {
        self.interrupted()
    }
}

/// Progress of work that is to be finished even after Ctrl-C (a second one still ends the process).
pub(super) struct Finishing<'a>(pub(super) &'a Progress);

impl Observer for Finishing<'_> {
    fn stage(&self, name: &'static str, total: Option<u64>) {
        self.0.stage(name, total);
    }

    fn advance(&self, units: u64) {
        self.0.advance(units);
    }
}
