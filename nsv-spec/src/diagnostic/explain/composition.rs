//! Specifications that are put together from others, and sweeps.

use super::{Explanation, edit, plain, with_files};
use crate::diagnostic::Rule;

pub(super) const ALL: &[(Rule, Explanation)] = &[
    (
        Rule::E0030,
        plain(
            "A path names the keys from the top of the specification down to a value, with points between them. A value that is put where nothing reads it would change nothing without a word, so every key must be known, and every name that you chose must be declared. Lists and expressions are given whole: a path does not lead into them.",
            &[edit(
                "horizon: 5 s,",
                "horizon: 5 s, sweep: {controller.blocks.motion.k: [1, 2]},",
                "horizon: 5 s, sweep: {controller.blocks.motion.K: [1, 2]},",
            )],
        ),
    ),
    (
        Rule::E0031,
        with_files(
            "What stands under `with` takes the place of constants and parameters that the included file declares. A name that it does not declare would have no effect.",
            &[edit(
                "name: cart\n",
                "name: cart\ninclude: [{file: data.yaml, with: {mas: 3 kg}}]\n",
                "name: cart\ninclude: [{file: data.yaml, with: {mass: 3 kg}}]\n",
            )],
            &[(
                "data.yaml",
                "constants: {mass: 2 kg}\n",
                "constants: {mass: 2 kg}\n",
            )],
        ),
    ),
    (
        Rule::E0032,
        with_files(
            "A specification that extends another takes a key away by giving it the value `~`. If the other one has no such key, the name is probably mistyped, and what should go would stay.",
            &[edit(
                "name: cart\n",
                "name: cart\nextends: base.yaml\nconstants: {mas: ~}\n",
                "name: cart\nextends: base.yaml\nconstants: {mass: ~}\n",
            )],
            &[(
                "base.yaml",
                "constants: {mass: 2 kg}\n",
                "constants: {mass: 2 kg}\n",
            )],
        ),
    ),
    (
        Rule::E0033,
        plain(
            "A sweep is a map from paths to lists of values. Every combination is compiled and flown, so there are at most 100, and each list has at least one value.",
            &[edit(
                "horizon: 5 s,",
                "horizon: 5 s, sweep: {controller.blocks.motion.K: 2},",
                "horizon: 5 s, sweep: {controller.blocks.motion.K: [2, 4]},",
            )],
        ),
    ),
];
