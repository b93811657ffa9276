//! Moves labels along a line until none overlaps another.

/// Returns places for boxes that are as close as possible to the wanted places.
///
/// Each entry of `wanted` is a centre and a height. Neighbours end up at least `gap` apart, and all
/// boxes lie between `low` and `high` if they fit. Except for these two bounds, the sum of the
/// squared moves is minimal among all arrangements in the order of the wanted places. A block of
/// touching boxes is at the mean of the places that its members want (the pool-adjacent-violators
/// algorithm).
pub(crate) fn push_apart(wanted: &[(f64, f64)], gap: f64, low: f64, high: f64) -> Vec<f64> {
    let mut order: Vec<usize> = (0..wanted.len()).collect();
    order.sort_by(|a, b| wanted[*a].0.total_cmp(&wanted[*b].0));
    // Subtracting the space of all earlier boxes turns "at least `gap` apart" into "not
    // decreasing".
    let mut before = 0.0;
    let mut offsets = Vec::with_capacity(order.len());
    let mut blocks: Vec<(f64, usize)> = Vec::new();
    for &k in &order {
        let (centre, height) = wanted[k];
        let offset = before + height / 2.0;
        before += height + gap;
        offsets.push(offset);
        blocks.push((centre - offset, 1));
        while let [.., (first, count), (second, more)] = blocks[..] {
            if first <= second {
                break;
            }
            let (count_f, more_f) = (count as f64, more as f64);
            let mean = (first * count_f + second * more_f) / (count_f + more_f);
            blocks.truncate(blocks.len() - 2);
            blocks.push((mean, count + more));
        }
    }
    let total = (before - gap).max(0.0);
    let reduced = blocks.iter().flat_map(|(place, count)| std::iter::repeat_n(*place, *count));
    let mut places = vec![0.0; wanted.len()];
    for ((&k, offset), place) in order.iter().zip(offsets).zip(reduced) {
        // Clamping keeps the order and the distances. If the boxes do not fit, `low` takes
        // precedence.
        places[k] = place.min(high - total).max(low) + offset;
    }
    places
}

#[cfg(test)]
mod tests {
    use super::push_apart;

    #[test]
    fn boxes_that_do_not_meet_stay() {
        let wanted = [(100.0, 20.0), (10.0, 10.0), (50.0, 20.0)];
        assert_eq!(push_apart(&wanted, 2.0, 0.0, 200.0), [100.0, 10.0, 50.0]);
    }

    #[test]
    fn two_at_one_place_move_by_the_same_amount() {
        assert_eq!(push_apart(&[(50.0, 10.0), (50.0, 10.0)], 2.0, 0.0, 100.0), [44.0, 56.0]);
    }

    #[test]
    fn no_two_overlap_and_all_stay_inside() {
        // Many arrangements, from a small congruential generator with a fixed seed.
        let mut state = 12_345_u64;
        let mut random = |top: f64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 40) as f64 / (1_u64 << 24) as f64 * top
        };
        for _ in 0..500 {
            let wanted: Vec<(f64, f64)> =
                (0..7).map(|_| (random(300.0), 10.0 + random(25.0))).collect();
            let places = push_apart(&wanted, 3.0, 0.0, 300.0);
            let mut boxes: Vec<(f64, f64)> =
                places.iter().zip(&wanted).map(|(y, (_, h))| (y - h / 2.0, y + h / 2.0)).collect();
            boxes.sort_by(|a, b| a.0.total_cmp(&b.0));
            assert!(boxes.windows(2).all(|w| w[0].1 + 3.0 <= w[1].0 + 1e-9), "{boxes:?}");
            assert!(boxes[0].0 >= -1e-9 && boxes[6].1 <= 300.0 + 1e-9, "{boxes:?}");
        }
    }
}
