// SPDX-License-Identifier: BSD-3-Clause
#ifndef RemarksOnOrder_h
#define RemarksOnOrder_h

#include <string_view>

namespace spherepacking
{
/// Whether a remark may say that columns are in another order than x, y, z, radius: by letters such
/// as zyx, or in words such as "radius first" or "radius, then the centre".
bool SpeaksOfOtherOrder(std::string_view remark);

/// Whether a remark may say that the fourth column is no radius: the square or logarithm of one, or
/// something else without a word of radii.
bool SpeaksOfOtherSize(std::string_view remark);
}

#endif
