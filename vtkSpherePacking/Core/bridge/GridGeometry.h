// SPDX-License-Identifier: BSD-3-Clause
#ifndef GridGeometry_h
#define GridGeometry_h

#include "metaballs/FieldScene.h"

namespace spherepacking
{
class PackingCharges;

/// A regular grid in the packing's coordinates.
struct GridGeometry
{
  double Origin[3];
  double Spacing[3];
  int Dimensions[3];

  double Points() const
  {
    return static_cast<double>(this->Dimensions[0]) * this->Dimensions[1] * this->Dimensions[2];
  }
};

/// What determines the grid of a field; the members are those of vtkMetaballField.
struct GridRequest
{
  int Dimensions[3];
  double Spacing[3];     ///< in place of the dimensions if the first is above 0
  double ModelBounds[6]; ///< unused if the first is above the second
  double Threshold;      ///< of the isosurface that is to be closed inside the grid, if above 0
  BlobKind Kind;
  double BytesPerPoint; ///< of the arrays on the grid

  bool HasBounds() const { return !(this->ModelBounds[0] > this->ModelBounds[1]); }
  bool HasSpacing() const { return this->Spacing[0] > 0.0; }
};

/// Throws a std::invalid_argument for a request that makes no grid whatever the packing is.
void CheckGridRequest(const GridRequest& request);

/// The grid of a request for the field of a packing. Throws a std::invalid_argument if it would be
/// flat, beyond the range of coordinates or too large for the memory.
GridGeometry ResolveGrid(const GridRequest& request, const PackingCharges& charges);
}

#endif
