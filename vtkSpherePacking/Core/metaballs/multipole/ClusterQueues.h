// SPDX-License-Identifier: BSD-3-Clause
#ifndef ClusterQueues_h
#define ClusterQueues_h

#include "metaballs/multipole/LocalExpansion.h"
#include "metaballs/multipole/MomentsToLocal.h"
#include "metaballs/multipole/Multipoles.h"

#include <algorithm>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Batches clusters for M2L: queues those for one local expansion by the order that they need, and
/// translates eight at once.
template <int Power>
class ClusterQueues
{
public:
  /// `unit` is that of the local expansion.
  ClusterQueues(const ChargeTree& tree, const Multipoles& multipoles, double unit)
    : Tree(tree)
    , Expansions(multipoles)
    , Order(multipoles.Moments.Reduced.Order)
    , Unit(static_cast<float>(unit))
  {
    std::fill_n(this->Sums, multipoles.Moments.Reduced.Count, Float8{});
  }

  /// `separation` is the vector from the cluster's centre to that of the expansion.
  void Add(std::int32_t node, const double (&separation)[3], double inverseDistance, int order)
  {
    ClusterBatch& queue = this->Queues[order];
    const int lane = queue.Count++;
    queue.Moments[lane] = this->Expansions.Moments[node];
    queue.X[lane] = static_cast<float>(separation[0] * inverseDistance);
    queue.Y[lane] = static_cast<float>(separation[1] * inverseDistance);
    queue.Z[lane] = static_cast<float>(separation[2] * inverseDistance);
    queue.InverseDistance[lane] = static_cast<float>(inverseDistance);
    queue.RadiusRatio[lane] = static_cast<float>(this->Tree.Nodes[node].Radius * inverseDistance);
    if (queue.Count == 8)
    {
      this->Translate(order);
    }
  }

  /// Translates what is queued and adds the sum of all to the expansion.
  void FlushTo(LocalExpansion& local)
  {
    for (int order = 0; order < this->Order; ++order)
    {
      this->Raise(order);
    }
    if (this->Queues[this->Order].Count > 0)
    {
      this->FillUp(this->Queues[this->Order]);
      this->Translate(this->Order);
    }
    for (int n = 0; n < this->Expansions.Moments.Reduced.Count; ++n)
    {
      for (int lane = 0; lane < 8; ++lane)
      {
        local.Derivatives[n] += this->Sums[n][lane];
      }
    }
  }

private:
  void Translate(int order)
  {
    MomentsToLocal<Power>(this->Expansions.Moments.Reduced, this->Expansions.Indices[order],
      this->Queues[order], this->Unit, this->Sums);
    this->Queues[order].Count = 0;
  }

  // Moves the remaining clusters of an order to the queue of the next: more accurate than they
  // need, but more batches are full.
  void Raise(int order)
  {
    ClusterBatch& queue = this->Queues[order];
    ClusterBatch& next = this->Queues[order + 1];
    while (queue.Count > 0)
    {
      const int from = --queue.Count;
      const int to = next.Count++;
      next.Moments[to] = queue.Moments[from];
      next.X[to] = queue.X[from];
      next.Y[to] = queue.Y[from];
      next.Z[to] = queue.Z[from];
      next.InverseDistance[to] = queue.InverseDistance[from];
      next.RadiusRatio[to] = queue.RadiusRatio[from];
      if (next.Count == 8)
      {
        this->Translate(order + 1);
      }
    }
  }

  // Gives unused lanes clusters without charges.
  void FillUp(ClusterBatch& queue) const
  {
    for (int lane = queue.Count; lane < 8; ++lane)
    {
      queue.Moments[lane] = this->Expansions.Zeros.data();
      queue.X[lane] = 1.0f;
      queue.Y[lane] = queue.Z[lane] = queue.RadiusRatio[lane] = 0.0f;
      queue.InverseDistance[lane] = 1.0f;
    }
  }

  const ChargeTree& Tree;
  const Multipoles& Expansions;
  const int Order;
  const float Unit;
  ClusterBatch Queues[MaxOrder + 1];
  Float8 Sums[MaxReduced]; // of the derivatives, lane by lane
};
}
}

#endif
