//! A method of a subject for each entry of its table of bounds.

use std::num::NonZeroUsize;

use tautline::{
    Constants,
    bounds::{BetweenPoints, Bound, BoundError, Computed, Enclosure, PaperRule, Setting, Spread},
};

use super::Subject;
use crate::replaceable::{Entry, for_each_bound, kind};

macro_rules! methods {
    ($($entry:ident($($name:ident),*) -> $result:ty = $genuine:path;)*) => {
        impl Subject {
            $(
                #[doc = concat!("Calls [`", stringify!($genuine), "`], or what replaces it.")]
                pub fn $entry(&self, $($name: kind!($name)),*) -> $result {
                    self.note(|asked| asked.add_bound(Entry::$entry as usize));
                    (self.bounds.$entry)($($name),*)
                }
            )*
        }
    };
}

for_each_bound!(methods);
