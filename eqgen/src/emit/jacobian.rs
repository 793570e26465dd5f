//! Derivatives by the chain rule over a plan's steps.
//!
//! Steps are vertices, local partial derivatives edges. Eliminating a vertex multiplies every edge into it with
//! every edge out of it (Griewank and Walther, Evaluating Derivatives, chapter 10); what remains between inputs and
//! rows is the Jacobian. The vertex that costs the fewest products goes next (Markowitz), ties by order of
//! evaluation, so that bottlenecks such as (v_r, v_t) are found rather than prescribed.

use std::collections::{BTreeMap, BTreeSet};

use super::graph::{Graph, Node};
use super::import::Import;
use crate::error::Error;

/// Nonzero derivatives of rows with respect to inputs: (row, place of the input) and the node.
pub type Jacobian = BTreeMap<(usize, usize), Node>;

/// Derivatives of the plan's symbols `rows` with respect to the inputs at `places`.
///
/// # Errors
/// As [`Import::partials`].
pub fn jacobian(import: &mut Import<'_>, rows: &[&str], places: &[usize]) -> Result<Jacobian, Error> {
    let mut edges = Edges::build(import, rows, places)?;
    edges.prune();
    while let Some(vertex) = edges.cheapest(&import.graph) {
        edges.eliminate(vertex, &mut import.graph);
    }
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

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Vertex {
    Input(usize),
    Step(usize),
    Row(usize),
}

/// Edges from both sides; zero edges are never kept.
#[derive(Debug, Default)]
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

    fn cheapest(&self, graph: &Graph) -> Option<Vertex> {
        let cost = |vertex: &Vertex| -> usize {
            let successors = self.successors(*vertex);
            let trivial = |node: Node| graph.is_uniform(node);
            let before = self.into.get(vertex).into_iter().flatten();
            before
                .map(|(_, &inner)| {
                    let products = successors.iter().filter_map(|next| self.into.get(next)?.get(vertex));
                    products.map(|&outer| if trivial(inner) && trivial(outer) { 1 } else { 4 }).sum::<usize>()
                })
                .sum()
        };
        self.steps().min_by_key(|vertex| (cost(vertex), *vertex))
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

    fn all(&self) -> Vec<((Vertex, Vertex), Node)> {
        let pairs = self.into.iter().flat_map(|(to, from)| from.iter().map(|(from, node)| ((*from, *to), *node)));
        pairs.collect()
    }
}
