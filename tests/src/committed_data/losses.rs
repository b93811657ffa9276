//! `paper/data/losses.csv`: each step of a proof gives an upper bound on the value before it.

use super::{Row, Table};

#[test]
fn no_step_of_a_proof_gains() {
    let table = Table::read("data/losses.csv");
    let rows: Vec<Row<'_>> = table.rows().collect();
    let same = |a: &Row<'_>, b: &Row<'_>| {
        a.text("case") == b.text("case") && a.text("chain") == b.text("chain")
    };
    let chains: Vec<_> = rows.chunk_by(same).collect();
    assert_eq!(chains.len(), 6, "two chains for each of three cases");
    for chain in chains {
        assert_eq!(chain[0].text("step"), "observed");
        for pair in chain.windows(2) {
            let [before, after] = [&pair[0], &pair[1]].map(|row| row.number("bound"));
            // The values are printed with ten digits.
            assert!(before <= after * (1.0 + 1e-9), "{:?}", pair[1].record);
        }
    }
    // Both chains start from the observed value, and the sharper chain loses less in total.
    for case in ["valleys_points", "shear_points", "separable_points"] {
        let ends = |name: &str| {
            let of_chain = |row: &&Row<'_>| row.text("case") == case && row.text("chain") == name;
            let bounds: Vec<f64> =
                rows.iter().filter(of_chain).map(|row| row.number("bound")).collect();
            (bounds[0], bounds[bounds.len() - 1])
        };
        let (paper, sharper) = (ends("theorem_1_1"), ends("theorem_d"));
        assert_eq!(paper.0, sharper.0, "{case}");
        assert!(sharper.1 < paper.1, "{case}");
    }
}
