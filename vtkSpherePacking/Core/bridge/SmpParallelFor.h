// SPDX-License-Identifier: BSD-3-Clause
#ifndef SmpParallelFor_h
#define SmpParallelFor_h

#include "base/ParallelFor.h"

namespace spherepacking
{
/// The threads of vtkSMPTools for those who know no VTK. The first exception that leaves the work
/// is thrown again in the calling thread, when all threads are done; no work is begun after it.
ParallelFor SmpParallelFor();
}

#endif
