// SPDX-License-Identifier: BSD-3-Clause
// What a vtkSpherePackingTracer keeps of a packing between its runs. Private to the module.
#ifndef vtkSpherePackingTracerInternals_h
#define vtkSpherePackingTracerInternals_h

#include "vtkSpherePackingArrays.h"

#include "kernels/TraceTile.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;

struct vtkSpherePackingTracerInternals
{
  // The arrays that the structure was built from, and when they had last changed.
  vtkSmartPointer<vtkDataArray> Points;
  vtkSmartPointer<vtkDataArray> Radii;
  vtkMTimeType Time = 0;
  int Structure = -1;
  int Cuts = -1;

  std::unique_ptr<vtkSpherePackingArrays> Arrays;
  std::unique_ptr<spherepacking::Bvh> Hierarchy;
  std::unique_ptr<spherepacking::GridTable> Table;
  std::vector<unsigned char> Colors; // RGBA a sphere
  std::string ColorState;            // what they were made of
  double BuildSeconds = 0.0;

  double Bytes() const
  {
    return this->Hierarchy ? static_cast<double>(this->Hierarchy->Bytes())
      : this->Table        ? static_cast<double>(this->Table->Bytes())
                           : 0.0;
  }

  spherepacking::Scene Scene() const
  {
    spherepacking::Scene scene;
    if (this->Arrays)
    {
      scene.Spheres = this->Arrays->Get();
    }
    scene.Hierarchy = this->Hierarchy.get();
    scene.Table = this->Table.get();
    scene.Colors = this->Colors.data();
    return scene;
  }
};
VTK_ABI_NAMESPACE_END

#endif
