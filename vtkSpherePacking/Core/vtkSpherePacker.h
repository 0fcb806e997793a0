// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpherePacker
 * @brief   fills a closed surface with spheres
 *
 * From a closed surface to a packing: again and again a sphere is put where about the largest fits
 * that overlaps neither the surface nor another sphere, until there are `NumberOfSpheres`, no
 * sphere of `MinimumRadius` fits, or `VolumeFraction` of the volume is filled. They are sorted by
 * their radii, largest first, so that the first of them are a packing, too. The first sphere is the
 * largest that fits to within 3 %, others are about two thirds of the largest that would fit then,
 * or larger; all touch what is around them. In gaps that are thin for their width, the largest that
 * was found in some time is taken.
 *
 * Surfaces may have points that coincide, triangles that are turned either way, edges that more
 * than two triangles share, and several shells; one that lies within another is a hole. What shells
 * that overlap share counts several times in the volume. Where edges have an odd number of
 * triangles, points that are within 1e-7 of the surface's longest side are taken for one, and of
 * several triangles between the same points one is left; what is open then is an error that says
 * where. What is inside is decided by the generalised winding number. No sphere of `MinimumRadius`
 * at all is an error, too.
 *
 * The output has double precision, a vertex for each sphere, the point array `radius`, and field
 * arrays of one value: `surface_volume`, in the cube of the input's unit, `volume_fraction`, the
 * volume of all spheres over that, not a number where the surface crosses itself so much that it
 * would be above 1, and `build_seconds`. The result depends on the seed, not on the
 * number of threads.
 *
 * ProgressEvent is invoked all the time; an observer may call SetAbortExecute(), then the spheres
 * that are there are the output and GetInterrupted() is true. Errors are reported through
 * vtkErrorMacro, and GetErrorMessage() is the sentence.
 *
 * Source of the problem: René Weller and Gabriel Zachmann, "ProtoSphere: a GPU-assisted prototype
 * guided sphere packing algorithm for arbitrary objects" (2010), which moves random points to
 * places of largest distance. Here a branch-and-bound search finds these.
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
   * How many spheres at most, 1 or more, default 1000. Numbers below 1 are an error when the filter
   * runs.
   */
  vtkSetMacro(NumberOfSpheres, int);
  vtkGetMacro(NumberOfSpheres, int);

  /**
   * Radii are above this, in the unit of the input, 0 or more, default 0: and anyway above about
   * a millionth of the longest side of the surface's box. Other numbers are an error when the
   * filter runs.
   */
  vtkSetMacro(MinimumRadius, double);
  vtkGetMacro(MinimumRadius, double);

  /**
   * Part of the volume that is enough, above 0 and up to 1, default 1. Other numbers are an error
   * when the filter runs.
   */
  vtkSetMacro(VolumeFraction, double);
  vtkGetMacro(VolumeFraction, double);

  /**
   * Another seed gives another packing: it shifts the octree of the search. Any number, default 0.
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
