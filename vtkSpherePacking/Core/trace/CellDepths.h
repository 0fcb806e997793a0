// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellDepths_h
#define CellDepths_h

#include "trace/RayBlock.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// tMax of the rays in each rectangle of cells of 4 x 4 rays: the depth of the farthest of their
/// closest hits. A table of all 256 rectangles, since many are looked up between two hits.
class CellDepths
{
public:
  /// The number of the rectangle of cells that has these columns and rows of rays.
  template <typename IntT>
  static IntT Rectangle(const IntT& x0, const IntT& x1, const IntT& y0, const IntT& y1)
  {
    static_assert(RayBlock::Side == 16 && Side == 4, "two bits a number");
    return x0 >> 2 | (x1 >> 2) << 2 | (y0 >> 2) << 4 | (y1 >> 2) << 6;
  }
  static constexpr unsigned Whole = 3u << 2 | 3u << 6;

  float operator[](unsigned rectangle) const { return this->Rectangles[rectangle]; }

  /// Updates some cells, a bit each. Depths are multiplied by `scale` and rounded up.
  void Update(const RayBlock& block, unsigned cells, double scale)
  {
    unsigned rows = 0;
    for (; cells != 0; cells &= cells - 1)
    {
      const int cell = __builtin_ctz(cells);
      const double depth = std::min(block.MaxDepth(cell) * scale, 3e38);
      this->Cells[cell] = static_cast<float>(depth) * (1.0f + 1e-6f);
      rows |= 1u << cell / Side;
    }
    for (; rows != 0; rows &= rows - 1)
    {
      this->UpdateRow(__builtin_ctz(rows));
    }
    for (int first = 0; first < Side; ++first)
    {
      Float4 depths[Side];
      for (int row = first; row < Side; ++row)
      {
        float* all = this->Rectangles + Side * Side * (first + Side * row);
        for (int last = 0; last < Side; ++last)
        {
          const Float4 next = Load<Float4>(this->Rows[row][last]);
          depths[last] = row == first || next > depths[last] ? next : depths[last];
          Store(depths[last], all + Side * last);
        }
      }
    }
  }

private:
  static constexpr int Side = RayBlock::CellsSide;
  using Float4 = float __attribute__((vector_size(16)));
  using Int4 = std::int32_t __attribute__((vector_size(16)));

  // From each column to each, the first columns side by side.
  void UpdateRow(int row)
  {
    const Int4 lane = { 0, 1, 2, 3 };
    const Float4 nothing = Float4{} - 3e38f;
    Float4 depths = nothing;
    for (int column = 0; column < Side; ++column)
    {
      const Float4 depth = lane <= column ? Float4{} + this->Cells[row * Side + column] : nothing;
      depths = depth > depths ? depth : depths;
      Store(depths, this->Rows[row][column]);
    }
  }

  float Cells[Side * Side];
  alignas(64) float Rows[Side][Side][Side]; // by row, last and first column
  alignas(64) float Rectangles[Side * Side * Side * Side];
};
}
}

#endif
