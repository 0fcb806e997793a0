// SPDX-License-Identifier: BSD-3-Clause
#ifndef RadiusArray_h
#define RadiusArray_h

#include "vtkType.h"

#include <string>

class vtkDataArray;
class vtkPolyData;

namespace spherepacking
{
/// The radii of a packing, or null, with a sentence in `message` if something is wrong with them;
/// see vtkSpherePackingInput::FindRadii().
vtkDataArray* FindRadii(vtkPolyData* packing, const char* name, std::string& message);

/// The same, with a std::invalid_argument for the sentence.
vtkDataArray* RadiiOf(vtkPolyData* packing, const std::string& name);

/// Throws a std::invalid_argument for more spheres than can be numbered.
void CheckCount(vtkIdType spheres);

/// The bounds of the spheres, see vtkSpherePackingInput::ComputeBounds().
void ComputeBounds(vtkPolyData* packing, vtkDataArray* radii, double bounds[6]);
}

#endif
