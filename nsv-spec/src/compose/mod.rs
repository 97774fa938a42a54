//! What a specification is put together from: its file with those that it includes and extends, values set on the command line,
//! and the values of a sweep.
//!
//! ```text
//! file over extended file -- settings --> tree -- values of a variant --> tree of the variant
//! ```

pub(crate) mod overlay;
mod path;
mod setting;
mod sweep;

use std::path::Path;

pub use setting::split;
pub use sweep::{MAX_VARIANTS, Variant};

use crate::diagnostic::{Diagnostic, Diagnostics, Rule, SourceMap};
use crate::include::{self, Joined};
use crate::model::Model;
use crate::yaml::Node;
use crate::{check, hash, parse};
use sweep::Sweep;

/// A specification that has been read and put together, but not checked.
#[derive(Clone, Debug)]
pub struct Composition {
    tree: Node,
    sources: SourceMap,
    sweep: Sweep,
    faults: Vec<Diagnostic>,
    /// Whether a file of it is not in the tree.
    partial: bool,
}

impl Composition {
    /// Reads a specification and sets values in it, each given as `PATH=VALUE` (see [`split`]). A value is YAML; `~` takes a key
    /// away; `@FILE` stands for what another specification has under the same path. Fails if the specification itself cannot be
    /// read; what is wrong with the rest comes out when it is checked.
    pub fn read(path: &Path, settings: &[String]) -> Result<Composition, Diagnostics> {
        let mut sources = SourceMap::default();
        let joined = include::read_file(path, &mut sources);
        Self::compose(joined, settings, sources)
    }

    /// Reads a specification that is not in a file; `name` is what messages call it.
    pub(crate) fn read_bytes(name: &str, bytes: &[u8]) -> Result<Composition, Diagnostics> {
        let mut sources = SourceMap::default();
        let joined = include::read_text(name, bytes, &mut sources);
        Self::compose(joined, &[], sources)
    }

    fn compose(
        joined: Result<Joined, Vec<Diagnostic>>,
        settings: &[String],
        sources: SourceMap,
    ) -> Result<Composition, Diagnostics> {
        let joined = match joined {
            Ok(joined) => joined,
            Err(items) => return Err(sorted(items, sources)),
        };
        let mut composition = Composition {
            tree: joined.tree,
            sources,
            sweep: Sweep::default(),
            faults: joined.faults,
            partial: joined.partial,
        };
        let fixed = composition.set_all(settings);
        match Sweep::take(&mut composition.tree, &fixed) {
            Ok(sweep) => composition.sweep = sweep,
            Err(faults) => composition.blame_paths(faults),
        }
        Ok(composition)
    }

    /// Applies settings and gives their paths.
    fn set_all(&mut self, settings: &[String]) -> Vec<String> {
        let mut fixed = Vec::new();
        for setting in settings {
            match setting::apply(&mut self.tree, setting, &mut self.sources) {
                Ok(path) => {
                    let keys: Vec<&str> = path.iter().map(|key| &*key.text).collect();
                    fixed.push(keys.join("."));
                }
                Err(faults) => self.blame_paths(faults),
            }
        }
        fixed
    }

    /// Reports faults of settings and sweeps, but no path that may lead into a file that is missing.
    fn blame_paths(&mut self, faults: Vec<Diagnostic>) {
        let partial = self.partial;
        let certain = |fault: &Diagnostic| !partial || fault.rule != Rule::E0030;
        self.faults.extend(faults.into_iter().filter(certain));
    }

    /// Checks the specification without regard to what is swept.
    pub fn base(&self) -> Result<(Model, Vec<Diagnostic>), Diagnostics> {
        self.build(&self.tree, self.sources.clone())
    }

    /// Every combination of swept values; none if nothing is swept.
    pub fn variants(&self) -> Vec<Variant> {
        self.sweep.variants()
    }

    /// Checks the specification with the values of one of its variants.
    pub fn variant(&self, variant: &Variant) -> Result<(Model, Vec<Diagnostic>), Diagnostics> {
        let (mut tree, mut sources) = (self.tree.clone(), self.sources.clone());
        match self.sweep.apply(variant, &mut tree, &mut sources) {
            Ok(()) => self.build(&tree, sources),
            Err(items) => Err(sorted(items, sources)),
        }
    }

    fn build(
        &self,
        tree: &Node,
        sources: SourceMap,
    ) -> Result<(Model, Vec<Diagnostic>), Diagnostics> {
        let (spec, faults) = parse::parse(tree, self.partial);
        let faults = self.faults.iter().cloned().chain(faults).collect();
        let model = check::check(&spec, faults, &sources, hash::of(&sources));
        model.map_err(|items| sorted(items, sources))
    }
}

/// Faults in order of place, each once.
fn sorted(mut items: Vec<Diagnostic>, sources: SourceMap) -> Diagnostics {
    items.sort_by_key(|item| item.span);
    // A fault in the body of a function is found at each of its calls.
    items.dedup_by(|a, b| (a.rule, a.span, &a.message) == (b.rule, b.span, &b.message));
    Diagnostics { sources, items }
}
