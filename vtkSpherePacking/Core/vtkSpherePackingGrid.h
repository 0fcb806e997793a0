// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpherePackingGrid
 * @brief   the cells of a uniform grid that spheres touch, as boxes
 *
 * The bounds of a packing, cut `Cuts` times along each axis, make (Cuts + 1)^3 cells. The output
 * has a box for each cell that a sphere touches, by the distance from the centre to the cell, so
 * that cells beside the rounding of a sphere stay empty. Cells and spheres are closed: a sphere
 * that ends on a face touches both sides. A sphere of radius 0 touches where its centre is.
 *
 * Cell arrays: `box_id`, the index of the cell, x fastest, then y, then z; `depth`, 0; `count`, how
 * many spheres touch the cell. Field arrays of one value: `build_seconds`; `memory_bytes`, what a
 * table of the spheres of each cell would take with 4 bytes per sphere and 8 per cell;
 * `occupied_share`, the fraction of the cells that are touched.
 *
 * The cells are counted here; no table is built. vtkSpherePackingTracer builds one of the same
 * cells for its `Cuts`, and a few bytes more, since that also lists spheres of radius above 0 that
 * miss a cell by rounding, and none of radius 0; its pictures tell the memory that it took.
 *
 * @sa vtkSpherePackingBoxAlgorithm
 */
#ifndef vtkSpherePackingGrid_h
#define vtkSpherePackingGrid_h

#include "vtkSpherePackingBoxAlgorithm.h"
#include "vtkSpherePackingCoreModule.h" // for the export macro

class VTKSPHEREPACKINGCORE_EXPORT vtkSpherePackingGrid : public vtkSpherePackingBoxAlgorithm
{
public:
  static vtkSpherePackingGrid* New();
  vtkTypeMacro(vtkSpherePackingGrid, vtkSpherePackingBoxAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How often each axis is cut, 0 or more, default 6. A negative number is an error when the filter
   * runs, and so are more cells than half of the machine's memory could count.
   */
  vtkSetMacro(Cuts, int);
  vtkGetMacro(Cuts, int);

protected:
  vtkSpherePackingGrid() = default;
  ~vtkSpherePackingGrid() override = default;
  void CheckOptions(vtkIdType spheres) override;
  void MakeBoxes(vtkPolyData* packing, vtkDataArray* radii, const double bounds[6],
    spherepacking::BoxOutput& boxes, vtkPolyData* output) override;

private:
  vtkSpherePackingGrid(const vtkSpherePackingGrid&) = delete;
  void operator=(const vtkSpherePackingGrid&) = delete;

  int Cuts = 6;
};

#endif
