//! How many decades each step of a proof loses.

use tautline::bounds::{
    c_tra, k1_g, k2_sharp, polyline_gap_trapezoidal, theorem_1_1_excess, theorem_d_excess,
    theorem_d_polyline_gap,
};
use tautline_statements::Evidence;

use crate::{
    Failure,
    artefact::Artefact,
    case::{Case, PaperRule, paper_bound, subintervals},
    cases::cases_named,
    data::{Data, Tolerance},
    drawing::{self, Align, Axis, Colour, Curve, Note, Panel, Scale, Scene, palette},
    observation::Observation,
    sweep::Sweep,
};

pub(super) const FIGURE: Artefact = Artefact::figure(
    "losses",
    "the steps from the observed excess E - d^2 of the trapezoidal rule with N = 256 to \
     the bound C/sqrt(N) of Theorem 1.1, and to that of Theorem D, each with the decades \
     that it gives away",
    data,
    draw,
);

const N: usize = 256;

const CASES: [(&str, &str); 3] = [
    ("valleys_points", "valleys, $(0,0)$ to $(4π,0)$"),
    ("shear_points", "shear, $(0,0)$ to $(2,3)$"),
    ("separable_points", "separable, $D = 3$"),
];

/// A chain of estimates, and its steps with their names in the figure.
#[derive(Clone, Copy)]
struct Chain {
    name: &'static str,
    colour: Colour,
    steps: &'static [(&'static str, &'static str)],
}

const CHAINS: [Chain; 2] = [
    Chain {
        name: "theorem_1_1",
        colour: palette::VERMILLION,
        steps: &[
            ("observed", "observed"),
            ("sum_of_cubes", "Lemma S.2: $|H - H_n| ≤ L_H|x - m_n|$"),
            ("root_of_n", "Prop. 7.8: mean$\u{2009}|β|^3 ≤ √{N} K_3^3$"),
            ("minimum_gap", "Prop. 7.7: $\"min\" E_N - d^2 ≤ C_\"tra\"(N)$"),
            ("speed", "$K\u{304}_3$ for $K_3$, by $C_\"tra\"(N)$"),
            ("uniform", "$C_\"tra\"^♯$ for $N C_\"tra\"(N)$"),
            ("christoffel", "Christoffel symbols in $K_2$"),
            ("one_constant", "$C/√{N}$ of Theorem 1.1"),
        ],
    },
    Chain {
        name: "theorem_d",
        colour: palette::GREEN,
        steps: &[
            ("observed", "observed"),
            ("sum_of_fourths", "Lemma S.2: $|D^2H| ≤ M_H$"),
            ("spread", "Lemma S.5: spread of the speeds"),
            ("minimum_gap", "Lemma S.4: $\"min\" E_N$, Theorem D"),
        ],
    },
];

fn data(_sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[
        ("case n chain step", Tolerance::Exact),
        // The first steps are differences of energies up to 700, each with an error of 1e-12.
        ("bound", Tolerance::Close { relative: 1e-6, absolute: 2e-10 }),
    ]);
    for case in cases_named(&CASES.map(|(name, _)| name))? {
        let seen = case.solve(PaperRule::Trapezoidal, N)?;
        let [prop_7_9, lemma_s_2] = case.gaps(N)?;
        let chains = [paper(&case, &seen, &prop_7_9)?, sharper(&case, &seen, &lemma_s_2)?];
        for (Chain { name: chain, steps, .. }, values) in CHAINS.into_iter().zip(chains) {
            // By the proofs, each step bounds the previous one, up to rounding.
            if let Some(k) = (1..values.len()).find(|&k| !(values[k - 1] <= values[k] * 1.000_001))
            {
                let (name, step) = (case.name, steps[k].0);
                let claim = format!("{name}, {chain}: {step} is below the step before it");
                return Err(Failure::Violated(claim));
            }
            for ((step, _), value) in steps.iter().zip(values) {
                let names = [case.name, &N.to_string(), chain, step].map(str::to_owned);
                data.push(names.into_iter().chain([format!("{value:.9e}")]));
            }
        }
    }
    Ok(data)
}

