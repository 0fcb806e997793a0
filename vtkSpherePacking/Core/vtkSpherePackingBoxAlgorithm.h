// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpherePackingBoxAlgorithm
 * @brief   what the filters from a packing to boxes have in common
 *
 * The output has six quads or twelve lines per box. Cell arrays, the same for all of a box:
 * `box_id`, `depth` and `count`. Field arrays of one value: `build_seconds`, until the boxes are
 * there, and what the subclass says of them. A packing without points has no boxes.
 *
 * An error leaves an empty output, is reported through vtkErrorMacro and sets GetErrorCode().
 * GetErrorMessage() is the sentence. Besides what the subclass refuses, radii that
 * vtkSpherePackingInput refuses are an error, and so are spheres that reach from so far to so far
 * that the difference is no finite number.
 *
 * @sa vtkSpherePackingBVH, vtkSpherePackingGrid
 */
#ifndef vtkSpherePackingBoxAlgorithm_h
#define vtkSpherePackingBoxAlgorithm_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSpherePackingCoreModule.h" // for the export macro

#include <string> // for std::string

class vtkDataArray;

namespace spherepacking
{
struct BoxOutput;
}

class VTKSPHEREPACKINGCORE_EXPORT vtkSpherePackingBoxAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkSpherePackingBoxAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Twelve lines per box instead of six quads. Off by default.
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
  vtkSpherePackingBoxAlgorithm() = default;
  ~vtkSpherePackingBoxAlgorithm() override = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /**
   * Throws std::invalid_argument with the sentence if the options cannot be followed for so many
   * spheres.
   */
  virtual void CheckOptions(vtkIdType spheres) = 0;

  /**
   * Adds the boxes, and arrays to the field data of `output`, which gets the rest afterwards. No
   * spheres come without `radii`.
   */
  virtual void MakeBoxes(vtkPolyData* packing, vtkDataArray* radii, const double bounds[6],
    spherepacking::BoxOutput& boxes, vtkPolyData* output) = 0;

private:
  vtkSpherePackingBoxAlgorithm(const vtkSpherePackingBoxAlgorithm&) = delete;
  void operator=(const vtkSpherePackingBoxAlgorithm&) = delete;

  bool BoxesAsLines = false;
  std::string RadiusArrayName = "radius";
  std::string ErrorMessage;
};

#endif
