//! The derivatives of the functions of one number.

use crate::{
    graph::Graph,
    operation::{Function, Step},
};

impl Graph {
    /// Returns `f′` and `f″` at `x`, where `v = f(x)`.
    pub(super) fn slopes(&mut self, function: Function, x: Step, v: Step) -> (Step, Step) {
        match function {
            Function::Neg => (self.constant(-1.0), self.constant(0.0)),
            Function::Sqr => (self.times(x, 2.0), self.constant(2.0)),
            Function::Recip => {
                let square = self.mul(v, v);
                let cube = self.mul(square, v);
                (self.neg(square), self.times(cube, 2.0))
            }
            Function::Sqrt => {
                let reciprocal = self.apply(Function::Recip, v);
                let slope = self.times(reciprocal, 0.5);
                let bend = self.div(slope, x);
                (slope, self.times(bend, -0.5))
            }
            Function::Exp => (v, v),
            Function::Ln => {
                let slope = self.apply(Function::Recip, x);
                let square = self.mul(slope, slope);
                (slope, self.neg(square))
            }
            Function::Sin => (self.apply(Function::Cos, x), self.neg(v)),
            Function::Cos => {
                let sine = self.apply(Function::Sin, x);
                (self.neg(sine), self.neg(v))
            }
            Function::Tan => {
                let square = self.mul(v, v);
                let slope = self.plus(square, 1.0);
                let bend = self.mul(v, slope);
                (slope, self.times(bend, 2.0))
            }
            Function::Atan => {
                let square = self.mul(x, x);
                let sum = self.plus(square, 1.0);
                let slope = self.apply(Function::Recip, sum);
                let square = self.mul(slope, slope);
                let bend = self.mul(x, square);
                (slope, self.times(bend, -2.0))
            }
            Function::Sinh => (self.apply(Function::Cosh, x), v),
            Function::Cosh => (self.apply(Function::Sinh, x), v),
            Function::Tanh => {
                // Not 1 − v², which cancels where v is close to ±1.
                let cosh = self.apply(Function::Cosh, x);
                let reciprocal = self.apply(Function::Recip, cosh);
                let slope = self.mul(reciprocal, reciprocal);
                let bend = self.mul(v, slope);
                (slope, self.times(bend, -2.0))
            }
        }
    }
}
