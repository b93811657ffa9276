//! Blocks of results become one table.

use super::{Block, BlockWriter, Head, MergeError};

/// Returns the order in which blocks follow each other, as indices, without empty ones. Every problem of
/// the plan must be in one of them, and only once.
///
/// # Errors
///
/// [`MergeError`], with all ids that are missing or occur twice.
pub fn in_order(heads: &[Head]) -> Result<Vec<usize>, MergeError> {
    let first = heads.first().ok_or(MergeError::Nothing)?;
    for (index, head) in heads.iter().enumerate() {
        for (what, found, expected) in [
            ("plan", &head.plan, &first.plan),
            ("version", &head.version, &first.version),
            ("columns", &head.columns, &first.columns),
            ("number of problems", &head.count.to_string(), &first.count.to_string()),
        ] {
            if found != expected {
                let (found, expected) = (found.clone(), expected.clone());
                return Err(MergeError::Other { index: index + 1, what, found, expected });
            }
        }
    }
    let mut order: Vec<usize> = (0..heads.len()).filter(|&i| !heads[i].ids.is_empty()).collect();
    order.sort_by_key(|&i| (heads[i].ids.start, heads[i].ids.end));
    let (mut missing, mut doubled) = (Vec::new(), Vec::new());
    // The end of the ids so far, and the block that reaches it.
    let (mut end, mut last) = (0, 0);
    for &i in &order {
        let ids = &heads[i].ids;
        if ids.start > end {
            missing.push(end..ids.start);
        }
        if ids.start < end {
            doubled.push((ids.start..end.min(ids.end), [last + 1, i + 1]));
        }
        if ids.end > end {
            (end, last) = (ids.end, i);
        }
    }
    if end < first.count {
        missing.push(end..first.count);
    }
    if missing.is_empty() && doubled.is_empty() {
        Ok(order)
    } else {
        Err(MergeError::NotOnce { missing, doubled })
    }
}

/// Returns the results of all problems as one text: that of one block with all ids.
///
/// # Errors
///
/// [`MergeError`].
pub fn merged(blocks: &[Block<'_>]) -> Result<String, MergeError> {
    let heads: Vec<Head> = blocks.iter().map(|block| block.head.clone()).collect();
    let order = in_order(&heads)?;
    let (mut writer, mut text) = BlockWriter::new(&heads[0].whole());
    for index in order {
        text += &writer.rows(blocks[index].rows.to_owned());
    }
    Ok(text + &writer.end())
}

impl Head {
    /// Returns the head of the merged results.
    #[must_use]
    pub fn whole(&self) -> Self {
        Self { ids: 0..self.count, ..self.clone() }
    }
}
