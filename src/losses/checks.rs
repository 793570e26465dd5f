//! The sums against what is known of them otherwise.

use std::f64::consts::{PI, TAU};

use super::series::{MAX_HARMONICS, Summand, Track, series, side_by_side};

/// A field with smooth bumps and a kink, given by value and derivative, on four tracks with uneven meshes.
fn tracks(value: impl Fn(f64) -> f64, slope: impl Fn(f64) -> f64, nodes: usize) -> Vec<Track> {
    let edges = [0.0, 0.23, 0.5, 0.81, 1.0];
    let track = |edges: &[f64]| {
        // Finer towards both ends, as meshes of a belt are.
        let place = |i: usize| {
            let t = i as f64 / nodes as f64;
            edges[0] + (edges[1] - edges[0]) * (t - 0.12 * (TAU * t).sin())
        };
        let u: Vec<f64> = (0..=nodes).map(place).collect();
        Track { value: u.iter().map(|u| value(*u)).collect(), slope: u.iter().map(|u| slope(*u)).collect(), u }
    };
    edges.windows(2).map(track).collect()
}

/// B_n = iωa e^{..}: a cosine has one harmonic, whose |B| is πn times its amplitude.
#[test]
fn a_cosine_has_one_harmonic() {
    for n in [1_usize, 3, 11, 40] {
        let omega = TAU * n as f64;
        let field = tracks(|u| 0.7 * (omega * u - 0.4).cos(), |u| -0.7 * omega * (omega * u - 0.4).sin(), 1600);
        let sum = series(&field, |_| 1.0, 1e-9).expect("smooth");
        let exact = (PI * n as f64 * 0.7).powi(2) / n as f64;
        assert!((sum.total / exact - 1.0).abs() < 1e-6, "{n}: {} and {exact}", sum.total);
        assert!((sum.regions.iter().sum::<f64>() / exact - 1.0).abs() < 1e-6);
    }
}

/// A triangle of height 1 has the amplitudes 8/(πn)² at odd n, and the sum Σ n a_n² π²/n·… = (64/π²) Σ 1/n³ over odd n.
#[test]
fn a_kink_is_summed_until_the_tail_is_small() {
    let triangle = |u: f64| 1.0 - (2.0 * u - 1.0).abs();
    let half = |low: f64, high: f64| {
        let u: Vec<f64> = (0..=20).map(|i| low + (high - low) * f64::from(i) / 20.0).collect();
        let slope = if high <= 0.5 { 2.0 } else { -2.0 };
        Track { value: u.iter().map(|u| triangle(*u)).collect(), slope: vec![slope; u.len()], u }
    };
    let field = vec![half(0.0, 0.5), half(0.5, 1.0)];
    // a_n = 4/(πn)², |B_n| = πn a_n, Σ |B_n|²/n = (16/π²) Σ_{odd} n^-3 = (16/π²) (7/8) ζ(3).
    let exact = 16.0 / (PI * PI) * 0.875 * 1.202_056_903_159_594;
    for tolerance in [1e-3, 1e-5, 1e-7] {
        let sum = series(&field, |_| 1.0, tolerance).expect("ends");
        assert!((sum.total - exact).abs() < 1.5 * tolerance, "{} and {exact}, {} harmonics", sum.total, sum.harmonics);
    }
}

#[test]
fn a_jump_has_no_sum() {
    let flat = |low: f64, high: f64, value: f64| {
        let u: Vec<f64> = (0..=20).map(|i| low + (high - low) * f64::from(i) / 20.0).collect();
        // A steep ramp stands for the jump: it ends only where its own length is resolved.
        Track { value: vec![value; u.len()], slope: vec![0.0; u.len()], u }
    };
    let ramp = |low: f64, from: f64, to: f64| Track {
        u: vec![low, low + 1e-7],
        value: vec![from, to],
        slope: vec![(to - from) / 1e-7; 2],
    };
    let field =
        vec![flat(0.0, 0.5, 1.0), ramp(0.5, 1.0, 0.0), flat(0.5 + 1e-7, 1.0 - 1e-7, 0.0), ramp(1.0 - 1e-7, 0.0, 1.0)];
    assert!(series(&field, |_| 1.0, 1e-6).is_none());
    // Beside it, a sum that ends does end.
    let smooth = tracks(|u| (TAU * u).cos(), |u| -TAU * (TAU * u).sin(), 60);
    let summand = |tracks| Summand { tracks, weight: &|_| 1.0, tolerance: 1e-6, most: 1e-6 };
    let both = side_by_side(&[summand(&field), summand(&smooth)]);
    assert!(both[0].is_none() && both[1].is_some());
}

#[test]
fn both_ways_to_integrate_agree_where_they_meet() {
    let value = |u: f64| (TAU * u).cos().exp() + 0.2 * (3.0 * TAU * u).sin();
    let slope = |u: f64| -TAU * (TAU * u).sin() * (TAU * u).cos().exp() + 0.6 * TAU * (3.0 * TAU * u).cos();
    // Quadrature reaches further on a fine mesh than on a coarse one.
    let sums = [60, 150].map(|nodes| series(&tracks(value, slope, nodes), |_| 1.0, 1e-9).expect("smooth"));
    assert!((sums[0].total / sums[1].total - 1.0).abs() < 1e-6, "{} and {}", sums[0].total, sums[1].total);
}

