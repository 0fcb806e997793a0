// SPDX-License-Identifier: BSD-3-Clause
#ifndef MercuryHeader_h
#define MercuryHeader_h

#include "vtkType.h"

#include <optional>
#include <string_view>

namespace spherepacking
{
/**
 * The line before the particles of a time step in a .data file of MercuryDPM (T. Weinhart et al.,
 * "Fast, flexible particle simulations - an introduction to MercuryDPM", 2020): the number of
 * particles, the time, and the least and greatest corner of the domain, which in two dimensions
 * have two coordinates.
 */
struct MercuryHeader
{
  static constexpr const char* Expected =
    "the number of particles, the time, and the least and greatest x y z of the domain";

  vtkIdType Count;
  double Time;
  int Dimensions;
  double Least[3];
  double Greatest[3];
};

/// Nothing if the line is no such header.
std::optional<MercuryHeader> ParseMercuryHeader(std::string_view line);

/// Whether a text begins as such a file does.
bool BeginsAsMercury(const char* begin, const char* end);
}

#endif
