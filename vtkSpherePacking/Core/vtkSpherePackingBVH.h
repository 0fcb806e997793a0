// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpherePackingBVH
 * @brief   the boxes of a binary bounding volume hierarchy of a packing, to be looked at
 *
 * The spheres of a packing are split in two over and over by the surface-area heuristic over all
 * axes, and the output has the boxes of the leaves or of all nodes of this binary tree. Every
 * sphere, of radius 0 too, lies in exactly one leaf. The boxes are the bounds of their spheres, in
 * double precision. A leaf of several spheres can always be split, if need be by their number, so
 * that there are as many leaves as wanted unless there are fewer spheres. The tree is the same in
 * every run.
 *
 * It is not the hierarchy that rays traverse in vtkSpherePackingTracer. That one comes from the
 * same splits, but collapsed to eight children per node and up to eight spheres per leaf, in single
 * precision with boxes that are enlarged by what rounding needs, and without spheres of radius 0:
 * its boxes are not bounds, and it has no cut into any wanted number of them, down to single
 * spheres. So `memory_bytes` and `build_seconds` here are not those of ray casting, whose pictures
 * tell their own.
 *
 * `Depth` says how far to split if it is 0 or more, otherwise `NumberOfBoxes` does.
 *
 * Cell arrays: `box_id`, the index of the node, numbered depth first from 0 for the root, whether
 * all are there or not; `depth`, 0 for the root; `count`, how many spheres lie in the box. Field
 * arrays of one value: `build_seconds`; `memory_bytes`, of the nodes and 4 bytes per sphere;
 * `sah_cost`; `occupied_share`, the sum of the volumes of the leaves over that of the root,
 * overlaps counted as often as they occur, 0 if the root has no volume. Another field array has one
 * value per sphere: `leaf_of_sphere`, the `box_id` of its leaf.
 *
 * The SAH cost is the expected number of nodes and spheres that a random ray through the root's box
 * has to be tested against: the sum over all nodes of the surface of their box over that of the
 * root, plus the sum of the same times `count` over the leaves; 0 if the root has no surface, so
 * that no random ray meets it. Sources: J. Goldsmith and J. Salmon, "Automatic Creation of Object
 * Hierarchies for Ray Tracing" (1987); J. D. MacDonald and K. S. Booth, "Heuristics for Ray Tracing
 * Using Space Subdivision" (1990).
 *
 * @sa vtkSpherePackingBoxAlgorithm, vtkSpherePackingTracer
 */
#ifndef vtkSpherePackingBVH_h
#define vtkSpherePackingBVH_h

#include "vtkSpherePackingBoxAlgorithm.h"
#include "vtkSpherePackingCoreModule.h" // for the export macro

class VTKSPHEREPACKINGCORE_EXPORT vtkSpherePackingBVH : public vtkSpherePackingBoxAlgorithm
{
public:
  static vtkSpherePackingBVH* New();
  vtkTypeMacro(vtkSpherePackingBVH, vtkSpherePackingBoxAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How many leaves there are, 1 or more, default 15; fewer if there are fewer spheres. The leaf
   * whose split lowers the SAH cost most, or raises it least, is split first. Numbers below 1 are
   * an error when the filter runs, and so are more boxes than fit in half of the memory.
   */
  vtkSetMacro(NumberOfBoxes, int);
  vtkGetMacro(NumberOfBoxes, int);

  /**
   * The depth down to which every node of more than one sphere is split, 0 for the root alone, or
   * -1, the default, for `NumberOfBoxes` leaves. Numbers below -1 are an error when the filter
   * runs, and so are more boxes than fit in half of the memory.
   */
  vtkSetMacro(Depth, int);
  vtkGetMacro(Depth, int);

  /**
   * The boxes of the leaves alone, instead of all nodes. On by default.
   */
  vtkSetMacro(LeavesOnly, bool);
  vtkGetMacro(LeavesOnly, bool);
  vtkBooleanMacro(LeavesOnly, bool);

protected:
  vtkSpherePackingBVH() = default;
  ~vtkSpherePackingBVH() override = default;
  void CheckOptions(vtkIdType spheres) override;
  void MakeBoxes(vtkPolyData* packing, vtkDataArray* radii, const double bounds[6],
    spherepacking::BoxOutput& boxes, vtkPolyData* output) override;

private:
  vtkSpherePackingBVH(const vtkSpherePackingBVH&) = delete;
  void operator=(const vtkSpherePackingBVH&) = delete;

  int NumberOfBoxes = 15;
  int Depth = -1;
  bool LeavesOnly = true;
};

#endif