/// Returns the steps to Theorem 1.1, each of which is a bound on `E(γᵖˡ) − d²`, in `m²`.
///
/// `K₂` is taken from Lemma S.1 up to the step that replaces it by the paper's `K₂`, which depends
/// on `D`.
///
/// Where the sequence itself enters, the bounds come from the evaluation of Proposition 7.9. Where
/// an estimate of `K₃` replaces the `K₃` of the sequence, its bound is evaluated with that
/// estimate.
fn paper(case: &Case, seen: &Observation, prop_7_9: &Evidence) -> Result<Vec<f64>, Failure> {
    let (setting, constants, n) = (case.setting, case.setting.constants(), subintervals(seen.n)?);
    let minimum = seen.discrete_energy - case.distance_squared;
    let [k1, k2] = [k1_g(setting), k2_sharp(setting)];
    let [cubes, of_k3] =
        ["|E(γᵖˡ) − E_tra,N| ≤ L_H mean|β|³/4N", "|E(γᵖˡ) − E_tra,N| ≤ L_H K₃³/4√N"]
            .map(|claim| prop_7_9.conclusion(claim).bound);
    let gap = |k3: f64| polyline_gap_trapezoidal(constants, k3, n);
    // K̄₃² = K₁² + C/c₁, where C bounds min E_N − d².
    let speed = |c: f64| (k1 * k1 + c / constants.c1()).sqrt();
    let of_n = c_tra(constants, k1, k2, n);
    let uniform = c_tra(constants, k1, k2, subintervals(1)?);
    Ok(vec![
        seen.energy.value - case.distance_squared,
        minimum + cubes,
        minimum + of_k3,
        of_n + of_k3,
        of_n + gap(speed(of_n)),
        uniform / seen.n as f64 + gap(speed(uniform)),
        theorem_1_1_excess(setting, n),
        paper_bound(setting, PaperRule::Trapezoidal, n),
    ])
}

/// Returns the steps to Theorem D.
fn sharper(case: &Case, seen: &Observation, lemma_s_2: &Evidence) -> Result<Vec<f64>, Failure> {
    let (setting, n) = (case.setting, subintervals(seen.n)?);
    let minimum = seen.discrete_energy - case.distance_squared;
    let known = |bound: Option<f64>| {
        bound.ok_or_else(|| Failure::Data(format!("{}: M_H is not known", case.name)))
    };
    Ok(vec![
        seen.energy.value - case.distance_squared,
        minimum + lemma_s_2.conclusion("|E(γᵖˡ) − E_tra,N| ≤ M_H mean|β|⁴/24N²").bound,
        minimum + known(theorem_d_polyline_gap(setting, n))?,
        known(theorem_d_excess(setting, n))?,
    ])
}

fn draw(data: &Data) -> Result<Scene, Failure> {
    let decades = |value: f64| value.log10();
    let mut rows = Vec::new();
    for Chain { name: chain, colour, steps } in CHAINS {
        let mut panels = Vec::new();
        for (k, (case, title)) in CASES.into_iter().enumerate() {
            let of_case = || data.rows_with("case", case);
            let all = || of_case().map(|row| row.number("bound"));
            let (least, most) = (all().fold(f64::INFINITY, f64::min), all().fold(0.0, f64::max));
            let of_chain = of_case().filter(|row| row.text("chain") == chain);
            let values: Vec<f64> = of_chain.map(|row| row.number("bound")).collect();
            // There is a decade before the first bar, and room for a number after the last one.
            let from = 10_f64.powi(decades(least).floor() as i32 - 1);
            let to = 10_f64.powi((decades(most) + 0.36 * decades(most / least)).ceil() as i32);
            let first_chain = chain == CHAINS[0].name;
            let x = Axis::new(Scale::Decades, from, to)?;
            let x = if first_chain { x } else { x.labelled("bound of $E(γ^\"pl\") - d^2$") };
            let y = Axis::of_names(steps.iter().rev().map(|(_, name)| *name))?;
            let y = if k == 0 { y } else { y.unnumbered() };
            let mut panel = Panel::new(x, y).tall(28.0 * steps.len() as f64 + 12.0);
            if first_chain {
                panel = panel.titled(format!("({}) {title}", ["a", "b", "c"][k]));
            }
            panels.push(bars(panel, &values, from, colour));
        }
        rows.push(panels);
    }
    let title = "Steps of the proofs of Theorems 1.1 and D, and what each gives away";
    Ok(drawing::Figure::new(960.0, title, rows).draw()?)
}

/// Draws one bar for each step, from the previous bound to its own, with the decades between them.
fn bars(mut panel: Panel, values: &[f64], from: f64, colour: Colour) -> Panel {
    let height = |k: usize| (values.len() - k) as f64;
    for (k, &value) in values.iter().enumerate() {
        let y = height(k);
        let before = if k == 0 { from } else { values[k - 1] };
        let shade = if k == 0 { palette::GREY } else { colour };
        panel = panel.curve(Curve::new([(before, y), (value, y)], shade).wide(11.0));
        if k + 1 < values.len() {
            let thread = Curve::new([(value, y), (value, height(k + 1))], palette::GREY);
            panel = panel.curve(thread.wide(0.8));
        }
        if k > 0 {
            let number = format!("$×10^{{{:.1}}}$", (value / before).log10());
            let note = Note::new((value, y), number, palette::INK, Align::Left);
            panel = panel.note(note.shifted(6.0, 0.0));
        }
    }
    panel
}
