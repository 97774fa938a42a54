//! `lyapunov.rs`: the Lyapunov function and its Ito generator along the plant.

use proc_macro2::TokenStream;

use crate::emit::comment::Comments;
use crate::emit::function::{Function, Record, Results};
use crate::emit::names::Fields;
use crate::emit::polynomial::Library;
use crate::ir::Program;

/// The function of the Lyapunov program; `docs` outlives the call.
pub(crate) fn function<'a>(
    program: &'a Program,
    docs: &'a [String],
    records: &'a [Record<'a>],
    tables: &'a Library,
) -> Function<'a> {
    Function {
        program,
        docs,
        records,
        results: Results::Own,
        tables,
        updates: None,
    }
}

/// The structs of its inputs.
pub(crate) fn records<'a>(params: &'a Fields, states: &'a Fields) -> [Record<'a>; 3] {
    [
        Record {
            prefix: "params",
            ty: "Params",
            fields: params,
        },
        Record {
            prefix: "plant",
            ty: "Params",
            fields: params,
        },
        Record {
            prefix: "state",
            ty: "State",
            fields: states,
        },
    ]
}

/// The items of the file.
pub(crate) fn items(
    program: &Program,
    params: &Fields,
    states: &Fields,
    library: &Library,
    comments: &mut Comments,
) -> Vec<TokenStream> {
    let docs = [
        "The Lyapunov function V and its Ito generator LV (2) along the plant with parameters `plant`, under the controller with".to_owned()
            + " parameters `params`.",
    ];
    let records = records(params, states);
    function(program, &docs, &records, library).items(comments)
}
