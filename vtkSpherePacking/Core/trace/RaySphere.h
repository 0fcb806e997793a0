// SPDX-License-Identifier: BSD-3-Clause
/// Where a ray meets the surface of a sphere: the one test of every technique and structure.
///
/// The discriminant is r^2 - |l|^2, where l is the perpendicular from the ray to the centre, so
/// that no large squares cancel. Source: Haines, Guenther, Akenine-Moller, "Precision Improvements
/// for Ray/Sphere Intersection", Ray Tracing Gems (2019), chapter 7. A ray that only touches
/// misses, and so does every ray a sphere of radius 0.
///
/// Error. Let f be the centre as seen from the origin, u = 2^-53, and terms of u^2 be left out.
/// f is rounded once (u|f|), t0 d has a rounding each in the product and in the subtraction
/// (u|f| + u|l|), and what is wrong in t0 moves l along d only, where |l| does not change to first
/// order; so |l| is off by 3u|f| at most. Its square adds 3u|l|^2, r^2 and the difference 2u r^2:
///
///   a ray that passes the surface by more than 6u(|f| + r) is decided right.
///
/// t0 |d| is off by 3u|f| from the dot product, 4u|f| from 1 / d.d and u|f| from their product;
/// half of the chord, r cos(a) at the angle of incidence a, by what |l|^2 - r^2 is off by over 2 r
/// cos(a), plus 3u of itself:
///
///   |t - exact| |d| <= 9u|f| + (6u(|f| + r) + 3ur) / cos(a) <= 16u(|f| + r) / cos(a).
///
/// Both hold for the numbers as given: a centre at 10^7 in double precision is itself known to
/// 10^-9 only. Compiled without contraction, the result is the same to the last bit whether rays
/// are tested one by one or many at once, on every processor.
#ifndef RaySphere_h
#define RaySphere_h

