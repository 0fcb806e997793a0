// SPDX-License-Identifier: BSD-3-Clause
#ifndef ColorArrays_h
#define ColorArrays_h

class vtkPointData;

namespace spherepacking
{
/**
 * Adds the array `rgb` if there are arrays of numbers named red, green, blue or r, g, b, in any
 * letter case; those of one spelling before others. Its values are floats if these are numbers from
 * 0 to 1, and else bytes if they are whole numbers from 0 to 255; there is none for others, which
 * are no colors that VTK knows. It has a fourth component if there is an array named a or alpha,
 * too, of the same range. The parts stay.
 */
void AddColors(vtkPointData* data);
}

#endif
