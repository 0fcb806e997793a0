// SPDX-License-Identifier: BSD-3-Clause
#include "io/CutFile.h"
#include "io/DockCluster.h"
#include "io/FileBytes.h"
#include "io/LineScanner.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/PdbRecord.h"
#include "io/SphereFields.h"
#include "io/Utf8Mark.h"

#include <algorithm>

namespace spherepacking
{
namespace
{
// The further whole numbers of a row, after the radius.
constexpr std::size_t Further = 3;

struct DockRow
{
  SphereFields Sphere;
  std::string_view Atom;
  std::string_view More[Further];
};

// Splits by the columns of sphgen, I5, 3F10.5, F8.3, I5, I2, I3, where numbers may touch; false if
// the line is not so.
bool SplitByColumns(std::string_view line, DockRow& row)
{
  bool good = HoldsFixedNumber(line, 36, 43, 3);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    good = good && HoldsFixedNumber(line, 6 + 10 * axis, 15 + 10 * axis, 5);
    row.Sphere.Numbers[axis] = PdbColumns(line, 6 + 10 * axis, 15 + 10 * axis);
  }
  row.Sphere.Numbers[3] = PdbColumns(line, 36, 43);
  row.Atom = PdbColumns(line, 1, 5);
  row.More[0] = PdbColumns(line, 44, 48);
  row.More[1] = PdbColumns(line, 49, 50);
  row.More[2] = PdbColumns(line, 51, 53);
  return good;
}

void SplitByFields(const LineScanner& scanner, DockRow& row)
{
  const auto fields = scanner.Fields();
  if (fields.size() != 5 && fields.size() != 5 + Further)
  {
    scanner.Refuse("the number of an atom, x y z radius and 3 whole numbers");
  }
  row = {};
  row.Atom = fields[0];
  std::copy_n(fields.begin() + 1, 4, row.Sphere.Numbers);
  std::copy(fields.begin() + 5, fields.end(), row.More);
}

// Whether the current line is the row of a sphere rather than a title or the name of a colour.
bool HoldsSphere(const LineScanner& scanner)
{
  DockRow row;
  const auto fields = scanner.Fields();
  double value;
  return SplitByColumns(scanner.WholeLine(), row) ||
    (fields.size() >= 5 &&
      std::all_of(
        fields.begin(), fields.begin() + 5, [&](auto f) { return ParseFinite(f, value); }));
}

/// The rows of a file of DOCK, in arrays.
class DockParser
{
public:
  explicit DockParser(const TextRange& text)
    : Text(text)
    , Scanner(text, {})
  {
  }

  // A title, perhaps names of colours, then clusters: a line with number and size, then the rows.
  void Scan()
  {
    bool within = false;
    while (this->Scanner.Next())
    {
      if (const auto cluster = ParseDockCluster(this->Scanner))
      {
        this->CheckSize();
        this->Cluster = *cluster;
        this->First = this->Spheres.size();
        this->ClusterLine = this->Scanner.LineNumber();
        within = true;
      }
      else if (within)
      {
        this->AddRow();
      }
      else if (HoldsSphere(this->Scanner))
      {
        this->Scanner.Refuse("the line of its cluster before it, such as cluster 1 number of "
                             "spheres in cluster 23");
      }
    }
    this->CheckSize();
    CheckNotCut(this->Text);
    if (this->Spheres.empty())
    {
      ThrowNoSphere("clusters with rows of x y z radius");
    }
  }

  PackingArrays Parse(bool single, Progress& progress) const
  {
    PackingArrays arrays = ParseSpheres(this->Spheres, SphereSize::Radius, single, progress);
    AddIntegers(arrays, "cluster", this->Clusters);
    AddIntegers(arrays, "atom", this->Atoms);
    const char* const names[Further] = { "second_atom", "critical_cluster", "color" };
    for (std::size_t i = 0; i < Further; ++i)
    {
      if (!this->More[i].empty())
      {
        AddIntegers(arrays, names[i], this->More[i]);
      }
    }
    return arrays;
  }

private:
  void CheckSize() const
  {
    const auto found = static_cast<vtkIdType>(this->Spheres.size() - this->First);
    if (found != this->Cluster.Size)
    {
      throw LineError(this->ClusterLine,
        "found " + std::to_string(this->Cluster.Size) + " as the number of spheres in cluster " +
          std::to_string(this->Cluster.Number) + ", but " + std::to_string(found) +
          " lines of spheres follow, expected as many");
    }
  }

  void AddRow()
  {
    DockRow row;
    if (!SplitByColumns(this->Scanner.WholeLine(), row))
    {
      SplitByFields(this->Scanner, row);
    }
    int atom;
    if (!ParseInteger(row.Atom, atom))
    {
      this->Scanner.Refuse("the number of an atom, x y z radius");
    }
    row.Sphere.Line = this->Scanner.LineNumber();
    this->Spheres.push_back(row.Sphere);
    this->Atoms.push_back(atom);
    this->Clusters.push_back(this->Cluster.Number);
    for (std::size_t i = 0; i < Further; ++i)
    {
      int value;
      if (ParseInteger(row.More[i], value))
      {
        this->More[i].push_back(value);
      }
      // Other programs leave them out, but then in every row.
      const std::size_t rows = this->Spheres.size();
      if (this->More[i].size() != rows && (!row.More[i].empty() || !this->More[i].empty()))
      {
        this->Scanner.Refuse("3 whole numbers after x y z radius, as in the rows before");
      }
    }
  }

  TextRange Text;
  LineScanner Scanner;
  DockCluster Cluster{ 0, 0 };
  std::size_t First = 0;
  vtkIdType ClusterLine = 0;
  std::vector<SphereFields> Spheres;
  std::vector<int> Clusters;
  std::vector<int> Atoms;
  std::vector<int> More[Further];
};
}

//------------------------------------------------------------------------------
PackingArrays ReadDock(const std::string& file, const ReadOptions& options, Progress& progress)
{
  progress.SetRange(0.0, 0.2);
  const FileBytes bytes = FileBytes::Read(file, progress);
  progress.SetRange(0.2, 1.0);
  return WithFileName(file,
    [&]
    {
      DockParser parser({ SkipUtf8Mark(bytes.Begin(), bytes.End()), bytes.End() });
      parser.Scan();
      return parser.Parse(options.Single, progress);
    });
}
}
