// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpherePackingInput
 * @brief   what every algorithm asks of a packing before it works on it
 *
 * A packing is a vtkPolyData: its points are the centres of the spheres, a point array of one
 * component holds their radii, and every other point array rides along.
 *
 * @sa vtkSpherePackingReader, vtkOpenGLSpherePackingMapper
 */
#ifndef vtkSpherePackingInput_h
#define vtkSpherePackingInput_h

#include "vtkObject.h"
#include "vtkSpherePackingCoreModule.h" // for the export macro

class vtkDataArray;
class vtkPolyData;

class VTKSPHEREPACKINGCORE_EXPORT vtkSpherePackingInput : public vtkObject
{
public:
  static vtkSpherePackingInput* New();
  vtkTypeMacro(vtkSpherePackingInput, vtkObject);

  /**
   * The radii of `packing`, or null together with a sentence in GetMessage() that names what was
   * found and what was expected. Accepted is a point array named `name` of any numeric type with
   * one component, one value per point, all values finite and not negative, over centres that are
   * finite. A packing without points needs no array and yields null with an empty message.
   */
  vtkDataArray* FindRadii(vtkPolyData* packing, const char* name);

  /**
   * Why the last FindRadii() found nothing; empty when there was no error.
   */
  const char* GetMessage() const { return this->Message.c_str(); }

  /**
   * The box around all spheres of `packing`, xmin, xmax, ymin, ymax, zmin, zmax, in the space of
   * its points. Spheres of radius 0 count as points. Without points the box is uninitialised in
   * the sense of vtkMath::UninitializeBounds().
   */
  static void ComputeBounds(vtkPolyData* packing, vtkDataArray* radii, double bounds[6]);

protected:
  vtkSpherePackingInput() = default;
  ~vtkSpherePackingInput() override = default;

private:
  vtkSpherePackingInput(const vtkSpherePackingInput&) = delete;
  void operator=(const vtkSpherePackingInput&) = delete;

  std::string Message;
};

#endif
