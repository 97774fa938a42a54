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

use crate::diagnostic::{Diagnostic, Diagnostics, SourceMap};
use crate::model::Model;
use crate::yaml::Node;
use crate::{build, include, sorted};
use sweep::Sweep;

/// A specification that has been read and put together, but not checked.
#[derive(Clone, Debug)]
pub struct Composition {
    tree: Node,
    sources: SourceMap,
    sweep: Sweep,
}

impl Composition {
    /// Reads a specification and sets values in it, each given as `PATH=VALUE` (see [`split`]). A value is YAML; `~` takes a key
    /// away; `@FILE` stands for what another specification has under the same path.
    pub fn read(path: &Path, settings: &[String]) -> Result<Composition, Diagnostics> {
        let mut sources = SourceMap::default();
        match compose(
            include::read_file(path, &mut sources),
            settings,
            &mut sources,
        ) {
            Ok((tree, sweep)) => Ok(Composition {
                tree,
                sources,
                sweep,
            }),
            Err(items) => Err(sorted(items, sources)),
        }
    }

    /// Reads a specification that is not in a file; `name` is what messages call it.
    pub(crate) fn read_bytes(name: &str, bytes: &[u8]) -> Result<Composition, Diagnostics> {
        let mut sources = SourceMap::default();
        match compose(
            include::read_text(name, bytes, &mut sources),
            &[],
            &mut sources,
        ) {
            Ok((tree, sweep)) => Ok(Composition {
                tree,
                sources,
                sweep,
            }),
            Err(items) => Err(sorted(items, sources)),
        }
    }

    /// Checks the specification without regard to what is swept.
    pub fn base(&self) -> Result<(Model, Vec<Diagnostic>), Diagnostics> {
        build(&self.tree, self.sources.clone())
    }

    /// Every combination of swept values; none if nothing is swept.
    pub fn variants(&self) -> Vec<Variant> {
        self.sweep.variants()
    }

    /// Checks the specification with the values of one of its variants.
    pub fn variant(&self, variant: &Variant) -> Result<(Model, Vec<Diagnostic>), Diagnostics> {
        let (mut tree, mut sources) = (self.tree.clone(), self.sources.clone());
        match self.sweep.apply(variant, &mut tree, &mut sources) {
            Ok(()) => build(&tree, sources),
            Err(items) => Err(sorted(items, sources)),
        }
    }
}

fn compose(
    tree: Result<Node, Vec<Diagnostic>>,
    settings: &[String],
    sources: &mut SourceMap,
) -> Result<(Node, Sweep), Vec<Diagnostic>> {
    let mut tree = tree?;
    let (mut fixed, mut faults) = (Vec::new(), Vec::new());
    for setting in settings {
        match setting::apply(&mut tree, setting, sources) {
            Ok(path) => {
                let keys: Vec<&str> = path.iter().map(|key| &*key.text).collect();
                fixed.push(keys.join("."));
            }
            Err(more) => faults.extend(more),
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let sweep = Sweep::take(&mut tree, &fixed)?;
    Ok((tree, sweep))
}
