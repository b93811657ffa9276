//! What is false in the paper as printed: a witness, a repair, and the statements that rely on it.

use tautline_statements::{Statement, Verdict, errata};

use crate::{
    Failure,
    artefact::Artefact,
    data::{Data, Tolerance},
    layout::{Layout, scientific},
    sweep::Sweep,
};

pub(super) const TABLE: Artefact = Artefact::table(
    "errata",
    "the statements that are false as printed, each with a witness and its two numbers (observed \
     above bound), the repaired form, and the statements that rely on it",
    data,
    layout,
)
.with_pages(pages);

/// The numbers are small fractions, evaluated by quadrature.
const NUMBER: Tolerance = Tolerance::Close { relative: 1e-6, absolute: 1e-9 };

fn data(_sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[
        ("number label printed witness", Tolerance::Exact),
        ("observed bound", NUMBER),
        ("repair relied_on_by", Tolerance::Exact),
    ]);
    for erratum in errata()? {
        let (statement, violated) = (erratum.statement, erratum.violated);
        // The number is printed without −0 and without digits that are rounding errors.
        let number = |value: f64| format!("{:.6}", (value * 1e6).round() / 1e6 + 0.0);
        data.push(vec![
            statement.number().to_owned(),
            statement.label().to_owned(),
            violated.claim.to_owned(),
            erratum.witness.to_owned(),
            number(violated.observed),
            number(violated.bound),
            statement.verdict().remark().to_owned(),
            erratum.relied_on_by.to_owned(),
        ]);
    }
    Ok(data)
}

fn layout(data: &Data) -> Result<Layout, Failure> {
    let mut layout = Layout::new(
        "Statements that are false as printed: a witness has the observed number where the printed \
         form allows at most the bound.",
        "statement & observed & bound",
    );
    for row in data.rows() {
        layout.push(vec![
            row.text("number").to_owned(),
            scientific(row.number("observed"), 3),
            scientific(row.number("bound"), 3),
        ]);
    }
    Ok(layout)
}

/// Misprints, each with its place. None of them changes a result.
const MISPRINTS: [&str; 14] = [
    "Section 2 refers to Section 6 for the failure of discretised lengths; it is in Section 5.",
    "Proposition 3.3: the norm in the last display lacks its subscript.",
    "Proposition 4.1 cites the theorem that Proposition 4.3 cites, for another fact.",
    "Proposition 4.2: the radius ε/2 in its proof does not fit near the ends of [0, 1], and points \
     that coincide are not covered; then the curve is constant.",
    "Lemma 4.4: its proof divides by the speed, which is 0 where the points coincide; then the curve \
     is constant.",
    "Section 5: that a minimal curve is monotone is shown by the intermediate value theorem in a \
     way that does not cover a curve which leaves the interval on both sides; on a shorter interval \
     it does.",
    "Proposition 7.1: the left-endpoint energy is not symmetric, as its proof has it; the bound works \
     from either end all the same.",
    "Proposition 7.3: the first ≤ of its proof is an equality.",
    "Proposition 7.5: the hypothesis bounds H at x₁ where it means every x.",
    "Proposition 7.6: in (7.5) an equality sign stands for ≤, and the two half distances to the \
     midpoint are counted as whole ones.",
    "Proposition 7.9 does not repeat that H is Lipschitz, which it needs; it does not need c₁ and c₂.",
    "Proposition 7.10: the bound by L h/h stands outside of its limit.",
    "Theorem 1.1: its proof ends with C/√N for the upper bound, where C_tra♯/N was shown and C/N is \
     claimed.",
    "Proposition 8.1: the first display of the proof lacks the factor 1/N, and \
     (7.8) is cited where it is not needed.",
];

/// Returns `ERRATA.md`, the errata for readers.
fn pages(data: &Data) -> Vec<(&'static str, String)> {
    let mut text = "\
# Errata

What is false in the paper as printed: the smallest witness that we know, the true form, and the statements that rely on it.
No theorem falls: wherever a refuted statement is used, the case at hand is covered by its repaired form.
`cargo xtask tables errata` evaluates every witness and writes this page together with `tables/errata.csv`.

"
    .to_owned();
    for row in data.rows() {
        text += &format!(
            "## {}\n\n- printed: {}\n- witness: {}; observed {}, bound {}\n- repaired: {}\n- relied \
             on by: {}\n- label: `{}`\n\n",
            row.text("number"),
            row.text("printed").replace('|', "∣"),
            row.text("witness").replace('|', "∣"),
            row.text("observed"),
            row.text("bound"),
            row.text("repair"),
            row.text("relied_on_by"),
            row.text("label"),
        );
    }
    text += "## To be read with care\n\n";
    for statement in Statement::ALL {
        if let Verdict::HoldsReadAs(reading) = statement.verdict() {
            text += &format!("- {}: {reading}.\n", statement.number());
        }
    }
    text += "- Propositions 4.3 and 6.2 need a connected manifold, since distances are otherwise not finite; \
             R^D is connected.\n- The constant C of Theorems 1.1 to 1.4 depends on D, through K_{2,g}.\n- \
             *Trapezoidal rule*: H is read at the midpoint of each chord, which elsewhere is the \
             midpoint rule.\n\n## The open question\n\n";
    for statement in Statement::ALL {
        if let Verdict::OpenAnsweredBy(answer) = statement.verdict() {
            text += &format!(
                "{} leaves open whether the rates of E(γᵖˡ) and L(γᵖˡ)² can be improved under \
                 additional discrete regularity or equidistribution information.\nAnswer: \
                 {answer}.\n\n",
                statement.number()
            );
        }
    }
    text += "## Misprints and gaps\n\n";
    for misprint in MISPRINTS {
        text += &format!("- {misprint}\n");
    }
    vec![("ERRATA.md", text)]
}
