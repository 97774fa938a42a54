//! The textual form of a program: one statement per line, the same text for the same program. [`super::read`] reads it back.
//!
//! ```text
//! program control
//! input x1: vec3
//! polynomial cl(alpha, mach) = -0.0819 [0, 0], 0.047 [0, 1]
//! table thrust(mach) = breaks [0.0, 1.0, 2.0], linear clamp [3.0, 2.5, 1.0]
//! tables at_mach(mach) = thrust [0], thrust [1]
//! family at_alpha(alpha) = cd [0.5, -0.0, 1.0], cm [0.25, 1.0]
//! basis basis1(p, q) = [0, 0], [1, 0], [0, 1]
//! origin "error variables" "e_1 = x_1 - y_r  (14)"
//! %0: vec3 = input x1
//! %1: vec3 = const [0.5, 0.0, 0.0]
//! %2 e1: vec3 = sub %0, %1 @0   ; e_1 = x_1 - y_r  (14)
//! output e1 = %2
//! ```

use std::fmt::{self, Display, Formatter};

use nsv_spec::interpolation::{Degree, Extrapolation};

use super::mnemonic::{COMPARISONS, FUNCTIONS, KERNELS, OPERATORS, word};
use super::{
    FamilyMember, Instruction, MonomialBasis, Op, Origin, PolynomialData, PolynomialFamily,
    Program, Shape, TableData, TableId, TableMember, Type, ValueId,
};

impl Display for Program {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "program {}", self.name)?;
        if self.fused {
            writeln!(f, "fused")?;
        }
        for input in &self.inputs {
            writeln!(f, "input {}: {}", input.name, Type::Real(input.shape))?;
        }
        for polynomial in &self.polynomials {
            writeln!(f, "{polynomial}")?;
        }
        for table in &self.tables {
            writeln!(f, "{table}")?;
        }
        for family in &self.table_families {
            let member = |member: &TableMember| {
                format!("{} {:?}", self.table_name(member.table), member.orders)
            };
            let members = list(family.members.iter().map(member));
            let arguments = family.arguments.join(", ");
            writeln!(f, "tables {}({arguments}) = {members}", family.name)?;
        }
        for family in &self.families {
            writeln!(f, "{family}")?;
        }
        for basis in &self.bases {
            writeln!(f, "{basis}")?;
        }
        for Origin { group, equation } in &self.origins {
            writeln!(f, "origin {} {}", quoted(group), quoted(equation))?;
        }
        for (index, instruction) in self.instructions.iter().enumerate() {
            self.write_instruction(f, index, instruction)?;
        }
        for (name, value) in &self.outputs {
            writeln!(f, "output {name} = {value}")?;
        }
        Ok(())
    }
}

impl Program {
    fn write_instruction(
        &self,
        f: &mut Formatter<'_>,
        index: usize,
        instruction: &Instruction,
    ) -> fmt::Result {
        write!(f, "%{index}")?;
        if let Some(name) = &instruction.name {
            write!(f, " {name}")?;
        }
        write!(
            f,
            ": {} = {}",
            instruction.ty,
            self.text_of(&instruction.op)
        )?;
        if let Some(origin) = instruction.origin {
            write!(f, " @{origin}")?;
            if let Some(origin) = self.origins.get(origin) {
                write!(f, "   ; {}", origin.equation.replace('\n', " "))?;
            }
        }
        writeln!(f)
    }

