//! Metrics of the gallery by their names in a file.

use tautline::{Formula, Metric, gallery::*};
use tautline_problem::{Question, problem_schema};

#[track_caller]
fn assert_records<const D: usize>(
    name: &str,
    parameters: &str,
    metric: Result<impl Metric<D>, GalleryError>,
) {
    let file = format!("dimension = {D}\n[metric.gallery.{name}]\n{parameters}");
    let question = Question::read(&file).unwrap_or_else(|error| panic!("{name}: {error}"));
    let recorded = Formula::record(&metric.expect("parameters")).expect("recorded");
    assert_eq!(question.formula::<D>(), Ok(recorded), "{name}");
}

#[test]
fn a_metric_of_the_gallery_is_the_one_in_rust() {
    assert_records::<1>("valleys", "", Ok(Valleys));
    assert_records::<4>("valleys", "", Ok(Valleys));
    assert_records::<1>("ramp", "amplitude = 0.5\nwave_number = 2", Ramp::new(0.5, 2.0));
    assert_records::<2>(
        "separable",
        "amplitudes = [0.3, 0.5]\nwave_numbers = [1, 2]",
        Separable::<2>::new([0.3, 0.5], [1.0, 2.0]),
    );
    assert_records::<2>("shear", "amplitude = 0.5\nwave_number = 2", Shear::new(0.5, 2.0));
    assert_records::<3>("lens", "height = 1\nwidth = 0.5", Lens::new(1.0, 0.5));
    assert_records::<2>("bump", "height = 1\nwidth = 0.5", Bump::new(1.0, 0.5));
    assert_records::<2>("hill", "height = 0.7\nwidth = 0.5", Hill::new(0.7, 0.5));
    assert_records::<2>(
        "soft_obstacles",
        "obstacles = [{ centre = [0, 1], height = 2, width = 0.5 }]",
        SoftObstacles::<2>::new(vec![Obstacle {
            centre: [0.0, 1.0].into(),
            height: 2.0,
            width: 0.5,
        }]),
    );
    assert_records::<2>("swirl", "angle = 1\nwidth = 0.5", Swirl::new(1.0, 0.5));
    assert_records::<2>("egg_crate", "amplitude = 0.5\nwave_number = 2", EggCrate::new(0.5, 2.0));
    assert_records::<3>(
        "corrugated",
        "amplitude = 0.5\nwave_number = 2",
        Corrugated::new(0.5, 2.0),
    );
    assert_records::<2>("checkerboard", "height = 2\ncell = 1.5", Checkerboard::new(2.0, 1.5));
    assert_records::<2>(
        "two_channels",
        "height = 2\noffset = 1\nwidth = 0.5",
        TwoChannels::new(2.0, 1.0, 0.5),
    );
    assert_records::<2>(
        "rotating_anisotropy",
        "eigenvalues = [1, 4]\nwave_vector = [0.5, 1.5]",
        RotatingAnisotropy::new([1.0, 4.0], [0.5, 1.5]),
    );
    assert_records::<2>("two_link_arm", "a = 4\nb = 0.8\nc = 1", TwoLinkArm::new(4.0, 0.8, 1.0));
    assert_records::<3>("coupled_cosines", "", Ok(CoupledCosines));
    assert_records::<3>("sphere", "", Ok(Sphere));
    assert_records::<3>("hyperbolic", "", Ok(Hyperbolic));
    assert_records::<2>("gaussian_fisher", "", Ok(GaussianFisher));
    assert_records::<2>("sphere_patch", "radius = 1", SpherePatch::new(1.0));
    assert_records::<2>("hyperbolic_patch", "radius = 0.5", HyperbolicPatch::new(0.5));
    assert_records::<2>("gaussian_fisher_patch", "rim = 0.75", GaussianFisherPatch::new(0.75));
}

#[test]
fn a_metric_without_parameters_needs_its_name_alone() {
    let question =
        |gallery: &str| Question::read(&format!("dimension = 2\n[metric]\ngallery = {gallery}\n"));
    let by_table = question("{ valleys = {} }").expect("a metric");
    let by_name = question("\"valleys\"").expect("a metric");
    assert_eq!(by_name.formula::<2>(), by_table.formula::<2>());
    let refused = |gallery| question(gallery).expect_err("a mistake").to_string();
    let message = refused("\"shear\"");
    assert!(message.contains("amplitude is missing"), "{message}");
    let message = refused("{ valleys = {}, sphere = {} }");
    assert!(message.contains("a second metric, "), "{message}");
    let message = refused("\"valeys\"");
    assert!(message.contains("valleys"), "{message}");
}

/// Returns the names of the gallery with the names of their parameters, from the schema.
fn names_and_parameters() -> Vec<(String, Vec<String>)> {
    let schema = problem_schema().to_value();
    let types = &schema["$defs"];
    let metrics = types["GalleryFile"]["oneOf"].as_array().expect("a list").iter();
    let metric = |one: &serde_json::Value| {
        let (name, of) = one["properties"].as_object()?.iter().next()?;
        let of = of["$ref"].as_str()?.rsplit('/').next()?;
        let own = types[of]["properties"].as_object().into_iter().flatten();
        Some((name.clone(), own.map(|(name, _)| name.clone()).collect()))
    };
    metrics.map(|one| metric(one).expect("a metric")).collect()
}

#[test]
fn the_schema_lists_the_metrics_that_need_their_name_alone() {
    let schema = problem_schema().to_value();
    let alone = schema["$defs"]["FromGallery"]["anyOf"][0]["enum"].as_array().expect("a list");
    let alone: Vec<_> = alone.iter().filter_map(|name| name.as_str()).collect();
    let metrics = names_and_parameters();
    assert_eq!(metrics.len(), 22);
    for (name, parameters) in &metrics {
        let read = Question::read(&format!("dimension = 2\n[metric]\ngallery = \"{name}\"\n"));
        assert_eq!(read.is_ok(), parameters.is_empty(), "{name}");
        assert_eq!(alone.contains(&name.as_str()), parameters.is_empty(), "{name}");
    }
}

#[test]
fn the_guide_lists_the_gallery() {
    let page = include_str!("../../../../../guide/pages/gallery.md");
    let rows: Vec<_> = page.lines().filter(|line| line.starts_with("| `")).collect();
    let metrics = names_and_parameters();
    assert_eq!(rows.len(), metrics.len());
    for ((name, mut parameters), row) in metrics.into_iter().zip(rows) {
        let cells: Vec<_> = row.split(" | ").collect();
        assert_eq!(cells[0], format!("| `{name}`"));
        let mut listed: Vec<_> = cells[1].split('`').skip(1).step_by(2).collect();
        if name == "soft_obstacles" {
            listed.truncate(1);
        }
        listed.sort_unstable();
        parameters.sort_unstable();
        assert_eq!(listed, parameters, "{name}");
    }
}
