//! Derivatives by the chain rule over a plan's steps.
//!
//! Steps are vertices, local partial derivatives edges. Eliminating a vertex multiplies every edge into it with
//! every edge out of it (Griewank and Walther, Evaluating Derivatives, chapter 10); what remains between inputs and
//! rows is the Jacobian. Orders are tried that find bottlenecks such as (v_r, v_t) by themselves, and the one with the
//! fewest operations is kept.

use std::collections::{BTreeMap, BTreeSet};

use super::graph::{Graph, Node};
use super::import::Import;
use crate::error::Error;

/// What a product at every point counts, against one that is done once a batch.
const UNIT: usize = 4;

/// Nonzero derivatives of rows with respect to inputs: (row, place of the input) and the node.
pub type Jacobian = BTreeMap<(usize, usize), Node>;

/// Derivatives of the plan's symbols `rows` with respect to the inputs at `places`.
///
/// # Errors
/// As [`Import::partials`].
pub fn jacobian(import: &mut Import<'_>, rows: &[&str], places: &[usize]) -> Result<Jacobian, Error> {
    let mut edges = Edges::build(import, rows, places)?;
    edges.prune();
    let values: Vec<Node> = rows.iter().filter_map(|row| import.nodes.get(*row).copied()).collect();
    let attempt = |order: Order| {
        let (mut graph, mut edges) = (import.graph.clone(), edges.clone());
        while let Some(vertex) = edges.next(order, &graph) {
            edges.eliminate(vertex, &mut graph);
        }
        let roots: Vec<Node> = values.iter().copied().chain(edges.all().map(|(_, node)| node)).collect();
        (graph.cost(&roots), graph, edges)
    };
    let best = Order::ALL.into_iter().map(attempt).min_by_key(|(cost, ..)| *cost);
    let Some((_, graph, edges)) = best else { return Ok(Jacobian::new()) };
    import.graph = graph;
    let mut entries = Jacobian::new();
    for ((from, to), node) in edges.all() {
        if let (Vertex::Input(place), Vertex::Row(row)) = (from, to) {
            let name = format!("d_{}_d_{}", rows[row], import.plan.inputs[place]);
            import.graph.suggest_name(node, &name);
            entries.insert((row, place), node);
        }
    }
    Ok(entries)
}

/// Which vertex goes next. No order is best for every graph; the one with the fewest operations is taken.
#[derive(Debug, Clone, Copy)]
enum Order {
    /// Fewest products, the first such step.
    Cheapest,
    /// Fewest products, the last such step.
    CheapestLast,
    /// Fewest products more than the vertex will cost in the end if it goes last: inputs that reach it times rows that
    /// it reaches (Griewank's "relatively greedy").
    Relative,
    /// From the first step to the last: forward mode.
    Forward,
    /// From the last step to the first: reverse mode.
    Reverse,
}

impl Order {
    const ALL: [Order; 5] = [Order::Cheapest, Order::CheapestLast, Order::Relative, Order::Forward, Order::Reverse];
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Vertex {
    Input(usize),
    Step(usize),
    Row(usize),
}

/// Edges from both sides; zero edges are never kept.
#[derive(Debug, Clone, Default)]
struct Edges {
    into: BTreeMap<Vertex, BTreeMap<Vertex, Node>>,
    out_of: BTreeMap<Vertex, BTreeSet<Vertex>>,
}

impl Edges {
    fn build(import: &mut Import<'_>, rows: &[&str], places: &[usize]) -> Result<Self, Error> {
        let plan = import.plan;
        let mut vertices: BTreeMap<&str, Vertex> =
            places.iter().map(|&place| (plan.inputs[place].as_str(), Vertex::Input(place))).collect();
        let mut edges = Self::default();
        for (index, step) in plan.steps.iter().enumerate() {
            for (name, partial) in import.partials(step)? {
                // A step that no wanted input reaches is a constant here.
                if let Some(&from) = vertices.get(name.as_str()) {
                    edges.add(from, Vertex::Step(index), partial, &mut import.graph);
                }
            }
            if edges.into.contains_key(&Vertex::Step(index)) {
                vertices.insert(&step.name, Vertex::Step(index));
            }
        }
        let one = import.graph.constant(1.0);
        for (row, name) in rows.iter().enumerate() {
            if let Some(&from) = vertices.get(name) {
                edges.add(from, Vertex::Row(row), one, &mut import.graph);
            }
        }
        Ok(edges)
    }

