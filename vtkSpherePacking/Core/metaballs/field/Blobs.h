// SPDX-License-Identifier: BSD-3-Clause
/// The kernels: what one sphere of the weight w and the radius r adds to the field at a distance d.
///
/// All are w on the sphere's surface. A blob class is a kernel written as a function of the squared
/// distance `square` and of two parameters that depend on the sphere alone, strength and shape:
///
/// - Strength() and Shape() are these parameters; the strength is w where there is no Strength();
/// - Value() is the kernel, Slope() its derivative by d, divided by d, so that the gradient is
///   Slope() times the vector from the centre to the point;
/// - Rank() is an increasing function of Value() that does not underflow, for comparisons alone;
///   Value() is 0 where the rank is at most ZeroRank;
/// - MaxRank() bounds the rank of all spheres whose distance is at least, and whose strength and
///   radius are at most the given ones;
/// - Relaxed() is a rank slightly reduced, to allow for rounding;
/// - Support() is the distance beyond which a sphere adds less than `cutoff`.
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
inline T Max(const T& a, const T& b)
{
  return a > b ? a : b;
}

/// factor / sqrt(x), with a relative error of at most 3e-7.
inline Float8 DivideBySqrt(const Float8& factor, const Float8& x)
{
#if defined(__AVX__)
  // The processor's estimate and one step of Newton's method, whose constants take the factor.
  const Float8 guess = _mm256_rsqrt_ps(x);
  return guess * (1.5f * factor - (0.5f * factor) * (x * guess * guess));
#else
  return factor / Sqrt(x);
#endif
}
inline double DivideBySqrt(double factor, double x)
{
  return factor / std::sqrt(x);
}

/// factor / x, with a relative error of at most 3e-7.
inline Float8 Divide(const Float8& factor, const Float8& x)
{
#if defined(__AVX__)
  const Float8 guess = _mm256_rcp_ps(x);
  return guess * (2.0f * factor - factor * (x * guess));
#else
  return factor / x;
#endif
}
inline double Divide(double factor, double x)
{
  return factor / x;
}

/// Relative error of the processor's reciprocals and reciprocal square roots, RCPPS and RSQRTPS.
///
/// Source: Intel, "Intel 64 and IA-32 Architectures Software Developer's Manual", volume 2 (2023).
constexpr double EstimateError = 1.5 / 4096.0;

/// factor / sqrt(x), with a relative error of at most EstimateError.
inline Float8 EstimateDivideBySqrt(const Float8& factor, const Float8& x)
{
#if defined(__AVX__)
  return factor * _mm256_rsqrt_ps(x);
#else
  return factor / Sqrt(x);
#endif
}

/// factor / x, with a relative error of at most EstimateError.
inline Float8 EstimateDivide(const Float8& factor, const Float8& x)
{
#if defined(__AVX__)
  return factor * _mm256_rcp_ps(x);
#else
  return factor / x;
#endif
}

/// w (r / d)^Power, constant below d = r / 1024, which keeps it finite. For Power = 1 the Coulomb
/// potential of a charge w r.
///
/// The shape is the squared radius of that constant core, but no less than 1e-36, which is still a
/// normal float.
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

  static constexpr double ZeroRank = 0.0;
  static double Rank(double square, double strength, double shape)
  {
    return Value(square, strength, shape);
  }
  static double Relaxed(double rank) { return 0.999999 * rank; }
  static double MaxRank(double distance, double strength, double)
  {
    // Smaller cores have larger values; this is the smallest.
    return Rank(distance * distance, strength, 1e-36);
  }

  static double Support(double, double, double) { return std::numeric_limits<double>::infinity(); }

  template <typename T>
  static T Value(const T& square, const T& strength, const T& shape)
  {
    const T clamped = Max(square, shape);
    return Power == 1 ? DivideBySqrt(strength, clamped) : Divide(strength, clamped);
  }

  /// Value() with a relative error of at most EstimateError.
  static Float8 Estimate(const Float8& square, const Float8& strength, const Float8& shape)
  {
    const Float8 clamped = Max(square, shape);
    return Power == 1 ? EstimateDivideBySqrt(strength, clamped) : EstimateDivide(strength, clamped);
  }

  template <typename T>
  static T Slope(const T& square, const T& strength, const T& shape)
  {
    const T factor = ScalarOf<T>(-Power) * Value(square, strength, shape);
    const T slope = Divide(factor, Max(square, shape));
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
  static constexpr double ZeroRank = -746.0; // exp(-746) is 0
  static double Rank(double square, double strength, double shape)
  {
    return std::log(strength) + 2.0 - 2.0 * (square * shape);
  }
  static double Relaxed(double rank) { return rank - 1e-6; }
  static double MaxRank(double distance, double strength, double radius)
  {
    return Rank(distance * distance, strength, Shape(radius));
  }

  static double Support(double weight, double radius, double cutoff)
  {
    return radius * std::sqrt(std::max(0.0, 1.0 + 0.5 * std::log(weight / cutoff)));
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

/// 2 w v^2 (1 - 4 u / 9) with u = (d / 2 r)^2 and v = max(1 - u, 0).
///
/// Source: Wyvill, McPheeters and Wyvill, "Data structure for soft objects" (1986), with an
/// influence of two radii.
struct WyvillBlob
{
  static constexpr bool HasEstimate = false;

  static double Shape(double radius) { return std::min(0.25 / (radius * radius), 1e36); }
  static constexpr double ZeroRank = 0.0;
  static double Rank(double square, double strength, double shape)
  {
    return Value(square, strength, shape);
  }
  static double Relaxed(double rank) { return 0.999999 * rank; }
  static double MaxRank(double distance, double strength, double radius)
  {
    return Rank(distance * distance, strength, Shape(radius));
  }
  static double Support(double, double radius, double) { return 2.0 * radius; }

  template <typename T>
  static T Value(const T& square, const T& strength, const T& shape)
  {
    using S = ScalarOf<T>;
    const T u = square * shape;
    const T v = Max(S(1) - u, T{});
    return (S(2) * strength) * (v * v) * (S(1) - u * S(4.0 / 9.0));
  }

  template <typename T>
  static T Slope(const T& square, const T& strength, const T& shape)
  {
    using S = ScalarOf<T>;
    const T u = square * shape;
    const T v = Max(S(1) - u, T{});
    return strength * shape * v * (u * S(16.0 / 3.0) - S(88.0 / 9.0));
  }
};
}
}

#endif
