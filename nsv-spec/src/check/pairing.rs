//! Joins two lists of names that should be the same, such as the blocks of plant and controller.

use crate::suggest::{Meant, nearest};

/// Which given name belongs to each wanted one, and what is left over.
pub(super) struct Pairing {
    /// For each wanted name the index of the given one.
    pub(super) matched: Vec<Option<usize>>,
    /// Indices of given names that nobody wants, with the wanted one that each was probably meant for: it is matched with that, so
    /// that what is missing is no second fault.
    pub(super) strangers: Vec<(usize, Option<Meant>)>,
}

/// Pairs equal names, then the others with the nearest that is free.
pub(super) fn pair(wanted: &[&str], given: &[&str]) -> Pairing {
    let place = |name: &str| given.iter().position(|other| *other == name);
    let mut matched: Vec<Option<usize>> = wanted.iter().map(|name| place(name)).collect();
    let mut strangers = Vec::new();
    for (at, name) in given.iter().enumerate() {
        if wanted.contains(name) {
            continue;
        }
        let open: Vec<usize> = (0..wanted.len())
            .filter(|&i| matched[i].is_none())
            .collect();
        let near = nearest(name, open.iter().map(|&i| wanted[i]));
        let meant = near.or_else(|| match open.as_slice() {
            [last] if wanted.len() == given.len() => Some(Meant {
                name: wanted[*last].to_owned(),
                sure: false,
            }),
            _ => None,
        });
        if let Some(meant) = &meant {
            let taken = open.into_iter().find(|&i| wanted[i] == meant.name);
            taken.into_iter().for_each(|i| matched[i] = Some(at));
        }
        strangers.push((at, meant));
    }
    Pairing { matched, strangers }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_is_paired_with_what_was_meant() {
        let Pairing { matched, strangers } = pair(&["attitude", "rates"], &["rates", "atitude"]);
        assert_eq!(matched, [Some(1), Some(0)]);
        assert!(strangers[0].1.as_ref().is_some_and(|meant| meant.sure));
    }

    #[test]
    fn the_last_two_belong_together_whatever_they_are_called() {
        let Pairing { matched, strangers } = pair(&["x", "y"], &["x", "speed"]);
        assert_eq!(matched, [Some(0), Some(1)]);
        assert!(strangers[0].1.as_ref().is_some_and(|meant| !meant.sure));
        assert_eq!(pair(&["x", "y", "z"], &["speed"]).matched, [None; 3]);
    }
}