#include "base/Simd.h"
#include "base/Sphere.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace spherepacking
{
/// The points O + t D for t > 0. D need not be a unit vector.
struct Ray
{
  double O[3];
  double D[3];
};

constexpr double NoHit = std::numeric_limits<double>::infinity();

inline namespace SPHEREPACKING_ISA
{
/// 1 / d.d, which all spheres along a ray share.
inline double InverseSquare(const Ray& ray)
{
  return 1.0 / (ray.D[0] * ray.D[0] + ray.D[1] * ray.D[1] + ray.D[2] * ray.D[2]);
}

/// The least t > 0 at which the ray through the origin along d meets the sphere around f, else
/// NoHit. Real is double, or a vector of doubles.
template <typename Real>
inline Real HitSphere(const Real& fx, const Real& fy, const Real& fz, double r, const Real& dx,
  const Real& dy, const Real& dz, const Real& inverseSquare)
{
  const Real none = Real{} + NoHit;
  const Real middle = (fx * dx + fy * dy + fz * dz) * inverseSquare;
  const Real lx = fx - middle * dx;
  const Real ly = fy - middle * dy;
  const Real lz = fz - middle * dz;
  const Real discriminant = r * r - (lx * lx + ly * ly + lz * lz);
  if (!Any(discriminant > 0.0))
  {
    return none;
  }
  // NaN where the discriminant is negative.
  const Real half = Sqrt(discriminant * inverseSquare);
  const Real near = middle - half;
  const Real far = middle + half;
  const Real t = near > 0.0 ? near : far;
  const Real ahead = t > 0.0 ? t : none;
  return discriminant > 0.0 ? ahead : none;
}

inline double HitSphere(const Ray& ray, const Sphere& sphere, double inverseSquare)
{
  return HitSphere<double>(sphere.X - ray.O[0], sphere.Y - ray.O[1], sphere.Z - ray.O[2], sphere.R,
    ray.D[0], ray.D[1], ray.D[2], inverseSquare);
}

/// The unit normal, out of the sphere, where HitSphere() found a hit; from the perpendicular, so
/// that it keeps its digits however far away the origin is.
template <typename Real>
inline void NormalAt(const Real (&f)[3], const Real& r, const Real (&d)[3],
  const Real& inverseSquare, Real (&normal)[3])
{
  const Real middle = (f[0] * d[0] + f[1] * d[1] + f[2] * d[2]) * inverseSquare;
  Real l[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    l[axis] = f[axis] - middle * d[axis];
  }
  const Real discriminant = r * r - (l[0] * l[0] + l[1] * l[1] + l[2] * l[2]);
  const Real half = Sqrt(discriminant * inverseSquare);
  const Real along = middle - half > 0.0 ? -half : half;
  for (int axis = 0; axis < 3; ++axis)
  {
    normal[axis] = along * d[axis] - l[axis];
  }
  // Its length is the radius but for rounding, which is all that is left of tiny spheres far away.
  const Real length = Sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  for (int axis = 0; axis < 3; ++axis)
  {
    normal[axis] /= length;
  }
}

inline void NormalAt(
  const Ray& ray, const Sphere& sphere, double inverseSquare, double (&normal)[3])
{
  const double f[3] = { sphere.X - ray.O[0], sphere.Y - ray.O[1], sphere.Z - ray.O[2] };
  NormalAt<double>(f, sphere.R, ray.D, inverseSquare, normal);
}

/// Which surfaces a ray meets: all, those from inside as well.
struct EverySurface
{
  static constexpr bool Behind = true; ///< whether centres behind the origin count
  static constexpr bool Any = false;   ///< whether one hit is as good as another

  double Hit(const Ray& ray, const Sphere& sphere, double inverseSquare, std::int64_t) const
  {
    return HitSphere(ray, sphere, inverseSquare);
  }
};

/// Those that a ray meets from outside when it leaves the surface of a sphere.
///
/// It cannot meet that one again. Where its origin is inside of another one, by rounding where
/// spheres touch or coincide, it leaves that one unseen: no light is lost in between.
template <bool AnyT>
struct OuterSurface
{
  static constexpr bool Behind = false;
  static constexpr bool Any = AnyT;
  std::int64_t Left; ///< id of the sphere

  double Hit(const Ray& ray, const Sphere& sphere, double inverseSquare, std::int64_t id) const
  {
    const double f[3] = { sphere.X - ray.O[0], sphere.Y - ray.O[1], sphere.Z - ray.O[2] };
    const double middle = (f[0] * ray.D[0] + f[1] * ray.D[1] + f[2] * ray.D[2]) * inverseSquare;
    double square = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double l = f[axis] - middle * ray.D[axis];
      square += l * l;
    }
    const double discriminant = sphere.R * sphere.R - square;
    if (!(middle > 0.0 && discriminant > 0.0) || id == this->Left)
    {
      return NoHit;
    }
    const double near = middle - std::sqrt(discriminant * inverseSquare);
    return near > 0.0 ? near : NoHit;
  }
};
}

/// A sphere in the packing and where a structure holds it; ordered by the former.
inline std::int64_t MakeKey(std::int64_t id, std::uint32_t place)
{
  return id * (std::int64_t{ 1 } << 32) + place;
}
inline std::int64_t IdOf(std::int64_t key)
{
  return key >> 32;
}
inline std::uint32_t PlaceOf(std::int64_t key)
{
  return static_cast<std::uint32_t>(key);
}

/// The first hit of a ray. Of two spheres at the same t the one with the lower id counts, so that
/// the order in which a structure offers them does not matter.
struct Hit
{
  double T = std::numeric_limits<double>::max();
  std::int64_t Id = -1; ///< of the sphere in the packing; -1 for none
  Sphere On = {};       ///< that sphere, if any

  void Offer(double t, std::int64_t id, const Sphere& sphere)
  {
    if (t < this->T || (t == this->T && id < this->Id))
    {
      this->T = t;
      this->Id = id;
      this->On = sphere;
    }
  }
};
}

#endif
