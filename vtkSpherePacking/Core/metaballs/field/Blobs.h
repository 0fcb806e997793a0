// SPDX-License-Identifier: BSD-3-Clause
/// What one sphere adds to the field at a distance d: the kernels.
///
/// All are 1 on the surface of a sphere of weight 1. Rank() grows with Value(), but does not become
/// zero where that is too small for a double; where it is not above LeastRank, Value() is 0.
/// Strength and shape are what a kernel keeps of the weight w and the radius r; the strength is the
/// weight where nothing else is said. Value() takes the square of the distance; Slope() is the
/// derivative by the distance, divided by the distance.
#ifndef Blobs_h
#define Blobs_h

#include "metaballs/field/Exponential.h"

#include <algorithm>
#include <limits>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// The number that a vector of floats, or a double, is made of.
template <typename T>
using ScalarOf = std::conditional_t<std::is_same<T, Float8>::value, float, double>;

template <typename T>
inline T Larger(const T& a, const T& b)
{
  return a > b ? a : b;
}

/// factor / sqrt(x) to 3e-7.
inline Float8 OverRoot(const Float8& factor, const Float8& x)
{
#if defined(__AVX__)
  // One step of Newton's method, with the factor taken into its constants.
  const Float8 guess = _mm256_rsqrt_ps(x);
  return guess * (1.5f * factor - (0.5f * factor) * (x * guess * guess));
#else
  return factor / Sqrt(x);
#endif
}
inline double OverRoot(double factor, double x)
{
  return factor / std::sqrt(x);
}

/// factor / x to 3e-7.
inline Float8 Over(const Float8& factor, const Float8& x)
{
#if defined(__AVX__)
  const Float8 guess = _mm256_rcp_ps(x);
  return guess * (2.0f * factor - factor * (x * guess));
#else
  return factor / x;
#endif
}
inline double Over(double factor, double x)
{
  return factor / x;
}

/// How exact the processor's own estimates are.
constexpr double EstimateError = 1.5 / 4096.0;

/// factor / sqrt(x) to EstimateError.
inline Float8 NearlyOverRoot(const Float8& factor, const Float8& x)
{
#if defined(__AVX__)
  return factor * _mm256_rsqrt_ps(x);
#else
  return factor / Sqrt(x);
#endif
}

/// factor / x to EstimateError.
inline Float8 NearlyOver(const Float8& factor, const Float8& x)
{
#if defined(__AVX__)
  return factor * _mm256_rcp_ps(x);
#else
  return factor / x;
#endif
}

/// w (r / d)^Power, but not above its value at d = r / 1024, which keeps it finite. For Power = 1
/// the potential of a charge.
template <int Power>
struct InverseBlob
{
  static constexpr double Core = 1.0 / 1024.0;
  static constexpr bool HasEstimate = true;

  static double Strength(double weight, double radius)
  {
    return Power == 1 ? weight * radius : weight * radius * radius;
  }
  static double Shape(double radius) { return std::max(Core * radius * Core * radius, 1e-36); }

  static constexpr double LeastRank = 0.0;
  static double Rank(double square, double strength, double shape)
  {
    return Value(square, strength, shape);
  }
  /// A little less, for rounding.
  static double Below(double rank) { return 0.999999 * rank; }
  /// Of spheres of at most this strength and radius at a distance.
  static double MostRank(double distance, double strength, double)
  {
    return Rank(distance * distance, strength, 1e-36);
  }

  /// Long-range kernels are not cut off.
  static double Reach(double, double, double) { return std::numeric_limits<double>::infinity(); }

  template <typename T>
  static T Value(const T& square, const T& strength, const T& shape)
  {
    const T length = Larger(square, shape);
    return Power == 1 ? OverRoot(strength, length) : Over(strength, length);
  }

  /// Value() to EstimateError.
  static Float8 Estimate(const Float8& square, const Float8& strength, const Float8& shape)
  {
    const Float8 length = Larger(square, shape);
    return Power == 1 ? NearlyOverRoot(strength, length) : NearlyOver(strength, length);
  }

  template <typename T>
  static T Slope(const T& square, const T& strength, const T& shape)
  {
    const T factor = ScalarOf<T>(-Power) * Value(square, strength, shape);
    const T slope = Over(factor, Larger(square, shape));
    return square > shape ? slope : T{};
  }
};

/// w exp(2 - 2 (d / r)^2).
///
/// Source: Blinn, "A Generalization of Algebraic Surface Drawing" (1982), with a blobbiness of -2.
struct GaussianBlob
{
  static constexpr bool HasEstimate = false;

  static double Shape(double radius) { return std::min(1.0 / (radius * radius), 1e36); }
  static constexpr double LeastRank = -746.0;
  static double Rank(double square, double strength, double shape)
  {
    return std::log(strength) + 2.0 - 2.0 * (square * shape);
  }
  static double Below(double rank) { return rank - 1e-6; }
  static double MostRank(double distance, double strength, double radius)
  {
    return Rank(distance * distance, strength, Shape(radius));
  }

  /// The distance from which on a sphere adds less than `least`.
  static double Reach(double weight, double radius, double least)
  {
    return radius * std::sqrt(std::max(0.0, 1.0 + 0.5 * std::log(weight / least)));
  }

  template <typename T>
  static T Value(const T& square, const T& strength, const T& shape)
  {
    using S = ScalarOf<T>;
    return strength * Exponential(S(2) - S(2) * (square * shape));
  }

  template <typename T>
  static T Slope(const T& square, const T& strength, const T& shape)
  {
    return ScalarOf<T>(-4) * shape * Value(square, strength, shape);
  }
};

/// 2 w (1 - u)^2 (1 - 4 u / 9) where u = (d / 2 r)^2 is below 1, else 0.
///
/// Source: Wyvill, McPheeters and Wyvill, "Data structure for soft objects" (1986), with an
/// influence of two radii.
struct WyvillBlob
{
  static constexpr bool HasEstimate = false;

  static double Shape(double radius) { return std::min(0.25 / (radius * radius), 1e36); }
  static constexpr double LeastRank = 0.0;
  static double Rank(double square, double strength, double shape)
  {
    return Value(square, strength, shape);
  }
  static double Below(double rank) { return 0.999999 * rank; }
  static double MostRank(double distance, double strength, double radius)
  {
    return Rank(distance * distance, strength, Shape(radius));
  }
  static double Reach(double, double radius, double) { return 2.0 * radius; }

  template <typename T>
  static T Value(const T& square, const T& strength, const T& shape)
  {
    using S = ScalarOf<T>;
    const T u = square * shape;
    const T left = Larger(S(1) - u, T{});
    return (S(2) * strength) * (left * left) * (S(1) - u * S(4.0 / 9.0));
  }

  template <typename T>
  static T Slope(const T& square, const T& strength, const T& shape)
  {
    using S = ScalarOf<T>;
    const T u = square * shape;
    const T left = Larger(S(1) - u, T{});
    return strength * shape * left * (u * S(16.0 / 3.0) - S(88.0 / 9.0));
  }
};
}
}

#endif
