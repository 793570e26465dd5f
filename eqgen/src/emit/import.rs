//! From Symbolica's expressions to the graph.

use std::collections::BTreeMap;

use symbolica::atom::{Atom, AtomCore, AtomView};

use super::graph::{Graph, Node, Operation};
use crate::error::Error;
use crate::plan::{Definition, Function, Plan, Step};

/// A plan's steps as nodes of a graph.
#[derive(Debug, Clone)]
pub struct Import<'a> {
    /// The plan.
    pub plan: &'a Plan,
    /// Its operations.
    pub graph: Graph,
    /// Inputs and steps by name.
    pub nodes: BTreeMap<String, Node>,
    nonzero: Vec<Node>,
}

impl<'a> Import<'a> {
    /// Imports the values of all steps; inputs from `first_constant` on are constants.
    ///
    /// # Errors
    /// [`Error::UndeclaredDivisor`] if a step divides by something that is not declared nonzero.
    pub fn new(plan: &'a Plan, first_constant: usize) -> Result<Self, Error> {
        let mut graph = Graph::new(first_constant);
        let nodes = plan.inputs.iter().enumerate().map(|(place, name)| (name.clone(), graph.input(place))).collect();
        let mut import = Self { plan, graph, nodes, nonzero: Vec::new() };
        let mut guards = plan.guards.iter().map(|guard| &guard.divisor).collect::<Vec<_>>();
        for step in &plan.steps {
            import.declare(&mut guards)?;
            let node = import.step(step)?;
            import.graph.suggest_name(node, &step.name);
            import.nodes.insert(step.name.clone(), node);
        }
        import.declare(&mut guards)?;
        Ok(import)
    }

    /// Moves the guards whose symbols are all known by now to the list of nodes that do not vanish.
    fn declare(&mut self, guards: &mut Vec<&'a Atom>) -> Result<(), Error> {
        let (ready, later) = guards.iter().partition(|guard| {
            let symbols = guard.get_all_symbols(false);
            symbols.iter().all(|symbol| self.nodes.contains_key(symbol.get_stripped_name()))
        });
        *guards = later;
        let ready: Vec<&Atom> = ready;
        for divisor in ready {
            let node = self.expression("guard", divisor)?;
            self.nonzero.push(node);
        }
        Ok(())
    }

    fn step(&mut self, step: &Step) -> Result<Node, Error> {
        match &step.definition {
            Definition::Number(value) => Ok(self.graph.constant(*value)),
            Definition::Expression(value) => self.expression(&step.name, value),
            Definition::Function(function, arguments) => {
                let arguments: Vec<Node> =
                    arguments.iter().map(|argument| self.expression(&step.name, argument)).collect::<Result<_, _>>()?;
                self.function(&step.name, *function, &arguments)
            }
        }
    }

    fn function(&mut self, step: &str, function: Function, arguments: &[Node]) -> Result<Node, Error> {
        let operation = match (function, arguments) {
            (Function::Sqrt, &[u]) => {
                self.must_not_vanish(step, u)?;
                Operation::Sqrt(u)
            }
            (Function::Tan, &[u]) => return self.tangent(step, u),
            (Function::Tanh, &[u]) => Operation::Tanh(u),
            (Function::Exp, &[u]) => Operation::Exp(u),
            (Function::Ln, &[u]) => Operation::Ln(u),
            (Function::Saturate, &[u]) => Operation::Saturate(u),
            (Function::Angle, &[u, v]) => Operation::Angle(u, v),
            (Function::Turn, &[u]) => Operation::Turn(u),
            _ => return Err(Error::Unsupported { step: step.into(), expression: format!("{function:?}") }),
        };
        Ok(self.graph.function(operation))
    }

    fn tangent(&mut self, step: &str, argument: Node) -> Result<Node, Error> {
        let sine = self.graph.function(Operation::Sin(argument));
        let cosine = self.graph.function(Operation::Cos(argument));
        self.must_not_vanish(step, cosine)?;
        let secant = self.graph.reciprocal(cosine);
        Ok(self.graph.mul(sine, secant))
    }

