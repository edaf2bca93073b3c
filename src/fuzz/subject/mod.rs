//! Implementations that are judged: closures, libraries, programs.

mod builtin;
mod child;
mod plain;
mod process;
mod wire;

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};

pub use builtin::{BuiltIn, UnknownSubject};
pub use process::{Mode, Process, ProcessOptions};
pub(super) use wire::line as wire_line;

use super::{Answer, Predicate};

/// Why a subject cannot be asked.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SubjectError {
    /// The command is no list of words.
    #[error("the command `{command}` is empty or has an open quote")]
    Command {
        /// The command.
        command: String,
    },
    /// The program does not start.
    #[error("`{command}` does not start: {source}")]
    Start {
        /// The command.
        command: String,
        /// The reason.
        source: std::io::Error,
    },
    /// The program does not answer the plainest case.
    #[error("`{command}` does not answer its first case ({what}){said}")]
    Mute {
        /// The command.
        command: String,
        /// What it did instead.
        what: String,
        /// The end of its standard error, after a colon; empty if it said nothing.
        said: String,
    },
    /// The program writes more answers than there are cases.
    #[error("`{command}` writes more than one answer a case")]
    TooMuch {
        /// The command.
        command: String,
    },
    /// The subject does not judge the predicate at all.
    #[error("{subject} does not support {predicate}")]
    Unsupported {
        /// The subject.
        subject: String,
        /// The predicate.
        predicate: Predicate,
    },
    /// Not as many answers as cases.
    #[error("{subject} gives {found} answers to {wanted} cases")]
    Count {
        /// The subject.
        subject: String,
        /// How many answers there are.
        found: usize,
        /// How many cases were asked.
        wanted: usize,
    },
    /// What the predicate does not take.
    #[error("no answer is right for `{case}`: the predicate does not take it")]
    NoCase {
        /// The case, as in the protocol.
        case: String,
    },
    /// It was restarted too often.
    #[error("`{command}` crashed or hung {times} times")]
    GaveUp {
        /// The command.
        command: String,
        /// How often.
        times: u32,
    },
}

/// An implementation of predicates.
pub trait Subject {
    /// What to call it in reports.
    fn name(&self) -> String;

    /// One answer for each case: `cases` holds `predicate.arity()` finite coordinates a case.
    ///
    /// # Errors
    /// [`SubjectError`] if there are no answers to be had at all; a crash or a hang is an [`Answer`].
    fn answer(&mut self, predicate: Predicate, cases: &[f64]) -> Result<Vec<Answer>, SubjectError>;

    /// Called after the last case, and before what has been found is shrunk; the subject may be asked again.
    ///
    /// # Errors
    /// [`SubjectError`] if what it has answered cannot be trusted to belong to the cases.
    fn end(&mut self) -> Result<(), SubjectError> {
        Ok(())
    }

    /// How many cases are best asked at once, and how many single questions a search for a smaller case may take.
    fn pace(&self) -> Pace {
        Pace { batch: 4096, tries: 20_000, crashes: 20_000 }
    }
}

/// How much to ask of a subject.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pace {
    /// Cases of a batch.
    pub batch: usize,
    /// Cases that shrinking one finding may take.
    pub tries: usize,
    /// The same for a finding that ends the subject, or hangs it.
    pub crashes: usize,
}

thread_local! {
    static ASKING: Cell<bool> = const { Cell::new(false) };
}

/// Is this thread within a subject's code? A panic there is a finding: a panic hook may keep quiet about it.
#[must_use]
pub fn asking() -> bool {
    ASKING.get()
}

/// What the function answers; [`Answer::Crash`] if it panics.
fn caught(ask: impl FnOnce() -> Answer) -> Answer {
    let outer = ASKING.replace(true);
    let answer = catch_unwind(AssertUnwindSafe(ask)).unwrap_or(Answer::Crash);
    ASKING.set(outer);
    answer
}

/// A subject that is a function; see [`from_fn`].
#[derive(Debug)]
pub struct Function<F> {
    name: String,
    function: F,
}

/// A subject from a function that gets the coordinates of one case. A panic in it is the answer
/// [`Answer::Crash`] (where panics unwind).
///
/// ```
/// use homeo::fuzz::{Answer, Predicate, Subject, from_fn};
///
/// let mut mine = from_fn("mine", |_, x| Answer::of_value(x[0] * x[1]));
/// let answers = mine.answer(Predicate::Orient2d, &[2.0, -3.0, 0.0, 0.0, 0.0, 0.0])?;
/// assert_eq!(answers, [Answer::Sign(homeo::predicate::Sign::Negative)]);
/// # Ok::<(), homeo::fuzz::SubjectError>(())
/// ```
pub fn from_fn<F: FnMut(Predicate, &[f64]) -> Answer>(name: &str, function: F) -> Function<F> {
    Function { name: name.to_owned(), function }
}

impl<F: FnMut(Predicate, &[f64]) -> Answer> Subject for Function<F> {
    fn name(&self) -> String {
        self.name.clone()
    }

    fn answer(&mut self, predicate: Predicate, cases: &[f64]) -> Result<Vec<Answer>, SubjectError> {
        let one = |case: &[f64]| caught(|| (self.function)(predicate, case));
        Ok(cases.chunks_exact(predicate.arity()).map(one).collect())
    }
}

/// A subject with all its signs negated: for the opposite convention of orientation.
#[derive(Debug)]
pub struct Flipped<S>(pub S);

impl<S: Subject> Subject for Flipped<S> {
    fn name(&self) -> String {
        format!("{}, flipped", self.0.name())
    }

    fn answer(&mut self, predicate: Predicate, cases: &[f64]) -> Result<Vec<Answer>, SubjectError> {
        Ok(self.0.answer(predicate, cases)?.into_iter().map(Answer::flipped).collect())
    }

    fn end(&mut self) -> Result<(), SubjectError> {
        self.0.end()
    }

    fn pace(&self) -> Pace {
        self.0.pace()
    }
}

impl<S: Subject + ?Sized> Subject for Box<S> {
    fn name(&self) -> String {
        (**self).name()
    }

    fn answer(&mut self, predicate: Predicate, cases: &[f64]) -> Result<Vec<Answer>, SubjectError> {
        (**self).answer(predicate, cases)
    }

    fn end(&mut self) -> Result<(), SubjectError> {
        (**self).end()
    }

    fn pace(&self) -> Pace {
        (**self).pace()
    }
}
