// SPDX-License-Identifier: BSD-3-Clause
/// Moments of charges about a centre.
#ifndef LeafMoments_h
#define LeafMoments_h

#include "base/Simd.h"
#include "metaballs/multipole/Moments.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Sums of charge times x^i y^j z^k / (i! j! k!), lane by lane, of charges that come in eights.
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

  void Add(const Float8 (&place)[3], const Float8& charge)
  {
    if (this->Index.Top < this->Index.Order)
    {
      this->AddFolded(place, charge);
    }
    else
    {
      this->AddAll(place, charge);
    }
  }

  /// Adds the lanes' sums to `moments` and sets them to zero.
  void MoveTo(double* moments)
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
  void AddAll(const Float8 (&place)[3], const Float8& charge)
  {
    Float8 powers[3][MostOrder + 1];
    for (int axis = 0; axis < 3; ++axis)
    {
      powers[axis][0] = Float8{} + 1.0f;
      for (int n = 1; n <= this->Index.Order; ++n)
      {
        powers[axis][n] = powers[axis][n - 1] * place[axis] * this->Inverse[n];
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

  // Those of larger exponents of z are added to the ones that are kept, k = 0 and 1, which become
  // homogeneous polynomials of degree n: sums of x, y and z times their derivatives, over n.
  // Derivatives of these are such polynomials again; that of (i, j, 1) by z is (i, j, 0), that of
  // (i, j, 0) by z is minus the sum of (i - 2, j, 1) and (i, j - 2, 1).
  void AddFolded(const Float8 (&place)[3], const Float8& charge)
  {
    const int order = this->Index.Order;
    // Over each degree; x, y and z.
    Float8 over[3][MostOrder + 1];
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int n = 1; n <= order; ++n)
      {
        over[axis][n] = place[axis] * this->Inverse[n];
      }
    }
    for (int j = 0; j <= order; ++j)
    {
      const Float8* evenBelow = this->Row(j - 1, 0);
      const Float8* oddBelow = this->Row(j - 1, 1);
      const Float8* oddTwoBelow = this->Row(j - 2, 1);
      Float8* evenSums = this->Sums + this->Index(0, j, 0);
      Float8* oddSums = j < order ? this->Sums + this->Index(0, j, 1) : nullptr;
      // Of i and i - 1, in registers, since the next wait for them.
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
        // That of i + 1.
        even = over[0][next] * even +
          (over[1][next] * evenBelow[i + 1] - over[2][next] * (odd + oddTwoBelow[i + 1]));
        odd = after;
      }
      evenSums[order - j] += even;
      this->Row(j, 0)[order - j] = even;
    }
  }

  // The two rows before the first stay zero.
  Float8* Row(int j, int k) { return this->Polynomials[k][j + 2]; }

  const MultiIndex& Index;
  float Inverse[MostOrder + 1];
  Float8 Polynomials[2][MostOrder + 3][MostOrder + 1];
  Float8 Sums[(MostKept + 7) / 8 * 8] = {};
};

/// Their places from the centre become single precision after the centre is taken off.
inline void MomentsOfLeaf(
  const MultiIndex& index, const ChargeNode& node, const Charge* charges, float* moments)
{
  MonomialSums sums(index);
  double totals[MostKept] = {};
  const double scale = node.Radius > 0.0 ? -1.0 / node.Radius : 0.0;
  for (std::int32_t first = 0; first < node.Count; first += 8)
  {
    Float8 place[3] = {};
    Float8 charge = {};
    for (int lane = 0; lane < std::min(8, node.Count - first); ++lane)
    {
      const Charge& from = charges[node.First + first + lane];
      charge[lane] = from.Strength;
      for (int axis = 0; axis < 3; ++axis)
      {
        place[axis][lane] = static_cast<float>(scale * (from.X[axis] - node.Center[axis]));
      }
    }
    sums.Add(place, charge);
    // A leaf has many charges only where these are at one place.
    if (first % 64 == 56)
    {
      sums.MoveTo(totals);
    }
  }
  sums.MoveTo(totals);
  std::copy_n(totals, index.Count, moments);
}
}
}

#endif
