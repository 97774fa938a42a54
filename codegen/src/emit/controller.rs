//! `controller.rs`: states, initialisation, the law, and the sampled controller around it that is total and reports a status.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::comment::{Comments, code, docs, prose};
use crate::emit::function::{Function, Record, Results, Updates};
use crate::emit::interface::Interface;
use crate::emit::literal::{float, row};
use crate::emit::names::{Fields, ident};
use crate::emit::pieces::{Split, call_with};
use crate::emit::polynomial::Library;
use crate::emit::record::constructor;
use crate::emit::state::{State, all, state_fields};
use crate::emit::types::{index, type_of, type_of_shape};
use crate::ir::{Program, Shape, Type, ValueId};

/// The controller's programs and names.
pub(crate) struct Controller<'a> {
    /// Names and values of the model.
    pub(crate) interface: &'a Interface,
    /// Initial states.
    pub(crate) initial: &'a Program,
    /// One sample of the law.
    pub(crate) control: &'a Program,
    /// Fields of `Params`.
    pub(crate) params: &'a Fields,
    /// Names of the polynomial functions.
    pub(crate) tables: &'a Library,
}

/// The law's next states replace its states.
pub(crate) const NEXT: Updates<'_> = Updates {
    prefix: "next",
    argument: "state",
};

/// The outputs of the law that `Output` passes on: all but the next states and the flag of the constraint.
pub(crate) fn reported(control: &Program) -> impl Iterator<Item = &(String, ValueId)> {
    control
        .outputs
        .iter()
        .filter(|(name, _)| !name.starts_with("next.") && name != "violated")
}

