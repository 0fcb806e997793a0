// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/SceneColors.h"

#include "base/RandomColor.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <tuple>

namespace spherepacking
{
namespace
{
void FillWith(const std::array<double, 3>& color, std::vector<unsigned char>& colors)
{
  unsigned char bytes[4] = { 0, 0, 0, 255 };
  for (int channel = 0; channel < 3; ++channel)
  {
    // NaN becomes 0.
    const double value = std::min(std::max(0.0, color[channel]), 1.0);
    bytes[channel] = static_cast<unsigned char>(255.0 * value + 0.5);
  }
  for (std::size_t i = 0; i < colors.size(); i += 4)
  {
    std::copy_n(bytes, 4, &colors[i]);
  }
}

// A grey ramp over the range of the scalars.
vtkSmartPointer<vtkScalarsToColors> DefaultTable(vtkAbstractArray* scalars)
{
  const auto table = vtkSmartPointer<vtkScalarsToColors>::New();
  vtkDataArray* numbers = vtkDataArray::SafeDownCast(scalars);
  double range[2] = { 0.0, 1.0 };
  if (numbers)
  {
    numbers->GetFiniteRange(range, numbers->GetNumberOfComponents() == 1 ? 0 : -1);
  }
  table->SetRange(range);
  return table;
}

void MapColors(vtkAbstractArray* scalars, const ColorOptions& options, vtkIdType count,
  std::vector<unsigned char>& colors)
{
  colors.resize(4 * count);
  if (options.Random)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      RandomColor(static_cast<std::uint64_t>(i), &colors[4 * i]);
    }
    return;
  }
  if (options.ArrayName.empty() || count == 0)
  {
    FillWith(options.Color, colors);
    return;
  }
  if (!scalars || scalars->GetNumberOfTuples() != count)
  {
    throw std::invalid_argument("scalars: the packing has no point array '" + options.ArrayName +
      "' with a value for each sphere, expected the name of one");
  }
  vtkSmartPointer<vtkScalarsToColors> table = options.Table;
  if (!table)
  {
    table = DefaultTable(scalars);
  }
  const auto mapped = vtkSmartPointer<vtkUnsignedCharArray>::Take(
    table->MapScalars(scalars, VTK_COLOR_MODE_DEFAULT, -1, VTK_RGBA));
  std::copy_n(mapped->GetPointer(0), colors.size(), colors.begin());
}
}

//------------------------------------------------------------------------------
bool ColorState::operator==(const ColorState& other) const
{
  const auto all = [](const ColorState& state)
  {
    return std::tie(state.Count, state.Scalars, state.ScalarsTime, state.Table, state.TableTime,
      state.Color, state.Random);
  };
  return all(*this) == all(other);
}

//------------------------------------------------------------------------------
void SceneColors::Update(vtkPolyData* packing, const ColorOptions& options)
{
  vtkAbstractArray* scalars = packing->GetPointData()->GetAbstractArray(options.ArrayName.c_str());
  const ColorState state{ packing->GetNumberOfPoints(), scalars, scalars ? scalars->GetMTime() : 0,
    options.Table, options.Table ? options.Table->GetMTime() : 0, options.Color, options.Random };
  if (this->Made == state)
  {
    return;
  }
  // In case that mapping fails halfway.
  this->Made = ColorState();
  MapColors(scalars, options, state.Count, this->Colors);
  this->Made = state;
}
}
