//! Batches of records on several threads; what they write comes out in the order of the batches.
use crate::answer::submissions::{Batch, RecordSource};
use crate::grade::run::GradeFault;
use std::collections::BTreeMap;
use std::io::Write;
use std::sync::{Condvar, Mutex, PoisonError};

/// What is done with what the workers wrote.
struct OrderedOutput<'a, 'b> {
    /// The batch whose turn it is.
    next: u64,
    /// Batches before their turn: their bytes, and how much was read with them.
    waiting: BTreeMap<u64, (Vec<u8>, u64)>,
    /// Buffers that were written and can be filled again.
    spare: Vec<Vec<u8>>,
    /// A worker is writing; it alone has the file for now.
    out: Option<&'b mut (dyn Write + Send + 'b)>,
    writing: bool,
    progress: &'a mut (dyn FnMut(u64) + Send),
    halted: bool,
}

/// What a worker does with a batch: it may write.
pub type Process<'a, W> = &'a (dyn Fn(&mut W, &Batch, &mut Vec<u8>) + Sync);

/// Runs all batches through the workers; what they write comes out in the order of the batches. A worker that finds the
/// turn of its batch come writes it and what waits behind it, while the others go on. Errors: reading or writing failed.
pub fn run_batches<'b, W: Send>(
    source: RecordSource,
    workers: Vec<W>,
    process: Process<'_, W>,
    out: Option<&'b mut (dyn Write + Send + 'b)>,
    progress: &mut (dyn FnMut(u64) + Send),
) -> Result<Vec<W>, GradeFault> {
    let limit = workers.len() * 4;
    let source = Mutex::new(source);
    let output = Mutex::new(OrderedOutput {
        next: 0,
        waiting: BTreeMap::new(),
        spare: Vec::new(),
        out,
        writing: false,
        progress,
        halted: false,
    });
    let turn = Condvar::new();
    let hold = || output.lock().unwrap_or_else(PoisonError::into_inner);
    let work = |mut worker: W| -> Result<W, GradeFault> {
        let (mut batch, mut text) = (Batch::default(), Vec::new());
        loop {
            let more = source.lock().unwrap_or_else(PoisonError::into_inner).next_batch(&mut batch);
            match more {
                Ok(true) => {}
                Ok(false) => return Ok(worker),
                Err(fault) => {
                    hold().halted = true;
                    turn.notify_all();
                    return Err(fault.into());
                }
            }
            text.clear();
            process(&mut worker, &batch, &mut text);
            let mut held = hold();
            while held.next != batch.number && held.waiting.len() >= limit && !held.halted {
                held = turn.wait(held).unwrap_or_else(PoisonError::into_inner);
            }
            if held.halted {
                return Ok(worker);
            }
            held.waiting.insert(batch.number, (std::mem::take(&mut text), batch.read_so_far));
            while !held.writing && !held.halted {
                let next = held.next;
                let Some((bytes, read)) = held.waiting.remove(&next) else { break };
                (held.progress)(read);
                if let Some(out) = held.out.take() {
                    held.writing = true;
                    drop(held);
                    let written = out.write_all(&bytes);
                    held = hold();
                    held.out = Some(out);
                    held.writing = false;
                    if let Err(fault) = written {
                        held.halted = true;
                        turn.notify_all();
                        return Err(GradeFault::Write(fault));
                    }
                }
                held.next += 1;
                held.spare.push(bytes);
                turn.notify_all();
            }
            text = held.spare.pop().unwrap_or_default();
        }
    };
    if workers.len() == 1 {
        return workers.into_iter().map(work).collect();
    }
    std::thread::scope(|scope| {
        let running: Vec<_> = workers.into_iter().map(|w| scope.spawn(|| work(w))).collect();
        running
            .into_iter()
            .map(|r| r.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
            .collect()
    })
}
