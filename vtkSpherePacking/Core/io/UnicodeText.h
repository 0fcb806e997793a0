// SPDX-License-Identifier: BSD-3-Clause
#ifndef UnicodeText_h
#define UnicodeText_h

#include "io/FileBytes.h"

namespace spherepacking
{
/// Whether bytes begin with the byte order mark of UTF-16 or UTF-32, as spreadsheets write for
/// "Unicode text".
bool HasWideMark(const FileBytes& bytes);

/// The same text in UTF-8, if there is such a mark; `bytes` as they are if not. Throws a
/// ContentError if the text is not valid.
FileBytes ToUtf8(FileBytes bytes);
}

#endif
