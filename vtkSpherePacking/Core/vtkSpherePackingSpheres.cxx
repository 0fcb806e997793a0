// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingSpheres.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
struct CopySpheres
{
  template <typename PointsT, typename RadiiT>
  void operator()(PointsT* points, RadiiT* radii, spherepacking::Sphere* spheres)
  {
    const auto centers = vtk::DataArrayTupleRange<3>(points);
    const auto r = vtk::DataArrayValueRange<1>(radii);
    vtkSMPTools::For(0, centers.size(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          spheres[i] = { static_cast<double>(centers[i][0]), static_cast<double>(centers[i][1]),
            static_cast<double>(centers[i][2]), static_cast<double>(r[i]) };
        }
      });
  }
};
}

//------------------------------------------------------------------------------
std::vector<spherepacking::Sphere> vtkSpherePackingSpheresOf(
  vtkPolyData* packing, vtkDataArray* radii)
{
  std::vector<spherepacking::Sphere> spheres;
  if (radii)
  {
    spheres.resize(radii->GetNumberOfTuples());
    vtkDataArray* points = packing->GetPoints()->GetData();
    CopySpheres worker;
    using Dispatcher =
      vtkArrayDispatch::Dispatch2ByValueType<vtkArrayDispatch::Reals, vtkArrayDispatch::AllTypes>;
    if (!Dispatcher::Execute(points, radii, worker, spheres.data()))
    {
      worker(points, radii, spheres.data());
    }
  }
  return spheres;
}
VTK_ABI_NAMESPACE_END
