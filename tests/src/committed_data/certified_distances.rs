//! `paper/tables/certified_distances.csv`: each metric of the gallery has a certificate, and each known
//! distance lies between its bounds.

use tautline::gallery::for_each_sample;

use super::Table;

macro_rules! names {
    ($($id:ident: $name:literal, $metric:expr, dimension $D:literal, in $cell:expr,
       exact $exact:expr $(, with $distances:ident)?;)*) => { [$(($name, stringify!($D))),*] };
}

#[test]
fn every_metric_of_the_gallery_is_in_the_table_of_certified_distances() {
    let table = Table::read("tables/certified_distances.csv");
    let on_balls = [("sphere", "2"), ("hyperbolic", "2"), ("Gaussian Fisher", "2")];
    for (metric, d) in for_each_sample!(names).into_iter().chain(on_balls) {
        table.row(&[("metric", metric), ("d", d)]);
    }
}

#[test]
fn known_distances_lie_between_the_certified_bounds() {
    let table = Table::read("tables/certified_distances.csv");
    let mut known = 0;
    for row in table.rows() {
        let [lower, upper] = ["lower", "upper"].map(|bound| row.number(bound));
        assert!(0.0 < lower && lower <= upper, "{:?}", row.record);
        // The gap is printed with two digits.
        let gap = (upper - lower) / upper;
        assert!(row.number("gap") > 0.9 * gap && row.number("gap") < 1.1 * gap, "{:?}", row.record);
        assert!(gap <= row.number("gap_wanted"), "{:?}", row.record);
        if !row.text("known").is_empty() {
            let d = row.number("known");
            // Closed forms are computed with a few roundings, or by a quadrature.
            let rounding = 1e-12 * d;
            assert!(lower <= d + rounding && d - rounding <= upper, "{:?}", row.record);
            known += 1;
        }
    }
    // The others are those without a closed form, and the valleys in the plane.
    assert!(known >= 20, "only {known} distances are known");
}
