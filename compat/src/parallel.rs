//! Several pieces of work at once.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

/// Does `work` for the numbers in `order`, begun in that order on `jobs` threads; the results are
/// sorted by number.
pub fn each<T: Send>(order: &[usize], jobs: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let results = Mutex::new(Vec::with_capacity(order.len()));
    thread::scope(|scope| {
        for _ in 0..jobs.max(1) {
            scope.spawn(|| {
                while let Some(&number) = order.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let result = work(number);
                    results.lock().unwrap_or_else(PoisonError::into_inner).push((number, result));
                }
            });
        }
    });
    let mut results = results.into_inner().unwrap_or_else(PoisonError::into_inner);
    results.sort_by_key(|&(number, _)| number);
    results.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_begins_in_the_order_given_and_ends_sorted() {
        let begun = Mutex::new(Vec::new());
        let squares = each(&[2, 0, 1], 1, |number| {
            begun.lock().unwrap().push(number);
            number * number
        });
        assert_eq!(squares, [0, 1, 4]);
        assert_eq!(begun.into_inner().unwrap(), [2, 0, 1]);
    }

    #[test]
    fn more_threads_do_each_piece_once() {
        let order: Vec<usize> = (0..100).collect();
        assert_eq!(each(&order, 8, |number| number), order);
    }
}
