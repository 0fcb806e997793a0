// SPDX-License-Identifier: BSD-3-Clause
#ifndef UnitsOfRemark_h
#define UnitsOfRemark_h

#include <set>
#include <string>
#include <string_view>

namespace spherepacking
{
/**
 * The units of length, in one spelling each, that a remark speaks of, but for those behind numbers,
 * "10 cm", and within other units, "kg/m^3". An m may be a mass: it is a unit in a bracket, behind
 * "in" or right behind a name, as in x/m.
 */
std::set<std::string> UnitsOfRemark(std::string_view remark);

/// Whether the brackets right behind names of the sphere hold units of different lengths, or one
/// and something else in place of it.
bool HasTwoUnits(std::string_view line);
}

#endif
