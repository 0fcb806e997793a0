// SPDX-License-Identifier: BSD-3-Clause
#include "io/FileBytes.h"
#include "io/LineScanner.h"
#include "io/Misspelt.h"
#include "io/PackingFileError.h"
#include "bridge/PrintableText.h"
#include "io/PackingFormats.h"
#include "io/SphereFields.h"
#include "io/Utf8Mark.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace spherepacking
{
namespace
{
struct Node
{
  std::string_view Center[3];
  vtkIdType Id;
};

/**
 * Reads the blocks of a model part of Kratos Multiphysics (P. Dadvand et al., "An object-oriented
 * environment for developing finite element codes for multi-disciplinary applications", 2010). The
 * spheres are the nodes for which the block NodalData RADIUS has a value.
 */
class KratosParser
{
public:
  explicit KratosParser(const TextRange& text)
    : Scanner(text, "//")
  {
  }

  void Scan()
  {
    while (this->Scanner.Next())
    {
      const auto fields = this->Scanner.Fields();
      if (fields[0] != "Begin" || fields.size() < 2)
      {
        this->Scanner.Refuse("Begin and the name of a block");
      }
      const std::string name(fields[1]);
      if (name == "Nodes" && fields.size() == 2)
      {
        this->ScanBlock(name, [&](const auto& row) { this->AddNode(row); });
      }
      else if (name == "NodalData" && fields.size() == 3 && fields[2] == "RADIUS")
      {
        this->ScanBlock(name, [&](const auto& row) { this->AddRadius(row); });
      }
      else if (name == "Elements" && fields.size() > 2 && fields[2].substr(0, 7) == "Spheric")
      {
        this->ScanBlock(name, [&](const auto& row) { this->AddElement(row); });
      }
      else
      {
        this->CheckName(fields);
        this->SkipBlock(name);
      }
    }
    for (const auto& [node, line] : this->Elements)
    {
      if (!this->Radii.empty() && this->Radii.count(node) == 0)
      {
        throw LineError(line,
          "found a spherical particle at node " + std::to_string(node) +
            ", expected its radius in a block NodalData RADIUS");
      }
    }
  }

  PackingArrays Parse(bool single, Progress& progress) const
  {
    std::vector<SphereFields> spheres;
    std::vector<double> ids;
    for (const Node& node : this->Nodes)
    {
      const auto radius = this->Radii.find(node.Id);
      if (radius != this->Radii.end())
      {
        SphereFields sphere = radius->second;
        std::copy_n(node.Center, 3, sphere.Numbers);
        spheres.push_back(sphere);
        ids.push_back(static_cast<double>(node.Id));
      }
    }
    if (spheres.empty())
    {
      ThrowNoSphere("nodes with a radius in a block NodalData RADIUS");
    }
    PackingArrays arrays = ParseSpheres(spheres, SphereSize::Radius, single, progress);
    std::copy(ids.begin(), ids.end(), arrays.AddExtra("id"));
    return arrays;
  }

private:
  // Refuses what may be a block of nodes or radii whose name is damaged. Others may be of any
  // variable; what follows the name of one of these is the name of an element or a number.
  void CheckName(const std::vector<std::string_view>& fields) const
  {
    constexpr std::string_view names[] = { "ModelPartData", "Properties", "Table", "Geometries",
      "Elements", "Conditions", "Constraints", "MasterSlaveConstraints", "NodalData",
      "ElementalData", "ConditionalData", "SubModelPart", "Mesh" };
    if (std::find(std::begin(names), std::end(names), fields[1]) == std::end(names) ||
      (fields[1] == "NodalData" && (fields.size() != 3 || IsMisspelt(fields[2], "RADIUS"))))
    {
      this->Scanner.Refuse("Begin and the name of a block of Kratos, such as Begin Nodes or Begin "
                           "NodalData RADIUS");
    }
  }

  // Hands each row of the current block to `add`.
  template <typename Add>
  void ScanBlock(const std::string& name, const Add& add)
  {
    const std::string end = "End " + PrintableText(name);
    for (this->Scanner.Require(end);; this->Scanner.Require(end))
    {
      const auto fields = this->Scanner.Fields();
      if (fields.size() > 1 && fields[0] == "End" && fields[1] == name)
      {
        return;
      }
      add(fields);
    }
  }

  // Blocks may lie in blocks, even in those of the same name, as a SubModelPart may.
  void SkipBlock(const std::string& name)
  {
    for (int depth = 1; depth > 0;)
    {
      this->Scanner.Require("End " + PrintableText(name));
      const auto fields = this->Scanner.Fields();
      if (fields.size() > 1 && fields[1] == name)
      {
        depth += (fields[0] == "Begin") - (fields[0] == "End");
      }
    }
  }

  void AddNode(const std::vector<std::string_view>& row)
  {
    Node node;
    if (row.size() != 4 || !ParseInteger(row[0], node.Id))
    {
      this->Scanner.Refuse("the number of a node and x y z, or End Nodes");
    }
    double value;
    if (!std::all_of(row.begin() + 1, row.end(), [&](auto f) { return ParseFinite(f, value); }))
    {
      this->Scanner.Refuse("x y z as finite numbers");
    }
    // Some writers repeat a block of nodes.
    if (this->Known.emplace(node.Id, this->Nodes.size()).second)
    {
      std::copy_n(row.begin() + 1, 3, node.Center);
      this->Nodes.push_back(node);
    }
  }

  // A row has the number of the element, that of its properties, and that of the node.
  void AddElement(const std::vector<std::string_view>& row)
  {
    vtkIdType node;
    if (row.size() != 3 || !ParseInteger(row[2], node))
    {
      this->Scanner.Refuse(
        "the numbers of an element, its properties and its node, or End Elements");
    }
    this->Elements.emplace_back(node, this->Scanner.LineNumber());
  }

  // A row has the number of the node, whether its value is fixed, and the value.
  void AddRadius(const std::vector<std::string_view>& row)
  {
    vtkIdType id;
    if (row.size() != 3 || !ParseInteger(row[0], id))
    {
      this->Scanner.Refuse("the number of a node, 0 or 1, and a radius, or End NodalData");
    }
    if (!this->Known.count(id))
    {
      this->Scanner.Refuse("the number of a node that a block Nodes before has");
    }
    this->Radii[id] = { { {}, {}, {}, row[2] }, this->Scanner.LineNumber() };
  }

  LineScanner Scanner;
  std::vector<Node> Nodes;
  std::unordered_map<vtkIdType, std::size_t> Known; // index in Nodes by id
  std::unordered_map<vtkIdType, SphereFields> Radii;
  std::vector<std::pair<vtkIdType, vtkIdType>> Elements; // nodes of spherical particles, and lines
};
}

//------------------------------------------------------------------------------
PackingArrays ReadKratos(const std::string& file, const ReadOptions& options, Progress& progress)
{
  progress.SetRange(0.0, 0.2);
  const FileBytes bytes = FileBytes::Read(file, progress);
  progress.SetRange(0.2, 1.0);
  return WithFileName(file,
    [&]
    {
      KratosParser parser({ SkipUtf8Mark(bytes.Begin(), bytes.End()), bytes.End() });
      parser.Scan();
      return parser.Parse(options.Single, progress);
    });
}
}
