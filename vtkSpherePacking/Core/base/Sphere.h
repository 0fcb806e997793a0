// SPDX-License-Identifier: BSD-3-Clause
#ifndef Sphere_h
#define Sphere_h

namespace spherepacking
{
struct Sphere
{
  double X;
  double Y;
  double Z;
  double R;
};
}

#endif
