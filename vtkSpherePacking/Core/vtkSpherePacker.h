// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpherePacker
 * @brief   fills a closed surface with spheres
 *
 * Puts sphere after sphere where about the largest fits that overlaps neither the surface nor
 * another sphere, until there are `NumberOfSpheres`, no sphere of `MinimumRadius` fits, or
 * `VolumeFraction` of the volume is filled. The spheres are sorted by radius, largest first, so
 * that the first of them are a packing, too. The radius of the first is within 3 % of the largest
 * possible, that of any other about two thirds or more of the largest that was still possible; each
 * is at a local maximum, where it touches what is around it. In gaps that are thin for their width,
 * where the search for the largest would take too long, the largest found in some time is taken.
 *
 * The surface may have coincident points, triangles of either orientation, non-manifold edges, and
 * several shells; a shell inside another bounds a hole. Where shells overlap, the volume counts
 * once for each of them. If edges are open, that is belong to an odd number of triangles, points
 * within 1e-7 of the longest side of the surface's box are merged and duplicate triangles are made
 * single; what is open then is an error that says where. What is inside is decided by the
 * generalised winding number. It is an error, too, if no sphere of `MinimumRadius` fits at all.
 *
 * The output has double precision, a vertex per sphere, the point array `radius`, and field arrays
 * of one value: `surface_volume`, in the cube of the input's unit; `volume_fraction`, the volume of
 * all spheres over that, or NaN where it would be above 1, because the surface crosses itself; and
 * `build_seconds`. The result depends on the seed, but not on the number of threads.
 *
 * ProgressEvent is invoked again and again; once an observer calls SetAbortExecute(), the output is
 * the spheres found so far and GetInterrupted() is true. Errors are reported through vtkErrorMacro,
 * and GetErrorMessage() is the sentence.
 *
 * Source of the problem: René Weller and Gabriel Zachmann, "ProtoSphere: a GPU-assisted prototype
 * guided sphere packing algorithm for arbitrary objects" (2010), which moves random points to
 * maxima of the distance. Here a branch-and-bound search finds these.
 */
#ifndef vtkSpherePacker_h
#define vtkSpherePacker_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSpherePackingCoreModule.h" // for the export macro

#include <functional>
#include <string>

class VTKSPHEREPACKINGCORE_EXPORT vtkSpherePacker : public vtkPolyDataAlgorithm
{
public:
  static vtkSpherePacker* New();
  vtkTypeMacro(vtkSpherePacker, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The maximum number of spheres, 1 or more, default 1000. Numbers below 1 are an error when the
   * filter runs.
   */
  vtkSetMacro(NumberOfSpheres, int);
  vtkGetMacro(NumberOfSpheres, int);

  /**
   * All radii are above this, in the unit of the input, 0 or more, default 0; they are also above
   * about a millionth of the longest side of the surface's box. Other numbers are an error when the
   * filter runs.
   */
  vtkSetMacro(MinimumRadius, double);
  vtkGetMacro(MinimumRadius, double);

  /**
   * The fraction of the volume at which to stop, above 0 and up to 1, default 1, which sets no
   * limit. Other numbers are an error when the filter runs.
   */
  vtkSetMacro(VolumeFraction, double);
  vtkGetMacro(VolumeFraction, double);

  /**
   * The seed of the random shift of the search's octree, any number, default 0: another one gives
   * another packing.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);

  /**
   * The error of the last run, empty if there was none.
   */
  const char* GetErrorMessage() const { return this->ErrorMessage.c_str(); }

  /**
   * Whether the last run was stopped by an observer.
   */
  vtkGetMacro(Interrupted, bool);

protected:
  vtkSpherePacker() = default;
  ~vtkSpherePacker() override = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSpherePacker(const vtkSpherePacker&) = delete;
  void operator=(const vtkSpherePacker&) = delete;

  void Pack(vtkPolyData* surface, vtkPolyData* output);
  void CheckParameters() const;
  [[noreturn]] void RefuseForNoSphere() const;

  // Reports progress now and then; returns whether to go on.
  std::function<bool()> AbortCheck();

  int NumberOfSpheres = 1000;
  double MinimumRadius = 0.0;
  double VolumeFraction = 1.0;
  int Seed = 0;
  bool Interrupted = false;
  std::string ErrorMessage;
};

#endif
