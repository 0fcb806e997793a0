// SPDX-License-Identifier: BSD-3-Clause
#ifndef ColorArrays_h
#define ColorArrays_h

class vtkPointData;

namespace spherepacking
{
/**
 * Adds the array `rgb` if there are arrays of numbers named r, g, b or red, green, blue, in any
 * letter case; with a fourth component if there is one named a or alpha, too. Its values are bytes
 * if the colors are whole numbers from 0 to 255 and not all 0 or 1, and floats if they are numbers
 * from 0 to 1. There is none for others, which are no colors that VTK knows. The parts stay.
 */
void AddColors(vtkPointData* data);
}

#endif
