// SPDX-License-Identifier: BSD-3-Clause
#ifndef ImdHeader_h
#define ImdHeader_h

namespace spherepacking
{
struct TableHead;

/**
 * Sets the cell of a table by IMD from the comments of its head: #F A and counts come first, then
 * the names of the columns, #C, and the vectors of the box, #X, #Y and #Z (J. Stadler et al., "IMD:
 * a software package for molecular dynamics studies on parallel computers", 1997). It does not say
 * along which axes it is periodic, and counts as periodic along all, the program's default.
 */
void ReadImdHeader(TableHead& head);
}

#endif
