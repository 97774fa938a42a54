//! Reading the textual form of [`super::print`]. It checks syntax only; [`super::verify`] judges the program.

use std::fmt::{self, Display, Formatter};
use std::str::FromStr;

use nsv_spec::interpolation::{Degree, Extrapolation, Interpolant};

use super::mnemonic::{COMPARISONS, FUNCTIONS, KERNELS, OPERATORS, item};
use super::{
    BasisId, FamilyId, FamilyMember, Input, Instruction, MonomialBasis, Op, Origin, PolynomialData,
    PolynomialFamily, PolynomialId, Program, Shape, TableData, TableFamily, TableFamilyId, TableId,
    TableMember, Type, ValueId,
};

/// A line that is not a statement of the textual form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ReadError {
    /// Line, from 1.
    pub line: usize,
    /// What should stand there.
    pub expected: &'static str,
}

impl Display for ReadError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: expected {}", self.line, self.expected)
    }
}

impl std::error::Error for ReadError {}

/// What was expected where reading failed.
type Expected<T> = Result<T, &'static str>;

impl FromStr for Program {
    type Err = ReadError;

    fn from_str(text: &str) -> Result<Program, ReadError> {
        let mut program = Program::default();
        for (index, line) in text.lines().enumerate() {
            let line = line.trim();
            if !line.is_empty() {
                program.read_statement(line).map_err(|expected| ReadError {
                    line: index + 1,
                    expected,
                })?;
            }
        }
        Ok(program)
    }
}

impl Program {
    fn read_statement(&mut self, line: &str) -> Expected<()> {
        if line.starts_with('%') {
            return self.read_instruction(line);
        }
        let (keyword, rest) = line.split_once(' ').unwrap_or((line, ""));
        match keyword {
            "program" => self.name = rest.to_owned(),
            "fused" => self.fused = true,
            "input" => {
                let (name, ty) = rest.split_once(": ").ok_or("`input name: type`")?;
                let Type::Real(shape) = read_type(ty)? else {
                    return Err("a real type");
                };
                self.inputs.push(Input {
                    name: name.to_owned(),
                    shape,
                });
            }
            "polynomial" => {
                let (name, arguments, items) = read_table(rest)?;
                let terms = items
                    .into_iter()
                    .map(|(head, exponents)| Ok((number(head)?, exponents)))
                    .collect::<Expected<_>>()?;
                self.polynomials.push(PolynomialData {
                    name,
                    arguments,
                    terms,
                });
            }
            "table" => {
                let (name, arguments, mut items) = read_table(rest)?;
                let (kind, coefficients) = items.pop().ok_or("coefficients")?;
                let (degree, extrapolation) = read_kind(kind)?;
                let interpolant = Interpolant {
                    degree,
                    extrapolation,
                    breaks: items.into_iter().map(|(_, breaks)| breaks).collect(),
                    coefficients,
                };
                self.tables.push(TableData {
                    name,
                    arguments,
                    interpolant,
                });
            }
            "tables" => {
                let (name, arguments, items) = read_table(rest)?;
                let member = |(table, orders): (&str, _)| {
                    let table = self.read_table_id(table)?;
                    Ok(TableMember { table, orders })
                };
                let members = items.into_iter().map(member).collect::<Expected<_>>()?;
                self.table_families.push(TableFamily {
                    name,
                    arguments,
                    members,
                });
            }
            "family" => {
                let (name, arguments, items) = read_table(rest)?;
                let member = |(name, coefficients): (&str, _)| FamilyMember {
                    name: name.to_owned(),
                    coefficients,
                };
                self.families.push(PolynomialFamily {
                    name,
                    argument: arguments.concat(),
                    members: items.into_iter().map(member).collect(),
                });
            }
            "basis" => {
                let (name, inputs, items) = read_table(rest)?;
                let exponents = items.into_iter().map(|(_, exponents)| exponents).collect();
                self.bases.push(MonomialBasis {
                    name,
                    inputs,
                    exponents,
                });
            }
            "origin" => {
                let (group, rest) = read_quoted(rest)?;
                let (equation, _) = read_quoted(rest.trim_start())?;
                self.origins.push(Origin { group, equation });
            }
            "output" => {
                let (name, value) = rest.split_once(" = ").ok_or("`output name = %value`")?;
                self.outputs.push((name.to_owned(), read_value(value)?));
            }
            _ => return Err("a statement"),
        }
        Ok(())
    }

