// SPDX-License-Identifier: BSD-3-Clause
/// A packing made ready for rays: its spheres, the structure that finds them, and their colours.
#ifndef PreparedScene_h
#define PreparedScene_h

#include "bridge/PackingSpheres.h"
#include "bridge/SceneColors.h"
#include "trace/Scene.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <memory>

class vtkPolyData;

namespace spherepacking
{
/// How rays find spheres; the numbers are those of vtkSpherePackingTracer::StructureType.
enum class StructureKind
{
  None,
  Grid,
  Bvh
};

struct StructureOptions
{
  const char* RadiusArrayName;
  StructureKind Kind;
  int Cuts; ///< of a grid along each axis, or -1 for a number that suits the spheres
};

/// Which spheres there are.
struct SpheresState
{
  // Held, because the spheres are used where they are.
  vtkSmartPointer<vtkDataArray> Points;
  vtkSmartPointer<vtkDataArray> Radii;
  vtkMTimeType Time = 0; ///< of the last change of either

  bool operator==(const SpheresState& other) const
  {
    return this->Points == other.Points && this->Radii == other.Radii && this->Time == other.Time;
  }
};

/// What a picture depends on, but for its view and its light. The structure is no part of it.
struct SceneState
{
  SpheresState Spheres;
  ColorState Colors;

  bool operator==(const SceneState& other) const
  {
    return this->Spheres == other.Spheres && this->Colors == other.Colors;
  }
};

/// Some of the spheres of a packing, so few that looking at them costs nothing.
struct SphereSamples
{
  static constexpr int Most = 64;

  // Of spheres at equal distances in the packing.
  std::array<double, 3 * Most> Centers{};
  std::array<double, Most> Radii{};
};

/// Keeps each part until VTK is notified that what it was made of has changed. What is kept holds
/// the numbers that it was made of: whoever writes into the arrays and notifies nobody gets the
/// picture of before, and never one of old boxes around new spheres.
class PreparedScene
{
public:
  /// Takes the packing's spheres and builds the structure. What is wrong with them or with the
  /// options is a std::invalid_argument.
  void Prepare(vtkPolyData* packing, const StructureOptions& options);

  /// Finds the colours of the spheres.
  void SetColors(vtkPolyData* packing, const ColorOptions& options);

  /// Compares spheres all over the packing with what they were, up to 64, and notifies VTK if any
  /// has changed: what has been written into a whole array is found, at no cost.
  void NoticeChanges();

  Scene Get() const;
  SceneState State() const { return { this->Made, this->Colors.State() }; }
  double BuildSeconds() const { return this->Seconds; }
  double StructureBytes() const;

private:
  void Build(vtkPolyData* packing, vtkDataArray* radii, const StructureOptions& options);

  bool IsUpToDate(const SpheresState& state, const StructureOptions& options) const;

  SpheresState Made;
  SphereSamples Samples; ///< of what was there then
  StructureKind Kind = StructureKind::None;
  int Cuts = -1;
  std::unique_ptr<PackingSpheres> Spheres;
  std::unique_ptr<Bvh> Hierarchy;
  std::unique_ptr<GridTable> Table;
  SceneColors Colors;
  double Seconds = 0.0;
};
}

#endif
