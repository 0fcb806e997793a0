// SPDX-License-Identifier: BSD-3-Clause
#ifndef Exponential_h
#define Exponential_h

#include "base/Simd.h"

#include <initializer_list>
#include <type_traits>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// e^x with a relative error of at most 3e-7 for x from -87 to 80, 0 below. x must not be above 80.
///
/// Range reduction x = n ln 2 + r, where n ln 2 is subtracted in two parts, of which the first has
/// so few digits that its product with n is exact; then 2^n times the Taylor polynomial of e^r.
/// Source: Cody and Waite, "Software Manual for the Elementary Functions" (1980).
inline Float8 Exponential(const Float8& x)
{
  const Float8 lowest = Float8{} - 87.0f;
  const Float8 inside = x < lowest ? lowest : x;
  const Float8 scaled = inside * 1.44269504f;
  const Float8 half = scaled < 0.0f ? Float8{} - 0.5f : Float8{} + 0.5f;
  const Int8 whole = __builtin_convertvector(scaled + half, Int8);
  const Float8 n = __builtin_convertvector(whole, Float8);
  const Float8 r = (inside - n * 0.693359375f) + n * 2.12194440e-4f;
  Float8 sum = Float8{} + 1.0f / 40320.0f;
  for (const float factor :
    { 1.0f / 5040.0f, 1.0f / 720.0f, 1.0f / 120.0f, 1.0f / 24.0f, 1.0f / 6.0f, 0.5f, 1.0f, 1.0f })
  {
    sum = sum * r + factor;
  }
  const Int8 bits = (whole + 127) << 23;
  Float8 power;
  std::memcpy(&power, &bits, sizeof(power));
  return x < lowest ? Float8{} : sum * power;
}
inline double Exponential(double x)
{
  return std::exp(x);
}
}
}

#endif
