// SPDX-License-Identifier: BSD-3-Clause
#ifndef CoordinateRange_h
#define CoordinateRange_h

namespace spherepacking
{
/// Throws a std::invalid_argument if differences of these bounds are not finite.
void CheckFinite(const double (&bounds)[6]);

/// Throws a std::invalid_argument if rays cannot be cast at spheres within these bounds: depths are
/// kept in single precision, and squares of lengths must be numbers.
void CheckCoordinateRange(const double (&bounds)[6]);
}

#endif
