// Which numbers of a row matter for success, as far as the examples tell.
//
// Permutation importance (Breiman, 2001) by cross-validation: how much worse the logarithmic loss on held-out
// examples becomes when one column is shuffled among them. Columns whose importance is not above its standard
// error are dropped, a classifier of the rest decides by its held-out loss whether that was right, and so on
// until it was not.
#pragma once

#include <cstddef>
#include <vector>

#include "practice/policies/classifier.hpp"

namespace praxis::practice {

/// The columns to keep, ascending: those that matter among the first `candidates`, and all later ones. With
/// fewer than eight examples of an outcome it is all columns. The same examples and seed give the same
/// answer. It fits `options` eight to some dozens of times.
std::vector<std::size_t> select_features(const Examples& examples, std::size_t candidates,
                                         const ClassifierOptions& options, Random& random);

/// The examples with these columns alone, in this order.
Examples with_columns(const Examples& examples, const std::vector<std::size_t>& columns);

}  // namespace praxis::practice
