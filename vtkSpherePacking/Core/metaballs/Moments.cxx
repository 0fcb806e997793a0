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

// Leaves first; the height of a node is one more than that of its higher child.
std::vector<std::vector<std::int32_t>> NodesByHeight(const ChargeTree& tree)
{
  std::vector<std::int32_t> heights(tree.Nodes.size(), 0);
  std::vector<std::vector<std::int32_t>> nodes;
  // Children come after their parents.
  for (std::size_t i = tree.Nodes.size(); i-- > 0;)
  {
    const std::int32_t child = tree.Nodes[i].Child;
    heights[i] = child < 0 ? 0 : 1 + std::max(heights[child], heights[child + 1]);
    nodes.resize(std::max(nodes.size(), static_cast<std::size_t>(heights[i]) + 1));
    nodes[heights[i]].push_back(static_cast<std::int32_t>(i));
  }
  return nodes;
}
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
  moments.Values.resize(tree.Nodes.size() * moments.Index.Count);
  const Computer computer(tree, moments);
  const auto of = [&](std::int64_t i) { return moments.Values.data() + i * moments.Index.Count; };
  // Nodes whose children are done, those of a height after another.
  constexpr std::int64_t part = 16;
  for (const std::vector<std::int32_t>& nodes : NodesByHeight(tree))
  {
    const auto number = static_cast<std::int64_t>(nodes.size());
    parallelFor((number + part - 1) / part,
      [&](std::int64_t first)
      {
        for (std::int64_t i = first * part; i < std::min(number, (first + 1) * part); ++i)
        {
          const std::int32_t node = nodes[i];
          if (tree.Nodes[node].Child < 0)
          {
            computer.OfCharges(tree.Nodes[node], of(node));
          }
          else
          {
            computer.OfChildren(tree.Nodes[node], of(node));
          }
        }
      });
  }
  return moments;
}
}
