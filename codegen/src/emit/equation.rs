//! The plant as an Ito equation for the integrators: `impl Sde`, and the parts that its methods call.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::emit::comment::docs;
use crate::emit::names::ident;
use crate::emit::pieces::{Split, call_with};
use crate::emit::plant::{Plant, noise_channels};
use crate::emit::source::mentions;
use crate::emit::types::index;
use crate::ir::{Op, Program, ValueId};
use crate::opt::dependence::{Dependence, dependences};

impl Plant<'_> {
    /// The equation by `dynamics`, and by `alone` where the diffusion is all that is asked for.
    pub(super) fn equation(&self, dynamics: &Split<'_>, alone: &Program) -> TokenStream {
        let (held, rate) = (self.held(), rate(dynamics, dynamics.rest()));
        let wiener = noise_channels(self.plant) > 0 && !held;
        let vector = quote!(Vector<T, STATES>);
        let (drift_docs, drift) = if held {
            (
                "Drift, with the noise that is held between samples.",
                quote!(#rate rate.drift + diffuse(&rate.diffusion, &self.plant.xi)),
            )
        } else {
            ("Drift.", quote!(#rate rate.drift))
        };
        let instant = Instant::of(dynamics);
        let Handed { field, at, given } = instant.handed(dynamics.rest());
        let instant = instant.ty();
        let drift = part("Drift", drift_docs, &vector, &drift, [field.as_ref(), None]);
        let (columns, noise) = if wiener {
            (quote!(NOISE_CHANNELS), self.noise(dynamics, alone))
        } else {
            let none = Literal::usize_unsuffixed(0);
            (quote!(#none), without_noise(&none))
        };
        let Noise {
            dependent,
            methods,
            parts,
        } = noise;
        quote! {
            impl<T: Real> Sde<T, STATES, #columns> for Plant<T> {
                type Instant = #instant;

                #dependent

                #[inline(always)]
                fn drift(&self, #at: &Self::Instant, x: &#vector) -> #vector {
                    T::outlined(Drift { plant: self, #given x })
                }

                #methods
            }

            #drift
            #(#parts)*
        }
    }

    /// The noise of the equation, of Wiener processes.
    fn noise(&self, dynamics: &Split<'_>, alone: &Program) -> Noise {
        let (vector, matrix) = (
            quote!(Vector<T, STATES>),
            quote!(Matrix<T, STATES, NOISE_CHANNELS>),
        );
        let (rate, alone_rate) = (rate(dynamics, dynamics.rest()), rate(dynamics, alone));
        let instant = Instant::of(dynamics);
        let (time, alone_time) = (instant.handed(dynamics.rest()), instant.handed(alone));
        let mut parts = vec![
            part(
                "Diffusion",
                "Diffusion.",
                &matrix,
                &quote!(#alone_rate rate.diffusion),
                [alone_time.field.as_ref(), None],
            ),
            part(
                "Rates",
                "Drift, and diffusion times noise.",
                &quote!((#vector, #vector)),
                &quote!(#rate (rate.drift, diffuse(&rate.diffusion, self.dw))),
                [
                    time.field.as_ref(),
                    Some(&quote!(dw: &'a Vector<T, NOISE_CHANNELS>)),
                ],
            ),
        ];
        let dependent = state_dependent(self.plant);
        let one_column = dependent.contains(&true).then(|| {
            let (method, column) = diffusion_column(&dependent, &alone_rate, &alone_time);
            parts.push(column);
            method
        });
        let dependent = dependent
            .contains(&false)
            .then(|| quote!(const STATE_DEPENDENT: [bool; NOISE_CHANNELS] = [#(#dependent),*];));
        let (Handed { at, given, .. }, alone_at, alone_given) =
            (time, alone_time.at, alone_time.given);
        let methods = quote! {
            #[inline(always)]
            fn diffusion(&self, #alone_at: &Self::Instant, x: &#vector) -> #matrix {
                T::outlined(Diffusion { plant: self, #alone_given x })
            }

            #one_column

            #[inline(always)]
            fn drift_and_noise(&self, #at: &Self::Instant, x: &#vector, dw: &Vector<T, NOISE_CHANNELS>) -> (#vector, #vector) {
                T::outlined(Rates { plant: self, #given x, dw })
            }
        };
        Noise {
            dependent,
            methods,
            parts,
        }
    }
}

/// How noise is part of the plant's equation.
struct Noise {
    /// Which columns of the diffusion depend on states, if not all do.
    dependent: Option<TokenStream>,
    /// Methods of the equation.
    methods: TokenStream,
    /// The parts that they call.
    parts: Vec<TokenStream>,
}

/// An equation without Wiener processes.
fn without_noise(columns: &Literal) -> Noise {
    Noise {
        dependent: None,
        methods: quote! {
            #[inline(always)]
            fn diffusion(&self, _at: &Self::Instant, _x: &Vector<T, STATES>) -> Matrix<T, STATES, #columns> { Matrix::zero() }
        },
        parts: Vec::new(),
    }
}

/// The method for one column of the diffusion, and the part for each column that depends on states: what others need is left out of it.
fn diffusion_column(
    dependent: &[bool],
    rate: &TokenStream,
    Handed { field, at, given }: &Handed,
) -> (TokenStream, TokenStream) {
    let columns = (0..).zip(dependent).filter(|(_, dependent)| **dependent);
    let columns: Vec<Literal> = columns.map(|(column, _)| index(column)).collect();
    let method = quote! {
        #[inline(always)]
        fn diffusion_column(&self, #at: &Self::Instant, x: &Vector<T, STATES>, j: usize) -> Vector<T, STATES> {
            match j {
                #(#columns => T::outlined(DiffusionColumn::<T, #columns> { plant: self, #given x }),)*
                _ => self.diffusion(#at, x).column(j),
            }
        }
    };
    let (docs, unused) = (docs(&["Column `J` of the diffusion."]), unused_plant(rate));
    let part = quote! {
        #docs
        #unused
        struct DiffusionColumn<'a, T, const J: usize> {
            plant: &'a Plant<T>,
            #field
            x: &'a Vector<T, STATES>,
        }

        impl<T: Real, const J: usize> Part for DiffusionColumn<'_, T, J> {
            type Output = Vector<T, STATES>;

            #[inline(always)]
            fn run(self) -> Vector<T, STATES> { #rate rate.diffusion.column(J) }
        }
    };
    (method, part)
}

/// Whether each column of the diffusion depends on states.
fn state_dependent(plant: &Program) -> Vec<bool> {
    let (_, id) = plant
        .outputs
        .iter()
        .find(|(name, _)| name == "diffusion")
        .expect("invariant: there is noise");
    let dependences = dependences(plant);
    let depends = |id: ValueId| dependences[id.0 as usize] == Dependence::States;
    let columns = noise_channels(plant);
    match &plant.instruction(*id).op {
        Op::Array(entries) => (0..columns)
            .map(|column| {
                entries
                    .iter()
                    .skip(column)
                    .step_by(columns)
                    .any(|&id| depends(id))
            })
            .collect(),
        _ => vec![depends(*id); columns],
    }
}

/// A part of the plant's equation as a function of its own: an integrator asks for it several times in a step.
fn part(
    name: &str,
    about: &str,
    output: &TokenStream,
    body: &TokenStream,
    arguments: [Option<&TokenStream>; 2],
) -> TokenStream {
    let (name, docs) = (ident(name), docs(&[about]));
    let [instant, noise] = arguments;
    let unused = unused_plant(body);
    quote! {
        #docs
        #unused
        struct #name<'a, T> {
            plant: &'a Plant<T>,
            #instant
            x: &'a Vector<T, STATES>,
            #noise
        }

        impl<T: Real> Part for #name<'_, T> {
            type Output = #output;

            #[inline(always)]
            fn run(self) -> #output { #body }
        }
    }
}

/// The allowance for the plant in a part whose body does not mention it.
fn unused_plant(body: &TokenStream) -> Option<TokenStream> {
    (!mentions(body, "plant"))
        .then(|| quote!(#[allow(dead_code, reason = "a diffusion may need states alone")]))
}

/// What the plant's equation takes of a time.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Instant {
    /// Nothing.
    Nothing,
    /// The time itself.
    Time,
    /// Values that depend on time alone.
    Clock,
}

impl Instant {
    /// Of the equation of a plant.
    pub(super) fn of(dynamics: &Split<'_>) -> Instant {
        let rest = dynamics.rest();
        let clock = reads_clock(rest);
        if clock && dynamics.shares_clock() && !reads_time(rest) {
            Instant::Clock
        } else if clock || reads_time(rest) {
            Instant::Time
        } else {
            Instant::Nothing
        }
    }

    fn ty(self) -> TokenStream {
        match self {
            Instant::Nothing => quote!(()),
            Instant::Time => quote!(f64),
            Instant::Clock => quote!(Clock<T>),
        }
    }

    /// How it reaches the part of the equation that calls a program.
    fn handed(self, program: &Program) -> Handed {
        let (field, given) = match self {
            Instant::Clock if reads_clock(program) => {
                (quote!(clock: &'a Clock<T>,), quote!(clock: at,))
            }
            Instant::Time if reads_clock(program) || reads_time(program) => {
                (quote!(t: f64,), quote!(t: *at,))
            }
            _ => {
                return Handed {
                    field: None,
                    at: quote!(_at),
                    given: quote!(),
                };
            }
        };
        Handed {
            field: Some(field),
            at: quote!(at),
            given,
        }
    }
}

/// An instant in a part that calls a program: neither field nor argument if the program does not need it.
struct Handed {
    /// The field.
    field: Option<TokenStream>,
    /// The parameter that gives it.
    at: TokenStream,
    /// The argument.
    given: TokenStream,
}

fn reads_time(program: &Program) -> bool {
    program.inputs.iter().any(|input| input.name == "t")
}

/// Whether a program needs values of `clock`.
fn reads_clock(program: &Program) -> bool {
    let mut names = program.inputs.iter().map(|input| &input.name);
    names.any(|name| name.starts_with("clock."))
}

/// `let rate = ..;` of a part of the plant's equation, by a piece, after the clock where the instant does not bring it.
fn rate(dynamics: &Split<'_>, piece: &Program) -> TokenStream {
    let instant = Instant::of(dynamics);
    let argument = |name: &str| argument(name, instant);
    let clock = dynamics
        .clock()
        .filter(|_| instant == Instant::Time && reads_clock(piece));
    let clock = clock.map(|clock| {
        let call = call_with(clock, argument);
        quote!(let clock = #call;)
    });
    let call = call_with(piece, argument);
    quote!(#clock let rate = #call;)
}

/// An argument of the plant's functions inside a part of its equation.
fn argument(name: &str, instant: Instant) -> TokenStream {
    match name {
        "t" => quote!(T::from_f64(self.t)),
        "params" => quote!(&self.plant.params),
        "prepared" => quote!(&self.plant.prepared),
        "clock" if instant == Instant::Clock => quote!(self.clock),
        "clock" => quote!(&clock),
        "u_sat" => quote!(self.plant.u_sat),
        _ => quote!(*self.x),
    }
}
