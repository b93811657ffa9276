//! `CheckError`: why a certificate proves nothing.

/// Why a certificate is refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CheckError {
    /// A line of the file is not what has to stand there.
    #[error("line {line}: {found:?} where {expected} should be")]
    Line {
        /// The line, counted from 1.
        line: usize,
        /// What should be there.
        expected: &'static str,
        /// What is there.
        found: String,
    },
    /// The dimension has no checker.
    #[error("dimension {dimension}: only 1 to 4 can be checked")]
    Dimension {
        /// The dimension in the file.
        dimension: usize,
    },
    /// A side of cubes is out of range.
    #[error("cubes of side 2^{exponent}: exponents are between -200 and 200")]
    Side {
        /// The exponent.
        exponent: i32,
    },
    /// A cube is too far from the origin.
    #[error("a cube at {place} sides from the origin: at most 2^28 are allowed")]
    Place {
        /// Its place along one axis, in sides.
        place: i32,
    },
    /// The cubes of a level are too far from each other.
    #[error("a box around the cubes of a level has more than 2^48 places")]
    Apart,
    /// The formula is too long.
    #[error("the formula has {lines} lines: at most {most} are allowed")]
    Formula {
        /// The number of lines.
        lines: usize,
        /// The most lines.
        most: usize,
    },
    /// A set is neither a point, a ball, a box or a half-space, nor a union of these.
    #[error("{kind} is no set of a certificate")]
    Set {
        /// The kind of set, with its article.
        kind: &'static str,
    },
    /// The offset of a half-space is too large for its normal.
    #[error("a half-space with the offset {offset:e} and a normal of at most {normal:e}: too far")]
    HalfSpace {
        /// The offset.
        offset: f64,
        /// The largest magnitude of a coordinate of the normal.
        normal: f64,
    },
    /// A set is too far from the origin for cubes of this size.
    #[error("cubes of side 2^{exponent} near the sets are too far from the origin: move it")]
    TooFar {
        /// The exponent.
        exponent: i32,
    },
    /// A list of numbers does not have one number for each node.
    #[error("{found} numbers for {nodes} nodes of level {level}")]
    Values {
        /// The level, from 0.
        level: usize,
        /// The number of nodes.
        nodes: usize,
        /// The number of numbers.
        found: usize,
    },
    /// A number of a level is not finite.
    #[error("level {level} has the value {value} at node {node}")]
    NotFinite {
        /// The level, from 0.
        level: usize,
        /// The node, from 0.
        node: usize,
        /// The value.
        value: f64,
    },
    /// The cubes of a level are neither as large as those of the level before nor half as large.
    #[error("level {level} has cubes of side 2^{exponent} after cubes of side 2^{before}")]
    Sides {
        /// The level, from 0.
        level: usize,
        /// The exponent of its side.
        exponent: i32,
        /// The exponent of the level before.
        before: i32,
    },
    /// A cube that may meet a short curve is missing in a level.
    #[error("level {level} lacks the cube at {place:?}, which a short curve may meet")]
    Missing {
        /// The level, from 0.
        level: usize,
        /// The place of the cube, in sides.
        place: Vec<i32>,
    },
    /// There are no levels, or a level has no cubes.
    #[error("the certificate has no levels, or a level without cubes")]
    Empty,
    /// The bound `hi` is not a positive number.
    #[error("the bound hi is {hi}")]
    Bound {
        /// The bound.
        hi: f64,
    },
    /// The bound `c₁` of the metric could not be proved near the sets.
    #[error("c1 = {c1:e} is not proved within {radius:e} of the sets")]
    Constant {
        /// The constant.
        c1: f64,
        /// The distance from the sets.
        radius: f64,
    },
    /// The declared bound `c₁` of the metric is no bound.
    #[error("the declared c1 is {c1:e}, which is not a positive number")]
    Declared {
        /// The constant.
        c1: f64,
    },
    /// The tubes are too thin to hold all short curves.
    #[error("tubes of radius {radius:e} with c1 = {c1:e} do not hold all curves shorter than {hi}")]
    Tubes {
        /// The radius.
        radius: f64,
        /// The constant.
        c1: f64,
        /// The length of the curves.
        hi: f64,
    },
    /// Neither set is bounded, or the region needs a bounded one.
    #[error("the region of this kind needs bounded sets")]
    Unbounded,
    /// The region has more cubes than can be checked, or far more than the first level has.
    #[error("the region has more than {most} cubes")]
    TooLarge {
        /// The limit.
        most: usize,
    },
    /// Short curves may leave the cubes of the first level.
    #[error("a curve of length {least} may leave the cubes, which is less than {hi}")]
    Exit {
        /// A lower bound on the length of such curves.
        least: f64,
        /// The length that it has to reach.
        hi: f64,
    },
    /// Two entries of the matrix that mirror each other are different steps. They might differ, or one
    /// might be undefined where the other is not.
    #[error(
        "the entries ({}, {}) and ({}, {}) of the matrix are different steps",
        row + 1, column + 1, column + 1, row + 1
    )]
    Halves {
        /// The row, from 0.
        row: usize,
        /// The column, from 0.
        column: usize,
    },
    /// An end of the curve does not lie in its set.
    #[error("the {end} point of the curve does not lie in its set")]
    CurveEnd {
        /// `first` or `last`.
        end: &'static str,
    },
    /// The curve is not proved to stay where the metric is defined and positive definite.
    #[error("on chord {chord} of the curve, H is not proved to be defined and positive definite")]
    CurveDomain {
        /// The chord, from 0. A curve without chords has chord 0, its only point.
        chord: usize,
    },
    /// The curve has no proved length below `hi`.
    #[error("the curve has length at most {length}, which is not below {hi}")]
    CurveLength {
        /// The upper bound on its length.
        length: f64,
        /// The bound of the certificate.
        hi: f64,
    },
    /// The check would take longer than a file of this size is worth.
    #[error("the check needs more than {budget} units of work, the most for a file of this size")]
    Work {
        /// The most units.
        budget: u64,
    },
    /// The check was stopped. The certificate is neither proved nor refused.
    #[error(
        "stopped after {levels} of {of} levels: what follows is not checked, and nothing is proved"
    )]
    Stopped {
        /// The number of levels that were checked, after the region and the curve.
        levels: usize,
        /// The number of levels.
        of: usize,
    },
    /// The proof contradicts the curve. One of the two is wrong, and nothing is proved.
    #[error(
        "the distance is at least {lower}, but there is a curve of length {upper}: a contradiction"
    )]
    Contradiction {
        /// The lower bound.
        lower: f64,
        /// The length of the curve.
        upper: f64,
    },
}