    /// `%12 e1: vec3 = sub %3, %4 @2   ; comment`
    fn read_instruction(&mut self, line: &str) -> Expected<()> {
        let code = line
            .split_once(" ;")
            .map_or(line, |(code, _)| code)
            .trim_end();
        let (code, origin) = match code.rsplit_once(" @") {
            Some((code, origin)) => (code, Some(number(origin)?)),
            None => (code, None),
        };
        let (head, op) = code.split_once(" = ").ok_or("`%value: type = operation`")?;
        let (head, ty) = head.split_once(": ").ok_or("a type after `: `")?;
        let (id, name) = head
            .split_once(' ')
            .map_or((head, None), |(id, name)| (id, Some(name.to_owned())));
        if read_value(id)?.0 as usize != self.instructions.len() {
            return Err("values numbered in order from %0");
        }
        let op = self.read_op(op)?;
        self.instructions.push(Instruction {
            op,
            ty: read_type(ty)?,
            name,
            origin,
        });
        Ok(())
    }

    fn read_table_id(&self, name: &str) -> Expected<TableId> {
        let names = self.tables.iter().map(|data| &data.name);
        Ok(TableId(index(position(names, name)?)?))
    }

    fn read_op(&self, text: &str) -> Expected<Op> {
        let (mnemonic, rest) = text.split_once(' ').unwrap_or((text, ""));
        let items: Vec<&str> = rest.split(", ").filter(|item| !item.is_empty()).collect();
        let values = |items: &[&str]| {
            items
                .iter()
                .map(|item| read_value(item))
                .collect::<Expected<Vec<ValueId>>>()
        };
        if mnemonic == "const" {
            let data = rest
                .trim_matches(['[', ']'])
                .split(", ")
                .filter(|item| !item.is_empty());
            return Ok(Op::Const(data.map(number).collect::<Expected<_>>()?));
        }
        Ok(match (mnemonic, items.as_slice()) {
            ("input", [name]) => {
                Op::Input(position(self.inputs.iter().map(|input| &input.name), name)?)
            }
            ("array", items) => Op::Array(values(items)?),
            ("polynomial", [name, arguments @ ..]) => {
                let id = position(self.polynomials.iter().map(|data| &data.name), name)?;
                Op::Polynomial(PolynomialId(index(id)?), values(arguments)?)
            }
            ("table", [head, arguments @ ..]) => {
                let mut words = head.split(' ');
                let id = self.read_table_id(words.next().ok_or("a table")?)?;
                let orders = words.map(number).collect::<Expected<_>>()?;
                Op::Table(id, orders, values(arguments)?)
            }
            ("tables", [name, arguments @ ..]) => {
                let names = self.table_families.iter().map(|family| &family.name);
                let id = TableFamilyId(index(position(names, name)?)?);
                Op::TableFamily(id, values(arguments)?)
            }
            ("family", [name, z]) => {
                let id = position(self.families.iter().map(|family| &family.name), name)?;
                Op::Family(FamilyId(index(id)?), read_value(z)?)
            }
            ("basis" | "basis_rate" | "basis_rate2", [name, operands @ ..]) => {
                let id = BasisId(index(position(
                    self.bases.iter().map(|basis| &basis.name),
                    name,
                )?)?);
                match *values(operands)?.as_slice() {
                    [a] if mnemonic == "basis" => Op::Basis(id, a),
                    [a, b] if mnemonic == "basis_rate" => Op::BasisRate(id, a, b),
                    [a, b, c] if mnemonic == "basis_rate2" => Op::BasisRate2(id, a, b, c),
                    _ => return Err("the operands of a basis"),
                }
            }
            ("powi", [a, n]) => Op::PowInt(read_value(a)?, number(n)?),
            ("element", [a, row, column]) => {
                Op::Element(read_value(a)?, number(row)?, number(column)?)
            }
            (mnemonic, items) => {
                plain(mnemonic, &values(items)?).ok_or("an operation with its operands")?
            }
        })
    }
}

