//! The row of a problem in the results: nothing that depends on threads, on shards or on time.

use crate::{Answer, Diagnostic, Failure};

/// The columns after the id and the parameters.
pub(crate) const COLUMNS: [&str; 12] = [
    "length",
    "length_error",
    "extrapolated",
    "extrapolated_error",
    "chords",
    "stop",
    "hessian",
    "residual",
    "newton_steps",
    "other_minima",
    "status",
    "reason",
];

/// What became of a problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Status {
    /// The search converged to a strict minimum, and the chords resolve the metric.
    Solved,
    /// There is a curve, but the search or the grid is not good enough.
    Doubtful,
    /// There is no curve.
    Failed,
}

impl Status {
    fn name(self) -> &'static str {
        match self {
            Status::Solved => "solved",
            Status::Doubtful => "doubtful",
            Status::Failed => "failed",
        }
    }
}

/// Returns the fields of a problem, and what became of it.
pub(crate) fn fields(answer: &Result<Answer, Failure>) -> ([String; COLUMNS.len()], Status) {
    let mut fields = [(); COLUMNS.len()].map(|()| String::new());
    let mut set = |column: &str, value: String| {
        if let Some(index) = COLUMNS.iter().position(|name| *name == column) {
            fields[index] = value;
        }
    };
    // Each number is the shortest decimal that is read as this number.
    let number = |value: f64| format!("{value:?}");
    let (status, reason) = match answer {
        Ok(answer) => {
            set("length", number(answer.length.value));
            set("length_error", number(answer.length.error));
            if let Some(extrapolated) = &answer.extrapolated {
                set("extrapolated", number(extrapolated.value));
                set("extrapolated_error", number(extrapolated.error));
            }
            set("chords", answer.n.to_string());
            set("stop", answer.search.stop.to_owned());
            set("hessian", answer.search.hessian.clone());
            set("residual", number(answer.search.residual));
            set("newton_steps", answer.search.newton_steps.to_string());
            set("other_minima", answer.other_minima.len().to_string());
            let doubts = answer.doubts.iter().map(|doubt| doubt.text.as_str());
            let reason = doubts.collect::<Vec<_>>().join("; ");
            let status = if reason.is_empty() { Status::Solved } else { Status::Doubtful };
            (status, reason)
        }
        Err(Failure::BadInput(diagnostic)) => (Status::Failed, in_words(diagnostic)),
        Err(Failure::NotComputed(reason)) => (Status::Failed, reason.clone()),
    };
    set("status", status.name().to_owned());
    // A row is a line.
    set("reason", reason.split_whitespace().collect::<Vec<_>>().join(" "));
    (fields, status)
}

fn in_words(diagnostic: &Diagnostic) -> String {
    match &diagnostic.help {
        Some(help) => format!("{diagnostic}; {help}"),
        None => diagnostic.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::{COLUMNS, Status, fields};
    use crate::{Answer, Doubt, Estimated, Failure, OtherMinimum, Question};

    /// Every doubt is a reason why a problem is not solved.
    #[test]
    fn every_doubt_is_named() {
        let file = "[metric]\nphi = \"1 + x1^2\"\n[from]\npoint = [0]\n[to]\npoint = [1]\n\
                    [certify]\nbound = false\n";
        let answer = Question::read(file).expect("a problem").solve(&mut |_| ()).expect("solved");
        let with = |change: &dyn Fn(&mut Answer)| {
            let mut answer = answer.clone();
            change(&mut answer);
            let (fields, status) = fields(&Ok(answer));
            assert_eq!((COLUMNS[10], fields[10].as_str()), ("status", status.name()));
            (status, fields[11].clone())
        };
        let solved = (Status::Solved, String::new());
        assert_eq!(with(&|_| ()), solved);
        assert_eq!(with(&|answer| answer.within_tolerance = Some(true)), solved);
        let doubts = [Doubt::NotConverged, Doubt::Shorter { length: 0.5 }];
        let [first, second] = doubts.each_ref().map(ToString::to_string);
        assert_eq!(
            with(&|answer| answer.doubts = doubts.iter().map(Into::into).collect()),
            (Status::Doubtful, format!("{first}; {second}"))
        );
    }

    #[test]
    fn a_reason_is_one_line() {
        let (fields, status) = fields(&Err(Failure::NotComputed("no curve:\r\n  why".to_owned())));
        assert_eq!((COLUMNS[11], fields[11].as_str()), ("reason", "no curve: why"));
        assert_eq!(
            (status, fields[10].as_str(), fields[0].as_str()),
            (Status::Failed, "failed", "")
        );
    }

    /// Each column has the number of its name. All numbers of this answer are different.
    #[test]
    fn each_column_is_the_number_of_its_name() {
        let file = "[metric]\nphi = \"1 + x1^2\"\n[from]\npoint = [0]\n[to]\npoint = [1]\n\
                    [certify]\nbound = false\n";
        let mut answer =
            Question::read(file).expect("a problem").solve(&mut |_| ()).expect("solved");
        answer.length = Estimated { value: 1.5, error: 0.1 + 0.2 };
        answer.extrapolated = Some(Estimated { value: 1.25, error: 5e-324 });
        answer.n = 77;
        (answer.search.residual, answer.search.residual_floor) = (1e-300, 2e-300);
        answer.search.newton_steps = 12;
        answer.search.hessian = "3 negative eigenvalues".to_owned();
        let longer = OtherMinimum {
            length: Estimated { value: 9.0, error: 0.0 },
            curve: answer.curve.clone(),
        };
        answer.other_minima = vec![longer.clone(), longer];
        let column = |fields: &[String; COLUMNS.len()], name: &str| {
            let at = COLUMNS.iter().position(|column| *column == name).expect("a column");
            fields[at].clone()
        };
        let (found, status) = fields(&Ok(answer.clone()));
        assert_eq!(status, Status::Solved);
        for (name, value) in [
            ("length", "1.5"),
            ("length_error", "0.30000000000000004"),
            ("extrapolated", "1.25"),
            ("extrapolated_error", "5e-324"),
            ("chords", "77"),
            ("stop", "converged"),
            ("hessian", "3 negative eigenvalues"),
            ("residual", "1e-300"),
            ("newton_steps", "12"),
            ("other_minima", "2"),
            ("status", "solved"),
            ("reason", ""),
        ] {
            assert_eq!(column(&found, name), value, "{name}");
        }
        answer.extrapolated = None;
        let (found, _) = fields(&Ok(answer));
        let empty = ["extrapolated", "extrapolated_error"].map(|name| column(&found, name));
        assert_eq!(empty, ["", ""]);
    }
}
