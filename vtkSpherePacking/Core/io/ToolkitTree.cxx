// SPDX-License-Identifier: BSD-3-Clause
#include "io/ToolkitTree.h"

#include "io/CutFile.h"
#include "io/LineScanner.h"
#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/SphereFields.h"
#include "io/TextTable.h"

#include <algorithm>

namespace spherepacking
{
namespace
{
// How many nodes a whole tree has, but not more than `limit` + 1.
vtkIdType CountNodes(vtkIdType levels, vtkIdType degree, vtkIdType limit)
{
  vtkIdType nodes = 0;
  vtkIdType inLevel = 1;
  for (vtkIdType level = 0; level < levels && nodes <= limit; ++level)
  {
    nodes += inLevel;
    inLevel = inLevel > limit / degree ? limit + 1 : inLevel * degree;
  }
  return std::min(nodes, limit + 1);
}

/// Reads the nodes of a tree, in the order of the file.
class TreeScanner
{
public:
  explicit TreeScanner(const TextRange& text)
    : Text(text)
    , Scanner(text)
  {
  }

  void Scan()
  {
    const std::string expected = "the numbers of levels and of children a node";
    this->Scanner.Require(expected, "no line");
    const auto head = this->Scanner.Fields();
    int levels;
    int degree;
    if (head.size() != 2 || !ParseInteger(head[0], levels) || !ParseInteger(head[1], degree) ||
      levels < 1 || degree < 1)
    {
      this->Scanner.Refuse(expected);
    }
    const vtkIdType headLine = this->Scanner.LineNumber();
    this->ScanNodes(degree);
    const auto nodes = static_cast<vtkIdType>(this->Kept.size());
    if (CountNodes(levels, degree, nodes) != nodes)
    {
      throw LineError(headLine,
        "found " + std::to_string(levels) + " levels of " + std::to_string(degree) +
          " children a node, but " + std::to_string(nodes) +
          " lines of nodes follow, expected as many as such a tree has");
    }
    if (this->Spheres.empty())
    {
      ThrowNoSphere("at least one node with a radius that is not negative");
    }
  }

  PackingArrays Parse(bool single, Progress& progress) const
  {
    PackingArrays arrays = ParseSpheres(this->Spheres, SphereSize::Radius, single, progress);
    if (this->HasOccupancy)
    {
      std::copy(this->Occupancies.begin(), this->Occupancies.end(), arrays.AddExtra("occupancy"));
    }
    AddIntegers(arrays, "level", this->Levels);
    AddIntegers(arrays, "parent", this->Parents);
    return arrays;
  }

private:
  void ScanNodes(int degree)
  {
    int level = 1;
    vtkIdType levelEnd = 1;
    vtkIdType levelSize = 1;
    for (vtkIdType node = 0; this->Scanner.Next(); ++node)
    {
      const std::string_view first = this->Scanner.Fields()[0];
      if (first == "Options" || first == "Evaluation")
      {
        return;
      }
      if (node == levelEnd)
      {
        ++level;
        levelSize *= degree; // which was at most the number of lines so far
        levelEnd += levelSize;
      }
      const int parent = node == 0 ? -1 : this->Kept[(node - 1) / degree];
      this->AddNode(level, parent);
    }
    CheckNotCut(this->Text);
  }

  void AddNode(int level, int parent)
  {
    const auto fields = this->Scanner.Fields();
    const auto has = [&](std::size_t count)
    { return fields.size() == count || fields.size() == count + 5; };
    this->HasOccupancy = this->Kept.empty() ? has(5) : this->HasOccupancy;
    double occupancy = 0.0;
    if (this->HasOccupancy ? !has(5) || !ParseFinite(fields[4], occupancy) : !has(4))
    {
      this->Scanner.Refuse(this->Kept.empty() || this->HasOccupancy
          ? "5 columns: x y z radius occupancy"
          : "4 columns: x y z radius");
    }
    double radius;
    if (ParseFinite(fields[3], radius) &&
      IsNegative(fields[3].data(), fields[3].data() + fields[3].size(), radius))
    {
      this->Kept.push_back(-1);
      return;
    }
    this->Kept.push_back(static_cast<int>(this->Spheres.size()));
    this->Spheres.push_back(
      { { fields[0], fields[1], fields[2], fields[3] }, this->Scanner.LineNumber() });
    this->Occupancies.push_back(occupancy);
    this->Levels.push_back(level);
    this->Parents.push_back(parent);
  }

  TextRange Text;
  LineScanner Scanner;
  bool HasOccupancy = false;
  std::vector<SphereFields> Spheres;
  std::vector<double> Occupancies;
  std::vector<int> Levels;
  std::vector<int> Parents;
  std::vector<int> Kept; // for each node, the index of its sphere or -1
};
}

//------------------------------------------------------------------------------
PackingArrays ParseToolkitTree(const TextRange& text, bool single, Progress& progress)
{
  TreeScanner scanner(text);
  scanner.Scan();
  return scanner.Parse(single, progress);
}
}
