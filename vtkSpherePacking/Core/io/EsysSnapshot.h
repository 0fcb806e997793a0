// SPDX-License-Identifier: BSD-3-Clause
#ifndef EsysSnapshot_h
#define EsysSnapshot_h

#include "bridge/PackingArrays.h"
#include "io/TextLines.h"

#include <string>
#include <vector>

namespace spherepacking
{
/**
 * The first file of a snapshot that a check-pointer of ESyS-Particle writes (S. Abe et al.,
 * "ESyS-Particle tutorial and user's guide", 2014): version 3, the number of time steps, their
 * length and which it is, each in a line; the program; the box, which axes are periodic, the
 * dimension; and the files of the particles, one per worker.
 */
struct EsysSnapshot
{
  double Time;
  SimulationCell Cell;
  std::vector<std::string> Files; ///< without folders, which are those of the run
  vtkIdType FilesLine;
};

/// Whether a text begins as such a file does, or as one of the files of particles, which by itself
/// may hold a part of the particles only.
bool BeginsAsEsysSnapshot(const char* begin, const char* end);

/// Throws if it is none.
EsysSnapshot ParseEsysSnapshot(const TextRange& text);
}

#endif
