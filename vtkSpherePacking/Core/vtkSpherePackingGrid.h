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
 * Cell arrays, the same for all quads or lines of a box: `box_id`, the index of the cell, x
 * fastest, then y, then z; `depth`, 0; `count`, how many spheres touch the cell. Field arrays of
 * one value: `build_seconds`; `memory_bytes`, of a table of the spheres of each cell with 4 bytes a
 * sphere and 8 a cell; `occupied_share` of the cells, from 0 to 1.
 *
 * An error leaves an empty output, is reported through vtkErrorMacro and sets GetErrorCode().
 * GetErrorMessage() is the sentence.
 *
 * @sa vtkSpherePackingInput
 */
#ifndef vtkSpherePackingGrid_h
#define vtkSpherePackingGrid_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSpherePackingCoreModule.h" // for the export macro

#include <string> // for std::string

class VTKSPHEREPACKINGCORE_EXPORT vtkSpherePackingGrid : public vtkPolyDataAlgorithm
{
public:
  static vtkSpherePackingGrid* New();
  vtkTypeMacro(vtkSpherePackingGrid, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How often each axis is cut, 0 or more, default 6. A negative number is an error when the filter
   * runs, and so are more cells than half of the machine's memory could count.
   */
  vtkSetMacro(Cuts, int);
  vtkGetMacro(Cuts, int);

  /**
   * Twelve lines a box instead of six quads. Off by default.
   */
  vtkSetMacro(BoxesAsLines, bool);
  vtkGetMacro(BoxesAsLines, bool);
  vtkBooleanMacro(BoxesAsLines, bool);

  /**
   * Name of the point array that holds the radii, default "radius".
   */
  vtkSetStdStringFromCharMacro(RadiusArrayName);
  vtkGetCharFromStdStringMacro(RadiusArrayName);

  /**
   * What was wrong in the last run; empty when nothing was.
   */
  const char* GetErrorMessage() const { return this->ErrorMessage.c_str(); }

protected:
  vtkSpherePackingGrid() = default;
  ~vtkSpherePackingGrid() override = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSpherePackingGrid(const vtkSpherePackingGrid&) = delete;
  void operator=(const vtkSpherePackingGrid&) = delete;
  int Fail(const std::string& message);

  int Cuts = 6;
  bool BoxesAsLines = false;
  std::string RadiusArrayName = "radius";
  std::string ErrorMessage;
};

#endif
