// SPDX-License-Identifier: BSD-3-Clause
/// The relative error of an expansion that is truncated at the order p: the multipole acceptance
/// criterion.
///
/// The field of a charge q > 0 at the distance d is q d^-v, for v = 1 or 2. Let the charges of a
/// cluster lie within the radius a about its centre, at distances y from it, and points within the
/// radius b about another centre; R is the vector from the cluster's centre to that of the points,
/// and its length where a number is meant. The vector from a charge to a point is R + u with
/// |u| <= b + y. Let t = |u| / R and x = -cos(R, u). The terms of total degree n in u of the Taylor
/// series of |R + u|^-v about R add up to R^-v t^n C_n^(v/2)(x) with the Gegenbauer polynomials C.
/// Let e be the sum of all terms of degree p + 1 and above, divided by the sum of all.
///
/// v = 1, C_n = P_n: with W(t) = sqrt(1 - 2 x t + t^2), the recurrence of P_n gives
///
///   e = W(t) sum of t^n P_n = (p + 1) integral from 0 to t of w^p (P_(p+1) - w P_p) / W(w) dw.
///
/// By Laplace's integral P_(p+1) - w P_p is the mean of z^p (z - w) over f in [0, pi], where
/// z = x + i sqrt(1 - x^2) cos f. As |z| <= 1 and |z - w| <= W(w), it is at most W(w), so
/// |e| <= t^(p+1), which is reached where u is parallel to R.
///
/// v = 2, C_n = U_n: the sum telescopes to e = t^(p+1) (U_(p+1) - t U_p), and |U_n| <= n + 1, so
/// |e| <= t^(p+1) (p + 2 + (p + 1) t).
///
/// Both bound the error of each charge by T = (b + a) / R in place of t. They also bound that of
/// the cluster, which is smaller as few charges are that far from its centre. At a point whose
/// distance to the cluster's centre is D >= R - b, no charge is nearer than D - a, so the error is
/// at most (D - a)^-v times the sum of q |e|. Let m^16 be the mean of y^16, weighted by q. For n <=
/// 16 the mean of (b + y)^n is at most (b + m)^n, by Minkowski's inequality and since power means
/// grow with the power. By Jensen's inequality the field is no less than (D + m)^-v times the sum
/// of q. With s = (b + m) / R the relative error is at most
///
///   ((R - b + m) / (R - b - a))^v |e|, where |e| is bounded by s in place of t in t^(p+1).
///
/// Where this is at most 1/2, it falls with p: a cluster may be expanded to a higher order than it
/// needs.
///
/// No charge is negative, so the relative error of a sum of clusters is at most the largest among
/// them. L2L shifts of a local expansion are exact.
///
/// Sources: Greengard and Rokhlin, "A fast algorithm for particle simulations" (1987), whose bound
/// has T in place of s and another factor; truncation by total degree in Cartesian coordinates is
/// that of Dehnen, "A hierarchical O(N) force calculation algorithm" (2002).
#ifndef TruncationError_h
#define TruncationError_h

#include "base/Simd.h"
#include "metaballs/multipole/MultiIndex.h"

#include <algorithm>

namespace spherepacking
{
/// The power of the mean m above, which has to exceed all orders.
constexpr int MeanPower = 16;
static_assert(MaxOrder < MeanPower, "the bound holds for orders below the power of the mean");

/// What the bound depends on: b, a and m above, each divided by R.
struct Separation
{
  double Points;
  double Charges;
  double MeanCharges;
};

inline namespace SPHEREPACKING_ISA
{
/// The lowest order up to `maxOrder` whose error is at most `error`, else maxOrder + 1.
template <int Power>
inline int OrderFor(const Separation& separation, double error, int maxOrder)
{
  const double t = separation.Points + separation.Charges; // T above
  if (!(t < 1.0))
  {
    return maxOrder + 1;
  }
  const double s = separation.Points + separation.MeanCharges;
  const double nearness = (1.0 - separation.Points + separation.MeanCharges) / (1.0 - t);
  double ofEach = t;
  double ofAll = s * (Power == 1 ? nearness : nearness * nearness);
  for (int order = 0; order <= maxOrder; ++order)
  {
    const double factor = Power == 1 ? 1.0 : order + 2.0 + (order + 1.0) * t;
    if (std::min(ofEach, ofAll) * factor <= error)
    {
      return order;
    }
    ofEach *= t;
    ofAll *= s;
  }
  return maxOrder + 1;
}
}
}

#endif
