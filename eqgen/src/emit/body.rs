//! From nodes to the statements of one function.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use super::graph::{Graph, Node, Operation};
use super::schedule::{self, Statement, Target};

/// An unnamed operation that is used once is written into its use, up to this many operations in one expression.
const LONGEST_EXPRESSION: usize = 8;

/// What a function writes, in order: a node, and the statement that stores the value of an expression.
pub type Outputs<'a> = Vec<Output<'a>>;

type Output<'a> = (Node, Box<dyn Fn(TokenStream) -> TokenStream + 'a>);

/// Operations of a function, those done once a batch apart.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Count {
    /// Additions, subtractions, negations and selections per point.
    pub additions: usize,
    /// Multiplications per point.
    pub multiplications: usize,
    /// Divisions per point.
    pub divisions: usize,
    /// Square roots per point.
    pub roots: usize,
    /// Sine-cosine pairs, hyperbolic tangents and angles per point.
    pub functions: usize,
    /// Operations of any kind once a batch.
    pub uniform: usize,
}

impl std::fmt::Display for Count {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { additions, multiplications, divisions, roots, functions, uniform } = self;
        if additions + multiplications + divisions + roots + functions == 0 {
            return write!(f, "{uniform} operations");
        }
        write!(
            f,
            "{additions} add, {multiplications} mul, {divisions} div, {roots} sqrt, {functions} fn a point; {uniform} \
            once"
        )
    }
}

/// One function's statements.
#[derive(Clone)]
pub struct Body<'a> {
    graph: &'a Graph,
    inputs: &'a [String],
    uses: BTreeMap<Node, usize>,
    names: BTreeMap<Node, Ident>,
    taken: BTreeSet<String>,
    emitted: BTreeSet<Node>,
    temporaries: usize,
    prefix: &'static str,
    /// Whether statements are those done once a batch.
    once: bool,
    count: Count,
    statements: Vec<TokenStream>,
    /// What each statement binds and reads.
    lives: Vec<Statement>,
}

/// The two halves of a batch function.
pub struct Halves {
    /// Statements that compute what all points share.
    pub uniform_statements: TokenStream,
    /// What they hand over.
    pub uniform_values: Vec<TokenStream>,
    /// Statements for each chunk of points.
    pub statements: TokenStream,
    /// Operations.
    pub count: Count,
}

