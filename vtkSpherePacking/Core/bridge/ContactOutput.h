// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContactOutput_h
#define ContactOutput_h

#include "base/HugeArray.h"
#include "contacts/FindContacts.h"

class vtkPolyData;

namespace spherepacking
{
/// Lines, points and arrays of a contact in the output, and before that in lists, in bytes.
constexpr double BytesPerContact = 96.0;

/// Makes lines of contacts, with the arrays that vtkSpherePackingContacts describes.
void WriteContacts(const HugeArray<Contact>& contacts, const SphereArrays& spheres,
  const PeriodicImages& images, const ParallelFor& parallelFor, vtkPolyData* packing,
  vtkPolyData* output);
}

#endif
