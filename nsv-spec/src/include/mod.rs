//! Joins the files of a specification into one tree, and reads the data files that it names.
//!
//! A file may list fragments under `include`: files below the directory of the specification with any of its top-level
//! sections. Maps merge key by key; anything else may be given in one file only. A specification may also extend another, over
//! which it is laid.

mod arguments;
mod data;
mod extend;

pub(crate) use data::MAX_DATA_FILES;

use std::collections::BTreeMap;
use std::fs;
use std::io::Read;
use std::path::{Component, Path, PathBuf};

use crate::diagnostic::{Diagnostic, FileId, Rule, SourceMap, Span};
use crate::yaml::{self, Entry, Key, Kind, MAX_BYTES, Node, excerpt};
use arguments::{DECLARING, Included};

/// Most files of one specification, itself included.
pub(crate) const MAX_FILES: usize = 16;
/// Deepest chain of files that include each other, the specification not counted.
pub(crate) const MAX_DEPTH: usize = 4;
/// Sections that belong to the specification itself.
const NOT_IN_FRAGMENTS: [&str; 5] = ["nsv", "name", "title", "extends", "scenario"];

/// The files of a specification as one tree.
pub(crate) struct Joined {
    pub(crate) tree: Node,
    /// What is wrong with what they name.
    pub(crate) faults: Vec<Diagnostic>,
    /// Whether one of them is not in the tree: what is missing there may stand in it.
    pub(crate) partial: bool,
}

/// Reads a specification with all that it includes; fails if the specification itself cannot be read.
pub(crate) fn read_file(path: &Path, sources: &mut SourceMap) -> Result<Joined, Vec<Diagnostic>> {
    let name = path.display().to_string();
    let bytes = read_capped(path).map_err(|error| {
        let message = format!("cannot read `{name}`: {}", reason(&error));
        vec![Diagnostic {
            span: None,
            ..Diagnostic::error(
                Rule::E0011,
                Span {
                    file: FileId(0),
                    start: 0,
                    end: 0,
                },
                message,
            )
        }]
    })?;
    let root = path.parent().map_or_else(PathBuf::new, Path::to_path_buf);
    let canonical = fs::canonicalize(path).unwrap_or_else(|_| path.into());
    let tree = parse(&name, &bytes, sources)?;
    let joiner = Joiner {
        root: Some(root),
        sources,
        open: vec![canonical.clone()],
        read: vec![(canonical, None)],
        data: BTreeMap::new(),
        faults: Vec::new(),
        partial: false,
        own: Vec::new(),
    };
    Ok(joiner.join_all(tree))
}

/// Reads a specification that is not in a file and therefore cannot include any.
pub(crate) fn read_text(
    name: &str,
    text: &[u8],
    sources: &mut SourceMap,
) -> Result<Joined, Vec<Diagnostic>> {
    let tree = parse(name, text, sources)?;
    let joiner = Joiner {
        root: None,
        sources,
        open: Vec::new(),
        read: Vec::new(),
        data: BTreeMap::new(),
        faults: Vec::new(),
        partial: false,
        own: Vec::new(),
    };
    Ok(joiner.join_all(tree))
}

/// Registers a file and parses it. A file that is not text is registered empty, so that faults can name it.
fn parse(name: &str, bytes: &[u8], sources: &mut SourceMap) -> Result<Node, Vec<Diagnostic>> {
    let file =
        FileId(u32::try_from(sources.files.len()).expect("invariant: at most MAX_FILES files"));
    match yaml::text(bytes, file) {
        Ok(text) => {
            sources.add(name, text.clone());
            yaml::read(&text, file).map_err(|fault| vec![*fault])
        }
        Err(fault) => {
            sources.add(
                name,
                String::from_utf8_lossy(&bytes[..bytes.len().min(MAX_BYTES)]).into(),
            );
            Err(vec![*fault])
        }
    }
}

