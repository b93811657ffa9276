//! Results in the order of their values.

use paper::parallel::map;

#[test]
fn results_come_in_order() {
    let values: Vec<u32> = (0..100).collect();
    assert!(map(&values, |x| x * x).into_iter().eq((0..100).map(|x| x * x)));
    assert!(map(&[] as &[u32], |x| *x).is_empty());
}
