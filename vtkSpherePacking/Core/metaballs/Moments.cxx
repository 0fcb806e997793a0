// SPDX-License-Identifier: BSD-3-Clause
#include "metaballs/Moments.h"

#include <algorithm>

namespace spherepacking
{
namespace
{
class Computer
{
public:
  Computer(const ChargeTree& tree, ClusterMoments& moments)
    : Tree(tree)
    , Moments(moments)
    , Index(moments.Index)
  {
  }

  void OfCharges(const ChargeNode& node, float* moments) const
  {
    double sums[MostMonomials] = {};
    double monomials[MostMonomials];
    const double scale = -1.0 / UnitOf(node.Radius);
    for (std::int32_t i = node.First; i < node.First + node.Count; ++i)
    {
      const Charge& charge = this->Tree.Charges[i];
      const double point[3] = { scale * (charge.X[0] - node.Center[0]),
        scale * (charge.X[1] - node.Center[1]), scale * (charge.X[2] - node.Center[2]) };
      Monomials(this->Index, point, monomials);
      for (int place = 0; place < this->Index.Count; ++place)
      {
        sums[place] += charge.Strength * monomials[place];
      }
    }
    std::copy_n(sums, this->Index.Count, moments);
  }

  void OfChildren(const ChargeNode& node, float* moments) const
  {
    double sums[MostMonomials] = {};
    for (std::int32_t child = node.Child; child < node.Child + 2; ++child)
    {
      this->Shift(this->Tree.Nodes[child], this->Moments[child], node, sums);
    }
    std::copy_n(sums, this->Index.Count, moments);
  }

private:
  // Adds the moments of a part to those of the whole, which the binomial theorem makes a sum over
  // products with the monomials of the shift.
  void Shift(
    const ChargeNode& part, const float* moments, const ChargeNode& whole, double* sums) const
  {
    const double unit = UnitOf(whole.Radius);
    double point[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = (whole.Center[axis] - part.Center[axis]) / unit;
    }
    double shifts[MostMonomials];
    Monomials(this->Index, point, shifts);
    double shrinks[MostOrder + 1] = { 1.0 };
    for (int n = 1; n <= this->Index.Order; ++n)
    {
      shrinks[n] = shrinks[n - 1] * (UnitOf(part.Radius) / unit);
    }
    ForEachMonomial(this->Index,
      [&](int i, int j, int k, int place)
      {
        const double moment = moments[place] * shrinks[i + j + k];
        const int most = this->Index.Order - i - j - k;
        for (int a = 0; a <= most; ++a)
        {
          for (int b = 0; a + b <= most; ++b)
          {
            double* to = sums + this->Index.Rows[i + a][j + b] + k;
            const double* by = shifts + this->Index.Rows[a][b];
            for (int c = 0; a + b + c <= most; ++c)
            {
              to[c] += moment * by[c];
            }
          }
        }
      });
  }

  const ChargeTree& Tree;
  const ClusterMoments& Moments;
  const MultiIndex& Index;
};
}

//------------------------------------------------------------------------------
void Monomials(const MultiIndex& index, const double (&point)[3], double* monomials)
{
  double powers[3][MostOrder + 1];
  for (int axis = 0; axis < 3; ++axis)
  {
    powers[axis][0] = 1.0;
    for (int n = 1; n <= index.Order; ++n)
    {
      powers[axis][n] = powers[axis][n - 1] * point[axis] / n;
    }
  }
  ForEachMonomial(index, [&](int i, int j, int k, int place)
    { monomials[place] = powers[0][i] * powers[1][j] * powers[2][k]; });
}

//------------------------------------------------------------------------------
ClusterMoments ComputeMoments(const ChargeTree& tree, int order, const ParallelFor& parallelFor)
{
  ClusterMoments moments;
  moments.Index = MultiIndex(order);
  const auto count = static_cast<std::int64_t>(tree.Nodes.size());
  moments.Values.resize(tree.Nodes.size() * moments.Index.Count);
  const Computer computer(tree, moments);
  const auto of = [&](std::int64_t i) { return moments.Values.data() + i * moments.Index.Count; };
  constexpr std::int64_t part = 64;
  parallelFor((count + part - 1) / part,
    [&](std::int64_t first)
    {
      for (std::int64_t i = first * part; i < std::min(count, (first + 1) * part); ++i)
      {
        if (tree.Nodes[i].Child < 0)
        {
          computer.OfCharges(tree.Nodes[i], of(i));
        }
      }
    });
  // Children come after their parents.
  for (std::int64_t i = count; i-- > 0;)
  {
    if (tree.Nodes[i].Child >= 0)
    {
      computer.OfChildren(tree.Nodes[i], of(i));
    }
  }
  return moments;
}
}