/// Fields on the same nodes, on others, absent from a region, and one whose sum ends much later.
/// The terms of a field with kinks fall as n⁻³: at a tolerance that no number of harmonics leads to, the sum has what
/// all of them say.
#[test]
fn a_kink_is_summed_as_far_as_the_harmonics_lead() {
    let kinked = tracks(|u| (PI * u).sin().abs(), |u| PI * (PI * u).cos() * (PI * u).sin().signum(), 60);
    let summed = |tolerance, most| {
        side_by_side(&[Summand { tracks: &kinked, weight: &|_| 1.0, tolerance, most }]).pop().flatten()
    };
    assert!(summed(1e-13, 1e-13).is_none());
    let (all, some) = (summed(1e-13, 1e-6).expect("as far as they lead"), summed(1e-6, 1e-6).expect("ends"));
    assert_eq!(all.harmonics, MAX_HARMONICS);
    assert!((all.total - some.total).abs() < 1.5e-6 && all.rest < 1e-6, "{} and {}", all.total, some.total);
}

#[test]
fn fields_side_by_side_are_summed_as_each_by_itself() {
    let wave = |n: f64| {
        let omega = TAU * n;
        (move |u: f64| (omega * u).cos().exp(), move |u: f64| -omega * (omega * u).sin() * (omega * u).cos().exp())
    };
    let ((a, da), (b, db)) = (wave(1.0), wave(9.0));
    let (first, second, third) = (tracks(a, da, 80), tracks(b, db, 80), tracks(b, db, 130));
    let mut fourth = tracks(|u| (PI * u).sin().powi(4), |u| 4.0 * PI * (PI * u).cos() * (PI * u).sin().powi(3), 80);
    fourth[3] = Track::default();
    let fields = [(&first, 1e-5), (&second, 1e-9), (&third, 1e-7), (&fourth, 1e-4)];
    let summands = fields.map(|(tracks, tolerance)| Summand {
        tracks,
        weight: &|n| 1.0 + 0.1 / n as f64,
        tolerance,
        most: tolerance,
    });
    let found = side_by_side(&summands);
    let mut ends = Vec::new();
    for (found, of) in found.into_iter().zip(summands) {
        let (found, alone) =
            (found.expect("smooth"), series(of.tracks, of.weight, of.tolerance).expect("smooth by itself"));
        assert_eq!(found.harmonics, alone.harmonics);
        assert!((found.total / alone.total - 1.0).abs() < 1e-9, "{} and {}", found.total, alone.total);
        for (found, alone) in found.regions.iter().zip(&alone.regions) {
            assert!((found - alone).abs() < 1e-9 * alone.abs().max(1.0), "{found} and {alone}");
        }
        ends.push(found.harmonics);
    }
    assert!(ends[0] < ends[1], "{ends:?}");
}

#[test]
fn a_sum_is_quadratic_in_its_field_and_linear_in_its_weight() {
    let make = |scale: f64| {
        tracks(
            move |u| scale * (TAU * u).cos().exp(),
            move |u| -scale * TAU * (TAU * u).sin() * (TAU * u).cos().exp(),
            50,
        )
    };
    let sum = |scale: f64, weight: f64| series(&make(scale), |_| weight, 1e-9).expect("smooth").total;
    let one = sum(1.0, 1.0);
    assert!((sum(1.0, 0.5) / one - 0.5).abs() < 1e-12);
    assert!((sum(2.0, 1.0) / one - 4.0).abs() < 1e-9);
}

/// A belt of a standard linear solid run through the field in time, step by step, against the sum with the solid's own
/// loss tangent at each harmonic.
///
/// The solid: σ = E_∞ a + E_1 (a − b), τ db/dt = a − b. Storage E' = E_∞ + E_1 (ωτ)²/(1 + (ωτ)²), loss E'' = E_1 ωτ/(1
/// + (ωτ)²); a cycle of the field dissipates ∮ σ da per length.
#[test]
fn a_standard_linear_solid_followed_in_time_dissipates_what_the_sum_says() {
    let (stiff, branch, relaxation, period) = (3.0, 0.8, 0.004, 0.05);
    let value = |u: f64| (2.0 * (TAU * u).cos()).exp() - 0.5 * (2.0 * TAU * u - 1.0).sin();
    let slope =
        |u: f64| -2.0 * TAU * (TAU * u).sin() * (2.0 * (TAU * u).cos()).exp() - TAU * (2.0 * TAU * u - 1.0).cos();
    // In time: the classical Runge–Kutta method over many periods, the work of the last one.
    let steps = 4000;
    let (dt, mut b, mut work) = (period / f64::from(steps), value(0.0), 0.0);
    let rate = |t: f64, b: f64| (value(t / period) - b) / relaxation;
    for cycle in 0..12 {
        work = 0.0;
        for step in 0..steps {
            let t = (f64::from(cycle * steps) + f64::from(step)) * dt;
            let power = |t: f64, b: f64| {
                (stiff * value(t / period) + branch * (value(t / period) - b)) * slope(t / period) / period
            };
            let k1 = rate(t, b);
            let k2 = rate(t + dt / 2.0, b + dt / 2.0 * k1);
            let k3 = rate(t + dt / 2.0, b + dt / 2.0 * k2);
            let k4 = rate(t + dt, b + dt * k3);
            let middle = b + dt / 4.0 * (k1 + k2);
            let end = b + dt / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
            work += dt / 6.0 * (power(t, b) + 4.0 * power(t + dt / 2.0, middle) + power(t + dt, end));
            b = end;
        }
    }
    // By the sum: π E'' a_n² a cycle and n cycles a period are Σ E''_n |B_n|²/(πn).
    let loss = |n: usize| {
        let x = TAU * n as f64 / period * relaxation;
        branch * x / (1.0 + x * x)
    };
    let sum = series(&tracks(value, slope, 300), |n| loss(n) / PI, 1e-10).expect("smooth");
    assert!((sum.total / work - 1.0).abs() < 1e-6, "{} and {work}", sum.total);
}

