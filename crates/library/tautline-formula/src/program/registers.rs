//! `Registers`: the memory of a program, and the interpreter.

use nalgebra::SVector;
use tautline_scalar::Table;

use crate::{
    functions,
    operation::Function,
    program::{
        Instruction, Program, Register,
        row::{Chunk, Row},
    },
};

/// The number of lanes of one chunk. The number of lanes of a row is a multiple of it.
pub const WIDTH: usize = 8;

/// Which processor instructions to use. The results are the same bit for bit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum InstructionSet {
    /// The instructions that every processor of the architecture has.
    Baseline,
    /// The widest instructions of this processor.
    #[default]
    Widest,
}

/// Registers, each a row of lanes.
#[derive(Clone, Debug)]
pub struct Registers {
    rows: Vec<Row>,
    /// Rows in which results are made before they are swapped into a register.
    spare: [Row; 2],
    /// The number of chunks in use, and the number of lanes requested.
    used: usize,
    count: usize,
    instruction_set: InstructionSet,
}

impl Registers {
    /// Allocates registers for a program, with this many lanes rounded up to the [`WIDTH`].
    pub(crate) fn new(program: &Program, lanes: usize, instruction_set: InstructionSet) -> Self {
        let chunks = lanes.div_ceil(WIDTH).max(1);
        let mut rows: Vec<_> = (0..program.registers()).map(|_| Row::new(chunks)).collect();
        for &(register, value) in &program.constants {
            rows[register as usize] = Row::filled(chunks, value);
        }
        Self {
            rows,
            spare: [Row::new(chunks), Row::new(chunks)],
            used: chunks,
            count: chunks * WIDTH,
            instruction_set,
        }
    }

    /// Allocates registers without a program.
    pub(crate) fn empty(rows: usize, lanes: usize) -> Self {
        let none = Program {
            instructions: Vec::new(),
            count: rows,
            constants: Vec::new(),
            tables: Vec::new(),
            outputs: Vec::new(),
        };
        Self::new(&none, lanes, InstructionSet::Baseline)
    }

    /// Returns how many lanes were requested. A few more may be filled.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }

    /// Returns the point and the vector of a lane.
    pub(crate) fn input<const D: usize>(&self, lane: usize) -> (SVector<f64, D>, SVector<f64, D>) {
        let row = |i: usize| self.rows[i].as_flattened()[lane];
        (SVector::from_fn(|i, _| row(i)), SVector::from_fn(|i, _| row(D + i)))
    }

    /// Returns coordinate `i` of the points and of the vectors.
    #[inline]
    pub(crate) fn input_rows(&mut self, dimension: usize, i: usize) -> [&mut [f64]; 2] {
        let (places, vectors) = self.rows.split_at_mut(dimension);
        [&mut places[i], &mut vectors[i]].map(|row| row.as_flattened_mut())
    }

    /// Overwrites a result in one lane until the program runs again. Do not overwrite other
    /// registers, such as constants, because the program reads them.
    ///
    /// # Panics
    ///
    /// If there is no such register or lane.
    pub fn set(&mut self, register: Register, lane: usize, value: f64) {
        self.rows[register as usize].as_flattened_mut()[lane] = value;
    }

    /// Overwrites results in one lane, as many as there are registers.
    pub(crate) fn set_all(&mut self, registers: &[Register], lane: usize, values: &[f64]) {
        for (&register, &value) in registers.iter().zip(values) {
            self.set(register, lane, value);
        }
    }

    /// Returns the greatest number of lanes.
    #[must_use]
    pub fn lanes(&self) -> usize {
        self.spare[0].len() * WIDTH
    }

    /// Returns the row of a register.
    #[must_use]
    #[inline]
    pub fn row(&self, register: Register) -> &[f64] {
        self.rows[register as usize].as_flattened()
    }

    /// Returns the first registers: those of the point and those of the vector.
    #[inline]
    pub(crate) fn inputs<const D: usize>(&mut self) -> [[&mut [f64]; D]; 2] {
        let (place, rest) = self.rows.split_first_chunk_mut::<D>().expect("2 D registers");
        let (vector, _) = rest.split_first_chunk_mut::<D>().expect("2 D registers");
        [place, vector].map(|rows| rows.each_mut().map(|row| row.as_flattened_mut()))
    }

    /// Restricts work to the first `lanes`, rounded up to the [`WIDTH`], and returns their number.
    pub(crate) fn set_used(&mut self, lanes: usize) -> usize {
        self.used = lanes.div_ceil(WIDTH).clamp(1, self.spare[0].len());
        self.count = lanes;
        self.used * WIDTH
    }

