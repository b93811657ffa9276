//! The same bits for any number of threads.

use rayon::ThreadPoolBuilder;

use crate::tampering::BASE;

#[test]
fn what_is_proved_does_not_depend_on_the_number_of_threads() {
    for threads in [1, 2, 3, 7] {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        let proved = pool.install(|| BASE.certificate.check()).expect("proved");
        assert_eq!(proved, BASE.proved, "{threads} threads");
        assert_eq!(proved.lower.to_bits(), BASE.proved.lower.to_bits());
    }
}
