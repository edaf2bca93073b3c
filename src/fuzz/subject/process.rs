//! A subject that is a program: started, asked, timed, restarted.

use std::process::Command;
use std::time::Duration;

use super::child::{Broken, Child};
use super::wire;
use super::{Pace, Subject, SubjectError};
use crate::fuzz::{Answer, Predicate};

/// How long the end of a program is waited for at most.
const FAREWELL: Duration = Duration::from_secs(2);

/// How cases are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// A line a case.
    #[default]
    Text,
    /// Batches of doubles.
    Binary,
}

/// How a program is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProcessOptions {
    /// How cases are written.
    pub mode: Mode,
    /// How long it may take from one answer to the next; in binary mode a millisecond more for each case of the batch, as
    /// these answers come all at once.
    pub timeout: Duration,
    /// How long it may take for its first answer.
    pub startup: Duration,
    /// How often it is started again before it is given up.
    pub restarts: u32,
}

impl Default for ProcessOptions {
    fn default() -> Self {
        Self {
            mode: Mode::Text,
            timeout: Duration::from_secs(2),
            startup: Duration::from_secs(30),
            restarts: 1000,
        }
    }
}

/// A program in the protocol of `docs/SUBJECTS.md`.
#[derive(Debug)]
pub struct Process {
    command: String,
    words: Vec<String>,
    options: ProcessOptions,
    child: Option<Child>,
    failures: u32,
}

impl Process {
    /// A program to be started when it is asked first; the command is split into words as a shell would.
    ///
    /// # Errors
    /// [`SubjectError::Command`] if there are no words.
    pub fn new(command: &str, options: ProcessOptions) -> Result<Self, SubjectError> {
        let words = shlex::split(command).filter(|words| !words.is_empty());
        let words = words.ok_or_else(|| SubjectError::Command { command: command.to_owned() })?;
        Ok(Self { command: command.to_owned(), words, options, child: None, failures: 0 })
    }

    /// Starts the program and asks the plainest case.
    fn start(&self, predicate: Predicate) -> Result<Child, SubjectError> {
        let mut command = Command::new(self.words.first().map_or("", String::as_str));
        command.args(self.words.iter().skip(1));
        let started = Child::start(command);
        let mut child =
            started.map_err(|source| SubjectError::Start { command: self.command.clone(), source })?;
        let (answers, broken) =
            ask(&mut child, self.options.mode, self.options.startup, predicate, &predicate.example());
        if let Some(broken) = broken {
            return Err(SubjectError::Mute {
                command: self.command.clone(),
                what: broken.to_string(),
                said: child.last_words(),
            });
        }
        if answers == [Answer::Unsupported] {
            return Err(SubjectError::Unsupported { subject: self.command.clone(), predicate });
        }
        Ok(child)
    }

    /// Answers from the front until the program is done or fails.
    fn attempt(
        &mut self,
        predicate: Predicate,
        cases: &[f64],
    ) -> Result<(Vec<Answer>, Option<Broken>), SubjectError> {
        let mut child = match self.child.take() {
            Some(child) => child,
            None => self.start(predicate)?,
        };
        if child.has_more() {
            return Err(SubjectError::TooMuch { command: self.command.clone() });
        }
        let (answers, broken) = ask(&mut child, self.options.mode, self.options.timeout, predicate, cases);
        if broken.is_none() {
            self.child = Some(child);
        } else {
            self.failures += 1;
            if self.failures > self.options.restarts {
                return Err(SubjectError::GaveUp { command: self.command.clone(), times: self.failures });
            }
        }
        Ok((answers, broken))
    }
}

/// Writes the cases and collects answers.
fn ask(
    child: &mut Child,
    mode: Mode,
    timeout: Duration,
    predicate: Predicate,
    cases: &[f64],
) -> (Vec<Answer>, Option<Broken>) {
    let count = cases.len() / predicate.arity();
    let mut answers = Vec::with_capacity(count);
    match mode {
        Mode::Text => child.send(wire::text(predicate, cases)),
        Mode::Binary => child.send(wire::binary(predicate, cases)),
    }
    let batch = timeout.saturating_add(Duration::from_millis(count as u64));
    while answers.len() < count {
        let next = match mode {
            Mode::Text => child.line(timeout).map(|line| wire::answer_of_line(&line)),
            Mode::Binary => child.byte(batch).map(wire::answer_of_byte),
        };
        match next {
            Ok(answer) => answers.push(answer),
            Err(broken) => return (answers, Some(broken)),
        }
    }
    (answers, None)
}

impl Subject for Process {
    fn name(&self) -> String {
        self.command.clone()
    }

    /// In text mode each answer is flushed: the first case without one has broken the program. In binary mode the batch is
    /// asked again in parts, down to the case that does it; if none does it again, the first suspect is named, because a
    /// program that fails now and then is not right.
    fn answer(&mut self, predicate: Predicate, cases: &[f64]) -> Result<Vec<Answer>, SubjectError> {
        let arity = predicate.arity();
        let mut answers: Vec<Answer> = Vec::with_capacity(cases.len() / arity);
        // Ends of the parts that are still to be asked, the next one last.
        let mut ends = vec![cases.len() / arity];
        // A failure whose case is still looked for: the suspects.
        let mut unexplained: Option<(usize, usize, Broken)> = None;
        while let Some(&end) = ends.last() {
            let first = answers.len();
            if first >= end {
                ends.pop();
                continue;
            }
            let part = cases.get(first * arity..end * arity).unwrap_or_default();
            let (got, broken) = self.attempt(predicate, part)?;
            let suspects = end - first - got.len();
            answers.extend(got);
            match broken {
                Some(broken) if suspects == 1 || self.options.mode == Mode::Text => {
                    answers.push(broken.answer());
                    unexplained = None;
                }
                Some(broken) => {
                    unexplained.get_or_insert((answers.len(), end, broken));
                    ends.push(answers.len() + suspects / 2);
                }
                None => {}
            }
            if let Some((suspect, last, broken)) = unexplained
                && answers.len() >= last
            {
                if let Some(answer) = answers.get_mut(suspect) {
                    *answer = broken.answer();
                }
                unexplained = None;
            }
        }
        Ok(answers)
    }

    fn end(&mut self) -> Result<(), SubjectError> {
        let has_more =
            self.child.take().is_some_and(|child| child.ends_with_more(self.options.timeout.min(FAREWELL)));
        if has_more { Err(SubjectError::TooMuch { command: self.command.clone() }) } else { Ok(()) }
    }

    fn pace(&self) -> Pace {
        match self.options.mode {
            Mode::Text => Pace { batch: 512, tries: 3000, crashes: 60 },
            Mode::Binary => Pace { batch: 8192, tries: 5000, crashes: 60 },
        }
    }
}
