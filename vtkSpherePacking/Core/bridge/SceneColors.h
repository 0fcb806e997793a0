// SPDX-License-Identifier: BSD-3-Clause
/// The colours of the spheres of a packing.
#ifndef SceneColors_h
#define SceneColors_h

#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkPolyData;
class vtkScalarsToColors;

namespace spherepacking
{
struct ColorOptions
{
  std::string ArrayName;               ///< of the scalars to colour by; empty for none
  vtkScalarsToColors* Table = nullptr; ///< by default a grey ramp over their range
  std::array<double, 3> Color;         ///< without scalars, from 0 to 1
  bool Random = false;                 ///< a random colour per sphere instead
};

/// What colours depend on. Neither arrays nor tables are held: no two of them have ever had the
/// same modified time, so a new one at the address of an old one is told apart by that.
struct ColorState
{
  vtkIdType Count = -1;
  const vtkAbstractArray* Scalars = nullptr;
  vtkMTimeType ScalarsTime = 0;
  const vtkScalarsToColors* Table = nullptr;
  vtkMTimeType TableTime = 0;
  std::array<double, 3> Color{};
  bool Random = false;

  bool operator==(const ColorState& other) const;
};

class SceneColors
{
public:
  /// Maps the scalars unless that would give the same. Scalars that are not there are a
  /// std::invalid_argument.
  void Update(vtkPolyData* packing, const ColorOptions& options);

  /// RGBA, four bytes per sphere.
  const unsigned char* Data() const { return this->Colors.data(); }
  const ColorState& State() const { return this->Made; }

private:
  std::vector<unsigned char> Colors;
  ColorState Made;
};
}

#endif