/// At most one byte more than is allowed, so that a huge or endless file costs nothing.
fn read_capped(path: &Path) -> std::io::Result<Vec<u8>> {
    // Before it is opened, since opening a pipe waits for its writer.
    let metadata = fs::metadata(path)?;
    if metadata.is_dir() {
        return Err(std::io::Error::other("it is a directory"));
    }
    if !metadata.is_file() {
        return Err(std::io::Error::other("not a regular file"));
    }
    let file = fs::File::open(path)?;
    let mut bytes = Vec::new();
    file.take(MAX_BYTES as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The empty path, of the directory of a file named without one, by its other name.
fn here(path: &Path) -> &Path {
    if path.as_os_str().is_empty() {
        Path::new(".")
    } else {
        path
    }
}

fn reason(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => "no such file".into(),
        std::io::ErrorKind::PermissionDenied => "permission denied".into(),
        _ => error.to_string().to_lowercase(),
    }
}

struct Joiner<'a> {
    /// Directory that no include may leave; `None` where there is none.
    root: Option<PathBuf>,
    sources: &'a mut SourceMap,
    /// Chain of files being read, to find cycles.
    open: Vec<PathBuf>,
    /// Every file with the entry that included it.
    read: Vec<(PathBuf, Option<Span>)>,
    /// Data files that have been read.
    data: BTreeMap<PathBuf, FileId>,
    faults: Vec<Diagnostic>,
    /// Whether a file that is named is not in the tree.
    partial: bool,
    /// Sections of the specification itself.
    own: Vec<Key>,
}

