//! Actuators and sensors in the simulator: between the controller's command and the plant, and between its state and the controller.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use nsv_spec::model::{Actuator, Effect, Sensor};

use crate::emit::comment::{code, docs};
use crate::emit::dispersion::draw;
use crate::emit::interface::Interface;
use crate::emit::literal::float;
use crate::emit::types::index;

/// The actuators and sensors of a specification.
pub(crate) struct Hardware<'a> {
    interface: &'a Interface,
}

impl<'a> Hardware<'a> {
    pub(crate) fn new(interface: &'a Interface) -> Self {
        Self { interface }
    }

    /// Position among the inputs, and the actuator.
    fn actuators(&self) -> Vec<(usize, &'a Actuator)> {
        let inputs = self.interface.inputs.iter().enumerate();
        inputs
            .filter_map(|(at, input)| Some((at, input.actuator.as_ref()?)))
            .collect()
    }

    /// Position in the state, and the sensor.
    fn sensors(&self) -> Vec<(usize, &'a Sensor)> {
        let states = self.interface.blocks.iter().flat_map(|block| &block.states);
        (states.enumerate())
            .filter_map(|(at, state)| Some((at, state.sensor.as_ref()?)))
            .collect()
    }

    /// Whether some input has an actuator.
    pub(crate) fn acts(&self) -> bool {
        !self.actuators().is_empty()
    }

    /// Whether some state has a sensor.
    pub(crate) fn senses(&self) -> bool {
        !self.sensors().is_empty()
    }

    /// Whether some sensor draws at each sample.
    fn draws(&self) -> bool {
        let random = |sensor: &Sensor| sensor.noise > 0.0 || sensor.dropout > 0.0;
        self.sensors().iter().any(|(_, sensor)| random(sensor))
    }

    /// Plant steps of the delay of an actuator.
    fn delay(&self, actuator: &Actuator) -> usize {
        (actuator.delay / self.step()).round() as usize
    }

    /// Length of a plant step, s.
    fn step(&self) -> f64 {
        self.interface.sample_time / f64::from(self.interface.substeps)
    }

