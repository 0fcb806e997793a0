// SPDX-License-Identifier: BSD-3-Clause
#ifndef Box_h
#define Box_h

namespace spherepacking
{
/// Parallel to the axes and closed: its faces belong to it.
struct Box
{
  double Low[3];
  double High[3];
};
}

#endif
