// SPDX-License-Identifier: BSD-3-Clause
#ifndef DisjointSets_h
#define DisjointSets_h

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace spherepacking
{
/// Union-find: a partition of the integers from 0 to count - 1, at first into single ones.
///
/// Find() halves the path that it follows; Unite() links the roots as they come, without ranks, so
/// m operations on n integers take O(m log n).
/// Sources: Tarjan, "Efficiency of a good but not linear set union algorithm" (1975); Tarjan and
/// van Leeuwen, "Worst-case analysis of set union algorithms" (1984), for path halving.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count)
    : Parents(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }

  /// The representative of the set that holds `i`.
  std::int32_t Find(std::int32_t i)
  {
    while (this->Parents[i] != i)
    {
      this->Parents[i] = this->Parents[this->Parents[i]];
      i = this->Parents[i];
    }
    return i;
  }

  /// Makes the sets that hold `a` and `b` one.
  void Unite(std::int32_t a, std::int32_t b) { this->Parents[this->Find(a)] = this->Find(b); }

  /// The members of each set, ascending; the sets ascend by their first members.
  std::vector<std::vector<std::int32_t>> Sets()
  {
    std::vector<std::vector<std::int32_t>> sets;
    std::vector<std::int32_t> indices(this->Parents.size(), -1); // of the set, for each root
    for (std::size_t i = 0; i < this->Parents.size(); ++i)
    {
      std::int32_t& index = indices[this->Find(static_cast<std::int32_t>(i))];
      if (index < 0)
      {
        index = static_cast<std::int32_t>(sets.size());
        sets.emplace_back();
      }
      sets[index].push_back(static_cast<std::int32_t>(i));
    }
    return sets;
  }

private:
  std::vector<std::int32_t> Parents;
};
}

#endif
