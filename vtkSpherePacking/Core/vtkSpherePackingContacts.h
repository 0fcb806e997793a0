// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpherePackingContacts
 * @brief   lines between the centres of spheres that touch
 *
 * Two spheres touch if the distance of their surfaces is at most `Gap`. That distance is, in double
 * precision, sqrt((dx dx + dy dy) + dz dz) - (ri + rj) with d = (cj - ci) + shift; no tolerance is
 * added, so spheres that touch on paper alone need a small gap.
 *
 * Every contact is a line, ordered by `i`, then `j`, i < j. Cell arrays: `gap`, the distance of the
 * surfaces, negative where spheres overlap; `overlap`, the amount by which they do, else 0; `i` and
 * `j` (int32), the spheres. The points are the packing's, in its order and with its arrays, and the
 * point array `coordination` (int32): how many contacts the sphere has.
 *
 * Field arrays `cell_vectors` (3 tuples a, b, c), `cell_origin` and `cell_periodic` of the packing
 * repeat it along the periodic vectors, which need not be orthogonal, and spheres need not lie in
 * the cell. Every image counts: two spheres may touch several times, and a sphere its own image,
 * which counts as two contacts of it. The cell array `cell_shift` (int32, 3 components) then says
 * how often each vector is added to the centre of j. Lines end at the image: for each contact with
 * a shift there is a further point behind the packing's, which has the arrays of its sphere.
 *
 * An error leaves an empty output, is reported through vtkErrorMacro and sets GetErrorCode();
 * GetErrorMessage() is the sentence. Errors are radii that vtkSpherePackingInput refuses,
 * coordinates beyond 1e30, periodic vectors that span no cell or so small a one that a sphere
 * reaches 100 000 of its images, and more contacts than fit in half of the memory.
 *
 * @sa vtkSpherePackingInput
 */
#ifndef vtkSpherePackingContacts_h
#define vtkSpherePackingContacts_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSpherePackingCoreModule.h" // for the export macro

#include <atomic>
#include <atomic> // for std::atomic
#include <string> // for std::string

class VTKSPHEREPACKINGCORE_EXPORT vtkSpherePackingContacts : public vtkPolyDataAlgorithm
{
public:
  static vtkSpherePackingContacts* New();
  vtkTypeMacro(vtkSpherePackingContacts, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The largest distance of two surfaces that counts as a contact, in the unit of the points.
   * Default 0. Below 0 only spheres count that overlap by that much.
   */
  vtkSetMacro(Gap, double);
  vtkGetMacro(Gap, double);
  ///@}

  ///@{
  /**
   * Name of the point array that holds the radii, default "radius".
   */
  vtkSetStdStringFromCharMacro(RadiusArrayName);
  vtkGetCharFromStdStringMacro(RadiusArrayName);
  ///@}

  /**
   * What was wrong in the last run; empty when nothing was.
   */
  const char* GetErrorMessage() const { return this->ErrorMessage.c_str(); }

protected:
  vtkSpherePackingContacts() = default;
  ~vtkSpherePackingContacts() override = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSpherePackingContacts(const vtkSpherePackingContacts&) = delete;
  void operator=(const vtkSpherePackingContacts&) = delete;

  void Find(vtkPolyData* packing, vtkPolyData* output, std::atomic<double>& done);

  double Gap = 0.0;
  std::string RadiusArrayName = "radius";
  std::string ErrorMessage;
};

#endif
