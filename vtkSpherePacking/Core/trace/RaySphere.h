// SPDX-License-Identifier: BSD-3-Clause
/// Ray/sphere intersection: the one test of every technique and structure on the processor. Its
/// twin in single precision is Rendering/glsl/RaySphereFS.glsl.
///
/// The discriminant is r^2 - |l|^2, where l is the perpendicular from the ray to the centre, so
/// that no large squares cancel. Source: Haines, Guenther, Akenine-Moller, "Precision Improvements
/// for Ray/Sphere Intersection", Ray Tracing Gems (2019), chapter 7. A ray that only touches
/// misses, and spheres of radius 0 are always missed.
///
/// Error. Let f be the centre as seen from the origin, t0 the middle of the chord, u = 2^-53, and
/// terms of u^2 be left out. f is rounded once (u|f|), t0 d has a rounding each in the product and
/// in the subtraction (u|f| + u|l|), and what is wrong in t0 moves l along d only, where |l| does
/// not change to first order; so |l| is off by 3u|f| at most. Its square adds 3u|l|^2, r^2 and the
/// difference 2u r^2:
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

/// The chord that a sphere around f cuts out of the line through the origin along d, whatever its
/// radius: t0 is the parameter of its middle, and l the perpendicular from there to the centre.
///
/// Real is double, or a vector of several; the direction may be the same for all of them.
template <typename Real>
struct Chord
{
  Real T0;
  Real L[3];
  Real Square; ///< |l|^2

  template <typename Direction, typename Scale>
  Chord(const Real (&f)[3], const Direction (&d)[3], const Scale& inverseSquare)
    : T0((f[0] * d[0] + f[1] * d[1] + f[2] * d[2]) * inverseSquare)
    , L{ f[0] - this->T0 * d[0], f[1] - this->T0 * d[1], f[2] - this->T0 * d[2] }
    , Square(this->L[0] * this->L[0] + this->L[1] * this->L[1] + this->L[2] * this->L[2])
  {
  }

  /// Above 0 where the line meets a sphere of that radius.
  template <typename Radius>
  Real Discriminant(const Radius& r) const
  {
    return r * r - this->Square;
  }
};

/// Whether the origin lies on the surface of a sphere whose centre is f from there, as far as
/// double precision can tell: |f|^2 and r^2 differ by no more than 2^-47 r^2, beyond which the
/// error bound says that hits have the right sign at any angle, and what comes of an origin that is
/// 16 roundings of the centre's coordinates away.
template <typename Real>
inline auto IsOnSurface(const Real (&f)[3], const Sphere& sphere)
{
  const double square = sphere.R * sphere.R;
  const double far = std::abs(sphere.X) + std::abs(sphere.Y) + std::abs(sphere.Z);
  const Real power = f[0] * f[0] + f[1] * f[1] + f[2] * f[2] - square;
  const Real tolerance = Real{} + (0x1p-47 * square + 0x1p-48 * far * sphere.R);
  return (power <= tolerance) & (power >= -tolerance);
}

/// The least t > 0 at which the ray through the origin along d meets the sphere, whose centre is f
/// from there, else NoHit. A ray that starts on the surface does not meet it there: outwards it
/// misses the sphere, inwards it meets its far side. `mayStartThere` is false if it is known not
/// to.
template <typename Real>
inline Real HitSphere(const Real (&f)[3], const Sphere& sphere, const Real (&d)[3],
  const Real& inverseSquare, bool mayStartThere = true)
{
  const Real miss = Real{} + NoHit;
  const Chord<Real> chord(f, d, inverseSquare);
  const Real discriminant = chord.Discriminant(sphere.R);
  if (!Any(discriminant > 0.0))
  {
    return miss;
  }
  // NaN where the discriminant is negative.
  const Real half = Sqrt(discriminant * inverseSquare);
  const Real near = chord.T0 - half;
  const Real far = chord.T0 + half;
  const Real t = near > 0.0 ? near : far;
  Real ahead = t > 0.0 ? t : miss;
  // From a surface, hits within a thousandth of the radius are in doubt; others are rare.
  if (mayStartThere && Any(t * t < 0x1p-20 * (sphere.R * sphere.R) * inverseSquare))
  {
    ahead = IsOnSurface(f, sphere) ? (chord.T0 > 0.0 ? far : miss) : ahead;
  }
  return discriminant > 0.0 ? ahead : miss;
}

