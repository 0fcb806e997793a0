// SPDX-License-Identifier: BSD-3-Clause
#ifndef FixedForms_h
#define FixedForms_h

#include "io/PackingFormats.h"
#include "io/TextLines.h"

namespace spherepacking
{
/// Detects by its first lines a format in which the meaning of a line follows from its place;
/// Format::Auto if it is none that is certain. `head` holds whole lines.
Format GuessFixedForm(const TextRange& head);

/// Throws a PackingFileError if `file`, by its extension or its first lines, is of a format that
/// holds atoms without radii.
void RefuseAtomsWithoutRadii(const std::string& file, const TextRange& head);
}

#endif