impl Joiner<'_> {
    fn join_all(mut self, mut tree: Node) -> Joined {
        if let Kind::Map(entries) = &tree.kind {
            self.own = entries.iter().map(|entry| entry.key.clone()).collect();
        }
        self.join(&mut tree, Path::new(""));
        Joined {
            tree,
            faults: self.faults,
            partial: self.partial,
        }
    }

    /// Merges everything that `tree` includes into it, lays it over what it extends, and removes these keys. `below` is the
    /// directory of the file, relative to that of the specification.
    fn join(&mut self, tree: &mut Node, below: &Path) {
        self.read_data(tree, below);
        let extends = extend::take(tree, "extends").map(|entry| entry.value);
        for included in self.take_list(tree) {
            let Included {
                name,
                span,
                arguments,
            } = included;
            let Some(path) = self.resolve(&name, span, below) else {
                self.partial = true;
                continue;
            };
            let name = below.join(&name);
            let shown = name.display().to_string();
            let file = self.file(&shown, &path, span);
            let Some(mut fragment) = file.and_then(|tree| self.check_fragment(tree, span)) else {
                self.partial = true;
                continue;
            };
            self.open.push(path);
            self.join(&mut fragment, name.parent().unwrap_or(below));
            self.open.pop();
            self.give(&shown, &mut fragment, arguments);
            self.merge(tree, fragment, "");
        }
        self.extend(tree, extends, below);
    }

    /// The entries of `include`, which is taken out of the tree.
    fn take_list(&mut self, tree: &mut Node) -> Vec<Included> {
        const EXPECTED: &str = "write `include: [models/plant.yaml]`";
        let Some(entry) = extend::take(tree, "include") else {
            return Vec::new();
        };
        let node = entry.value;
        let items = match node.kind {
            Kind::Seq(items) => items,
            Kind::Scalar(_) => vec![node],
            Kind::Null => Vec::new(),
            Kind::Map(_) => {
                let message = "found a map, expected a list of files";
                self.fault(Rule::E0020, node.span, message, EXPECTED);
                self.partial = true;
                Vec::new()
            }
        };
        let mut included = Vec::new();
        for item in items {
            match item.kind {
                Kind::Scalar(scalar) => included.push(Included {
                    name: scalar.text,
                    span: item.span,
                    arguments: Vec::new(),
                }),
                Kind::Map(_) => match self.long_form(&item) {
                    Some(one) => included.push(one),
                    None => self.partial = true,
                },
                _ => {
                    self.partial = true;
                    let message = format!("found {}, expected a file name", item.describe());
                    self.fault(Rule::E0020, item.span, message, EXPECTED);
                }
            }
        }
        included
    }

    /// The canonical path of an included file, if it may be read.
    fn resolve(&mut self, name: &str, span: Span, below: &Path) -> Option<PathBuf> {
        const STAY: &str = "files are named relative to the file that names them and lie below the specification's directory";
        let Some(root) = self.root.clone() else {
            self.fault(
                Rule::E0020,
                span,
                "found the name of another file in a specification that is not in a file",
                "save the specification to a file",
            );
            return None;
        };
        let shown = excerpt(name);
        let plain = Path::new(name)
            .components()
            .all(|part| matches!(part, Component::Normal(_)));
        if !plain || name.is_empty() || name.contains(['\\', '\0', ':']) {
            self.fault(
                Rule::E0020,
                span,
                format!("path `{shown}` is not allowed: expected a relative path without `..`"),
                STAY,
            );
            return None;
        }
        let resolved = fs::canonicalize(root.join(below).join(name))
            .and_then(|path| Ok((path, fs::canonicalize(here(&root))?)));
        let (path, root) = match resolved {
            Ok(found) => found,
            Err(error) => {
                self.fault(
                    Rule::E0021,
                    span,
                    format!("cannot read `{shown}`: {}", reason(&error)),
                    STAY,
                );
                return None;
            }
        };
        if !path.starts_with(&root) {
            self.fault(
                Rule::E0020,
                span,
                format!("path `{shown}` leads out of the specification's directory through a link"),
                STAY,
            );
            return None;
        }
        Some(path)
    }

    /// Reads a file, unless that would go round in circles or on and on.
    fn file(&mut self, name: &str, path: &Path, span: Span) -> Option<Node> {
        let shown = excerpt(name);
        if self.open.iter().any(|open| open == path) {
            let message = format!("file `{shown}` includes itself");
            let fault = Diagnostic::error(Rule::E0022, span, message)
                .with_help("remove one of the includes of the circle");
            let fault = self.with_chain(fault);
            self.faults.push(fault);
            return None;
        }
        if let Some((_, first)) = self.read.iter().find(|(read, _)| read == path) {
            let fault = Diagnostic::error(
                Rule::E0022,
                span,
                format!("file `{shown}` is included twice"),
            )
            .with_help("remove one of the includes");
            self.faults.push(match first {
                Some(first) => fault.with_related(*first, "first included here"),
                None => fault,
            });
            return None;
        }
        if self.read.len() >= MAX_FILES {
            self.fault(
                Rule::E0023,
                span,
                format!("specification has more than {MAX_FILES} files"),
                "join some of the included files",
            );
            return None;
        }
        if self.open.len() > MAX_DEPTH {
            let message = format!("includes are nested deeper than {MAX_DEPTH} files");
            let root = &self.sources.source(FileId(0)).name;
            let help = format!(
                "take it out here, and include `{shown}` in `{}` itself",
                excerpt(root)
            );
            let fault = Diagnostic::error(Rule::E0023, span, message).with_help(help);
            let fault = self.with_chain(fault);
            self.faults.push(fault);
            return None;
        }
        self.read.push((path.into(), Some(span)));
        let bytes = match read_capped(path) {
            Ok(bytes) => bytes,
            Err(error) => {
                self.fault(
                    Rule::E0021,
                    span,
                    format!("cannot read `{shown}`: {}", reason(&error)),
                    "check the name and the permissions of the file",
                );
                return None;
            }
        };
        let place = self.root.clone().unwrap_or_default().join(name);
        match parse(&place.display().to_string(), &bytes, self.sources) {
            Ok(tree) => Some(tree),
            Err(faults) => {
                let related = |fault: Diagnostic| fault.with_related(span, "included here");
                self.faults.extend(faults.into_iter().map(related));
                None
            }
        }
    }

    /// The fault with the places that include the files that are being read, the innermost first.
    fn with_chain(&self, fault: Diagnostic) -> Diagnostic {
        let entry = |open: &PathBuf| {
            let (_, included) = self.read.iter().find(|(read, _)| read == open)?;
            *included
        };
        let places = self.open.iter().rev().filter_map(entry);
        places.fold(fault, |fault, place| {
            fault.with_related(place, "this file is named here")
        })
    }

    /// A fragment without the sections that it must not have, which are reported.
    fn check_fragment(&mut self, mut tree: Node, span: Span) -> Option<Node> {
        match &mut tree.kind {
            Kind::Null => Some(tree),
            Kind::Map(entries) => {
                let misplaced = |entry: &Entry| NOT_IN_FRAGMENTS.contains(&entry.key.text.as_str());
                for entry in entries.iter().filter(|entry| misplaced(entry)) {
                    let message = format!(
                        "found `{}` in an included file, expected it in the specification only",
                        entry.key.text
                    );
                    let fault = Diagnostic::error(Rule::E0024, entry.key.span, message)
                        .with_related(span, "included here");
                    let key = &entry.key.text;
                    let own = self.own.iter().find(|own| own.text == *key);
                    self.partial |= own.is_none();
                    self.faults.push(match own {
                        Some(own) => fault
                            .with_related(own.span, format!("the specification has its own `{key}` here"))
                            .with_help("remove it; what is still needed of it goes into the specification's own"),
                        None => fault.with_help("move it to the specification"),
                    });
                }
                entries.retain(|entry| !misplaced(entry));
                Some(tree)
            }
            _ => {
                let message = format!("found {}, expected a map of sections", tree.describe());
                let fault = Diagnostic::error(Rule::E0024, tree.span, message)
                    .with_related(span, "included here");
                self.faults.push(
                    fault.with_help("write sections such as `constants:` and `definitions:`"),
                );
                None
            }
        }
    }

    /// Adds the keys of `fragment` to `tree`, map by map.
    fn merge(&mut self, tree: &mut Node, fragment: Node, path: &str) {
        let (Kind::Map(into), Kind::Map(from)) = (&mut tree.kind, fragment.kind) else {
            return;
        };
        let mut index = BTreeMap::new();
        for (at, entry) in into.iter().enumerate() {
            index.entry(entry.key.text.clone()).or_insert(at);
        }
        for entry in from {
            let name = if path.is_empty() {
                entry.key.text.clone()
            } else {
                format!("{path}.{}", entry.key.text)
            };
            match index.get(&entry.key.text).map(|&at| &mut into[at]) {
                None => into.push(entry),
                Some(old)
                    if matches!(
                        (&old.value.kind, &entry.value.kind),
                        (Kind::Map(_), Kind::Map(_))
                    ) =>
                {
                    self.merge(&mut old.value, entry.value, &name);
                }
                Some(old) => {
                    self.faults.push(twice(&name, &entry, old));
                    let is_map = |node: &Node| matches!(node.kind, Kind::Map(_));
                    // Of a constant or parameter the one is as good as the other.
                    let short = DECLARING.contains(&path);
                    self.partial |= !short && is_map(&entry.value) != is_map(&old.value);
                    // More can be told of a map than of what stands in its place.
                    if is_map(&entry.value) {
                        old.value = entry.value;
                    }
                }
            }
        }
    }

    fn fault(&mut self, rule: Rule, span: Span, message: impl Into<String>, help: &str) {
        self.faults
            .push(Diagnostic::error(rule, span, message).with_help(help));
    }
}

fn twice(name: &str, new: &Entry, old: &Entry) -> Diagnostic {
    let also = match (&new.value.kind, &old.value.kind) {
        (Kind::Map(_), _) => format!("also given here, as {}", old.value.describe()),
        (_, Kind::Map(_)) => "also given here, as a map".to_owned(),
        _ => "also given here".to_owned(),
    };
    let message = format!("`{name}` is given in two files");
    Diagnostic::error(Rule::E0025, new.key.span, message)
        .with_related(old.key.span, also)
        .with_help("remove one of them; only maps are merged")
}
