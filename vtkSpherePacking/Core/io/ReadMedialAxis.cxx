// SPDX-License-Identifier: BSD-3-Clause
#include "io/CutFile.h"
#include "io/FileBytes.h"
#include "io/LineScanner.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/SphereFields.h"
#include "io/Utf8Mark.h"

#include <algorithm>

namespace spherepacking
{
namespace
{
// What the lines after the counts are, in this order, and the letters that they begin with.
constexpr const char* Kinds[] = { "vertices", "edges", "faces" };
constexpr const char* Letters[] = { "v", "e", "f" };

// Which of Kinds a line of `fields` is. Files without letters have the vertices first.
std::size_t KindOf(const LineScanner& scanner, bool letters, vtkIdType rows, vtkIdType vertices)
{
  const auto fields = scanner.Fields();
  if (!letters)
  {
    return rows < vertices ? 0 : fields.size() == 3 ? 2 : 1;
  }
  for (std::size_t kind = 0; kind < 3; ++kind)
  {
    if (fields[0] == Letters[kind])
    {
      return kind;
    }
  }
  scanner.Refuse("a line that begins with v, e or f");
}

void AddVertex(const LineScanner& scanner, bool letters, std::vector<SphereFields>& spheres)
{
  const auto fields = scanner.Fields();
  const std::size_t first = letters ? 1 : 0;
  if (fields.size() < first + 4)
  {
    scanner.Refuse(letters ? "v x y z radius" : "x y z radius");
  }
  SphereFields sphere{ {}, scanner.LineNumber() };
  std::copy_n(fields.begin() + first, 4, sphere.Numbers);
  spheres.push_back(sphere);
}

/**
 * Reads the spheres of a medial mesh, as Q-MAT writes it (P. Li et al., "Q-MAT: computing medial
 * axis transform by quadratic error minimization", 2015), and its successors: the numbers of
 * vertices, edges and faces, then "v x y z radius" of each vertex, "e i j" and "f i j k". Some
 * leave out the letters, some add numbers to a vertex. Edges, faces and such numbers are left out.
 */
std::vector<SphereFields> FindVertices(const TextRange& text)
{
  LineScanner scanner(text);
  const std::string expected = "the numbers of vertices, edges and faces";
  if (!scanner.Next())
  {
    ThrowNoSphere(expected);
  }
  const vtkIdType headLine = scanner.LineNumber();
  vtkIdType counts[3] = {};
  const auto head = scanner.Fields();
  for (std::size_t i = 0; i < head.size(); ++i)
  {
    if (i >= 3 || !ParseInteger(head[i], counts[i]) || counts[i] < 0)
    {
      scanner.Refuse(expected);
    }
  }
  std::vector<SphereFields> spheres;
  vtkIdType found[3] = {};
  bool letters = false;
  for (vtkIdType row = 0; scanner.Next(); ++row)
  {
    letters |= row == 0 && scanner.Fields()[0] == Letters[0];
    const std::size_t kind = KindOf(scanner, letters, row, counts[0]);
    ++found[kind];
    if (kind == 0)
    {
      AddVertex(scanner, letters, spheres);
    }
  }
  CheckNotCut(text);
  for (std::size_t kind = 0; kind < head.size(); ++kind)
  {
    if (counts[kind] != found[kind])
    {
      throw LineError(headLine,
        "found " + std::to_string(counts[kind]) + " as the number of " + Kinds[kind] + ", but " +
          std::to_string(found[kind]) + " lines of " + Kinds[kind] + " follow, expected as many");
    }
  }
  if (spheres.empty())
  {
    ThrowNoSphere("vertices with x y z radius");
  }
  return spheres;
}
}

//------------------------------------------------------------------------------
PackingArrays ReadMedialAxis(
  const std::string& file, const ReadOptions& options, Progress& progress)
{
  progress.SetRange(0.0, 0.2);
  const FileBytes bytes = FileBytes::Read(file, progress);
  progress.SetRange(0.2, 1.0);
  return WithFileName(file,
    [&]
    {
      const auto spheres = FindVertices({ SkipUtf8Mark(bytes.Begin(), bytes.End()), bytes.End() });
      return ParseSpheres(spheres, SphereSize::Radius, options.Single, progress);
    });
}
}
