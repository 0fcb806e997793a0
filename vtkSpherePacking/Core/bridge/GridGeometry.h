// SPDX-License-Identifier: BSD-3-Clause
#ifndef GridGeometry_h
#define GridGeometry_h

#include "metaballs/FieldScene.h"

namespace spherepacking
{
class FieldInput;

/// A regular grid in the packing's space.
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

/// What a user may say of the grid of a field; the members are those of vtkMetaballField.
struct GridRequest
{
  int Dimensions[3];
  double Spacing[3];     ///< instead of dimensions, if the first is above 0
  double ModelBounds[6]; ///< if the first is not above the second
  double Threshold;      ///< of the surface that is to close inside, if above 0
  BlobKind Kind;
  double BytesPerPoint; ///< of the arrays on the grid

  bool HasBounds() const { return !(this->ModelBounds[0] > this->ModelBounds[1]); }
  bool HasSpacing() const { return this->Spacing[0] > 0.0; }
};

/// Throws a std::invalid_argument for numbers that make no grid whatever the packing is.
void CheckGridRequest(const GridRequest& request);

/// Where the grid lies. A std::invalid_argument if it would be flat, too far away or too large.
GridGeometry PlaceGrid(const GridRequest& request, const FieldInput& input);
}

#endif
