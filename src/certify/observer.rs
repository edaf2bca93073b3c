//! Progress and interruption of long work.

/// Told of progress, asked whether to stop. All methods are called from worker threads.
pub trait Observer: Sync {
    /// A stage begins; `total` units of work if known.
    fn stage(&self, name: &'static str, total: Option<u64>) {
        let _ = (name, total);
    }

    /// `units` more of the current stage are done.
    fn advance(&self, units: u64) {
        let _ = units;
    }

    /// The shell under construction has `count` prisms now.
    fn prisms(&self, count: u64) {
        let _ = count;
    }

    /// Should the work stop? It then ends with [`CertifyError::Cancelled`](super::CertifyError::Cancelled).
    fn cancelled(&self) -> bool {
        false
    }
}

/// An observer that says nothing and never stops.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Observer for Silent {}

/// Passes progress on in batches, so that hot loops do not pay for it.
pub(crate) struct Ticker<'a> {
    observer: &'a dyn Observer,
    pending: u64,
}

impl<'a> Ticker<'a> {
    const BATCH: u64 = 1024;

    pub(crate) fn new(observer: &'a dyn Observer) -> Self {
        Self { observer, pending: 0 }
    }

    /// One more unit is done; whether to stop.
    pub(crate) fn tick(&mut self) -> bool {
        self.pending += 1;
        if self.pending < Self::BATCH {
            return false;
        }
        self.observer.advance(self.pending);
        self.pending = 0;
        self.observer.cancelled()
    }
}

impl Drop for Ticker<'_> {
    fn drop(&mut self) {
        self.observer.advance(self.pending);
    }
}
