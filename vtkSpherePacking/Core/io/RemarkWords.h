// SPDX-License-Identifier: BSD-3-Clause
#ifndef RemarkWords_h
#define RemarkWords_h

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace spherepacking
{
/// A word of a remark: letters, digits, apostrophes within, and all that is not ASCII.
struct RemarkWord
{
  std::size_t Begin;
  std::size_t End;
  std::string Lower; // ASCII alone
};

/// The words of `remark`, in turn.
std::vector<RemarkWord> SplitRemark(std::string_view remark);
}

#endif
