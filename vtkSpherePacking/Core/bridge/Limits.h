// SPDX-License-Identifier: BSD-3-Clause
/// Limits of numbers that users give, and why. Those of Python's arguments are in checks.py.
#ifndef Limits_h
#define Limits_h

#include <cstdint>
#include <limits>

namespace spherepacking
{
/// Spheres of a packing: structures number them in 32 bits.
constexpr std::int64_t MaxSpheres = std::numeric_limits<std::int32_t>::max();

/// Lengths and coordinates that rays and fields can hold: single precision goes from about 1e-38 to
/// 3e38, and some of them are squared relative to each other.
constexpr double MinLength = 1e-30;
constexpr double MaxCoordinate = 1e30;

/// Radiance of sky and sun: the variance of pixels squares it in single precision.
constexpr double MaxRadiance = 1e15;

/// Exposure, either way: 2 to this power is a number in single precision.
constexpr double MaxExposure = 100.0;

/// Weights of metaballs: sums of many are numbers in single precision.
constexpr double MaxWeight = 1e20;

/// Relative errors of fields that can be asked for: single precision alone makes one of 1e-5.
constexpr double MinRelativeError = 2e-5;
constexpr double MaxRelativeError = 0.5;
}

#endif
