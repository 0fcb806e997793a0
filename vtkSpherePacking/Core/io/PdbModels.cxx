// SPDX-License-Identifier: BSD-3-Clause
#include "io/PdbModels.h"

#include "io/PdbRecord.h"

namespace spherepacking
{
//------------------------------------------------------------------------------
PdbModels FindModels(const TextRange& text)
{
  PdbModels models{ text, 0 };
  bool atoms = false; // whether the current model has any
  LineFinder find(text.End);
  for (const char* p = text.Begin; p != text.End;)
  {
    const char* const end = find(p);
    if (BeginsWithRecord(p, end, "MODEL") || BeginsWithRecord(p, end, "ENDMDL"))
    {
      if (atoms && ++models.Count == 1)
      {
        models.First.End = p;
      }
      atoms = false;
    }
    else if (!atoms)
    {
      atoms = IsAtomRecord(p, end);
    }
    p = SkipLineEnd(end, text.End);
  }
  models.Count += atoms;
  return models;
}
}
