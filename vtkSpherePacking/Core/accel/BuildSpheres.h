// SPDX-License-Identifier: BSD-3-Clause
/// What builders of hierarchies work on: spheres that are sorted into the order of the leaves.
#ifndef BuildSpheres_h
#define BuildSpheres_h

#include "base/ParallelFor.h"
#include "base/SphereArrays.h"
#include "base/HugeArray.h"
#include "accel/SahSplit.h"

#include <utility>

namespace spherepacking
{
/// A range of BuildSpheres, the box of the spheres and that of their centres.
struct BuildRange
{
  std::int64_t First = 0;
  std::int64_t Count = 0;
  FloatBox Box;
  FloatBox Centers;
};

class BuildSpheres
{
public:
  /// Takes those of `spheres` with a radius above `least`, in coordinates from -1 to 1.
  BuildSpheres(const SphereArrays& spheres, double least, const ParallelFor& parallelFor);

  HugeArray<BuildSphere> Spheres;
  HugeArray<std::int32_t> Ids;
  std::int64_t Count;
  double Center[3];
  double Scale;

  BuildRange All() const;

  /// Partitions the spheres of `range` by the best SAH split and returns the two sides. Where all
  /// centres coincide the range is halved by number. `range` has two spheres at least.
  std::pair<BuildRange, BuildRange> Split(const BuildRange& range);

  /// The two halves of a range in its present order.
  std::pair<BuildRange, BuildRange> Halve(const BuildRange& range) const;

private:
  void FindBounds(const SphereArrays& spheres);
  SahSplit Find(const BuildRange& range, const SahBinning& binning, int bins) const;
  std::int64_t Partition(const BuildRange& range, const SahBinning& binning, const SahSplit& split,
    FloatBox (&centers)[2]);
  std::int64_t PartitionPart(std::int64_t first, std::int64_t last, const SahBinning& binning,
    const SahSplit& split, FloatBox (&centers)[2]);
  std::int64_t PartitionInParallel(const BuildRange& range, const SahBinning& binning,
    const SahSplit& split, FloatBox (&centers)[2]);

  // Scratch space of the partitioning.
  HugeArray<BuildSphere> ScratchSpheres;
  HugeArray<std::int32_t> ScratchIds;
  const ParallelFor& For;
};
}

#endif
