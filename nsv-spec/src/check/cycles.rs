//! Guarantees that declarations can be put in an order in which each uses only earlier ones.

use std::collections::{BTreeMap, BTreeSet};

/// Declarations in order of use, and the circles that stand in the way.
pub(super) struct Order {
    /// Indices such that each follows those that it uses; the earliest declared first where that leaves a choice.
    pub(super) sorted: Vec<usize>,
    /// Each circle once, every member using the next and the last the first.
    pub(super) circles: Vec<Vec<usize>>,
    /// Everything that is part of a circle or uses one.
    pub(super) unsorted: BTreeSet<usize>,
}

/// Sorts declarations of which `uses[i]` are the ones that declaration `i` uses.
pub(super) fn order(uses: &[BTreeSet<usize>]) -> Order {
    let mut waits_for: Vec<usize> = uses.iter().map(BTreeSet::len).collect();
    let mut used_by: Vec<Vec<usize>> = vec![Vec::new(); uses.len()];
    for (user, used) in uses.iter().enumerate() {
        used.iter().for_each(|&one| used_by[one].push(user));
    }
    let mut ready: BTreeSet<usize> = (0..uses.len()).filter(|&i| waits_for[i] == 0).collect();
    let mut sorted = Vec::with_capacity(uses.len());
    while let Some(next) = ready.pop_first() {
        sorted.push(next);
        for &user in &used_by[next] {
            waits_for[user] -= 1;
            if waits_for[user] == 0 {
                ready.insert(user);
            }
        }
    }
    let unsorted: BTreeSet<usize> = (0..uses.len()).filter(|&i| waits_for[i] > 0).collect();
    Order {
        sorted,
        circles: circles(uses, &unsorted),
        unsorted,
    }
}

/// Walks from each unsorted declaration along one of its unsorted uses until the walk meets itself or an earlier one.
fn circles(uses: &[BTreeSet<usize>], unsorted: &BTreeSet<usize>) -> Vec<Vec<usize>> {
    let mut visited: BTreeMap<usize, usize> = BTreeMap::new();
    let mut circles = Vec::new();
    for &start in unsorted {
        let mut walk = Vec::new();
        let mut at = start;
        while !visited.contains_key(&at) {
            visited.insert(at, start);
            walk.push(at);
            at = *uses[at]
                .intersection(unsorted)
                .next()
                .expect("invariant: an unsorted declaration uses an unsorted one");
        }
        if visited[&at] == start {
            let first = walk
                .iter()
                .position(|&i| i == at)
                .expect("invariant: the walk met itself");
            circles.push(walk.split_off(first));
        }
    }
    circles
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sort(uses: &[&[usize]]) -> Order {
        order(
            &uses
                .iter()
                .map(|used| used.iter().copied().collect())
                .collect::<Vec<_>>(),
        )
    }

    #[test]
    fn each_follows_what_it_uses() {
        let order = sort(&[&[2], &[], &[1], &[0, 1]]);
        assert_eq!(order.sorted, [1, 2, 0, 3]);
        assert!(order.circles.is_empty() && order.unsorted.is_empty());
    }

    #[test]
    fn every_circle_is_found_once() {
        let order = sort(&[&[1], &[2], &[1], &[3], &[0], &[]]);
        assert_eq!(order.circles, [vec![1, 2], vec![3]]);
        assert_eq!(order.sorted, [5]);
        assert_eq!(order.unsorted, BTreeSet::from([0, 1, 2, 3, 4]));
    }

    #[test]
    fn a_long_chain_needs_no_stack() {
        let uses: Vec<BTreeSet<usize>> = (0..200_000)
            .map(|i: usize| i.checked_sub(1).into_iter().collect())
            .collect();
        assert_eq!(order(&uses).sorted.len(), uses.len());
    }
}
