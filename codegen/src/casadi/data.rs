//! Calls of polynomial data and of lookup tables in a tape, which give how often to differentiate by each argument.

use super::decode::{Decoder, Term};
use super::job::MAX_ORDER;
use super::polynomial::differentiate;
use super::request::Data;
use crate::ir::{Op, PolynomialId, TableId, ValueId};

impl Decoder<'_> {
    /// A call: index in the request, then the order by each argument.
    pub(super) fn data(&mut self, arguments: &[usize], data: &[i64]) -> Option<Term> {
        let (index, orders) = data.split_first()?;
        let orders: Vec<u32> = orders
            .iter()
            .map(|order| u32::try_from(*order).ok())
            .collect::<Option<_>>()?;
        let fits = orders.len() == arguments.len();
        if !fits || orders.iter().any(|order| *order > MAX_ORDER as u32) {
            return None;
        }
        match self.question.data.get(usize::try_from(*index).ok()?)? {
            Data::Polynomial(id) => self.polynomial(*id, arguments, data, &orders),
            Data::Table(id, taken) => {
                let orders = orders.iter().zip(taken).map(|(order, taken)| order + taken);
                self.table(*id, arguments, orders.collect())
            }
        }
    }

    fn polynomial(
        &mut self,
        id: PolynomialId,
        arguments: &[usize],
        key: &[i64],
        orders: &[u32],
    ) -> Option<Term> {
        let source = &self.question.formula.polynomials[id.0 as usize];
        if arguments.len() != source.arguments.len() {
            return None;
        }
        let known = self.polynomials.get(key).copied();
        let id = known.unwrap_or_else(|| {
            let derived = differentiate(source, orders);
            let next = PolynomialId(
                u32::try_from(self.program.polynomials.len()).expect("invariant: few polynomials"),
            );
            let id = (!derived.terms.is_empty()).then_some(next);
            self.program.polynomials.extend(id.map(|_| derived));
            self.polynomials.insert(key.to_vec(), id);
            id
        });
        let Some(id) = id else {
            return Some(Term::Zero);
        };
        let arguments = self.reals(arguments);
        Some(self.push(Op::Polynomial(id, arguments)))
    }

    /// Beyond its degree every derivative of a table is 0.
    fn table(&mut self, id: TableId, arguments: &[usize], orders: Vec<u32>) -> Option<Term> {
        let source = &self.question.formula.tables[id.0 as usize];
        if arguments.len() != source.arguments.len() {
            return None;
        }
        let degree = source.interpolant.degree.number();
        if orders.iter().any(|&order| order as usize > degree) {
            return Some(Term::Zero);
        }
        let tables = &mut self.program.tables;
        let known = tables.iter().position(|known| known == source);
        let at = known.unwrap_or_else(|| {
            tables.push(source.clone());
            tables.len() - 1
        });
        let id = TableId(u32::try_from(at).expect("invariant: few tables"));
        let arguments = self.reals(arguments);
        Some(self.push(Op::Table(id, orders, arguments)))
    }

    fn reals(&mut self, nodes: &[usize]) -> Vec<ValueId> {
        nodes.iter().map(|node| self.real(*node)).collect()
    }
}
