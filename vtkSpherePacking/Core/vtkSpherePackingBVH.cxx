// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingBVH.h"

#include "bridge/PackingSpheres.h"
#include "bridge/BoxOutput.h"
#include "bridge/FieldData.h"
#include "bridge/MemoryLimit.h"
#include "bridge/RadiusArray.h"
#include "bridge/SmpParallelFor.h"

#include "accel/BoxTree.h"

#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cmath>
#include <limits>
#include <stdexcept>

vtkStandardNewMacro(vtkSpherePackingBVH);

namespace
{
// What is held at the same time for a leaf: the nodes above it in the builder and in the tree.
constexpr double BytesPerLeaf = 512.0;

void AddLeafOfSphere(const spherepacking::BoxTree& tree, vtkPolyData* output)
{
  vtkNew<vtkIdTypeArray> leaves;
  leaves->SetName("leaf_of_sphere");
  leaves->SetNumberOfValues(static_cast<vtkIdType>(tree.Ids.size()));
  for (std::size_t id = 0; id < tree.Nodes.size(); ++id)
  {
    const spherepacking::BoxNode& node = tree.Nodes[id];
    if (node.IsLeaf())
    {
      for (std::int64_t i = node.First; i < node.First + node.Count; ++i)
      {
        leaves->SetValue(tree.Ids[i], static_cast<vtkIdType>(id));
      }
    }
  }
  output->GetFieldData()->AddArray(leaves);
}
}

//------------------------------------------------------------------------------
void vtkSpherePackingBVH::CheckOptions(vtkIdType spheres)
{
  const bool byDepth = this->Depth != -1;
  const std::string found = byDepth ? "depth: found " + std::to_string(this->Depth)
                                    : "boxes: found " + std::to_string(this->NumberOfBoxes);
  if (byDepth && this->Depth < 0)
  {
    throw std::invalid_argument(found + ", expected 0 or more, or -1 for a number of boxes");
  }
  if (!byDepth && this->NumberOfBoxes < 1)
  {
    throw std::invalid_argument(found + ", expected 1 or more");
  }
  spherepacking::CheckCount(spheres);
  const double wanted = byDepth ? std::exp2(this->Depth) : this->NumberOfBoxes;
  const double leaves = std::min(wanted, static_cast<double>(spheres));
  const double boxes = this->LeavesOnly ? leaves : 2.0 * leaves;
  if (leaves * BytesPerLeaf + boxes * spherepacking::BoxOutput::BytesPerBox >
    spherepacking::HalfOfMemory())
  {
    throw std::invalid_argument(
      found + ", which makes more boxes than fit in half of the memory, expected fewer");
  }
}

//------------------------------------------------------------------------------
void vtkSpherePackingBVH::MakeBoxes(vtkPolyData* packing, vtkDataArray* radii, const double[6],
  spherepacking::BoxOutput& boxes, vtkPolyData* output)
{
  const spherepacking::PackingSpheres spheres(packing, radii);
  const spherepacking::ParallelFor parallelFor = spherepacking::SmpParallelFor();
  const spherepacking::BoxTree tree = this->Depth < 0
    ? spherepacking::BuildBoxTreeOfLeaves(spheres.Get(), this->NumberOfBoxes, parallelFor)
    : spherepacking::BuildBoxTreeOfDepth(spheres.Get(), this->Depth, parallelFor);
  for (std::size_t id = 0; id < tree.Nodes.size(); ++id)
  {
    const spherepacking::BoxNode& node = tree.Nodes[id];
    if (node.IsLeaf() || !this->LeavesOnly)
    {
      boxes.Add(node.Bounds, static_cast<vtkIdType>(id), node.Depth, node.Count);
    }
  }
  AddLeafOfSphere(tree, output);
  spherepacking::AddFieldArray(output, "memory_bytes", { static_cast<double>(tree.Bytes()) });
  spherepacking::AddFieldArray(output, "sah_cost", { tree.SahCost() });
  spherepacking::AddFieldArray(output, "occupied_share", { tree.OccupiedFraction() });
}

//------------------------------------------------------------------------------
void vtkSpherePackingBVH::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfBoxes: " << this->NumberOfBoxes << "\n";
  os << indent << "Depth: " << this->Depth << "\n";
  os << indent << "LeavesOnly: " << this->LeavesOnly << "\n";
}
