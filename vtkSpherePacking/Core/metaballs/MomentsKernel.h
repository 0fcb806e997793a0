// SPDX-License-Identifier: BSD-3-Clause
#ifndef MomentsKernel_h
#define MomentsKernel_h

#include "metaballs/AxisShifts.h"
#include "metaballs/Moments.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// x^i y^j z^k / (i! j! k!), with those of larger exponents of z added to those that are kept.
///
/// Homogeneous polynomials of degree n are sums of x, y and z times their derivatives, over n.
/// Derivatives of these are monomials again, of which those that are not kept are minus the sum of
/// two others.
inline void Monomials(
  const MultiIndex& index, const Float8& x, const Float8& y, const Float8& z, Float8* monomials)
{
  const auto at = [&](int i, int j, int k) -> Float8& { return monomials[index(i, j, k)]; };
  const Float8 zero{};
  monomials[0] = zero + 1.0f;
  for (int degree = 1; degree <= index.Order; ++degree)
  {
    const float scale = 1.0f / static_cast<float>(degree);
    for (int k = 0; k <= std::min(degree, index.Top); ++k)
    {
      for (int j = 0; j + k <= degree; ++j)
      {
        const int i = degree - j - k;
        Float8 sum = (i > 0 ? x * at(i - 1, j, k) : zero) + (j > 0 ? y * at(i, j - 1, k) : zero);
        if (k > 0)
        {
          sum += z * at(i, j, k - 1);
        }
        else if (index.Top < index.Order)
        {
          sum -= z * ((i > 1 ? at(i - 2, j, 1) : zero) + (j > 1 ? at(i, j - 2, 1) : zero));
        }
        at(i, j, k) = sum * scale;
      }
    }
  }
}

/// Up to 64 charges, eight at once. Their places from the centre become single precision after the
/// centre is taken off.
inline void MomentsOfCharges(const MultiIndex& index, const ChargeNode& node, const Charge* charges,
  int count, double* moments)
{
  Float8 sums[MostKept] = {};
  Float8 monomials[MostKept];
  const double scale = -1.0 / UnitOf(node.Radius);
  for (int first = 0; first < count; first += 8)
  {
    Float8 point[3] = {};
    Float8 strength = {};
    for (int lane = 0; lane < std::min(8, count - first); ++lane)
    {
      const Charge& charge = charges[first + lane];
      strength[lane] = charge.Strength;
      for (int axis = 0; axis < 3; ++axis)
      {
        point[axis][lane] = static_cast<float>(scale * (charge.X[axis] - node.Center[axis]));
      }
    }
    Monomials(index, point[0], point[1], point[2], monomials);
    for (int place = 0; place < index.Count; ++place)
    {
      sums[place] += strength * monomials[place];
    }
  }
  for (int place = 0; place < index.Count; ++place)
  {
    const Float8& sum = sums[place];
    moments[place] +=
      ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
  }
}

/// A leaf has many charges only where these are at one place.
inline void MomentsOfLeaf(
  const MultiIndex& index, const ChargeNode& node, const Charge* charges, float* moments)
{
  double sums[MostKept] = {};
  constexpr std::int32_t most = 64;
  for (std::int32_t first = 0; first < node.Count; first += most)
  {
    MomentsOfCharges(
      index, node, charges + node.First + first, std::min(most, node.Count - first), sums);
  }
  std::copy_n(sums, index.Count, moments);
}

/// Sets the moments of up to eight nodes from those of their children.
inline void MomentsOfChildren(
  const ChargeTree& tree, const std::int32_t* nodes, int count, ClusterMoments& moments)
{
  const MultiIndex& kept = moments.Kept;
  Float8 sums[MostKept] = {};
  for (int child = 0; child < 2; ++child)
  {
    Float8 shifted[MostKept];
    Float8 away[3] = {};
    Float8 shrink = {};
    const float* from[8] = {};
    for (int lane = 0; lane < 8; ++lane)
    {
      const ChargeNode& whole = tree.Nodes[nodes[std::min(lane, count - 1)]];
      const ChargeNode& part = tree.Nodes[whole.Child + child];
      const double scale = 1.0 / UnitOf(whole.Radius);
      for (int axis = 0; axis < 3; ++axis)
      {
        away[axis][lane] = static_cast<float>(scale * (whole.Center[axis] - part.Center[axis]));
      }
      shrink[lane] = static_cast<float>(scale * UnitOf(part.Radius));
      from[lane] = moments[whole.Child + child];
    }
    Float8 shrinks[MostOrder + 1];
    shrinks[0] = Float8{} + 1.0f;
    for (int n = 1; n <= kept.Order; ++n)
    {
      shrinks[n] = shrinks[n - 1] * shrink;
    }
    ForEachMonomial(kept,
      [&](int i, int j, int k, int at) { shifted[at] = shrinks[i + j + k] * Gather(from, at); });
    ShiftMoments(kept, moments.All, away, shifted);
    for (int place = 0; place < kept.Count; ++place)
    {
      sums[place] += shifted[place];
    }
  }
  for (int lane = 0; lane < count; ++lane)
  {
    float* to = moments[nodes[lane]];
    for (int place = 0; place < kept.Count; ++place)
    {
      to[place] = sums[place][lane];
    }
  }
}

/// Sets the moments of nodes that are all leaves, or all of which have children that are done.
inline void ComputeMomentsKernel(
  const ChargeTree& tree, const std::int32_t* nodes, int count, ClusterMoments& moments)
{
  if (tree.Nodes[nodes[0]].Child >= 0)
  {
    for (int first = 0; first < count; first += 8)
    {
      MomentsOfChildren(tree, nodes + first, std::min(8, count - first), moments);
    }
    return;
  }
  for (int i = 0; i < count; ++i)
  {
    MomentsOfLeaf(moments.Kept, tree.Nodes[nodes[i]], tree.Charges.data(), moments[nodes[i]]);
  }
}
}
}

#endif