/// Operations whose text is a word and values.
fn plain(mnemonic: &str, operands: &[ValueId]) -> Option<Op> {
    Some(match (mnemonic, operands) {
        ("not", &[a]) => Op::Not(a),
        ("transpose", &[a]) => Op::Transpose(a),
        ("sum_squares", &[a]) => Op::SumSquares(a),
        ("singular_vector", &[a]) => Op::SingularVector(a),
        ("and", &[a, b]) => Op::And(a, b),
        ("or", &[a, b]) => Op::Or(a, b),
        ("matmul", &[a, b]) => Op::MatMul(a, b),
        ("dot", &[a, b]) => Op::Dot(a, b),
        ("outer", &[a, b]) => Op::Outer(a, b),
        ("solve", &[a, b]) => Op::Solve(a, b),
        ("ldlt", &[a]) => Op::Ldlt(a),
        ("mul_add", &[a, b, c]) => Op::MulAdd(a, b, c),
        ("select", &[a, b, c]) => Op::Select(a, b, c),
        (word, &[a]) => {
            let function = item(&FUNCTIONS, word).map(|function| Op::Apply(function, a));
            function.or_else(|| item(&KERNELS, word).map(|kernel| Op::Kernel(kernel, a)))?
        }
        (word, &[a, b]) => {
            let operator = item(&OPERATORS, word).map(|operator| Op::Binary(operator, a, b));
            operator.or_else(|| {
                item(&COMPARISONS, word).map(|comparison| Op::Compare(comparison, a, b))
            })?
        }
        _ => return None,
    })
}

fn number<T: FromStr>(text: &str) -> Expected<T> {
    text.trim().parse().map_err(|_| "a number")
}

fn index(position: usize) -> Expected<u32> {
    u32::try_from(position).map_err(|_| "a smaller number")
}

fn read_value(text: &str) -> Expected<ValueId> {
    let digits = text.strip_prefix('%').ok_or("a value `%n`")?;
    number(digits).map(ValueId)
}

fn read_type(text: &str) -> Expected<Type> {
    const EXPECTED: &str = "a type: bool, real, vecN, matRxC or ldltN";
    if let Some(size) = text.strip_prefix("mat") {
        let (rows, columns) = size.split_once('x').ok_or(EXPECTED)?;
        return Ok(Type::Real(Shape::Matrix(extent(rows)?, extent(columns)?)));
    }
    if let Some(size) = text.strip_prefix("ldlt") {
        return Ok(Type::Ldlt(extent(size)?));
    }
    match (text, text.strip_prefix("vec")) {
        ("bool", _) => Ok(Type::Bool),
        ("real", _) => Ok(Type::Real(Shape::Scalar)),
        (_, Some(size)) => Ok(Type::Real(Shape::Vector(extent(size)?))),
        _ => Err(EXPECTED),
    }
}

/// Rows, columns or entries: so few that the product of two of them is a number.
fn extent(digits: &str) -> Expected<usize> {
    let extent: Expected<u16> = number(digits);
    extent
        .map(usize::from)
        .map_err(|_| "a size of at most 65535")
}

/// Position of a name, or the number after `#`.
fn position<'a>(mut names: impl Iterator<Item = &'a String>, name: &str) -> Expected<usize> {
    match name.strip_prefix('#') {
        Some(digits) => number(digits),
        None => names
            .position(|entry| entry == name)
            .ok_or("a declared name"),
    }
}