    /// An operation as text, such as `sub %3, %4`.
    fn text_of(&self, op: &Op) -> String {
        let operands = list(op.operands());
        match op {
            Op::Const(data) if data.len() == 1 => format!("const {:?}", data[0]),
            Op::Const(data) => format!("const {data:?}"),
            Op::Input(index) => format!(
                "input {}",
                named(self.inputs.get(*index).map(|input| &input.name), *index)
            ),
            Op::Apply(function, _) => format!("{} {operands}", word(&FUNCTIONS, *function)),
            Op::Kernel(kernel, _) => format!("{} {operands}", word(&KERNELS, *kernel)),
            Op::Binary(operator, _, _) => format!("{} {operands}", word(&OPERATORS, *operator)),
            Op::PowInt(_, n) => format!("powi {operands}, {n}"),
            Op::Compare(comparison, _, _) => {
                format!("{} {operands}", word(&COMPARISONS, *comparison))
            }
            Op::And(..) => format!("and {operands}"),
            Op::Or(..) => format!("or {operands}"),
            Op::Not(_) => format!("not {operands}"),
            Op::MulAdd(..) => format!("mul_add {operands}"),
            Op::Select(..) => format!("select {operands}"),
            Op::Array(_) => format!("array {operands}"),
            Op::Element(_, row, column) => format!("element {operands}, {row}, {column}"),
            Op::MatMul(..) => format!("matmul {operands}"),
            Op::Transpose(_) => format!("transpose {operands}"),
            Op::Dot(..) => format!("dot {operands}"),
            Op::Outer(..) => format!("outer {operands}"),
            Op::SumSquares(_) => format!("sum_squares {operands}"),
            Op::Solve(..) => format!("solve {operands}"),
            Op::Ldlt(..) => format!("ldlt {operands}"),
            Op::SingularVector(_) => format!("singular_vector {operands}"),
            Op::Polynomial(id, _) => {
                let name = named(
                    self.polynomials.get(id.0 as usize).map(|data| &data.name),
                    id.0 as usize,
                );
                if operands.is_empty() {
                    format!("polynomial {name}")
                } else {
                    format!("polynomial {name}, {operands}")
                }
            }
            Op::Table(id, orders, _) => {
                let orders: Vec<String> = orders.iter().map(u32::to_string).collect();
                let name = self.table_name(*id);
                format!("table {name} {}, {operands}", orders.join(" "))
            }
            Op::TableFamily(id, _) => {
                let family = self.table_families.get(id.0 as usize);
                let name = named(family.map(|family| &family.name), id.0 as usize);
                format!("tables {name}, {operands}")
            }
            Op::Family(id, _) => {
                let family = self.families.get(id.0 as usize);
                let name = named(family.map(|family| &family.name), id.0 as usize);
                format!("family {name}, {operands}")
            }
            Op::Basis(id, _) => format!("basis {}, {operands}", self.basis_name(id.0 as usize)),
            Op::BasisRate(id, _, _) => {
                format!("basis_rate {}, {operands}", self.basis_name(id.0 as usize))
            }
            Op::BasisRate2(id, _, _, _) => {
                format!("basis_rate2 {}, {operands}", self.basis_name(id.0 as usize))
            }
        }
    }

    fn table_name(&self, id: TableId) -> String {
        let data = self.tables.get(id.0 as usize);
        named(data.map(|data| &data.name), id.0 as usize)
    }

    fn basis_name(&self, index: usize) -> String {
        named(self.bases.get(index).map(|basis| &basis.name), index)
    }
}

/// The name, or `#index` for what a faulty program does not have.
fn named(name: Option<&String>, index: usize) -> String {
    name.map_or_else(|| format!("#{index}"), Clone::clone)
}

/// Whether a name can stand in the textual form: letters, digits, `_`, `.` and `/`.
pub fn is_word(name: &str) -> bool {
    !name.is_empty()
        && name
            .chars()
            .all(|c| c.is_ascii_alphanumeric() || "_./".contains(c))
}

impl Display for ValueId {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "%{}", self.0)
    }
}

impl Display for Type {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Type::Bool => write!(f, "bool"),
            Type::Real(Shape::Scalar) => write!(f, "real"),
            Type::Real(Shape::Vector(n)) => write!(f, "vec{n}"),
            Type::Real(Shape::Matrix(r, c)) => write!(f, "mat{r}x{c}"),
            Type::Ldlt(n) => write!(f, "ldlt{n}"),
        }
    }
}

impl Display for PolynomialData {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let terms = list(
            self.terms
                .iter()
                .map(|(c, exponents)| format!("{c:?} {exponents:?}")),
        );
        write!(
            f,
            "polynomial {}({}) = {terms}",
            self.name,
            self.arguments.join(", ")
        )
    }
}

impl Display for TableData {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let interpolant = &self.interpolant;
        let axes = interpolant.breaks.iter();
        let axes: String = axes.map(|breaks| format!("breaks {breaks:?}, ")).collect();
        let degree = match interpolant.degree {
            Degree::Linear => "linear",
            Degree::Cubic => "cubic",
        };
        let outside = match interpolant.extrapolation {
            Extrapolation::Clamp => "clamp",
            Extrapolation::Error => "error",
        };
        write!(
            f,
            "table {}({}) = {axes}{degree} {outside} {:?}",
            self.name,
            self.arguments.join(", "),
            interpolant.coefficients
        )
    }
}

impl Display for PolynomialFamily {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let member = |member: &FamilyMember| format!("{} {:?}", member.name, member.coefficients);
        let members = list(self.members.iter().map(member));
        write!(f, "family {}({}) = {members}", self.name, self.argument)
    }
}

impl Display for MonomialBasis {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let monomials = list(
            self.exponents
                .iter()
                .map(|exponents| format!("{exponents:?}")),
        );
        write!(
            f,
            "basis {}({}) = {monomials}",
            self.name,
            self.inputs.join(", ")
        )
    }
}

fn list(items: impl IntoIterator<Item = impl Display>) -> String {
    items
        .into_iter()
        .map(|item| item.to_string())
        .collect::<Vec<_>>()
        .join(", ")
}

/// Text in quotes; a quote, a backslash and a line break are escaped.
fn quoted(text: &str) -> String {
    format!(
        "\"{}\"",
        text.replace('\\', "\\\\")
            .replace('"', "\\\"")
            .replace('\n', "\\n")
    )
}
