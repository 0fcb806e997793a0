// SPDX-License-Identifier: BSD-3-Clause
#ifndef ChargeTree_h
#define ChargeTree_h

#include "base/ParallelFor.h"
#include "metaballs/field/Charge.h"

#include <cstdint>
#include <vector>

namespace spherepacking
{
/// A node of the tree, which stands for a cluster: some of the charges, and a ball around them.
struct ChargeNode
{
  double Center[3];
  double Radius;     ///< the largest distance of a charge from the centre
  double MeanRadius; ///< the power mean m of those distances in TruncationError.h
  std::int32_t First = 0;
  std::int32_t Count = 0;
  std::int32_t Child = -1; ///< the first of two siblings, or -1 for a leaf
  float MaxRadius = 0.0f;  ///< of the spheres
  float MaxStrength = 0.0f;
};

/// A binary tree of charges, which are in the order of its leaves. Node 0 is the root; there is
/// none without charges.
struct ChargeTree
{
  std::vector<Charge> Charges;
  std::vector<ChargeNode> Nodes; ///< parents before their children
};

/// Splits the charges' bounding boxes in the middle of their longest side, down to leaves of at
/// most `leafSize` charges; more only where these are coincident.
ChargeTree BuildChargeTree(
  std::vector<Charge>&& charges, std::int32_t leafSize, const ParallelFor& parallelFor);
}

#endif
