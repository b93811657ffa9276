//! Files whose claims are true.

use serde_json::Value;

use crate::program::{file, numbers, run, with_status};

/// Audits a file in which every law must hold, within 20 seconds.
fn holds(name: &str) -> Value {
    let start = std::time::Instant::now();
    let ran = run(&[&file(name), "--json"]);
    assert!(start.elapsed().as_secs_f64() < 20.0);
    let audit = ran.json();
    assert_eq!((ran.code, audit["verdict"].as_str()), (0, Some("holds")), "{}", ran.out);
    assert!(audit["lies"].as_array().is_some_and(Vec::is_empty));
    for status in ["fails", "false_hypothesis", "not_tried"] {
        assert!(with_status(&audit, status).is_empty());
    }
    // Proofs, samples, problems and refusals are among the laws that held.
    let held = with_status(&audit, "holds");
    for law in ["no_constant_is_refuted", "is_positive_definite", "theorem_1_1", "prop_s_8"] {
        assert!(held.contains(&law), "{held:?}");
    }
    audit
}

#[test]
fn constants_of_a_periodic_metric_are_proved_on_all_of_space() {
    let audit = holds("right_periodic");
    let constants = &audit["constants"];
    assert!(constants["proved"] == true && constants["within"].is_null());
    // The maximum of |2 (2 − cos x) sin x| is 4.40366947…; the accuracy of proofs is 10⁻³.
    let l_h = constants["l_h"].as_f64().expect("a number");
    assert!((4.403669..4.4081).contains(&l_h), "{l_h}");
    assert_eq!(audit["region"]["why"], "one period of the formula");
}

#[test]
fn claims_that_are_attained_are_right_to_a_percentage() {
    let audit = holds("right_anisotropic");
    assert_eq!(audit["constants"]["proved"], false);
    let proved = audit["proved"].as_array().expect("an array");
    assert_eq!(proved.len(), 4);
    for standing in proved {
        let proof = standing["proof"].as_str().expect("a text");
        assert!(proof.contains("right to") || proof.ends_with("proved"), "{proof}");
    }
    // Sharp claims are also tested by making them wrong.
    let held = with_status(&audit, "holds");
    for law in ["refuses_a_larger_c1", "refuses_a_smaller_l_h", "refuses_a_smaller_m_h"] {
        assert!(held.contains(&law), "{held:?}");
    }
}

/// The corners of the region are nodes of the grid, where the third derivatives jump.
#[test]
fn a_table_is_audited_and_its_constants_are_proved_on_all_of_space() {
    let constants = &holds("right_table")["constants"];
    assert!(constants["proved"] == true && constants["within"].is_null());
}

#[test]
fn three_coordinates_are_audited() {
    assert_eq!(holds("right_three_coordinates")["dimension"], 3);
}

#[test]
fn a_metric_on_the_line_that_is_constant_far_away_has_constants_everywhere() {
    let audit = holds("right_line");
    assert!(audit["constants"]["proved"] == true && audit["constants"]["within"].is_null());
    // The derivative of exp(−x²) is largest at x = 1/√2, where it is √(2/e).
    let measured = audit["measured"].as_array().expect("an array");
    let l_h = measured.iter().find(|found| found["constant"] == "L_H").expect("measured");
    let value = l_h["value"].as_f64().expect("a number");
    assert!((value - (2.0 / std::f64::consts::E).sqrt()).abs() < 1e-6, "{value}");
}

#[test]
fn normal_distributions_are_audited_in_a_ball() {
    let audit = holds("right_ball");
    assert_eq!(audit["constants"]["within"]["radius"], 0.5);
    let [lower, upper] = ["lower", "upper"].map(|end| numbers(&audit["region"][end]));
    // The corners of the cube lie on the sphere.
    for corner in [lower, upper] {
        assert!((corner[0].hypot(corner[1]) - 0.5).abs() < 1e-15, "{corner:?}");
    }
}
