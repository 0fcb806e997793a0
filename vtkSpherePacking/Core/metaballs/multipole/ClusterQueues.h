// SPDX-License-Identifier: BSD-3-Clause
#ifndef ClusterQueues_h
#define ClusterQueues_h

#include "metaballs/FieldScene.h"
#include "metaballs/multipole/LocalExpansion.h"
#include "metaballs/multipole/MomentsToLocal.h"

#include <algorithm>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Clusters on their way into one expansion, by the order that they need, until there are eight.
template <int Power>
class ClusterQueues
{
public:
  ClusterQueues(const FieldScene& scene, double unit)
    : Scene(scene)
    , Order(scene.Moments.Kept.Order)
    , Unit(static_cast<float>(unit))
  {
    std::fill_n(this->Sums, scene.Moments.Kept.Count, Float8{});
  }

  /// `away` points from the cluster's centre to that of the expansion.
  void Add(std::int32_t node, const double (&away)[3], double inverseDistance, int order)
  {
    Clusters& queue = this->Queues[order];
    const int lane = queue.Count++;
    queue.Moments[lane] = this->Scene.Moments[node];
    queue.X[lane] = static_cast<float>(away[0] * inverseDistance);
    queue.Y[lane] = static_cast<float>(away[1] * inverseDistance);
    queue.Z[lane] = static_cast<float>(away[2] * inverseDistance);
    queue.InverseDistance[lane] = static_cast<float>(inverseDistance);
    queue.Shrink[lane] = static_cast<float>(this->Scene.Tree.Nodes[node].Radius * inverseDistance);
    if (queue.Count == 8)
    {
      this->Translate(order);
    }
  }

  /// Adds all to the expansion.
  void AddTo(LocalExpansion& local)
  {
    for (int order = 0; order < this->Order; ++order)
    {
      this->Raise(order);
    }
    if (this->Queues[this->Order].Count > 0)
    {
      this->Fill(this->Queues[this->Order]);
      this->Translate(this->Order);
    }
    for (int place = 0; place < this->Scene.Moments.Kept.Count; ++place)
    {
      for (int lane = 0; lane < 8; ++lane)
      {
        local.Derivatives[place] += this->Sums[place][lane];
      }
    }
  }

private:
  void Translate(int order)
  {
    TranslateMoments<Power>(this->Scene.Moments.Kept, this->Scene.Indices[order],
      this->Queues[order], this->Unit, this->Sums);
    this->Queues[order].Count = 0;
  }

  // What is left of an order joins those of the next: more exact than it need be, but the more
  // often eight are together.
  void Raise(int order)
  {
    Clusters& queue = this->Queues[order];
    Clusters& next = this->Queues[order + 1];
    while (queue.Count > 0)
    {
      const int from = --queue.Count;
      const int to = next.Count++;
      next.Moments[to] = queue.Moments[from];
      next.X[to] = queue.X[from];
      next.Y[to] = queue.Y[from];
      next.Z[to] = queue.Z[from];
      next.InverseDistance[to] = queue.InverseDistance[from];
      next.Shrink[to] = queue.Shrink[from];
      if (next.Count == 8)
      {
        this->Translate(order + 1);
      }
    }
  }

  void Fill(Clusters& queue) const
  {
    for (int lane = queue.Count; lane < 8; ++lane)
    {
      queue.Moments[lane] = this->Scene.Nothing.data();
      queue.X[lane] = 1.0f;
      queue.Y[lane] = queue.Z[lane] = queue.Shrink[lane] = 0.0f;
      queue.InverseDistance[lane] = 1.0f;
    }
  }

  const FieldScene& Scene;
  const int Order;
  const float Unit;
  Clusters Queues[MostOrder + 1];
  Float8 Sums[MostKept];
};
}
}

#endif