    /// `ACTUATORS` and `SENSORS`.
    pub(crate) fn constants(&self) -> Vec<TokenStream> {
        let named = |names: Vec<&String>| {
            let names: Vec<String> = names.into_iter().map(|name| code(name)).collect();
            names.join(", ")
        };
        let mut constants = Vec::new();
        if self.acts() {
            let names = self
                .actuators()
                .iter()
                .map(|(at, _)| &self.interface.inputs[*at].name)
                .collect();
            let docs = docs(&[format!(
                "Actuators of {}, after their delays.",
                named(names)
            )]);
            let all: Vec<_> = self
                .actuators()
                .iter()
                .map(|(_, actuator)| self.actuator(actuator))
                .collect();
            let count = index(all.len());
            constants.push(quote!(#docs const ACTUATORS: [Actuator; #count] = [#(#all),*];));
        }
        if self.senses() {
            let states: Vec<_> = self
                .interface
                .blocks
                .iter()
                .flat_map(|block| &block.states)
                .collect();
            let names = self
                .sensors()
                .iter()
                .map(|(at, _)| &states[*at].name)
                .collect();
            let docs = docs(&[format!("Sensors of {}.", named(names))]);
            let all = self.sensors().into_iter().map(|(_, sensor)| {
                let (noise, quantum, dropout) = (
                    float(sensor.noise),
                    float(sensor.quantum),
                    float(sensor.dropout),
                );
                quote!(Sensor { noise: #noise, quantum: #quantum, dropout: #dropout })
            });
            let all: Vec<_> = all.collect();
            let count = index(all.len());
            constants.push(quote!(#docs const SENSORS: [Sensor; #count] = [#(#all),*];));
        }
        constants
    }

    fn actuator(&self, actuator: &Actuator) -> TokenStream {
        let approach = match actuator.lag {
            lag if lag > 0.0 => -libm::expm1(-self.step() / lag),
            _ => 1.0,
        };
        let travel = actuator
            .rate_limit
            .map_or(f64::INFINITY, |rate| rate * self.step());
        let (quantum, approach, travel) = (float(actuator.quantum), float(approach), float(travel));
        let faults = actuator.faults.iter().map(|fault| {
            let at = float(fault.at);
            let effect = match fault.effect {
                Effect::Effectiveness(share) => {
                    let share = float(share);
                    quote!(Effect::Effectiveness(#share))
                }
                Effect::Stuck(None) => quote!(Effect::Stuck),
                Effect::Stuck(Some(place)) => {
                    let place = float(place);
                    quote!(Effect::StuckAt(#place))
                }
            };
            quote!(Fault { at: #at, effect: #effect })
        });
        quote!(Actuator { quantum: #quantum, approach: #approach, travel: #travel, faults: &[#(#faults),*] })
    }

    /// Fields of the simulator.
    pub(crate) fn fields(&self) -> TokenStream {
        let mut fields = TokenStream::new();
        if self.acts() {
            let (inputs, count) = (
                index(self.interface.inputs.len()),
                index(self.actuators().len()),
            );
            let delays = self.delays().map(|(field, steps)| {
                let steps = index(steps);
                quote!(#field: Delay<T, #steps>,)
            });
            fields.extend(
                quote!(#(#delays)* position: Vector<T, #count>, u_act: Vector<T, #inputs>,),
            );
        }
        if self.senses() {
            let (states, count) = (index(self.measured()), index(self.sensors().len()));
            fields.extend(quote!(bias: Vector<T, #count>, y: Vector<T, #states>,));
        }
        if self.draws() {
            fields.extend(quote!(errors: Option<Noise<T>>,));
        }
        fields
    }

    /// Number of states that the controller measures.
    fn measured(&self) -> usize {
        self.interface
            .blocks
            .iter()
            .map(|block| block.states.len())
            .sum()
    }

    /// Field and steps of each delay.
    fn delays(&self) -> impl Iterator<Item = (Ident, usize)> {
        let delays = self
            .actuators()
            .into_iter()
            .map(|(at, actuator)| (delay_field(at), self.delay(actuator)));
        delays.filter(|(_, steps)| *steps > 0)
    }

    /// Their values at the start, `x` being the initial state and `options` the run's.
    pub(crate) fn initial(&self) -> TokenStream {
        let mut fields = TokenStream::new();
        if self.acts() {
            let safe = |at: usize| {
                let value = float(self.interface.inputs[at].safe);
                quote!(T::from_f64(#value))
            };
            let delays = self
                .actuators()
                .into_iter()
                .filter(|(_, actuator)| self.delay(actuator) > 0);
            let delays = delays.map(|(at, _)| {
                let (field, safe) = (delay_field(at), safe(at));
                quote!(#field: Delay::new(#safe),)
            });
            let rest = self.actuators().into_iter().map(|(at, _)| safe(at));
            let felt = (0..self.interface.inputs.len()).map(safe);
            fields.extend(
                quote!(#(#delays)* position: Vector([#(#rest),*]), u_act: Vector([#(#felt),*]),),
            );
        }
        if self.senses() {
            let (bias, states) = (self.bias(), (0..self.measured()).map(index));
            fields.extend(quote!(bias: #bias, y: Vector([#(x[#states]),*]),));
        }
        if self.draws() {
            fields.extend(
                quote!(errors: options.noise.then_some(Noise::sensor(options.seed, options.run)),),
            );
        }
        fields
    }

    fn bias(&self) -> TokenStream {
        let sensors = self.sensors();
        let fixed = sensors.iter().map(|(_, sensor)| {
            let bias = float(sensor.bias);
            quote!(T::from_f64(#bias))
        });
        let fixed: Vec<TokenStream> = fixed.collect();
        if sensors
            .iter()
            .all(|(_, sensor)| sensor.drawn_bias.is_none())
        {
            return quote!(Vector([#(#fixed),*]));
        }
        let first = self.interface.parameters.len() + self.interface.states().count();
        let drawn = sensors
            .iter()
            .zip(&fixed)
            .enumerate()
            .map(|(at, ((_, sensor), fixed))| match &sensor.drawn_bias {
                Some(dispersion) => draw(dispersion, first + at),
                None => fixed.clone(),
            });
        quote! {
            if options.dispersion {
                let noise = Noise::dispersion(options.seed, options.run);
                Vector([#(#drawn),*])
            } else {
                Vector([#(#fixed),*])
            }
        }
    }

    /// `actuate` and `measure`.
    pub(crate) fn methods(&self) -> TokenStream {
        let mut methods = TokenStream::new();
        if self.acts() {
            methods.extend(self.actuate());
        }
        if self.senses() {
            methods.extend(self.measure());
        }
        methods
    }

    fn actuate(&self) -> TokenStream {
        let actuators = self.actuators();
        let inputs = index(self.interface.inputs.len());
        let mut steps = Vec::new();
        let mut effects: Vec<TokenStream> = (0..self.interface.inputs.len())
            .map(|at| {
                let at = index(at);
                quote!(command[#at])
            })
            .collect();
        for (place, (at, actuator)) in actuators.iter().enumerate() {
            let (place, input) = (index(place), index(*at));
            let command = if self.delay(actuator) > 0 {
                let field = delay_field(*at);
                quote!(self.#field.pass(command[#input]))
            } else {
                quote!(command[#input])
            };
            steps.push(quote!(self.position[#place] = ACTUATORS[#place].step(t, #command, self.position[#place]);));
            effects[*at] = quote!(ACTUATORS[#place].effect(t, self.position[#place]));
        }
        let docs = docs(&[
            "What the actuators make of the command over the plant step that starts at time `t`.",
        ]);
        quote! {
            #docs
            #[inline(always)]
            fn actuate(&mut self, t: f64) -> Vector<T, #inputs> {
                let command = self.output.u_sat;
                #(#steps)*
                self.u_act = Vector([#(#effects),*]);
                self.u_act
            }
        }
    }

    fn measure(&self) -> TokenStream {
        let mut entries: Vec<TokenStream> = (0..self.measured())
            .map(|at| {
                let at = index(at);
                quote!(self.x[#at])
            })
            .collect();
        for (place, (at, _)) in self.sensors().into_iter().enumerate() {
            let (place, state) = (index(place), index(at));
            let draws = match self.draws() {
                true => quote!(draws[#place]),
                false => quote!(Draws::none()),
            };
            entries[at] = quote!(SENSORS[#place].measure(self.x[#state], self.bias[#place], #draws, self.y[#state]));
        }
        let count = index(self.sensors().len());
        let draws = self
            .draws()
            .then(|| quote!(let draws = Draws::of_all::<#count>(&self.errors, self.sample);));
        let docs = docs(&["What the sensors make of the state at the sample."]);
        quote! {
            #docs
            #[inline(always)]
            fn measure(&mut self) {
                #draws
                self.y = Vector([#(#entries),*]);
            }
        }
    }
}

fn delay_field(input: usize) -> Ident {
    format_ident!("delay{}", input + 1)
}
