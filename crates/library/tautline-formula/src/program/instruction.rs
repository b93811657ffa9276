//! `Instruction`: an operation on whole registers.

use crate::{operation::Function, program::Register};

/// One instruction: the register of the result, followed by the registers of the operands.
///
/// Fused instructions round after each operation, as separate instructions would. They do not use
/// fused multiply-add, which some processors lack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Instruction {
    /// `a + b`.
    Add(Register, [Register; 2]),
    /// `a − b`.
    Sub(Register, [Register; 2]),
    /// `a b`.
    Mul(Register, [Register; 2]),
    /// `a / b`.
    Div(Register, [Register; 2]),
    /// `a + c`.
    Plus(Register, Register, f64),
    /// `c − a`.
    From(Register, Register, f64),
    /// `c a`.
    Times(Register, Register, f64),
    /// `a / c`.
    Over(Register, Register, f64),
    /// `f(a)`.
    Of(Function, Register, Register),
    /// The sine and the cosine of a number.
    SinCos([Register; 2], Register),
    /// `c x + d (a b)`.
    Mixed(Register, [Register; 3], [f64; 2]),
    /// Begins a sum with up to four `c x`, or adds them to it.
    Linear { begins: bool, count: u8, x: [Register; 4], c: [f64; 4] },
    /// Begins a sum with up to two `c (a b)`, or adds them to it.
    Products { begins: bool, count: u8, a: [Register; 2], b: [Register; 2], c: [f64; 2] },
    /// Ends a sum.
    Done(Register),
    /// A partial derivative of a table.
    Table { to: Register, table: u32, orders: [u8; 3], axes: u8, u: [Register; 3] },
}
