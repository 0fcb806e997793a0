// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShortRows_h
#define ShortRows_h

namespace spherepacking
{
/**
 * A fast path for rows of four numbers, each with or without a minus and with 1 to 8 digits before
 * and up to 7 after the point, separated by a space each, within 64 bytes. Parses rows from `p` on
 * into `centers`, x y z x y z ..., and `radii`, up to the first that is anything else, valid or
 * not, or that comes close to `end`, the end of a line. Sets `count` to the number of rows, and
 * returns where the next begins. That one may have been written, too.
 *
 * Digits are joined to an integer and divided by a power of ten, both of which `Real` holds
 * exactly, so the value is rounded once (W. Clinger, "How to Read Floating Point Numbers
 * Accurately", 1990). All four numbers of a row are converted together. Needs AVX2; see
 * io/ShortRow.h for other processors.
 */
const char* ParseShortRowsAvx2(
  const char* p, const char* end, double* centers, double* radii, long long& count);
const char* ParseShortRowsAvx2(
  const char* p, const char* end, float* centers, float* radii, long long& count);
}

#endif
