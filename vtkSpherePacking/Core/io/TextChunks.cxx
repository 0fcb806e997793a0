// SPDX-License-Identifier: BSD-3-Clause
#include "io/TextChunks.h"

#include <algorithm>
#include <cstddef>

namespace spherepacking
{
namespace
{
// Sets Rows to the number of rows and FirstLine to the number of lines.
void CountLines(RowKind kind, TextChunk& chunk)
{
  LineFinder find(chunk.End);
  vtkIdType lines = 0;
  for (const char* p = chunk.Begin; p != chunk.End; ++lines)
  {
    const char* end = find(p);
    chunk.Rows += IsRow(kind, p, end);
    p = SkipLineEnd(end, chunk.End);
  }
  chunk.FirstLine = lines;
}

// The same for a chunk in which every line ends in LF and begins with neither a blank nor a #, so
// that it is a row; false for any other. Compilers vectorise the loop.
bool CountPlainLines(TextChunk& chunk)
{
  const auto special = [](char c) { return static_cast<unsigned char>(c) <= ' ' || c == '#'; };
  if (special(*chunk.Begin) || chunk.End[-1] != '\n')
  {
    return false;
  }
  constexpr std::ptrdiff_t block = 128; // so that a byte can count the line ends
  vtkIdType lines = 0;
  const char* const last = chunk.End - 1;
  for (const char* p = chunk.Begin; p < last; p += block)
  {
    const std::ptrdiff_t length = std::min(block, last - p);
    unsigned char ends = 0;
    unsigned char odd = 0;
    for (std::ptrdiff_t i = 0; i < length; ++i)
    {
      const bool atEnd = p[i] == '\n';
      ends = static_cast<unsigned char>(ends + atEnd);
      odd |= static_cast<unsigned char>((p[i] == '\r') | (atEnd & special(p[i + 1])));
    }
    if (odd)
    {
      return false;
    }
    lines += ends;
  }
  chunk.FirstLine = chunk.Rows = lines + 1;
  return true;
}
}

//------------------------------------------------------------------------------
std::vector<TextChunk> CutIntoChunks(
  const TextRange& text, RowKind kind, vtkIdType chunkSize, vtkIdType firstRow, Progress& progress)
{
  std::vector<TextChunk> chunks;
  for (const char* p = text.Begin; p != text.End;)
  {
    const char* cut = text.End - p > chunkSize ? p + chunkSize : text.End;
    while (cut != text.End && !IsLineEnd(*cut))
    {
      ++cut;
    }
    cut = SkipLineEnd(cut, text.End);
    TextChunk chunk;
    chunk.Begin = p;
    chunk.End = cut;
    chunks.push_back(chunk);
    p = cut;
  }

  // FirstLine holds the number of lines of the chunk itself until these are summed up.
  ForInBatches(
    static_cast<vtkIdType>(chunks.size()), 4, progress,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        if (kind != RowKind::Data || !CountPlainLines(chunks[i]))
        {
          CountLines(kind, chunks[i]);
        }
      }
    },
    [] {});

  vtkIdType line = text.FirstLine;
  for (TextChunk& chunk : chunks)
  {
    const vtkIdType count = chunk.FirstLine;
    chunk.FirstLine = line;
    chunk.FirstRow = firstRow;
    line += count;
    firstRow += chunk.Rows;
  }
  return chunks;
}
}
