// SPDX-License-Identifier: BSD-3-Clause
#ifndef ChargeTree_h
#define ChargeTree_h

#include "base/ParallelFor.h"

#include <cstdint>
#include <vector>

namespace spherepacking
{
/// What makes a field: one point a sphere, coordinates scaled so that the scene is about 1 long.
struct Charge
{
  double X[3];
  float Strength;  ///< what the sphere adds, in the unit of its kernel; above 0
  float Radius;    ///< of the sphere
  std::int32_t Id; ///< of the sphere in the packing
};

/// Part of the charges, of which all lie in a ball.
struct ChargeNode
{
  double Center[3];
  double Radius;     ///< of the ball
  double MeanRadius; ///< of the charges' distances from the centre, by their 16th powers
  std::int32_t First = 0;
  std::int32_t Count = 0;
  std::int32_t Child = -1; ///< the first of two neighbours, or -1
  float MostRadius = 0.0f; ///< of the spheres
  float MostStrength = 0.0f;
};

/// Charges in the order of the leaves of a binary tree; node 0 is all of them.
struct ChargeTree
{
  std::vector<Charge> Charges;
  std::vector<ChargeNode> Nodes;
};

/// Halves boxes along their longest side until no leaf has more than `leaf` charges.
ChargeTree BuildChargeTree(
  std::vector<Charge>&& charges, std::int32_t leaf, const ParallelFor& parallelFor);
}

#endif