    fn add(&mut self, from: Vertex, to: Vertex, value: Node, graph: &mut Graph) {
        let into = self.into.entry(to).or_default();
        let total = match into.get(&from) {
            Some(&so_far) => graph.add(so_far, value),
            None => value,
        };
        if graph.is_zero(total) {
            into.remove(&from);
            self.out_of.entry(from).or_default().remove(&to);
        } else {
            into.insert(from, total);
            self.out_of.entry(from).or_default().insert(to);
        }
    }

    /// Removes steps that lead to no row.
    fn prune(&mut self) {
        loop {
            let idle = self.steps().find(|vertex| self.successors(*vertex).is_empty());
            let Some(vertex) = idle else { return };
            self.remove(vertex);
        }
    }

    fn next(&self, order: Order, graph: &Graph) -> Option<Vertex> {
        let cost = |vertex: &Vertex| self.products(*vertex, graph) as isize;
        match order {
            Order::Cheapest => self.steps().min_by_key(|vertex| (cost(vertex), *vertex)),
            Order::CheapestLast => self.steps().min_by_key(|vertex| (cost(vertex), std::cmp::Reverse(*vertex))),
            Order::Relative => {
                let bound = |vertex: &Vertex| (self.ends(*vertex, false) * self.ends(*vertex, true)) as isize;
                self.steps().min_by_key(|vertex| (cost(vertex) - UNIT as isize * bound(vertex), *vertex))
            }
            Order::Forward => self.steps().next(),
            Order::Reverse => self.steps().last(),
        }
    }

    /// Products that eliminating the vertex takes; those of constants are done once a batch, and nearly free.
    fn products(&self, vertex: Vertex, graph: &Graph) -> usize {
        let successors = self.successors(vertex);
        let inner = self.into.get(&vertex).into_iter().flatten().map(|(_, &node)| node);
        let outer: Vec<Node> =
            successors.iter().filter_map(|next| self.into.get(next)?.get(&vertex).copied()).collect();
        inner
            .flat_map(|inner| outer.iter().map(move |&outer| (inner, outer)))
            .map(|(inner, outer)| if graph.is_uniform(inner) && graph.is_uniform(outer) { 1 } else { UNIT })
            .sum()
    }

    /// How many rows a vertex reaches, or how many inputs reach it.
    fn ends(&self, vertex: Vertex, forward: bool) -> usize {
        let (mut seen, mut open) = (BTreeSet::new(), vec![vertex]);
        while let Some(vertex) = open.pop() {
            let neighbours: Vec<Vertex> = if forward {
                self.successors(vertex).into_iter().collect()
            } else {
                self.into.get(&vertex).into_iter().flatten().map(|(from, _)| *from).collect()
            };
            open.extend(neighbours.into_iter().filter(|next| seen.insert(*next)));
        }
        seen.into_iter().filter(|vertex| !matches!(vertex, Vertex::Step(_))).count()
    }

    fn eliminate(&mut self, vertex: Vertex, graph: &mut Graph) {
        let inner: Vec<(Vertex, Node)> =
            self.into.get(&vertex).into_iter().flatten().map(|(from, node)| (*from, *node)).collect();
        for next in self.successors(vertex) {
            let Some(&outer) = self.into.get(&next).and_then(|into| into.get(&vertex)) else { continue };
            for &(from, node) in &inner {
                let product = graph.mul(outer, node);
                self.add(from, next, product, graph);
            }
        }
        self.remove(vertex);
    }

    fn remove(&mut self, vertex: Vertex) {
        for from in self.into.remove(&vertex).into_iter().flatten().map(|(from, _)| from) {
            if let Some(next) = self.out_of.get_mut(&from) {
                next.remove(&vertex);
            }
        }
        for next in self.out_of.remove(&vertex).into_iter().flatten() {
            if let Some(into) = self.into.get_mut(&next) {
                into.remove(&vertex);
            }
        }
    }

    fn steps(&self) -> impl Iterator<Item = Vertex> {
        self.into.keys().copied().filter(|vertex| matches!(vertex, Vertex::Step(_)))
    }

    fn successors(&self, vertex: Vertex) -> BTreeSet<Vertex> {
        self.out_of.get(&vertex).cloned().unwrap_or_default()
    }

    fn all(&self) -> impl Iterator<Item = ((Vertex, Vertex), Node)> {
        self.into.iter().flat_map(|(to, from)| from.iter().map(|(from, node)| ((*from, *to), *node)))
    }
}
