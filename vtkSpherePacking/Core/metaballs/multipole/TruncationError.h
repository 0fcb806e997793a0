// SPDX-License-Identifier: BSD-3-Clause
/// How exact a truncated expansion of a field is.
///
/// The field of a charge q > 0 at the distance d is q d^-v, for v = 1 or 2. Let the charges of a
/// cluster lie within the radius a about its centre, at distances y from it, and places within the
/// radius b about another centre; R is the distance of the centres. A charge and a place are apart
/// by R + u, both vectors, with |u| <= b + y. Let t = |u| / R and x = -cos(R, u). What the Taylor
/// series of |R + u|^-v about R has of total degree n in u is, with the Gegenbauer polynomials C,
/// R^-v t^n C_n^(v/2)(x). Let e be the sum of the terms of degree p + 1 on, over that of all.
///
/// v = 1, C_n = P_n: with W(t) = sqrt(1 - 2 x t + t^2), the recurrence of P_n gives
///
///   e = W(t) sum of t^n P_n = (p + 1) integral from 0 to t of s^p (P_(p+1) - s P_p) / W(s) ds.
///
/// By Laplace's integral P_(p+1) - s P_p is the mean of z^p (z - s) over f in [0, pi], where
/// z = x + i sqrt(1 - x^2) cos f. As |z| <= 1 and |z - s| <= W(s), it is at most W(s), so
/// |e| <= t^(p+1), which is reached where u is parallel to R.
///
/// v = 2, C_n = U_n: the sum telescopes to e = t^(p+1) (U_(p+1) - t U_p), and |U_n| <= n + 1, so
/// |e| <= t^(p+1) (p + 2 + (p + 1) t).
///
/// Both bound the error of each charge by T = (b + a) / R in place of t. They also bound that of
/// the cluster, which is smaller as few charges are that far from its centre. At a place whose
/// distance to the cluster's centre is D >= R - b, no charge is nearer than D - a, so the error is
/// at most (D - a)^-v times the sum of q |e|. Let m^16 be the mean of y^16, weighted by q. For n <=
/// 16 the mean of (b + y)^n is at most (b + m)^n, by Minkowski's inequality and since power means
/// grow with the power. By Jensen's inequality the field is no less than (D + m)^-v times the sum
/// of q. With s = (b + m) / R the relative error is at most
///
///   ((R - b + m) / (R - b - a))^v |e|, where |e| is bounded by s in place of t in t^(p+1).
///
/// Where this is at most 1/2, it falls with p: clusters may be expanded to a higher order than they
/// need.
///
/// No charge is negative, so the relative error of a sum of clusters is no larger than the largest
/// among them. Shifting a polynomial to another centre does not change it.
///
/// Sources: Greengard and Rokhlin, "A fast algorithm for particle simulations" (1987), where T
/// replaces s and another factor stands before it; the truncation by total degree in Cartesian
/// coordinates is that of Dehnen, "A hierarchical O(N) force calculation algorithm" (2002).
#ifndef TruncationError_h
#define TruncationError_h

#include "base/Simd.h"
#include "metaballs/multipole/MultiIndex.h"

#include <algorithm>

namespace spherepacking
{
/// Power of the mean m above; no order may reach it.
constexpr int MeanPower = 16;
static_assert(MostOrder < MeanPower, "the bound holds for orders below the power of the mean");

/// What the bound depends on: b, a and m above over R.
struct Separation
{
  double Places;
  double Charges;
  double Mean;
};

inline namespace SPHEREPACKING_ISA
{
/// The smallest order, up to `most`, whose error is at most `error`, or most + 1 if there is none.
template <int Power>
inline int OrderFor(const Separation& by, double error, int most)
{
  const double extreme = by.Places + by.Charges;
  if (!(extreme < 1.0))
  {
    return most + 1;
  }
  const double typical = by.Places + by.Mean;
  const double nearness = (1.0 - by.Places + by.Mean) / (1.0 - extreme);
  double ofEach = extreme;
  double ofAll = typical * (Power == 1 ? nearness : nearness * nearness);
  for (int order = 0; order <= most; ++order)
  {
    const double factor = Power == 1 ? 1.0 : order + 2.0 + (order + 1.0) * extreme;
    if (std::min(ofEach, ofAll) * factor <= error)
    {
      return order;
    }
    ofEach *= extreme;
    ofAll *= typical;
  }
  return most + 1;
}
}
}

#endif
