//! Answers questions about partial derivatives: from memory, from stored exports, or from CasADi.

use std::collections::{BTreeMap, BTreeSet};

use super::decode::decode;
use super::document::{CASADI_VERSION, Export, SCHEMA};
use super::environment::{Environment, Mode};
use super::error::Error;
use super::exporter::Exporter;
use super::job::Job;
use super::request::Question;
use super::store::{Key, Store};
use crate::ir::Program;

/// Takes partial derivatives, and remembers which exports it used.
pub struct Provider<'a> {
    environment: Environment,
    exports: Store,
    cache: Option<Store>,
    exporter: Option<Exporter>,
    progress: Box<dyn FnMut(&str) + 'a>,
    used: BTreeMap<Key, Export>,
}

impl<'a> Provider<'a> {
    /// A provider; `progress` is told what takes time.
    pub fn new(environment: Environment, progress: impl FnMut(&str) + 'a) -> Self {
        let exports = Store::new(&environment.exports);
        let cache = environment.cached_exports().map(Store::new);
        Self {
            environment,
            exports,
            cache,
            exporter: None,
            progress: Box::new(progress),
            used: BTreeMap::new(),
        }
    }

    /// The derivatives of `formula` that `job` asks for, as a program of scalar instructions.
    pub fn partials(&mut self, formula: &Program, job: &Job) -> Result<Program, Error> {
        let question = Question::new(formula, job);
        let key = question.key();
        let export = match self.used.get(&key) {
            Some(export) => export.clone(),
            None => self.find(&key, &question)?,
        };
        let decoded = decode(&question, &export.tape);
        let program = decoded.map_err(|error| Error::Tape {
            formula: formula.name.clone(),
            error,
        })?;
        self.used.insert(key, export);
        Ok(program)
    }

    /// Keys of the exports used so far.
    pub fn used(&self) -> BTreeSet<Key> {
        self.used.keys().cloned().collect()
    }

    /// Exports used so far.
    pub fn exports(&self) -> impl Iterator<Item = &Export> {
        self.used.values()
    }

    /// Writes the exports used so far to the committed directory.
    pub fn commit(&self) -> Result<(), Error> {
        self.used
            .values()
            .try_for_each(|export| self.exports.save(export))
    }

    /// Committed exports that nothing has used so far.
    pub fn unused(&self) -> Result<BTreeSet<Key>, Error> {
        Ok(self
            .exports
            .keys()?
            .into_iter()
            .filter(|key| !self.used.contains_key(key))
            .collect())
    }

    fn find(&mut self, key: &Key, question: &Question<'_>) -> Result<Export, Error> {
        if let Some(export) = self.exports.load(key, &question.request)? {
            return Ok(export);
        }
        // A cache can be made again: what is wrong in it is not an error but absent.
        if let Some(Ok(Some(export))) = self
            .cache
            .as_ref()
            .map(|cache| cache.load(key, &question.request))
            && decode(question, &export.tape).is_ok()
        {
            return Ok(export);
        }
        let formula = &question.formula.name;
        match self.environment.mode {
            Mode::Offline => Err(Error::ExportMissing {
                formula: formula.clone(),
                key: key.clone(),
            }),
            Mode::Provision => self.ask(question),
        }
    }

    fn ask(&mut self, question: &Question<'_>) -> Result<Export, Error> {
        let mut exporter = match self.exporter.take() {
            Some(exporter) => exporter,
            None => {
                let python = self.environment.provision(&mut *self.progress)?;
                Exporter::start(&python, self.environment.timeout)?
            }
        };
        let formula = &question.formula.name;
        (self.progress)(&format!(
            "taking the partial derivatives of `{formula}` with casadi"
        ));
        let tape = exporter.tape(formula, &question.request)?;
        self.exporter = Some(exporter);
        let fits = decode(question, &tape);
        fits.map_err(|error| Error::Tape {
            formula: formula.clone(),
            error,
        })?;
        let request = question.request.clone();
        let export = Export {
            schema: SCHEMA.to_owned(),
            casadi: CASADI_VERSION.to_owned(),
            request,
            tape,
        };
        if let Some(cache) = &self.cache {
            // The answer is good even if it cannot be kept.
            let _ = cache.save(&export);
        }
        Ok(export)
    }
}
