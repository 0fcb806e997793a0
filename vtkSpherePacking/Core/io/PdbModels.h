// SPDX-License-Identifier: BSD-3-Clause
#ifndef PdbModels_h
#define PdbModels_h

#include "io/TextLines.h"

namespace spherepacking
{
/// The models of a file that is laid out as those of the Protein Data Bank: alternatives of one
/// structure, each between the records MODEL and ENDMDL.
struct PdbModels
{
  TextRange First; ///< the lines up to the end of the first model
  vtkIdType Count; ///< 1 for a file without these records
};

PdbModels FindModels(const TextRange& text);
}

#endif
