// SPDX-License-Identifier: BSD-3-Clause
#ifndef PackingArrays_h
#define PackingArrays_h

#include "vtkAOSDataArrayTemplate.h"
#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkAbstractArray;
class vtkDataArray;
class vtkPolyData;

namespace spherepacking
{
/// The simulation cell of a packing: the parallelepiped of three vectors from its origin.
struct SimulationCell
{
  double Origin[3];
  double Vectors[3][3]; ///< a, b, c
  std::array<bool, 3> Periodic{ true, true, true };
};

/**
 * The arrays of a packing while they are filled. Centres and radii have the same precision; further
 * arrays of numbers are double, since single precision would round ids beyond 2^24.
 */
class PackingArrays
{
public:
  /// Without radii the packing gets no array of them.
  PackingArrays(vtkIdType count, bool single, bool hasRadii = true);

  vtkIdType GetCount() const { return this->Count; }
  bool IsSingle() const { return this->Single; }

  /// What the file calls the radii or diameters, `radius` by default; empty without.
  const std::string& GetRadiusName() const { return this->RadiusName; }
  void SetRadiusName(const std::string& name) { this->RadiusName = name; }

  /// Centres, x y z x y z ..., and radii, null without; `Real` must be float if and only if
  /// IsSingle().
  template <typename Real>
  Real* Centers() const
  {
    return vtkAOSDataArrayTemplate<Real>::FastDownCast(this->CenterArray)->GetPointer(0);
  }
  template <typename Real>
  Real* Radii() const
  {
    return !this->RadiusArray
      ? nullptr
      : vtkAOSDataArrayTemplate<Real>::FastDownCast(this->RadiusArray)->GetPointer(0);
  }

  /// Adds a further array, uninitialised, and returns its values.
  double* AddExtra(const std::string& name);

  /// The values of the further array of numbers of that name; null without one.
  const double* FindExtra(const std::string& name) const;

  /// Removes the further array of that name.
  void RemoveExtra(const std::string& name);

  /// Adds a further array that is filled already.
  void AddArray(vtkSmartPointer<vtkDataArray> array) { this->Extras.push_back(std::move(array)); }

  /// Adds a further array of text, and returns its values, which are empty.
  std::string* AddText(const std::string& name);

  /// Removes the further array of text with these values.
  void RemoveText(const std::string* values);

  /// Adds a field array of one number, by which a reader tells of the file.
  void AddFieldValue(const std::string& name, double value)
  {
    this->Fields.push_back({ name, value });
  }

  /// The simulation cell becomes the field arrays `cell_vectors` (3 tuples a, b, c), `cell_origin`
  /// (3 values) and `cell_periodic` (3 bytes, 1 for periodic); the time `TimeValue` (1 value), the
  /// name that VTK's own readers give it.
  void SetCell(const SimulationCell& cell) { this->Cell = cell; }
  void SetTime(double time) { this->Time = time; }

  /// Moves all arrays to `output`, with a vertex per sphere. Components that stand in arrays of
  /// their own, such as vx, vy, vz or R, G, B, also become one array, see AddVectors() and
  /// AddColors().
  void MoveTo(vtkPolyData* output);

private:
  vtkIdType Count;
  bool Single;
  std::string RadiusName;
  vtkSmartPointer<vtkDataArray> CenterArray;
  vtkSmartPointer<vtkDataArray> RadiusArray; // null without radii
  std::vector<vtkSmartPointer<vtkAbstractArray>> Extras;
  std::optional<SimulationCell> Cell;
  std::optional<double> Time;
  std::vector<std::pair<std::string, double>> Fields;
};
}

#endif
