// SPDX-License-Identifier: BSD-3-Clause
#ifndef EsysSnapshot_h
#define EsysSnapshot_h

namespace spherepacking
{
/**
 * Whether a text begins as a file of a snapshot of ESyS-Particle (D. Weatherley et al.,
 * "ESyS-Particle tutorial and user's guide", 2014): the header, whose first line is V and the
 * version, or the part of a process, whose lines are the number of particles, the particles and
 * bonds.
 */
bool BeginsAsEsysSnapshot(const char* begin, const char* end);
}

#endif
