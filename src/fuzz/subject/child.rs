//! A running program: one thread writes to it, one reads its output, one keeps the end of its complaints.

use std::fmt;
use std::io::{Read, Write as _};
use std::process::{self, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use crate::fuzz::Answer;

/// A line longer than this is no answer.
const LONGEST: usize = 4096;
/// Bytes of standard error that are kept.
const KEPT: usize = 400;

/// Why there is no further answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Broken {
    /// Its output has ended.
    Ended,
    /// It writes nothing.
    Silent,
    /// It writes a line without an end.
    Endless,
}

impl Broken {
    pub(super) fn answer(self) -> Answer {
        match self {
            Self::Ended => Answer::Crash,
            Self::Silent => Answer::Hang,
            Self::Endless => Answer::Bad("a line without an end".into()),
        }
    }
}

impl fmt::Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Ended => "it ended",
            Self::Silent => "it said nothing in time",
            Self::Endless => "it wrote a line without an end",
        })
    }
}

/// The program; killed when dropped.
#[derive(Debug)]
pub(super) struct Child {
    process: process::Child,
    /// Nothing once its input has ended.
    input: Option<Sender<Vec<u8>>>,
    output: Receiver<Vec<u8>>,
    /// Bytes that have arrived; those before `used` are done with.
    arrived: Vec<u8>,
    used: usize,
    complaints: Arc<Mutex<Vec<u8>>>,
}

impl Child {
    pub(super) fn start(mut command: Command) -> std::io::Result<Self> {
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        // Ctrl-C is meant for the judge, which then ends the subject in order.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut process = command.spawn()?;
        let (input, requests) = channel::<Vec<u8>>();
        let (chunks, output) = sync_channel(4);
        let complaints = Arc::new(Mutex::new(Vec::new()));
        if let Some(mut stdin) = process.stdin.take() {
            std::thread::spawn(move || {
                // Ends when the child does, or with the sender.
                while let Ok(bytes) = requests.recv() {
                    if stdin.write_all(&bytes).and_then(|()| stdin.flush()).is_err() {
                        break;
                    }
                }
            });
        }
        if let Some(stdout) = process.stdout.take() {
            std::thread::spawn(move || pass_on(stdout, |bytes| chunks.send(bytes.to_vec()).is_ok()));
        }
        if let Some(stderr) = process.stderr.take() {
            let complaints = Arc::clone(&complaints);
            std::thread::spawn(move || {
                pass_on(stderr, |bytes| {
                    let mut kept = complaints.lock().unwrap_or_else(PoisonError::into_inner);
                    kept.extend(bytes);
                    let surplus = kept.len().saturating_sub(KEPT);
                    kept.drain(..surplus);
                    true
                });
            });
        }
        Ok(Self { process, input: Some(input), output, arrived: Vec::new(), used: 0, complaints })
    }

    /// Hands bytes to the writer. A program that has ended is noticed when it does not answer.
    pub(super) fn send(&mut self, bytes: Vec<u8>) {
        if let Some(input) = &self.input {
            let _ = input.send(bytes);
        }
    }

    /// Has it written what nobody asked for?
    pub(super) fn has_more(&mut self) -> bool {
        if let Ok(bytes) = self.output.try_recv() {
            self.arrived.extend(bytes);
        }
        self.used < self.arrived.len()
    }

    /// Ends its input and waits for the end of its output: did it write what nobody asked for? A program that does not end in
    /// time is killed, which is no fault.
    pub(super) fn ends_with_more(mut self, timeout: Duration) -> bool {
        self.input = None;
        self.has_more() || self.receive(timeout).is_ok()
    }

    pub(super) fn byte(&mut self, timeout: Duration) -> Result<u8, Broken> {
        loop {
            if let Some(byte) = self.arrived.get(self.used) {
                self.used += 1;
                return Ok(*byte);
            }
            self.receive(timeout)?;
        }
    }

    /// A line without its line feed, the whole of which has to arrive in time.
    pub(super) fn line(&mut self, timeout: Duration) -> Result<Vec<u8>, Broken> {
        let start = Instant::now();
        loop {
            let rest = self.arrived.get(self.used..).unwrap_or_default();
            if let Some(length) = rest.iter().position(|b| *b == b'\n') {
                let line = rest.get(..length).unwrap_or_default().to_vec();
                self.used += length + 1;
                return Ok(line);
            }
            if rest.len() > LONGEST {
                return Err(Broken::Endless);
            }
            self.receive(timeout.saturating_sub(start.elapsed()))?;
        }
    }

    fn receive(&mut self, timeout: Duration) -> Result<(), Broken> {
        self.arrived.drain(..self.used);
        self.used = 0;
        match self.output.recv_timeout(timeout) {
            Ok(bytes) => {
                self.arrived.extend(bytes);
                Ok(())
            }
            Err(RecvTimeoutError::Timeout) => Err(Broken::Silent),
            Err(RecvTimeoutError::Disconnected) => Err(Broken::Ended),
        }
    }

    /// The end of what it wrote to standard error, after a colon.
    pub(super) fn last_words(&mut self) -> String {
        // What a program says as it ends may arrive after the end of its output.
        std::thread::sleep(Duration::from_millis(50));
        let kept = self.complaints.lock().unwrap_or_else(PoisonError::into_inner);
        let text = String::from_utf8_lossy(&kept).trim().to_owned();
        if text.is_empty() { text } else { format!(": {text}") }
    }
}

/// Reads until the end, or until `take` says no.
fn pass_on(mut from: impl Read, mut take: impl FnMut(&[u8]) -> bool) {
    let mut buffer = [0; 1 << 14];
    while let Ok(count @ 1..) = from.read(&mut buffer) {
        if !take(buffer.get(..count).unwrap_or_default()) {
            break;
        }
    }
}

impl Drop for Child {
    fn drop(&mut self) {
        // What the program has started goes with it: the processes behind a script, which would hold the pipes.
        #[cfg(unix)]
        let _ = rustix::process::kill_process_group(
            rustix::process::Pid::from_child(&self.process),
            rustix::process::Signal::KILL,
        );
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
