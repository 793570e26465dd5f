#![allow(missing_docs)]
use solver::model::{Differentiated, Model, Scalar};
use solver::*;
struct T(u32, f64);
impl Model for T {
    fn layout(&self) -> Layout {
        let (a, b) = if self.0 == 3 { (-1.0, 1.0) } else { (0.0, 1.0) };
        Layout::dense(vec![Region::dense("line", (a, b), &["u", "v"], &[], 0)], &[], &["left", "right"])
    }
    fn rhs<S: Scalar>(&self, _: usize, x: S, y: &[S], _: &[S], f: &mut [S]) {
        let e = self.1;
        let pi = std::f64::consts::PI;
        f[0] = y[1];
        f[1] = match self.0 {
            8 => -y[1] / e,
            3 => {
                let c = (x * pi).cos();
                let s = (x * pi).sin();
                (-(c + 2.0) * y[1] + y[0] - c * (1.0 + e * pi * pi) - (c + 2.0) * s * pi) / e
            }
            _ => y[0],
        };
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
        if self.0 == 8 {
            (g[0], g[1]) = (e[0] - 1.0, e[2] - 2.0);
        } else {
            (g[0], g[1]) = (e[0] + 1.0, e[2] + 1.0);
        }
    }
}
fn main() {
    for (id, eps) in [(8, 1e-6), (3, 1e-5)] {
        for order in [Order::Four, Order::Six] {
            let problem = Differentiated::new(T(id, eps)).unwrap();
            let guess = Guess::uniform(problem.layout(), 20, &[], |_, _, y| y.fill(0.0));
            match solve(&problem, &guess, &[], &Options { order, ..Options::default() }) {
                Ok(s) => {
                    println!("T{id} {order:?} N {}", s.intervals());
                    for h in s.history() {
                        println!("   {:?} {:?}", h.intervals, h.defects);
                    }
                }
                Err(e) => println!("T{id} {order:?} {e}"),
            }
        }
    }
}