impl Controller<'_> {
    /// The items of the file.
    pub(crate) fn items(&self, comments: &mut Comments) -> Vec<TokenStream> {
        let states = state_fields(self.initial);
        let records = [
            Record {
                prefix: "params",
                ty: "Params",
                fields: self.params,
            },
            Record {
                prefix: "state",
                ty: "State",
                fields: &states,
            },
        ];
        let initial_docs = ["The controller's states at its first sample.".to_owned()];
        let control_docs = self.law_docs();
        let initial = Function {
            program: self.initial,
            docs: &initial_docs,
            records: &records,
            results: Results::Existing("State", &states),
            tables: self.tables,
            updates: None,
        };
        let control = Function {
            program: self.control,
            docs: &control_docs,
            records: &records,
            results: Results::Own,
            tables: self.tables,
            updates: Some(NEXT),
        };
        let mut items = self.constants();
        items.extend(
            State {
                blocks: &self.interface.blocks,
                initial: self.initial,
                control: self.control,
                fields: &states,
            }
            .items(),
        );
        let law = Split::law(&control);
        items.push(self.output(&control));
        items.push(self.controller_struct(&law));
        items.push(self.controller_impl(&control, &law));
        items.push(self.begin());
        items.push(self.restore());
        items.extend(initial.items(comments));
        items.extend(law.items(comments));
        items
    }

    /// What the law does, and the gains that are numbers in its formulas.
    fn law_docs(&self) -> Vec<String> {
        let about = "One sample of the control law: control and the signals on the way; the states become those of the next sample.";
        let blocks = (1..).zip(&self.interface.blocks);
        let gains = blocks.flat_map(|(i, block): (usize, _)| {
            let name = code(&block.name);
            let gains: Vec<String> = block.gains.iter().map(|gain| code(gain)).collect();
            let gains = gains.join(", ");
            let line =
                format!("Gains of block {i}, {name}, which are numbers in the formulas: {gains}.");
            [String::new(), line]
        });
        std::iter::once(about.to_owned()).chain(gains).collect()
    }

    fn constants(&self) -> Vec<TokenStream> {
        let (sample_time, width) = (
            float(self.interface.sample_time),
            index(self.interface.inputs.len()),
        );
        let safe: Vec<f64> = self
            .interface
            .inputs
            .iter()
            .map(|input| input.safe)
            .collect();
        let limits: Vec<f64> = self
            .interface
            .inputs
            .iter()
            .map(|input| input.limit)
            .collect();
        let (safe, limits) = (row(&safe), row(&limits));
        let time_docs = docs(&["Time between samples, s."]);
        let names = self
            .interface
            .inputs
            .iter()
            .map(|input| format!("{} in {}", code(&input.name), prose(&input.unit)));
        let names = names.collect::<Vec<_>>().join(", ");
        let limit_docs = docs(&[format!("Largest magnitude of each control: {names}.")]);
        let safe_docs = docs(&["Control while a measurement is not finite."]);
        vec![
            quote!(#limit_docs pub const INPUT_LIMIT: [f64; #width] = #limits;),
            quote!(#time_docs pub const SAMPLE_TIME: f64 = #sample_time;),
            quote!(#safe_docs pub const SAFE_INPUT: [f64; #width] = #safe;),
        ]
    }

    fn output(&self, control: &Function<'_>) -> TokenStream {
        let own = control.output_fields();
        let mut fields = Vec::new();
        for (name, id) in reported(self.control) {
            let (field, ty) = (own.get(name), type_of(self.control.ty(*id)));
            let line = match name.as_str() {
                "u" => "Control that the law asks for, before its limits.".to_owned(),
                "u_sat" => "Control to apply: within its limits, always finite.".to_owned(),
                _ => control.output_doc(name, *id),
            };
            let docs = docs(&[line]);
            fields.push(quote!(#docs pub #field: #ty));
        }
        let (docs_struct, docs_status) = (
            docs(&[
                "What a sample of the controller gives.",
                "",
                "With `Status::NON_FINITE_INPUT`, only the control is meaningful.",
            ]),
            docs(&["What happened, in any lane."]),
        );
        let docs_valid =
            docs(&["Whether the law was finite, so that its control and next states are used."]);
        let zeros = reported(self.control).map(|(name, id)| {
            let field = own.get(name);
            match self.control.ty(*id) {
                Type::Bool => quote!(#field: T::Mask::splat(false)),
                Type::Real(shape) => {
                    let constructor = constructor(shape);
                    quote!(#field: #constructor::zero())
                }
                Type::Ldlt(_) => panic!("invariant: factors are no output"),
            }
        });
        let zero_docs = docs(&["Before the first sample: all zero."]);
        quote! {
            #docs_struct
            #[derive(Clone, Copy, Debug)]
            pub struct Output<T: Real> {
                #docs_status
                pub status: Status,
                #docs_valid
                pub valid: T::Mask,
                #(#fields),*
            }

            impl<T: Real> Output<T> {
                #zero_docs
                #[inline(always)]
                pub fn zero() -> Self {
                    Self { status: Status::OK, valid: T::Mask::splat(false), #(#zeros),* }
                }
            }
        }
    }

    fn controller_struct(&self, law: &Split<'_>) -> TokenStream {
        let docs = docs(&[
            prose(&self.interface.title),
            String::new(),
            "The sampled controller: [`Controller::step`] is total, allocates nothing and cannot panic.".to_owned(),
        ]);
        let prepared = law.prepare().map(|_| quote!(prepared: Prepared<T>,));
        quote! {
            #docs
            #[derive(Clone, Debug)]
            pub struct Controller<T: Real> {
                params: Params<T>,
                #prepared
                state: State<T>,
                started: T::Mask,
            }
        }
    }

    /// `t` and the state of each block: names, and parameters of methods.
    fn measurements(&self) -> (Vec<Ident>, Vec<TokenStream>) {
        let mut names = vec![format_ident!("t")];
        let mut parameters = vec![quote!(t: T)];
        for (number, block) in (1..).zip(&self.interface.blocks) {
            let name = format_ident!("x{}", number as usize);
            let ty = type_of_shape(Shape::Vector(block.states.len()));
            parameters.push(quote!(#name: #ty));
            names.push(name);
        }
        (names, parameters)
    }

    fn controller_impl(&self, control: &Function<'_>, law: &Split<'_>) -> TokenStream {
        let (names, parameters) = self.measurements();
        let prepared = law.prepare().map(|prepare| {
            let call = call_with(prepare, |_| quote!(&params));
            quote!(prepared: #call,)
        });
        let new_docs = docs(&["A controller that starts at its first step."]);
        let reset_docs = docs(&[
            "Starts anew from these measurements; from the next ones if they are not finite.",
        ]);
        let measured = all(names.iter().map(|name| quote!(#name.is_finite())));
        let (state_docs, params_docs) = (docs(&["The states."]), docs(&["The parameters."]));
        let step = self.step(control, law);
        quote! {
            impl<T: Real> Controller<T> {
                #new_docs
                #[inline(always)]
                pub fn new(params: Params<T>) -> Self {
                    Self { #prepared params, state: State::zero(), started: T::Mask::splat(false) }
                }

                #reset_docs
                #[inline(always)]
                pub fn reset(&mut self, #(#parameters),*) {
                    self.state = State::zero();
                    self.started = T::Mask::splat(false);
                    let mask = #measured;
                    T::outlined(Begin { controller: self, mask, #(#names),* });
                }

                #step

                #state_docs
                #[inline(always)]
                pub fn state(&self) -> &State<T> { &self.state }

                #params_docs
                #[inline(always)]
                pub fn params(&self) -> &Params<T> { &self.params }
            }
        }
    }

    /// The states at the first sample, in a function of its own because it runs once.
    fn begin(&self) -> TokenStream {
        let (_, parameters) = self.measurements();
        let (t, x) = parameters
            .split_first()
            .expect("invariant: time and states");
        let initial = call_with(self.initial, |argument| match argument {
            "params" => quote!(&self.controller.params),
            _ => {
                let name = ident(argument);
                quote!(self.#name)
            }
        });
        let docs = docs(&["Initialises the states where the mask is true and they are finite."]);
        quote! {
            #docs
            struct Begin<'a, T: Real> {
                controller: &'a mut Controller<T>,
                mask: T::Mask,
                #t,
                #(#x),*
            }

            impl<T: Real> Part for Begin<'_, T> {
                type Output = ();

                #[inline(always)]
                fn run(self) {
                    let start = #initial;
                    let mask = self.mask.and(start.is_finite());
                    self.controller.state = State::select(mask, &start, &self.controller.state);
                    self.controller.started = self.controller.started.or(mask);
                }
            }
        }
    }

    /// What a step does about lanes whose law was not finite, in a function of its own because that is rare.
    fn restore(&self) -> TokenStream {
        let (names, _) = self.measurements();
        let origin = names.iter().map(|name| match name.to_string().as_str() {
            "t" => quote!(#name: T::zero()),
            _ => quote!(#name: Vector::zero()),
        });
        let docs = docs(&[
            "Gives the states back where the law was not finite: those before it, or if they made it overflow those of a start at the origin, \
             until the next sample.",
        ]);
        quote! {
            #docs
            struct Restore<'a, T: Real> {
                controller: &'a mut Controller<T>,
                valid: T::Mask,
                measured: T::Mask,
                before: Option<State<T>>,
            }

            impl<T: Real> Part for Restore<'_, T> {
                type Output = ();

                #[inline(always)]
                fn run(self) {
                    let zero = State::zero();
                    let controller = self.controller;
                    let kept = match &self.before {
                        Some(before) => State::select(self.measured, &zero, before),
                        None => zero,
                    };
                    controller.state = State::select(self.valid, &controller.state, &kept);
                    let mask = self.measured.and(self.valid.not());
                    T::outlined(Begin { controller: &mut *controller, mask, #(#origin),* });
                    controller.started = controller.started.and(mask.not());
                }
            }
        }
    }

    /// The step, and with a clock of its own the step with one that is given.
    fn step(&self, control: &Function<'_>, law: &Split<'_>) -> TokenStream {
        let (names, parameters) = self.measurements();
        let (t, x) = (&parameters[0], &parameters[1..]);
        let (sample_docs, body) = (docs(&STEP_DOCS), self.sample(control, law));
        let Some(clock) = law.clock() else {
            return quote! {
                #sample_docs
                #[inline(always)]
                pub fn step(&mut self, #t, #(#x),*) -> Output<T> { #body }
            };
        };
        let (clock, measured) = (call_with(clock, argument), &names[1..]);
        let at_docs = docs(&[
            "As [`Controller::step`], with the values of [`clock`] at this time, which can serve many runs.",
        ]);
        quote! {
            #sample_docs
            #[inline(always)]
            pub fn step(&mut self, #t, #(#x),*) -> Output<T> {
                let clock = #clock;
                self.step_at(t, &clock, #(#measured),*)
            }

            #at_docs
            #[inline(always)]
            pub fn step_at(&mut self, #t, clock: &Clock<T>, #(#x),*) -> Output<T> { #body }
        }
    }

    /// The body of a step.
    fn sample(&self, control: &Function<'_>, law: &Split<'_>) -> TokenStream {
        let (names, _) = self.measurements();
        let own = control.output_fields();
        let law = call_with(law.rest(), argument);
        let finite = all(names.iter().map(|name| quote!(#name.is_finite())));
        let has = |name: &str| {
            self.control
                .outputs
                .iter()
                .any(|(output, _)| output == name)
        };
        let violated = has("violated").then(|| {
            let violated = own.get("violated");
            quote!(| Status::CONSTRAINT_VIOLATED.when(valid.and(law.#violated).any()))
        });
        let channels = (0..self.interface.inputs.len()).map(index);
        let saturated = any(channels.map(|channel| quote!(u[#channel].ne(u_sat[#channel]))));
        let telemetry = reported(self.control).map(|(name, _)| {
            let field = own.get(name);
            if name == "u" || name == "u_sat" {
                quote!(#field)
            } else {
                quote!(#field: law.#field)
            }
        });
        quote! {
            let measured = #finite;
            let starting = measured.and(self.started.not());
            if starting.any() {
                T::outlined(Begin { controller: self, mask: starting, #(#names),* });
            }
            let before = if measured.all() { None } else { Some(self.state) };
            let law = #law;
            let valid = measured.and(self.started).and(law.u.is_finite()).and(law.u_sat.is_finite()).and(self.state.is_finite());
            if !valid.all() {
                T::outlined(Restore { controller: self, valid, measured, before });
            }
            let u = Vector::select(valid, law.u, Vector::from_f64(SAFE_INPUT));
            let u_sat = Vector::select(valid, law.u_sat, Vector::from_f64(SAFE_INPUT));
            let saturated = #saturated;
            let status = Status::NON_FINITE_INPUT.when(valid.not().any())
                #violated
                | Status::SATURATED.when(saturated.any());
            Output { status, valid, #(#telemetry),* }
        }
    }
}

/// An argument of the law or its clock inside a method that has the measurements as variables.
fn argument(name: &str) -> TokenStream {
    match name {
        "params" => quote!(&self.params),
        "prepared" => quote!(&self.prepared),
        "state" => quote!(&mut self.state),
        other => {
            let name = ident(other);
            quote!(#name)
        }
    }
}

/// Rustdoc of `step`.
const STEP_DOCS: [&str; 5] = [
    "One sample: the control for the time since start (s) and the measured states (SI), after which the states are those of the next sample.",
    "",
    "Where a measurement, a next state or the control is not finite, the control is [`SAFE_INPUT`] and the status has \
     `NON_FINITE_INPUT`. `SATURATED` means that a control is at its limit, `CONSTRAINT_VIOLATED` that an error has reached its bound \
     and the barrier was clamped.",
    "",
    "The first step with finite measurements initialises the states. A measurement that is not finite leaves them as they were; a law \
     that overflows although its measurements are finite gives them up, and the next step with finite measurements starts anew.",
];

fn any(masks: impl Iterator<Item = TokenStream>) -> TokenStream {
    masks
        .reduce(|any, mask| quote!(#any.or(#mask)))
        .unwrap_or_else(|| quote!(T::Mask::splat(false)))
}
