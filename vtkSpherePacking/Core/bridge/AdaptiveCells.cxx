// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/AdaptiveCells.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
//------------------------------------------------------------------------------
AdaptiveCells::AdaptiveCells(const PathPicture& picture)
  : Picture(picture)
  , Columns((picture.Width - 1) / PathCells::Side + 1)
  , Rows((picture.Height - 1) / PathCells::Side + 1)
  , Active(static_cast<std::size_t>(this->Columns) * this->Rows, 1)
{
}

//------------------------------------------------------------------------------
void AdaptiveCells::DropConverged(unsigned samples, double target)
{
  for (int row = 0; row < this->Rows; ++row)
  {
    for (int column = 0; column < this->Columns; ++column)
    {
      unsigned char& active = this->Active[static_cast<std::size_t>(row) * this->Columns + column];
      active = active && !this->IsConverged(column, row, samples, target);
    }
  }
}

//------------------------------------------------------------------------------
bool AdaptiveCells::IsConverged(int column, int row, unsigned samples, double target) const
{
  constexpr int side = PathCells::Side;
  double variance = 0.0;
  double luminance = 0.0;
  int number = 0;
  for (int y = row * side; y < std::min((row + 1) * side, this->Picture.Height); ++y)
  {
    for (int x = column * side; x < std::min((column + 1) * side, this->Picture.Width); ++x)
    {
      const std::int64_t pixel = static_cast<std::int64_t>(y) * this->Picture.Width + x;
      if (this->Picture.Samples[pixel] != samples)
      {
        return false;
      }
      variance += this->Picture.Variance[pixel];
      luminance += Luminance(this->Picture.Radiance + 3 * pixel);
      ++number;
    }
  }
  return std::sqrt(variance / number) <= target * luminance / number;
}

//------------------------------------------------------------------------------
bool AdaptiveCells::Any() const
{
  return std::find(this->Active.begin(), this->Active.end(), 1) != this->Active.end();
}
}