    /// Partial derivatives of a step with respect to the symbols it uses, by name; those that vanish are left out.
    ///
    /// # Errors
    /// As [`Import::new`].
    pub fn partials(&mut self, step: &Step) -> Result<Vec<(String, Node)>, Error> {
        match &step.definition {
            Definition::Number(_) => Ok(Vec::new()),
            Definition::Expression(value) => self.gradient(&step.name, value),
            Definition::Function(function, arguments) => self.chain(step, *function, arguments),
        }
    }

    fn gradient(&mut self, step: &str, value: &Atom) -> Result<Vec<(String, Node)>, Error> {
        let mut symbols: Vec<_> = value.get_all_symbols(false).into_iter().collect();
        symbols.sort_by_key(|symbol| symbol.get_stripped_name().to_owned());
        let mut partials = Vec::new();
        for symbol in symbols {
            let partial = value.derivative(symbol);
            if !partial.is_zero() && self.nodes.contains_key(symbol.get_stripped_name()) {
                partials.push((symbol.get_stripped_name().to_owned(), self.expression(step, &partial)?));
            }
        }
        Ok(partials)
    }

    fn chain(&mut self, step: &Step, function: Function, arguments: &[Atom]) -> Result<Vec<(String, Node)>, Error> {
        let mut partials: BTreeMap<String, Node> = BTreeMap::new();
        for (place, argument) in arguments.iter().enumerate() {
            let outer = self.slope(step, function, place)?;
            for (name, inner) in self.gradient(&step.name, argument)? {
                let product = self.graph.mul(outer, inner);
                let so_far = partials.get(&name).copied();
                let total = so_far.map_or(product, |so_far| self.graph.add(so_far, product));
                partials.insert(name, total);
            }
        }
        Ok(partials.into_iter().filter(|&(_, node)| !self.graph.is_zero(node)).collect())
    }

    /// Derivative of a function step with respect to its argument at `place`, from the step's own value.
    fn slope(&mut self, step: &Step, function: Function, place: usize) -> Result<Node, Error> {
        let unsupported = || Error::Unsupported { step: step.name.clone(), expression: format!("d {function:?}") };
        let value = self.nodes.get(&step.name).copied().ok_or_else(unsupported)?;
        let (half, one) = (self.graph.constant(0.5), self.graph.constant(1.0));
        match function {
            Function::Sqrt => {
                self.must_not_vanish(&step.name, value)?;
                let inverse = self.graph.reciprocal(value);
                Ok(self.graph.mul(half, inverse))
            }
            Function::Tan => {
                let square = self.graph.mul(value, value);
                Ok(self.graph.add(one, square))
            }
            Function::Tanh => {
                let square = self.graph.mul(value, value);
                Ok(self.graph.sub(one, square))
            }
            Function::Exp => Ok(value),
            Function::Ln => match self.graph.operation(value) {
                Operation::Ln(u) => {
                    self.must_not_vanish(&step.name, u)?;
                    Ok(self.graph.reciprocal(u))
                }
                _ => Err(unsupported()),
            },
            Function::Saturate => match self.graph.operation(value) {
                Operation::Saturate(u) => Ok(self.graph.function(Operation::BelowOne(u))),
                _ => Err(unsupported()),
            },
            Function::Turn => Ok(one),
            // d atan2(b, a) = (a db − b da)/(a² + b²)
            Function::Angle => match self.graph.operation(value) {
                Operation::Angle(a, b) => {
                    let (aa, bb) = (self.graph.mul(a, a), self.graph.mul(b, b));
                    let square = self.graph.add(aa, bb);
                    let inverse = self.graph.reciprocal(square);
                    let numerator = if place == 0 { self.graph.neg(b) } else { a };
                    Ok(self.graph.mul(numerator, inverse))
                }
                _ => Err(unsupported()),
            },
        }
    }

