//! One table as Markdown and as LaTeX.

use paper::layout::{Layout, scientific};

#[test]
fn both_formats_hold_every_cell() {
    let mut layout = Layout::new("A caption", "case & $|x|$");
    layout.push(vec!["a_b".to_owned(), scientific(1.5e-7, 1)]);
    layout.group();
    layout.push(vec!["c".to_owned(), scientific(f64::NAN, 1)]);
    assert_eq!(
        layout.markdown(),
        "A caption\n\n| case | $\\|x\\|$ |\n| ---: | ---: |\n\
         | a_b | $1.5\\cdot 10^{-7}$ |\n| c | – |\n"
    );
    assert_eq!(
        layout.latex(),
        "% A caption\n\\begin{tabular}{rr}\n  \\toprule\n  case & $|x|$ \\\\\n  \\midrule\n  \
         a\\_b & $1.5\\cdot 10^{-7}$ \\\\\n  \\addlinespace\n  c & – \\\\\n  \
         \\bottomrule\n\\end{tabular}\n"
    );
}

#[test]
fn numbers_of_size_one_have_no_exponent() {
    assert_eq!(scientific(2.5, 3), "$2.500$");
    assert_eq!(scientific(0.0, 3), "$0$");
    assert_eq!(scientific(-31.0, 1), "$-3.1\\cdot 10^{1}$");
}
