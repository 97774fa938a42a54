//! Files, YAML and includes.

use super::{Explanation, Twist, edit, plain, twisted, undo, with_files};
use crate::diagnostic::Rule;

pub(super) const ALL: &[(Rule, Explanation)] = &[
    (
        Rule::E0001,
        twisted(
            "A specification is written by people, and a large one has 30 kB. The reader stops at 1 MiB, so that a wrong file on the command line costs neither memory nor time.",
            &[undo("name: cart\n", "name: cart\n# …\n")],
            Twist::Long("measured data, ", 80_000),
        ),
    ),
    (
        Rule::E0002,
        twisted(
            "YAML files are UTF-8. A file in another encoding would be read as other text than you see in your editor, so it is refused at its first byte that is not UTF-8.",
            &[edit(
                "name: cart\n",
                "name: cart\ntitle: Café cart\n",
                "name: cart\ntitle: Café cart\n",
            )],
            Twist::Latin1,
        ),
    ),
    (
        Rule::E0003,
        plain(
            "Some editors on Windows write an invisible mark at the start of UTF-8 files. YAML tools disagree about it, and hashes of files that look the same differ, so nsv wants plain UTF-8.",
            &[undo("nsv: 1", "\u{feff}nsv: 1")],
        ),
    ),
    (
        Rule::E0004,
        plain(
            "The file is not YAML, so nothing of it can be checked. The usual causes are a bracket or quote that is not closed, a colon without a blank behind it, keys of one map at different columns, and text with special characters that is not in quotes.",
            &[undo("{v: 1 m/s}", "{v: 1 m/s")],
        ),
    ),
    (
        Rule::E0005,
        plain(
            "No specification needs more than eight levels of nesting. The limit of 32 protects the reader from files made to exhaust it; if you meet it, a bracket is probably not closed.",
            &[undo(
                "1 m/s",
                "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]",
            )],
        ),
    ),
    (
        Rule::E0006,
        plain(
            "Aliases of aliases multiply: seven lines of YAML can stand for ten million values. The reader stops at 100000 values.",
            &[undo(
                "name: cart\n",
                "name: cart\na: &a [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\nb: &b [*a, *a, *a, *a, *a, *a, *a, *a, *a, *a]\nc: &c [*b, *b, *b, *b, *b, *b, *b, *b, *b, *b]\nd: &d [*c, *c, *c, *c, *c, *c, *c, *c, *c, *c]\ne: &e [*d, *d, *d, *d, *d, *d, *d, *d, *d, *d]\n",
            )],
        ),
    ),
    (
        Rule::E0007,
        plain(
            "Tags such as `!!python/object` ask a YAML reader to make objects of a type. A specification is text, numbers, lists and maps only, and never makes a reader do anything else.",
            &[undo("substeps: 4", "substeps: !steps 4")],
        ),
    ),
    (
        Rule::E0008,
        plain(
            "A file is one specification. A line `---` starts a second document, which would be ignored silently by other tools.",
            &[undo("controller:\n", "---\ncontroller:\n")],
        ),
    ),
    (
        Rule::E0009,
        plain(
            "An alias `*x` repeats the value marked `&x` before it. It cannot stand for a value that is not marked, nor for one that contains the alias itself, as in `a: &c {b: *c}`: written out, that would never end. Write the value that is meant in its place. The merge key `<<` is no part of YAML 1.2 and hides where a key comes from; included files do its work.",
            &[undo("drift: \"-v/(1 s)\"", "drift: *v")],
        ),
    ),
    (
        Rule::E0010,
        plain(
            "Keys are names. YAML lets lists and maps be keys, which have no meaning here; mostly a `?` or a bracket slipped in front of a colon.",
            &[undo("{v: 1 m/s}", "{[v]: 1 m/s}")],
        ),
    ),
    (
        Rule::E0011,
        twisted(
            "The specification named on the command line cannot be opened: it is not there, is a directory, or may not be read.",
            &[],
            Twist::Absent,
        ),
    ),
    (
        Rule::E0020,
        with_files(
            "Included files lie below the directory of the specification and are named relative to the file that names them. `include` is a list of files, `extends` the name of one specification, for a specification is another one with changes, not several. So a specification can be copied with its folder, and one from elsewhere cannot read your other files.",
            &[edit(
                "name: cart\n",
                "name: cart\ninclude: [../data.yaml]\n",
                "name: cart\ninclude: [data.yaml]\n",
            )],
            &[("data.yaml", "", "")],
        ),
    ),
    (
        Rule::E0021,
        with_files(
            "An included file cannot be opened. Names are relative to the file that includes them, not to the directory where nsv runs.",
            &[edit(
                "name: cart\n",
                "name: cart\ninclude: [dat.yaml]\n",
                "name: cart\ninclude: [data.yaml]\n",
            )],
            &[("data.yaml", "", "")],
        ),
    ),
    (
        Rule::E0022,
        with_files(
            "Every file is read once. Including it again would declare everything in it twice, and files that include each other would never end.",
            &[edit(
                "name: cart\n",
                "name: cart\ninclude: [data.yaml, data.yaml]\n",
                "name: cart\ninclude: [data.yaml]\n",
            )],
            &[("data.yaml", "", "")],
        ),
    ),
    (
        Rule::E0023,
        with_files(
            "A specification has at most 16 files, nested at most four deep, so that a person can still find where something is declared. A file at the end of too long a chain is taken out of the file that includes it, and included by the specification itself, by its path from there.",
            &[edit(
                "name: cart\n",
                "name: cart\ninclude: [a.yaml]\n",
                "name: cart\ninclude: [a.yaml, e.yaml]\n",
            )],
            &[
                ("a.yaml", "include: [b.yaml]\n", "include: [b.yaml]\n"),
                ("b.yaml", "include: [c.yaml]\n", "include: [c.yaml]\n"),
                ("c.yaml", "include: [d.yaml]\n", "include: [d.yaml]\n"),
                ("d.yaml", "include: [e.yaml]\n", ""),
                ("e.yaml", "", ""),
            ],
        ),
    ),
    (
        Rule::E0024,
        with_files(
            "An included file describes a part, mostly a plant. The language version, the name and the scenario belong to the whole and stand in the specification itself: move the section there, or remove it if the specification has its own.",
            &[edit(
                "name: cart\n",
                "name: cart\ninclude: [data.yaml]\n",
                "name: cart\ntitle: A cart\ninclude: [data.yaml]\n",
            )],
            &[(
                "data.yaml",
                "title: A cart\nconstants: {mass: 2 kg}\n",
                "constants: {mass: 2 kg}\n",
            )],
        ),
    ),
    (
        Rule::E0025,
        with_files(
            "Maps of several files are joined key by key. A single value cannot be joined with another, and letting the last one win would make the order of the files matter.",
            &[edit(
                "name: cart\n",
                "name: cart\ninclude: [data.yaml]\n",
                "name: cart\ninclude: [data.yaml]\n",
            )],
            &[(
                "data.yaml",
                "reference: {v: 2 m/s}\nconstants: {mass: 2 kg}\n",
                "constants: {mass: 2 kg}\n",
            )],
        ),
    ),
];