/// `cubic clamp`
fn read_kind(text: &str) -> Expected<(Degree, Extrapolation)> {
    Ok(match text {
        "linear clamp" => (Degree::Linear, Extrapolation::Clamp),
        "linear error" => (Degree::Linear, Extrapolation::Error),
        "cubic clamp" => (Degree::Cubic, Extrapolation::Clamp),
        "cubic error" => (Degree::Cubic, Extrapolation::Error),
        _ => return Err("`linear` or `cubic`, and `clamp` or `error`"),
    })
}

/// What stands before the brackets, and the numbers in them.
type TableItem<'a, N> = (&'a str, Vec<N>);

/// `name(a, b) = head [n, n], head [n, n]`
fn read_table<N: FromStr>(text: &str) -> Expected<(String, Vec<String>, Vec<TableItem<'_, N>>)> {
    let (signature, items) = text.split_once(" =").ok_or("`name(arguments) = terms`")?;
    let (name, arguments) = signature
        .strip_suffix(')')
        .and_then(|head| head.split_once('('))
        .ok_or("`name(arguments)`")?;
    let read_item = |item: &'_ str| -> Expected<(usize, Vec<N>)> {
        let open = item.find('[').ok_or("numbers in brackets")?;
        let numbers = item[open + 1..]
            .split(", ")
            .filter(|e| !e.is_empty())
            .map(number)
            .collect::<Expected<_>>()?;
        Ok((open, numbers))
    };
    let items = items.split_terminator(']').map(|item| {
        let item = item.trim_start_matches([',', ' ']);
        read_item(item).map(|(open, numbers)| (item[..open].trim(), numbers))
    });
    let arguments = arguments
        .split(", ")
        .filter(|argument| !argument.is_empty())
        .map(str::to_owned)
        .collect();
    Ok((name.to_owned(), arguments, items.collect::<Expected<_>>()?))
}

/// Text in quotes, and what follows.
fn read_quoted(text: &str) -> Expected<(String, &str)> {
    let body = text.strip_prefix('"').ok_or("a text in quotes")?;
    let mut content = String::new();
    let mut characters = body.char_indices();
    while let Some((at, character)) = characters.next() {
        match character {
            '"' => return Ok((content, &body[at + 1..])),
            '\\' => match characters.next().ok_or("a closing quote")?.1 {
                'n' => content.push('\n'),
                escaped => content.push(escaped),
            },
            other => content.push(other),
        }
    }
    Err("a closing quote")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::random;

    #[test]
    fn printed_programs_read_back_equal() {
        for seed in 0..100 {
            let program = random::program(seed, 150);
            let text = program.to_string();
            let read: Program = text.parse().expect("a readable program");
            assert_eq!(read, program);
            assert_eq!(read.to_string(), text);
        }
    }

    #[test]
    fn negative_zero_is_read_back() {
        let mut program = Program::default();
        program.scalar(-0.0);
        let read: Program = program.to_string().parse().expect("a readable program");
        assert!(matches!(&read.instructions[0].op, Op::Const(data) if data[0].is_sign_negative()));
    }

    #[test]
    fn errors_name_the_line() {
        let check = |text: &str, line: usize, expected: &str| {
            let error = text.parse::<Program>().expect_err(text);
            assert_eq!(
                error.to_string(),
                format!("line {line}: expected {expected}")
            );
        };
        check("program p\nprogam q", 2, "a statement");
        check(
            "%1: real = const 1.0",
            1,
            "values numbered in order from %0",
        );
        check(
            "%0: rael = const 1.0",
            1,
            "a type: bool, real, vecN, matRxC or ldltN",
        );
        check(
            "input x: mat4x80000000000000000000",
            1,
            "a size of at most 65535",
        );
        check("%0: real = input x", 1, "a declared name");
        check("%0: real = neg %1, %2", 1, "an operation with its operands");
        check("origin \"a\" \"b", 1, "a closing quote");
    }
}
