//! Points in portions, by two threads.

use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use crate::points::{Kind, Points};

/// Points of a portion: a multiple of every number of lanes.
const PORTION: u64 = 512;

/// Threads.
const THREADS: usize = 2;

/// Points one after another, the number of the first, and the kind of each.
pub struct Portion<'a> {
    /// Number of the first point.
    pub first: u64,
    /// Entries of the points.
    pub points: &'a [f64],
    /// What they are.
    pub kinds: &'a [Kind],
}

/// Calls `work` of a worker of each thread with portions of `count` points, and gives the workers back.
pub fn share<W: Send>(points: &Points, count: u64, worker: impl Fn() -> W + Sync, work: impl Fn(&mut W, Portion<'_>) + Sync) -> Vec<W> {
    let next = AtomicU64::new(0);
    let of_thread = || {
        let mut state = worker();
        let mut buffer = Vec::new();
        loop {
            let first = next.fetch_add(PORTION, Ordering::Relaxed);
            if first >= count {
                return state;
            }
            buffer.resize(PORTION.min(count - first) as usize * points.layout().size(), 0.0);
            let rows = buffer.chunks_mut(points.layout().size());
            let kinds: Vec<Kind> = (first..).zip(rows).map(|(index, point)| points.draw(index, point)).collect();
            work(&mut state, Portion { first, points: &buffer, kinds: &kinds });
        }
    };
    thread::scope(|scope| {
        let threads: Vec<_> = (0..THREADS).map(|_| scope.spawn(of_thread)).collect();
        threads.into_iter().map(|thread| thread.join().expect("a worker does not panic")).collect()
    })
}
