// SPDX-License-Identifier: BSD-3-Clause
/// P2M: moments of charges about a centre.
#ifndef LeafMoments_h
#define LeafMoments_h

#include "base/Simd.h"
#include "metaballs/multipole/Moments.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// P2M: sums of charge times x^i y^j z^k / (i! j! k!), eight charges at a time, a sum per lane.
class MonomialSums
{
public:
  explicit MonomialSums(const MultiIndex& index)
    : Index(index)
  {
    for (int n = 0; n <= index.Order; ++n)
    {
      this->Inverse[n] = 1.0f / static_cast<float>(std::max(n, 1));
    }
    for (int row = -2; row < 0; ++row)
    {
      std::fill_n(this->Row(row, 0), index.Order + 1, Float8{});
      std::fill_n(this->Row(row, 1), index.Order + 1, Float8{});
    }
  }

  void Add(const Float8 (&position)[3], const Float8& charge)
  {
    if (this->Index.ZDegree < this->Index.Order)
    {
      this->AddReduced(position, charge);
    }
    else
    {
      this->AddFull(position, charge);
    }
  }

  /// Adds the sums of all lanes to `moments` and starts again from zero.
  void FlushTo(double* moments)
  {
    for (int first = 0; first < this->Index.Count; first += 8)
    {
      const Float8 totals = SumsOfLanes(this->Sums + first);
      for (int i = 0; i < std::min(8, this->Index.Count - first); ++i)
      {
        moments[first + i] += totals[i];
      }
    }
    std::fill_n(this->Sums, this->Index.Count, Float8{});
  }

private:
  void AddFull(const Float8 (&position)[3], const Float8& charge)
  {
    Float8 powers[3][MaxOrder + 1];
    for (int axis = 0; axis < 3; ++axis)
    {
      powers[axis][0] = Float8{} + 1.0f;
      for (int n = 1; n <= this->Index.Order; ++n)
      {
        powers[axis][n] = powers[axis][n - 1] * position[axis] * this->Inverse[n];
      }
    }
    Float8* sum = this->Sums;
    for (int k = 0; k <= this->Index.Order; ++k)
    {
      for (int j = 0; j + k <= this->Index.Order; ++j)
      {
        const Float8 row = charge * powers[2][k] * powers[1][j];
        for (int i = 0; i + j + k <= this->Index.Order; ++i)
        {
          *sum++ += row * powers[0][i];
        }
      }
    }
  }

  // A reduced moment (i, j, k), k = 0 or 1, is the sum over the charges of a polynomial F(i, j, k)
  // of x, y and z: its own monomial and what moments with k >= 2 contribute to it, see
  // MultiIndex.h. All terms have the degree n = i + j + k, so Euler's theorem on homogeneous
  // functions gives
  //
  //   n F = x dF/dx + y dF/dy + z dF/dz,
  //
  // and the derivatives are such polynomials again: F(i - 1, j, k) by x, F(i, j - 1, k) by y, and
  // by z F(i, j, 0) for k = 1 and -F(i - 2, j, 1) - F(i, j - 2, 1) for k = 0. With this recurrence
  // each moment takes five or six operations per charge.
  void AddReduced(const Float8 (&position)[3], const Float8& charge)
  {
    const int order = this->Index.Order;
    // x, y and z over each degree.
    Float8 over[3][MaxOrder + 1];
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int n = 1; n <= order; ++n)
      {
        over[axis][n] = position[axis] * this->Inverse[n];
      }
    }
    for (int j = 0; j <= order; ++j)
    {
      const Float8* evenBelow = this->Row(j - 1, 0);
      const Float8* oddBelow = this->Row(j - 1, 1);
      const Float8* oddTwoBelow = this->Row(j - 2, 1);
      Float8* evenSums = this->Sums + this->Index(0, j, 0);
      Float8* oddSums = j < order ? this->Sums + this->Index(0, j, 1) : nullptr;
      // F(i, j, 0) and F(i - 1, j, 1) stay in registers: the next ones wait for them.
      Float8 even = j == 0 ? charge : over[1][j] * evenBelow[0] - over[2][j] * oddTwoBelow[0];
      Float8 odd = {};
      for (int i = 0; i + j < order; ++i)
      {
        const int next = i + j + 1;
        const Float8 after =
          over[0][next] * odd + (over[1][next] * oddBelow[i] + over[2][next] * even);
        this->Row(j, 0)[i] = even;
        this->Row(j, 1)[i] = after;
        evenSums[i] += even;
        oddSums[i] += after;
        even = over[0][next] * even +
          (over[1][next] * evenBelow[i + 1] - over[2][next] * (odd + oddTwoBelow[i + 1]));
        odd = after;
      }
      evenSums[order - j] += even;
      this->Row(j, 0)[order - j] = even;
    }
  }

  // F(0, j, k) and those of larger i; the two rows before j = 0 stay zero.
  Float8* Row(int j, int k) { return this->Polynomials[k][j + 2]; }

  const MultiIndex& Index;
  float Inverse[MaxOrder + 1];
  Float8 Polynomials[2][MaxOrder + 3][MaxOrder + 1];
  Float8 Sums[(MaxReduced + 7) / 8 * 8] = {};
};

/// P2M: sets the moments of a node's charges, from positions relative to its centre as floats.
inline void MomentsOfLeaf(
  const MultiIndex& reduced, const ChargeNode& node, const Charge* charges, float* moments)
{
  MonomialSums sums(reduced);
  double totals[MaxReduced] = {};
  const double scale = node.Radius > 0.0 ? -1.0 / node.Radius : 0.0;
  for (std::int32_t first = 0; first < node.Count; first += 8)
  {
    Float8 position[3] = {};
    Float8 charge = {};
    for (int lane = 0; lane < std::min(8, node.Count - first); ++lane)
    {
      const Charge& from = charges[node.First + first + lane];
      charge[lane] = from.Strength;
      for (int axis = 0; axis < 3; ++axis)
      {
        position[axis][lane] =
          static_cast<float>(scale * (from.Position[axis] - node.Center[axis]));
      }
    }
    sums.Add(position, charge);
    // Floats would lose digits in longer sums, which only leaves of coincident charges have.
    if (first % 64 == 56)
    {
      sums.FlushTo(totals);
    }
  }
  sums.FlushTo(totals);
  std::copy_n(totals, reduced.Count, moments);
}
}
}

#endif
