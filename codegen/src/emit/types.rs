//! Rust types and literals of shapes.

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

use crate::emit::literal;
use crate::ir::{Shape, Type};

/// The Rust type of a value.
pub(crate) fn type_of(ty: Type) -> TokenStream {
    match ty {
        Type::Bool => quote!(T::Mask),
        Type::Real(shape) => type_of_shape(shape),
        Type::Ldlt(rows) => {
            let rows = index(rows);
            quote!(Ldlt<T, #rows>)
        }
    }
}

/// The Rust type of real values of a shape.
pub(crate) fn type_of_shape(shape: Shape) -> TokenStream {
    match shape {
        Shape::Scalar => quote!(T),
        Shape::Vector(n) => {
            let n = index(n);
            quote!(Vector<T, #n>)
        }
        Shape::Matrix(rows, columns) => {
            let (rows, columns) = (index(rows), index(columns));
            quote!(Matrix<T, #rows, #columns>)
        }
    }
}

/// A number of entries or the position of one.
pub(crate) fn index(n: usize) -> Literal {
    Literal::usize_unsuffixed(n)
}

/// A literal wherever it stands.
pub(crate) fn constant(ty: Type, data: &[f64]) -> TokenStream {
    match ty {
        Type::Bool => {
            let truth = data.first().is_some_and(|&value| value != 0.0);
            quote!(T::Mask::splat(#truth))
        }
        Type::Real(Shape::Scalar) if data[0] == core::f64::consts::PI => quote!(T::pi()),
        Type::Real(Shape::Scalar) => {
            let value = literal::float(data[0]);
            quote!(real(#value))
        }
        Type::Real(shape) => {
            let (n, array) = (sizes(shape), literal_array(shape, data));
            let turbofish = match shape {
                Shape::Matrix(..) => quote!(Matrix::<T, #n>),
                _ => quote!(Vector::<T, #n>),
            };
            let call = array.into_iter().skip(1);
            quote!(#turbofish #(#call)*)
        }
        Type::Ldlt(_) => panic!("invariant: factors are no literal"),
    }
}

fn sizes(shape: Shape) -> TokenStream {
    match shape {
        Shape::Scalar => TokenStream::new(),
        Shape::Vector(n) => index(n).to_token_stream(),
        Shape::Matrix(rows, columns) => {
            let (rows, columns) = (index(rows), index(columns));
            quote!(#rows, #columns)
        }
    }
}

/// `Vector::from_f64([..])` or `Matrix::from_f64([..])`, zeros by name; the type follows from the context.
pub(crate) fn literal_array(shape: Shape, data: &[f64]) -> TokenStream {
    let zero = data.iter().all(|value| value.to_bits() == 0);
    match shape {
        Shape::Matrix(..) if zero => quote!(Matrix::zero()),
        Shape::Matrix(_, columns) => {
            let entries = literal::rows(data, columns);
            quote!(Matrix::from_f64(#entries))
        }
        _ if zero => quote!(Vector::zero()),
        _ => {
            let entries = literal::row(data);
            quote!(Vector::from_f64(#entries))
        }
    }
}
