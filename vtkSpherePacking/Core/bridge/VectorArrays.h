// SPDX-License-Identifier: BSD-3-Clause
#ifndef VectorArrays_h
#define VectorArrays_h

#include <array>
#include <string>

class vtkDataArray;
class vtkPointData;

namespace spherepacking
{
/**
 * Adds an array of vectors for every three arrays of numbers that are its components: `velocity`
 * of vx, vy, vz, and so on by the words of DEM programs and LAMMPS; NAME of NAME_x, NAME_y, NAME_z,
 * of NAME:0, NAME:1, NAME:2, of NAME_0, NAME_1, NAME_2 (which ParaView's tables have) and of
 * NAME[0], NAME[1], NAME[2]. Where NAME is v, vel, velo or Velocity, `velocity`, too. The
 * components stay. A name that is taken is left alone.
 */
void AddVectors(vtkPointData* data);

/// The names of the components by which DEM programs and LAMMPS call a vector: vx, vy, vz of
/// `velocity`, and so on; NAME_0, NAME_1, NAME_2 of others.
std::array<std::string, 3> ComponentNames(const std::string& vector);

/// Whether an array of vectors is what AddVectors() makes of others that are there.
bool IsMadeOfParts(vtkPointData* data, vtkDataArray* vectors);
}

#endif
