//! What is said of a search for a certificate.

use core::ops::ControlFlow;

use tautline_problem::{Failure, Question, distance::Wanted};

/// The channel below is the shorter one. From the one above no certificate reaches its gap, and the bounds
/// do not say that one did.
#[test]
fn bounds_say_whether_their_certificate_reached_its_gap() {
    for (through, reached) in [("-0.8", true), ("1", false)] {
        let file = format!(
            "metric = {{ phi = \"1 + 2*(1 - up)*(1 - down)\" }}\n\
             from = {{ point = [-3, 0] }}\nto = {{ point = [3, 0] }}\n\
             [let]\nup = \"exp(-((x2 - 1)/0.5)^2/2)\"\ndown = \"exp(-((x2 + 0.8)/0.5)^2/2)\"\n\
             [solve]\nonly_these_starts = true\nstarts = [[[-3, 0], [0, {through}], [3, 0]]]\n"
        );
        let answer = Question::read(&file).expect("a file").solve(&mut |_| ()).expect("solved");
        let bounds = answer.bounds.expect("proved");
        assert_eq!(bounds.lower_by, "a certificate");
        let certificate = bounds.certificate.expect("a certificate");
        assert_eq!(certificate.reached, reached, "{certificate:?}");
        assert_eq!(certificate.ended == "the gap is as small as wanted", reached);
    }
}

/// The set that cannot be written into a certificate is the one that is underlined.
#[test]
fn the_set_without_a_certificate_is_underlined() {
    let point = "point = [0, 0]";
    let sphere = "sphere = { centre = [3, 0], radius = 1 }";
    for (sets, end, section) in
        [([sphere, point], "first", "[from]"), ([point, sphere], "second", "[to]")]
    {
        let file = format!("[metric]\nphi = \"1\"\n[from]\n{}\n[to]\n{}\n", sets[0], sets[1]);
        let question = Question::read(&file).expect("a file");
        let found = question.certify(Wanted::gap(0.1), &mut |_| ControlFlow::Continue(()));
        let Err(Failure::BadInput(wrong)) = found else { panic!("{found:?}") };
        assert!(wrong.message.contains(&format!("the {end} set")), "{wrong}");
        assert_eq!(&file[wrong.at.clone()], section);
    }
}