/// A moment EI κ + c V κ' dissipates ∮ c V² κ'² dS, by quadrature in space; its loss tangent at the n-th harmonic is 2π
/// f_n c/EI, with f_n = n V/L.
#[test]
fn a_kelvin_voigt_moment_costs_the_sum_with_its_own_loss_tangent() {
    let (length, speed, stiffness, damping) = (0.86, 24.0, 0.26, 2e-4);
    let value = |u: f64| 12.0 + 3.0 * (2.0 * (TAU * u).cos()).exp() - (2.0 * TAU * u - 1.0).sin();
    let slope =
        |u: f64| -12.0 * PI * (TAU * u).sin() * (2.0 * (TAU * u).cos()).exp() - 2.0 * TAU * (2.0 * TAU * u - 1.0).cos();
    // The trapezoidal rule is exact to rounding for a smooth periodic integrand. κ' = dκ/dS = (dκ/du)/L.
    let places = 4096;
    let square = |place: i32| (slope(f64::from(place) / f64::from(places)) / length).powi(2);
    let in_space = damping * speed * speed * length * (0..places).map(square).sum::<f64>() / f64::from(places);
    // P = V (EI/π) Σ tan δ_n |B_n|²/n.
    let tangent = |n: usize| TAU * n as f64 * speed / length * damping / stiffness;
    let sum = series(&tracks(value, slope, 300), |n| speed * stiffness / PI * tangent(n), 1e-8 * in_space);
    let by_harmonics = sum.expect("smooth").total;
    assert!((by_harmonics / in_space - 1.0).abs() < 1e-6, "{by_harmonics} and {in_space}");
}

#[test]
fn derivatives_are_those_of_finite_differences() {
    let value = |u: f64| (TAU * u).cos().exp() * (0.3 + (u - 0.5).abs());
    let slope = |u: f64| {
        let (bump, kink) = ((TAU * u).cos().exp(), 0.3 + (u - 0.5).abs());
        -TAU * (TAU * u).sin() * bump * kink + bump * if u < 0.5 { -1.0 } else { 1.0 }
    };
    let field = tracks(value, slope, 12);
    let weight = |n: usize| 1.0 + 0.3 / n as f64;
    let tolerance = 1e-7;
    let sum = series(&field, weight, tolerance).expect("ends");
    let gradient = sum.gradient(&field, weight);
    // As many harmonics as before: a difference must not see another end of the sum.
    let total = |field: &[Track]| {
        let mut integrals = super::series::Integrals::new(&[field]);
        let mut parts = [vec![(0.0, 0.0); field.len()]];
        let term = |n: usize| {
            integrals.next(&[true], &mut parts);
            let (re, im) = parts[0].iter().fold((0.0, 0.0), |sum, part| (sum.0 + part.0, sum.1 + part.1));
            weight(n) / n as f64 * (re * re + im * im)
        };
        (1..=sum.harmonics).map(term).sum::<f64>()
    };
    for (region, by) in gradient.iter().enumerate() {
        for node in 0..field[region].u.len() {
            type Pick = fn(&mut Track) -> &mut Vec<f64>;
            // The sum is quadratic in values and slopes: a large step is exact.
            let picks: [(&str, Pick, f64, f64); 3] = [
                ("u", |track| &mut track.u, by.u[node], 1e-6),
                ("value", |track| &mut track.value, by.value[node], 1e-3),
                ("slope", |track| &mut track.slope, by.slope[node], 1e-3),
            ];
            for (name, pick, found, step) in picks {
                let moved = |by: f64| {
                    let mut field = field.clone();
                    pick(&mut field[region])[node] += by;
                    total(&field)
                };
                let expected = (moved(step) - moved(-step)) / (2.0 * step);
                let size = expected.abs().max(1e-2);
                assert!((found - expected).abs() < 2e-5 * size, "{region} {node} {name}: {found} and {expected}");
            }
        }
    }
}