    /// Copies lane `count − 1` of the first `registers` registers to all lanes from `count` to
    /// `used`.
    pub(crate) fn repeat(&mut self, registers: usize, count: usize, used: usize) {
        for row in &mut self.rows[..registers] {
            let row = row.as_flattened_mut();
            let last = row[count - 1];
            row[count..used].fill(last);
        }
    }

    /// Runs the program that the registers were made for.
    pub(crate) fn run(&mut self, program: &Program) {
        match self.instruction_set {
            InstructionSet::Baseline => run_baseline(self, program),
            InstructionSet::Widest => run_widest(self, program),
        }
    }

    #[inline(always)]
    fn run_inline(&mut self, program: &Program) {
        let Self { rows, spare: [out, other], used, .. } = self;
        let used = *used;
        for instruction in &program.instructions {
            macro_rules! row {
                ($register:expr) => {
                    &rows[$register as usize][..]
                };
            }
            macro_rules! done {
                ($register:expr) => {
                    std::mem::swap(&mut rows[$register as usize], out)
                };
            }
            macro_rules! unary {
                ($to:expr, $a:expr, $f:expr) => {{
                    unary(out, used, row!($a), $f);
                    done!($to)
                }};
            }
            macro_rules! binary {
                ($to:expr, $operands:expr, $f:expr) => {{
                    binary(out, used, [row!($operands[0]), row!($operands[1])], $f);
                    done!($to)
                }};
            }
            macro_rules! function {
                ($to:expr, $a:expr, $f:path) => {{
                    for (y, x) in out[..used].iter_mut().zip(&row!($a)[..used]) {
                        $f(y, x);
                    }
                    done!($to)
                }};
            }
            match *instruction {
                Instruction::Add(to, ab) => binary!(to, ab, |a, b| a + b),
                Instruction::Sub(to, ab) => binary!(to, ab, |a, b| a - b),
                Instruction::Mul(to, ab) => binary!(to, ab, |a, b| a * b),
                Instruction::Div(to, ab) => binary!(to, ab, |a, b| a / b),
                Instruction::Plus(to, a, c) => unary!(to, a, |a| a + c),
                Instruction::From(to, a, c) => unary!(to, a, |a| c - a),
                Instruction::Times(to, a, c) => unary!(to, a, |a| a * c),
                Instruction::Over(to, a, c) => unary!(to, a, |a| a / c),
                Instruction::Of(Function::Neg, to, a) => unary!(to, a, |a| -a),
                Instruction::Of(Function::Sqr, to, a) => unary!(to, a, |a| a * a),
                Instruction::Of(Function::Recip, to, a) => unary!(to, a, |a| 1.0 / a),
                Instruction::Of(Function::Sqrt, to, a) => unary!(to, a, f64::sqrt),
                Instruction::Of(Function::Exp, to, a) => function!(to, a, functions::exp),
                Instruction::Of(Function::Ln, to, a) => function!(to, a, functions::ln),
                Instruction::Of(Function::Tanh, to, a) => function!(to, a, functions::tanh),
                Instruction::Of(Function::Cosh, to, a) => function!(to, a, functions::cosh),
                Instruction::Of(Function::Atan, to, a) => function!(to, a, functions::atan),
                Instruction::Of(function, to, a) => {
                    for (y, x) in out[..used].iter_mut().zip(&row!(a)[..used]) {
                        one_by_one(function, y, x);
                    }
                    done!(to)
                }
                Instruction::SinCos([sin, cos], a) => {
                    let both = out[..used].iter_mut().zip(&mut other[..used]);
                    for ((sin, cos), x) in both.zip(&row!(a)[..used]) {
                        functions::sin_cos(sin, cos, x);
                    }
                    done!(sin);
                    std::mem::swap(&mut rows[cos as usize], other);
                }
                Instruction::Mixed(to, [x, a, b], [c, d]) => {
                    let [x, a, b] = [row!(x), row!(a), row!(b)];
                    for k in (0..used).map(std::hint::black_box) {
                        let [x, a, b] = [&x[k], &a[k], &b[k]];
                        chunk(&mut out[k], |i| c * x[i] + d * (a[i] * b[i]));
                    }
                    done!(to)
                }
                Instruction::Linear { begins, count, x, c } => {
                    macro_rules! linear {
                        ($count:literal) => {{
                            let x: [_; $count] = std::array::from_fn(|k| row!(x[k]));
                            if begins {
                                linear::<$count, true>(out, used, x, c);
                            } else {
                                linear::<$count, false>(out, used, x, c);
                            }
                        }};
                    }
                    match count {
                        1 => linear!(1),
                        2 => linear!(2),
                        3 => linear!(3),
                        _ => linear!(4),
                    }
                }
                Instruction::Products { begins, count, a, b, c } => {
                    macro_rules! products {
                        ($count:literal) => {{
                            let a: [[_; $count]; 2] =
                                [a, b].map(|a| std::array::from_fn(|k| row!(a[k])));
                            if begins {
                                products::<$count, true>(out, used, a, c);
                            } else {
                                products::<$count, false>(out, used, a, c);
                            }
                        }};
                    }
                    match count {
                        1 => products!(1),
                        _ => products!(2),
                    }
                }
                Instruction::Done(to) => done!(to),
                Instruction::Table { to, table, orders, axes, u } => {
                    let u = u.map(|u| &rows[u as usize][..used]);
                    let table = &*program.tables[table as usize];
                    tabulate(&mut out[..used], &u[..usize::from(axes)], table, orders);
                    done!(to)
                }
            }
        }
    }
}