/// Writes the outputs as a function over a batch; `load` gives the expression that reads a varying input.
pub fn batch(graph: &Graph, inputs: &[String], outputs: Outputs<'_>, load: &dyn Fn(usize) -> TokenStream) -> Halves {
    let roots: Vec<Node> = outputs.iter().map(|(node, _)| *node).collect();
    let reachable = reach(graph, &roots);
    let is_number = |node: Node| graph.number(node).is_some();
    // Uniform values that a varying operation, or an output, asks for.
    let asked = reachable.iter().filter(|node| !graph.is_uniform(**node));
    let asked = asked.flat_map(|node| graph.operation(*node).operands()).chain(roots.iter().copied());
    let shared: BTreeSet<Node> = asked.filter(|node| graph.is_uniform(*node) && !is_number(*node)).collect();
    let shared: Vec<Node> = shared.into_iter().collect();

    let mut once = Body::new(graph, inputs, "u", true, &shared);
    let mut values = Vec::new();
    for &node in &shared {
        values.push(once.name(node, &|place| {
            let place = Literal::usize_unsuffixed(place - first_constant(graph, inputs));
            quote!(constants[#place])
        }));
    }
    let mut start = Body::new(graph, inputs, "t", false, &roots);
    start.taken = once.taken.clone();
    for (place, &node) in shared.iter().enumerate() {
        let place = Literal::usize_unsuffixed(place);
        // A handed-over value keeps its name, if it has one.
        let name = once.names.get(&node).cloned().unwrap_or_else(|| format_ident!("w{}", values.len()));
        start.statements.push(quote!(let #name = Real::splat(uniforms[#place]);));
        start.names.insert(node, name);
        start.emitted.insert(node);
    }
    // Once as the outputs ask for it, to know the statements; then in the order that keeps few values waiting.
    let mut draft = start.clone();
    outputs.iter().enumerate().for_each(|(place, output)| draft.store(place, output, load));
    let mut body = start;
    for place in schedule::order(&draft.lives) {
        match &draft.lives[place].target {
            Target::Values(nodes) => nodes.iter().for_each(|&node| body.require(node, load)),
            Target::Output(place) => body.store(*place, &outputs[*place], load),
        }
    }
    let mut count = body.count;
    count.uniform = once.count.uniform;
    let (once, body) = (once.statements, body.statements);
    Halves { uniform_statements: quote!(#(#once)*), uniform_values: values, statements: quote!(#(#body)*), count }
}

/// Writes the outputs as a plain scalar function.
pub fn scalar(
    graph: &Graph,
    inputs: &[String],
    outputs: Outputs<'_>,
    load: &dyn Fn(usize) -> TokenStream,
) -> (TokenStream, Count) {
    let roots: Vec<Node> = outputs.iter().map(|(node, _)| *node).collect();
    let mut body = Body::new(graph, inputs, "t", true, &roots);
    outputs.iter().enumerate().for_each(|(place, output)| body.store(place, output, load));
    let statements = body.statements;
    (quote!(#(#statements)*), body.count)
}

fn first_constant(graph: &Graph, inputs: &[String]) -> usize {
    graph.first_constant().min(inputs.len())
}

fn reach(graph: &Graph, roots: &[Node]) -> BTreeSet<Node> {
    let mut reachable = BTreeSet::new();
    let mut open: Vec<Node> = roots.to_vec();
    while let Some(node) = open.pop() {
        if reachable.insert(node) {
            open.extend(graph.operation(node).operands());
        }
    }
    reachable
}

/// A literal, with an exponent where it would be long otherwise.
fn number(value: f64) -> Literal {
    let plain = Literal::f64_unsuffixed(value);
    if value == 0.0 || (1e-5..1e9).contains(&value) {
        return plain;
    }
    format!("{value:e}").parse().unwrap_or(plain)
}

/// How tightly an expression binds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Sign,
    Whole,
}

struct Expression {
    tokens: TokenStream,
    binding: Binding,
    operations: usize,
}

impl<'a> Body<'a> {
    fn new(graph: &'a Graph, inputs: &'a [String], prefix: &'static str, once: bool, roots: &[Node]) -> Self {
        let mut uses = BTreeMap::new();
        for &root in roots {
            *uses.entry(root).or_insert(0) += 1;
        }
        for node in reach(graph, roots) {
            for operand in graph.operation(node).operands() {
                *uses.entry(operand).or_insert(0) += 1;
            }
        }
        Self {
            graph,
            inputs,
            uses,
            names: BTreeMap::new(),
            taken: BTreeSet::new(),
            emitted: BTreeSet::new(),
            temporaries: 0,
            prefix,
            once,
            count: Count::default(),
            statements: Vec::new(),
            lives: Vec::new(),
        }
    }

    /// Stores an output.
    fn store(&mut self, place: usize, (node, store): &Output<'_>, load: &dyn Fn(usize) -> TokenStream) {
        self.require(*node, load);
        let (reads, value) = (self.reads(*node), self.expression(*node).tokens);
        self.lives.push(Statement { target: Target::Output(place), reads });
        self.statements.push(store(value));
    }

    /// A statement that binds one value.
    fn bind(&mut self, node: Node, value: TokenStream) {
        let reads = self.reads(node);
        let name = self.fresh(node);
        self.lives.push(Statement { target: Target::Values(vec![node]), reads });
        self.statements.push(quote!(let #name = #value;));
        self.names.insert(node, name);
    }

    /// The named values in the expression for a node.
    fn reads(&self, node: Node) -> BTreeSet<Node> {
        let mut reads = BTreeSet::new();
        let mut open = vec![node];
        while let Some(node) = open.pop() {
            if self.names.contains_key(&node) {
                reads.insert(node);
            } else {
                open.extend(self.graph.operation(node).operands());
            }
        }
        reads
    }

    /// The value of a node, bound to a name.
    fn name(&mut self, node: Node, load: &dyn Fn(usize) -> TokenStream) -> TokenStream {
        let value = self.value(node, load);
        if self.names.contains_key(&node) || self.graph.number(node).is_some() {
            return value;
        }
        self.bind(node, value);
        self.expression(node).tokens
    }

    fn value(&mut self, node: Node, load: &dyn Fn(usize) -> TokenStream) -> TokenStream {
        self.require(node, load);
        self.expression(node).tokens
    }

    /// Emits what has to stand before an expression for `node`, and `node` itself if it gets a name.
    fn require(&mut self, node: Node, load: &dyn Fn(usize) -> TokenStream) {
        if !self.emitted.insert(node) {
            return;
        }
        let operation = self.graph.operation(node);
        for operand in operation.operands() {
            self.require(operand, load);
        }
        match operation {
            Operation::Constant(_) => {}
            Operation::Input(place) => {
                self.bind(node, load(place));
            }
            Operation::Sin(argument) | Operation::Cos(argument) => self.sine_and_cosine(argument),
            _ => {
                self.tally(operation);
                let expression = self.expression(node);
                let single = self.uses.get(&node).copied().unwrap_or(0) <= 1 && self.graph.name(node).is_none();
                let short = expression.operations <= LONGEST_EXPRESSION;
                if !(single && short || matches!(operation, Operation::Neg(_)) && self.graph.name(node).is_none()) {
                    self.bind(node, expression.tokens);
                }
            }
        }
    }

    /// Sine and cosine of the same argument come together.
    fn sine_and_cosine(&mut self, argument: Node) {
        let find = |operation| self.graph.find(operation).filter(|node| self.uses.contains_key(node));
        let (sine, cosine) = (find(Operation::Sin(argument)), find(Operation::Cos(argument)));
        let (of, reads) = (self.expression(argument).tokens, self.reads(argument));
        let target = Target::Values(sine.into_iter().chain(cosine).collect());
        self.lives.push(Statement { target, reads });
        let label = self.names.get(&argument).map_or_else(|| format!("{}", self.temporaries), Ident::to_string);
        let mut bind = |node: Option<Node>, function: &str| match node {
            Some(node) => {
                let name = self.unique(&format!("{function}_{label}"));
                self.names.insert(node, name.clone());
                self.emitted.insert(node);
                quote!(#name)
            }
            None => quote!(_),
        };
        let (sine, cosine) = (bind(sine, "sin"), bind(cosine, "cos"));
        self.temporaries += 1;
        if self.once {
            self.count.uniform += 1;
        } else {
            self.count.functions += 1;
        }
        self.statements.push(quote!(let (#sine, #cosine) = sin_cos(#of);));
    }

    fn tally(&mut self, operation: Operation) {
        if self.once {
            self.count.uniform += 1;
            return;
        }
        match operation {
            Operation::Mul(..) => self.count.multiplications += 1,
            Operation::Reciprocal(_) => self.count.divisions += 1,
            Operation::Sqrt(_) => self.count.roots += 1,
            Operation::Tanh(_) | Operation::Exp(_) | Operation::Ln(_) | Operation::Angle(..) => {
                self.count.functions += 1;
            }
            _ => self.count.additions += 1,
        }
    }

    fn fresh(&mut self, node: Node) -> Ident {
        let wanted = match self.graph.operation(node) {
            Operation::Input(place) => Some(self.inputs[place].clone()),
            _ => self.graph.name(node).map(str::to_owned),
        };
        match wanted {
            Some(name) => self.unique(&name),
            None => {
                self.temporaries += 1;
                self.unique(&format!("{}{}", self.prefix, self.temporaries))
            }
        }
    }

    fn unique(&mut self, wanted: &str) -> Ident {
        let mut name = wanted.to_owned();
        let mut copy = 1;
        while !self.taken.insert(name.clone()) {
            copy += 1;
            name = format!("{wanted}_{copy}");
        }
        Ident::new(&name, Span::call_site())
    }

    fn expression(&self, node: Node) -> Expression {
        use Operation::*;
        if let Some(name) = self.names.get(&node) {
            return Expression { tokens: quote!(#name), binding: Binding::Whole, operations: 0 };
        }
        let call = |function: &str, arguments: &[Node]| {
            let function = format_ident!("{function}");
            let parts: Vec<Expression> = arguments.iter().map(|&argument| self.expression(argument)).collect();
            let operations = 1 + parts.iter().map(|part| part.operations).sum::<usize>();
            let tokens = parts.into_iter().map(|part| part.tokens);
            Expression { tokens: quote!(#function(#(#tokens),*)), binding: Binding::Whole, operations }
        };
        match self.graph.operation(node) {
            Constant(bits) => {
                let literal = number(f64::from_bits(bits));
                let tokens = if self.once { quote!(#literal) } else { quote!(Real::splat(#literal)) };
                Expression { tokens, binding: Binding::Whole, operations: 0 }
            }
            Input(place) => unreachable!("input {place} is always named"),
            Add(a, b) => self.infix(a, quote!(+), b, Binding::Sum, Binding::Product),
            Sub(a, b) => self.infix(a, quote!(-), b, Binding::Sum, Binding::Product),
            Mul(a, b) => self.infix(a, quote!(*), b, Binding::Product, Binding::Whole),
            Neg(a) => {
                let (inner, operations) = self.bound(a, Binding::Whole);
                Expression { tokens: quote!(-#inner), binding: Binding::Sign, operations: operations + 1 }
            }
            Reciprocal(a) => call("reciprocal", &[a]),
            Sqrt(a) => call("sqrt", &[a]),
            Sin(a) => call("sin", &[a]),
            Cos(a) => call("cos", &[a]),
            Tanh(a) => call("tanh", &[a]),
            Exp(a) => call("exp", &[a]),
            Ln(a) => call("ln", &[a]),
            Saturate(a) => call("saturate", &[a]),
            BelowOne(a) => call("below_one", &[a]),
            Angle(a, b) => call("angle", &[a, b]),
            Turn(a) => call("turn", &[a]),
        }
    }

    fn infix(&self, a: Node, sign: TokenStream, b: Node, left: Binding, right: Binding) -> Expression {
        let ((a, in_a), (b, in_b)) = (self.bound(a, left), self.bound(b, right));
        Expression { tokens: quote!(#a #sign #b), binding: left, operations: in_a + in_b + 1 }
    }

    /// An expression in parentheses unless it binds at least as tightly as `least`.
    fn bound(&self, node: Node, least: Binding) -> (TokenStream, usize) {
        let Expression { tokens, binding, operations } = self.expression(node);
        let tokens = if binding >= least { tokens } else { quote!((#tokens)) };
        (tokens, operations)
    }
}