/// The unit normal, out of the sphere, of the hit at t; from the perpendicular, so that it keeps
/// its digits however far away the origin is.
template <typename Real>
inline void NormalAt(const Real (&f)[3], const Real& r, const Real (&d)[3],
  const Real& inverseSquare, const Real& t, Real (&normal)[3])
{
  const Chord<Real> chord(f, d, inverseSquare);
  const Real half = Sqrt(chord.Discriminant(r) * inverseSquare);
  const Real along = t > chord.T0 ? half : -half;
  for (int axis = 0; axis < 3; ++axis)
  {
    normal[axis] = along * d[axis] - chord.L[axis];
  }
  // Its length is the radius but for rounding, which is all that is left of tiny spheres far away.
  const Real length = Sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  for (int axis = 0; axis < 3; ++axis)
  {
    normal[axis] /= length;
  }
}

inline void NormalAt(
  const Ray& ray, const Sphere& sphere, double inverseSquare, double t, double (&normal)[3])
{
  const double f[3] = { sphere.X - ray.O[0], sphere.Y - ray.O[1], sphere.Z - ray.O[2] };
  NormalAt<double>(f, sphere.R, ray.D, inverseSquare, t, normal);
}

/// Primary rays meet every surface, from inside of a sphere as well.
struct PrimaryRay
{
  static constexpr bool CenterMayBeBehind = true; ///< whether spheres around the origin count
  static constexpr bool AnyHit = false;           ///< whether one hit is as good as another

  double Hit(const Ray& ray, const Sphere& sphere, double inverseSquare, std::int64_t) const
  {
    const double f[3] = { sphere.X - ray.O[0], sphere.Y - ray.O[1], sphere.Z - ray.O[2] };
    return HitSphere<double>(f, sphere, ray.D, inverseSquare);
  }
};

/// Secondary rays leave the surface of a sphere and meet others from outside; shadow rays need any
/// hit.
///
/// Such a ray cannot meet its own sphere again. Where its origin is inside of another one, by
/// rounding where spheres touch or coincide, it leaves that one unseen: no light is lost in
/// between.
template <bool AnyHitT>
struct SecondaryRay
{
  static constexpr bool CenterMayBeBehind = false;
  static constexpr bool AnyHit = AnyHitT;
  std::int64_t OriginSphere; ///< id

  double Hit(const Ray& ray, const Sphere& sphere, double inverseSquare, std::int64_t id) const
  {
    const double f[3] = { sphere.X - ray.O[0], sphere.Y - ray.O[1], sphere.Z - ray.O[2] };
    const Chord<double> chord(f, ray.D, inverseSquare);
    const double discriminant = chord.Discriminant(sphere.R);
    if (!(chord.T0 > 0.0 && discriminant > 0.0) || id == this->OriginSphere)
    {
      return NoHit;
    }
    const double near = chord.T0 - std::sqrt(discriminant * inverseSquare);
    return near > 0.0 ? near : NoHit;
  }
};
}

/// The id of a sphere and the slot in which a structure holds it; ordered by the former.
inline std::int64_t MakeKey(std::int64_t id, std::uint32_t slot)
{
  return id * (std::int64_t{ 1 } << 32) + slot;
}
inline std::int64_t IdOf(std::int64_t key)
{
  return key >> 32;
}
inline std::uint32_t SlotOf(std::int64_t key)
{
  return static_cast<std::uint32_t>(key);
}

/// The closest hit of a ray. Of two spheres at the same t the one with the lower id counts, so that
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
