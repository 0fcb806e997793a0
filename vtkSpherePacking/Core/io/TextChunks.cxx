// SPDX-License-Identifier: BSD-3-Clause
#include "io/TextChunks.h"

namespace spherepacking
{
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

  // FirstLine and FirstRow hold the counts of the chunk itself until they are summed up.
  ForInBatches(
    static_cast<vtkIdType>(chunks.size()), 1, progress,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        TextChunk& chunk = chunks[i];
        LineFinder lines(chunk.End);
        vtkIdType count = 0;
        for (const char* p = chunk.Begin; p != chunk.End; ++count)
        {
          const char* end = lines(p);
          chunk.Rows += IsRow(kind, p, end);
          p = SkipLineEnd(end, chunk.End);
        }
        chunk.FirstLine = count;
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
