//! Which checks kill which mutant: the table of mutants in a terminal.

use tautline_verify::{
    Mutant,
    battery::{Scope, kills},
};

fn main() {
    for mutant in Mutant::ALL {
        let all = kills(&mutant, Scope::Everything, 48);
        let paper = kills(&mutant, Scope::PaperAlone, u32::MAX);
        println!("{mutant:?}: {} kill, e.g. {:?}; paper alone: {paper:?}", all.len(), all.first());
    }
}
