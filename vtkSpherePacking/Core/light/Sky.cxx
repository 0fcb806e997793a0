// SPDX-License-Identifier: BSD-3-Clause
#include "light/Sky.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spherepacking
{
namespace
{
constexpr double Pi = 3.141592653589793;

// The point of the image for a direction, in pixels from its upper left corner.
void Project(const double (&d)[3], int width, int height, double& x, double& y)
{
  x = (0.5 - std::atan2(d[1], d[0]) / (2.0 * Pi)) * width;
  y = std::acos(std::clamp(d[2], -1.0, 1.0)) / Pi * height;
}

// Extent of a row along z, to which its solid angle is proportional.
double RowHeight(int row, int height)
{
  return std::cos(Pi * row / height) - std::cos(Pi * (row + 1) / height);
}

// Inverts a cumulative distribution: the interval that `value` falls into, and where in it.
template <typename Iterator>
int InvertCdf(Iterator begin, Iterator end, double value, double& within)
{
  const Iterator at = std::min(std::upper_bound(begin, end, value), end - 1);
  const double low = at == begin ? 0.0 : static_cast<double>(*(at - 1));
  const double high = *at;
  within = high > low ? std::clamp((value - low) / (high - low), 0.0, 1.0) : 0.5;
  return static_cast<int>(at - begin);
}
}

//------------------------------------------------------------------------------
void Sky::SetImage(std::vector<float> pixels, int width, int height)
{
  this->Pixels = std::move(pixels);
  this->Width = this->Pixels.empty() ? 0 : width;
  this->Height = this->Pixels.empty() ? 0 : height;
  this->Rows.clear();
  this->Columns.clear();
  if (this->Pixels.empty())
  {
    return;
  }
  this->Rows.resize(height);
  this->Columns.resize(static_cast<std::size_t>(width) * height);
  double total = 0.0;
  for (int row = 0; row < height; ++row)
  {
    double sum = 0.0;
    float* columns = &this->Columns[static_cast<std::size_t>(row) * width];
    std::vector<double> cumulative(width);
    for (int column = 0; column < width; ++column)
    {
      sum += this->MeanWithin(column, row);
      cumulative[column] = sum;
    }
    for (int column = 0; column < width; ++column)
    {
      columns[column] = static_cast<float>(
        sum > 0.0 ? cumulative[column] / sum : static_cast<double>(column + 1) / width);
    }
    total += sum * RowHeight(row, height);
    this->Rows[row] = total;
  }
  if (!(total > 0.0))
  {
    this->Rows.clear();
    return;
  }
  for (double& row : this->Rows)
  {
    row /= total;
  }
}

//------------------------------------------------------------------------------
double Sky::MeanWithin(int column, int row) const
{
  // Radiance() interpolates between the middles of pixels: the mean within a pixel is three
  // quarters of its own value and an eighth of each neighbour's, along each axis.
  double mean = 0.0;
  for (int y = -1; y <= 1; ++y)
  {
    for (int x = -1; x <= 1; ++x)
    {
      const float* pixel = this->PixelAt(column + x, row + y);
      const double weight = (x == 0 ? 0.75 : 0.125) * (y == 0 ? 0.75 : 0.125);
      mean += weight * (static_cast<double>(pixel[0]) + pixel[1] + pixel[2]);
    }
  }
  return mean;
}

//------------------------------------------------------------------------------
const float* Sky::PixelAt(int column, int row) const
{
  column = (column + this->Width) % this->Width;
  row = std::clamp(row, 0, this->Height - 1);
  return &this->Pixels[3 * (static_cast<std::size_t>(row) * this->Width + column)];
}

//------------------------------------------------------------------------------
void Sky::Radiance(const double (&d)[3], float (&radiance)[3]) const
{
  if (!this->HasImage())
  {
    const auto up = static_cast<float>(0.5 + 0.5 * d[2]);
    for (int channel = 0; channel < 3; ++channel)
    {
      // Exact where both are equal.
      radiance[channel] = this->Bottom[channel] + up * (this->Top[channel] - this->Bottom[channel]);
    }
    return;
  }
  double x;
  double y;
  Project(d, this->Width, this->Height, x, y);
  // Between the middles of four pixels.
  const double left = std::floor(x - 0.5);
  const double above = std::floor(y - 0.5);
  const double right = x - 0.5 - left;
  const double below = y - 0.5 - above;
  std::fill_n(radiance, 3, 0.0f);
  for (int corner = 0; corner < 4; ++corner)
  {
    const float* pixel =
      this->PixelAt(static_cast<int>(left) + corner % 2, static_cast<int>(above) + corner / 2);
    const double weight = (corner % 2 ? right : 1.0 - right) * (corner / 2 ? below : 1.0 - below);
    for (int channel = 0; channel < 3; ++channel)
    {
      radiance[channel] += static_cast<float>(weight) * pixel[channel];
    }
  }
}

//------------------------------------------------------------------------------
double Sky::PixelDensity(int column, int row) const
{
  const double rowMass = this->Rows[row] - (row > 0 ? this->Rows[row - 1] : 0.0);
  const float* columns = &this->Columns[static_cast<std::size_t>(row) * this->Width];
  const double mass = columns[column] - (column > 0 ? columns[column - 1] : 0.0);
  return rowMass * mass * this->Width / (2.0 * Pi * RowHeight(row, this->Height));
}

//------------------------------------------------------------------------------
double Sky::Sample(double x, double y, double (&d)[3]) const
{
  double within[2];
  const int row = InvertCdf(this->Rows.begin(), this->Rows.end(), y, within[1]);
  const auto begin = this->Columns.begin() + static_cast<std::ptrdiff_t>(row) * this->Width;
  const int column = InvertCdf(begin, begin + this->Width, x, within[0]);
  const double angle = (0.5 - (column + within[0]) / this->Width) * 2.0 * Pi;
  const double z = std::cos(Pi * row / this->Height) - within[1] * RowHeight(row, this->Height);
  const double across = std::sqrt(std::max(0.0, 1.0 - z * z));
  d[0] = across * std::cos(angle);
  d[1] = across * std::sin(angle);
  d[2] = z;
  return this->PixelDensity(column, row);
}

//------------------------------------------------------------------------------
double Sky::Density(const double (&d)[3]) const
{
  double x;
  double y;
  Project(d, this->Width, this->Height, x, y);
  return this->PixelDensity(std::clamp(static_cast<int>(x), 0, this->Width - 1),
    std::clamp(static_cast<int>(y), 0, this->Height - 1));
}
}
