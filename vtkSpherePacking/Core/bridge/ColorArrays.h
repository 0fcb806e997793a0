// SPDX-License-Identifier: BSD-3-Clause
#ifndef ColorArrays_h
#define ColorArrays_h

class vtkPointData;

namespace spherepacking
{
/**
 * Adds the array `rgb` if there are arrays of numbers named r, g, b or red, green, blue, in any
 * letter case. Its values are floats if these are numbers from 0 to 1, and else bytes if they are
 * whole numbers from 0 to 255; there is none for others, which are no colors that VTK knows. It has
 * a fourth component if there is an array named a or alpha, too, of the same range. The parts stay.
 */
void AddColors(vtkPointData* data);
}

#endif
