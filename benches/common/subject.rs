//! A program that stays and answers batches: doubles in, bytes or lines out (`docs/SUBJECTS.md`), or that works once for
//! every line `run` (`reference/cgal/serve.hpp`).

use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use crate::cgal::{Answer, CgalError};

/// Bytes that are written at once, so that no copy of all data is made.
const CHUNK: usize = 1 << 20;

/// A running program. It ends when this value goes away.
#[derive(Debug)]
pub struct Subject {
    name: String,
    child: Child,
    input: Option<ChildStdin>,
    output: BufReader<ChildStdout>,
}

impl Subject {
    /// Starts `folder/program`.
    ///
    /// # Errors
    /// It cannot be started.
    pub fn start(folder: &Path, program: &str, options: &[&str]) -> Result<Self, CgalError> {
        let name = [&[program], options].concat().join(" ");
        Self::spawn(name, Command::new(folder.join(program)).args(options))
    }

    /// Starts a program, which is called `name` in errors.
    ///
    /// # Errors
    /// It cannot be started.
    pub fn spawn(name: String, command: &mut Command) -> Result<Self, CgalError> {
        let failed = |source| CgalError::Io { what: name.clone(), source };
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().map_err(failed)?;
        let input = child.stdin.take();
        let output = child.stdout.take().ok_or_else(|| failed(std::io::ErrorKind::BrokenPipe.into()))?;
        Ok(Self { name, child, input, output: BufReader::new(output) })
    }

    /// The program and its options.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Sends a batch: the line `predicate cases`, then the numbers of all cases. Returns when the program has read it, so
    /// that several programs can work at the same time.
    ///
    /// # Errors
    /// The program is gone.
    pub fn send(&mut self, predicate: &str, cases: usize, numbers: &[f64]) -> Result<(), CgalError> {
        let mut bytes = format!("{predicate} {cases}\n").into_bytes();
        bytes.extend(numbers.iter().flat_map(|x| x.to_le_bytes()));
        self.write(&bytes)
    }

    /// Sends one line of text.
    ///
    /// # Errors
    /// The program is gone.
    pub fn send_line(&mut self, line: &str) -> Result<(), CgalError> {
        self.write(format!("{line}\n").as_bytes())
    }

    /// Sends numbers alone, little-endian.
    ///
    /// # Errors
    /// The program is gone.
    pub fn send_numbers(&mut self, numbers: &[f64]) -> Result<(), CgalError> {
        numbers
            .chunks(CHUNK / 8)
            .try_for_each(|part| self.write(&part.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>()))
    }

    /// Sends indices alone, little-endian.
    ///
    /// # Errors
    /// The program is gone.
    pub fn send_indices(&mut self, indices: &[u32]) -> Result<(), CgalError> {
        indices
            .chunks(CHUNK / 4)
            .try_for_each(|part| self.write(&part.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>()))
    }

    /// Waits for the line `ready`.
    ///
    /// # Errors
    /// The program ended, or says something else.
    pub fn ready(&mut self) -> Result<(), CgalError> {
        let line = self.line()?;
        if line == "ready" {
            return Ok(());
        }
        Err(CgalError::Failed { program: self.name.clone(), text: line })
    }

    /// Has the program work once.
    ///
    /// # Errors
    /// The program ended.
    pub fn turn(&mut self) -> Result<Answer, CgalError> {
        self.send_line("run")?;
        let line = self.line()?;
        Ok(Answer::parse(&self.name, &line))
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), CgalError> {
        let input = self.input.as_mut().ok_or(std::io::ErrorKind::BrokenPipe.into());
        input
            .and_then(|input| input.write_all(bytes).and_then(|()| input.flush()))
            .map_err(|source| CgalError::Io { what: self.name.clone(), source })
    }

    /// The answers to a batch, a byte a case.
    ///
    /// # Errors
    /// The program ended before it had answered.
    pub fn signs(&mut self, cases: usize) -> Result<Vec<i8>, CgalError> {
        let mut bytes = vec![0; cases];
        let read = self.output.read_exact(&mut bytes);
        read.map_err(|source| CgalError::Io { what: self.name.clone(), source })?;
        Ok(bytes.into_iter().map(u8::cast_signed).collect())
    }

    /// One line of an answer.
    ///
    /// # Errors
    /// The program ended before it had answered.
    pub fn line(&mut self) -> Result<String, CgalError> {
        let failed = |source| CgalError::Io { what: self.name.clone(), source };
        let mut line = String::new();
        match self.output.read_line(&mut line).map_err(failed)? {
            0 => Err(failed(std::io::ErrorKind::UnexpectedEof.into())),
            _ => Ok(line.trim_end().to_owned()),
        }
    }
}

impl Drop for Subject {
    fn drop(&mut self) {
        // After an error it may wait for ever to be read. Nothing can be done about a failure here.
        drop(self.input.take());
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