#[inline(never)]
fn run_baseline(registers: &mut Registers, program: &Program) {
    registers.run_inline(program);
}

#[multiversion::multiversion(targets("x86_64+avx2"))]
fn run_widest(registers: &mut Registers, program: &Program) {
    registers.run_inline(program);
}

/// Fills a chunk lane by lane.
///
/// The result is made in a local array first, because a compiler that cannot exclude aliasing with
/// an operand would not vectorise.
#[inline(always)]
fn chunk(y: &mut Chunk, of: impl Fn(usize) -> f64) {
    let mut made = [0.0; WIDTH];
    for i in 0..WIDTH {
        made[i] = of(i);
    }
    *y = made;
}

// `black_box` hides the chunk index. The compiler would otherwise vectorise across chunks, with one
// lane from each.

#[inline(always)]
fn unary(y: &mut [Chunk], used: usize, a: &[Chunk], f: impl Fn(f64) -> f64) {
    for k in (0..used).map(std::hint::black_box) {
        let a = &a[k];
        chunk(&mut y[k], |i| f(a[i]));
    }
}

#[inline(always)]
fn binary(y: &mut [Chunk], used: usize, [a, b]: [&[Chunk]; 2], f: impl Fn(f64, f64) -> f64) {
    for k in (0..used).map(std::hint::black_box) {
        let [a, b] = [&a[k], &b[k]];
        chunk(&mut y[k], |i| f(a[i], b[i]));
    }
}

/// Computes `c₀ x₀ + c₁ x₁ + …`, from left to right, and adds it to the sum so far unless it
/// `BEGINS`.
#[inline(always)]
fn linear<const COUNT: usize, const BEGINS: bool>(
    y: &mut [Chunk],
    used: usize,
    x: [&[Chunk]; COUNT],
    c: [f64; 4],
) {
    for k in (0..used).map(std::hint::black_box) {
        let x = x.map(|x| &x[k]);
        let before = y[k];
        chunk(&mut y[k], |i| {
            let mut sum = c[0] * x[0][i];
            if !BEGINS {
                sum += before[i];
            }
            for k in 1..COUNT {
                sum += c[k] * x[k][i];
            }
            sum
        });
    }
}

/// Does the same for `c₀ a₀ b₀ + c₁ a₁ b₁`.
#[inline(always)]
fn products<const COUNT: usize, const BEGINS: bool>(
    y: &mut [Chunk],
    used: usize,
    [a, b]: [[&[Chunk]; COUNT]; 2],
    c: [f64; 2],
) {
    for k in (0..used).map(std::hint::black_box) {
        let [a, b] = [a, b].map(|rows| rows.map(|row| &row[k]));
        let before = y[k];
        chunk(&mut y[k], |i| {
            let mut sum = c[0] * (a[0][i] * b[0][i]);
            if !BEGINS {
                sum += before[i];
            }
            for k in 1..COUNT {
                sum += c[k] * (a[k][i] * b[k][i]);
            }
            sum
        });
    }
}

#[inline(never)]
fn tabulate(y: &mut [Chunk], u: &[&[Chunk]], table: &dyn Table, orders: [u8; 3]) {
    for (k, y) in y.iter_mut().enumerate() {
        for (lane, y) in y.iter_mut().enumerate() {
            let mut at = [0.0; 3];
            at.iter_mut().zip(u).for_each(|(at, u)| *at = u[k][lane]);
            *y = table.value(&at[..u.len()], orders);
        }
    }
}

#[inline(never)]
fn one_by_one(function: Function, y: &mut Chunk, x: &Chunk) {
    for (y, &x) in y.iter_mut().zip(x) {
        *y = function.of(x);
    }
}