    fn must_not_vanish(&self, step: &str, divisor: Node) -> Result<(), Error> {
        let bare = match self.graph.operation(divisor) {
            Operation::Neg(positive) => positive,
            _ => divisor,
        };
        let listed = |node: &Node| {
            *node == bare || matches!(self.graph.operation(*node), Operation::Neg(positive) if positive == bare)
        };
        let fine = match self.graph.operation(bare) {
            Operation::Constant(_) => !self.graph.is_zero(bare),
            Operation::Mul(a, b) if !self.nonzero.iter().any(listed) => {
                return self.must_not_vanish(step, a).and_then(|()| self.must_not_vanish(step, b));
            }
            Operation::Reciprocal(_) => true,
            _ => self.nonzero.iter().any(listed),
        };
        let divisor = || self.describe(bare);
        if fine { Ok(()) } else { Err(Error::UndeclaredDivisor { step: step.into(), divisor: divisor() }) }
    }

    /// A node in the plan's own names.
    fn describe(&self, node: Node) -> String {
        if let Some((name, _)) = self.nodes.iter().find(|(_, known)| **known == node) {
            return name.clone();
        }
        if let Some(number) = self.graph.number(node) {
            return number.to_string();
        }
        let operation = self.graph.operation(node);
        let operands: Vec<String> = operation.operands().map(|operand| self.describe(operand)).collect();
        match operation {
            Operation::Add(..) => operands.join(" + "),
            Operation::Sub(..) => format!("{} - ({})", operands[0], operands[1]),
            Operation::Mul(..) => format!("({})", operands.join(") * (")),
            Operation::Reciprocal(_) => format!("1/({})", operands[0]),
            other => format!("{} of {}", other.name(), operands.join(", ")),
        }
    }

    /// Imports an expression in known symbols.
    ///
    /// # Errors
    /// As [`Import::new`].
    pub fn expression(&mut self, step: &str, expression: &Atom) -> Result<Node, Error> {
        self.view(step, expression.as_view())
    }

    fn view(&mut self, step: &str, expression: AtomView<'_>) -> Result<Node, Error> {
        let unsupported = || Error::Unsupported { step: step.into(), expression: expression.to_string() };
        match expression {
            AtomView::Num(_) => number(expression).map(|value| self.graph.constant(value)).ok_or_else(unsupported),
            AtomView::Var(variable) => {
                let symbol = variable.get_symbol();
                let name = symbol.get_stripped_name();
                if name == "𝜋" {
                    return Ok(self.graph.constant(std::f64::consts::PI));
                }
                let unknown = || Error::UnknownSymbol { step: step.into(), symbol: name.into() };
                self.nodes.get(name).copied().ok_or_else(unknown)
            }
            AtomView::Fun(function) => {
                let name = function.get_symbol().get_stripped_name().to_owned();
                let argument = function.iter().next().ok_or_else(unsupported)?;
                let argument = self.view(step, argument)?;
                let operation = match name.as_str() {
                    "sin" => Operation::Sin(argument),
                    "cos" => Operation::Cos(argument),
                    _ => return Err(unsupported()),
                };
                Ok(self.graph.function(operation))
            }
            AtomView::Pow(power) => {
                let (base, exponent) = power.get_base_exp();
                let exponent: i64 = exponent.to_string().parse().map_err(|_| unsupported())?;
                let base = self.view(step, base)?;
                if exponent < 0 {
                    self.must_not_vanish(step, base)?;
                }
                Ok(self.graph.power(base, exponent))
            }
            AtomView::Mul(product) => {
                let factors = product.iter().map(|factor| self.view(step, factor)).collect::<Result<_, _>>()?;
                Ok(self.graph.product(factors))
            }
            AtomView::Add(sum) => {
                let terms = sum.iter().map(|term| self.view(step, term)).collect::<Result<_, _>>()?;
                Ok(self.graph.sum(terms))
            }
        }
    }
}

/// The value of a rational number.
fn number(view: AtomView<'_>) -> Option<f64> {
    let text = view.to_string();
    match text.split_once('/') {
        Some((above, below)) => Some(above.parse::<f64>().ok()? / below.parse::<f64>().ok()?),
        None => text.parse().ok(),
    }
}
