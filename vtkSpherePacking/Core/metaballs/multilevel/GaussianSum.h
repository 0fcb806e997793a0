// SPDX-License-Identifier: BSD-3-Clause
/// d^-v, for v = 1 or 2, as a sum of Gaussians of the distance d, and what is made of it on meshes.
///
/// With u = e^t, d^-v = 2 / Gamma(v / 2) times the integral of u^v e^(-u^2 d^2) over all t. The
/// trapezoidal rule with the step ln(2) / 2 gives
///
///   d^-v = sum of w(m) e^(-u(m)^2 d^2) over all whole m, u(m) = a 2^(-m/2), w(m) ~ u(m)^v.
///
/// By Poisson's formula its relative error is the sum over k > 0 of 2 |Gamma(v / 2 + i pi k /
/// step)| / Gamma(v / 2), below 1e-5, at any d. No term is negative. So the relative error of a
/// field of positive charges is bounded by that of one charge, which is bounded, at any d, by the
/// mean of that of each term, weighted by the term's part of d^-v.
///
/// Terms with m < 0 are sharp. They are summed charge by charge, as d^-v less the others, up to the
/// distance Reach, and left out beyond, where they are 4.2e-4 of d^-v (2.5e-4 for v = 2) at most.
///
/// The other terms are smooth, and are made on meshes. A Gaussian of the variance A + B is the
/// integral of the product of two, of the variances A and B; instead of integrating it is summed
/// over nodes a step h apart. By Poisson's formula the sum is the Gaussian times a factor between 1
/// - e and 1 + e, with e = 2 exp(-2 pi^2 s / h^2) + ... and 1 / s = 1 / A + 1 / B, along each axis.
/// Sums of such sums stay within the product of the factors:
///
///   Charges go to mesh 0, whose nodes are where the field is wanted, as Gaussians of the variance
///   s0 = 1 / (4 a^2), and from mesh l - 1 to mesh l, whose step is h 2^l, so that they have spread
///   by 4^l h^2. Mesh 0 makes the terms m = 0, 1 and 2, mesh l those with 2 l + 1 and 2 l + 2, by
///   sums with a Gaussian of what is left of the variance 1 / (2 u^2). Mesh l adds its field to
///   that of mesh l - 1, and spreads it by 4^l h^2 in all.
///
/// For a h = 0.55, s0 = 0.83 h^2. e is largest for m = 0, 5.8e-4, but that term is no more than
/// 0.17 of d^-1 (0.26 of d^-2) at any d. Gaussians are cut off, 4 h away where charges are spread
/// and sqrt(22) standard deviations away elsewhere: of a term at the distance d that loses what the
/// product of the two Gaussians, whose middle is between, has beyond, most where the term is nearly
/// nothing. Terms that hardly fall within a scene become one on its last mesh, and the smooth terms
/// within Reach a polynomial. All this together is at most 7e-4 of d^-v at any d;
/// tests/core/test_gaussian_sum.py adds it up. Sums in single precision, see AddInParts, are wrong
/// by 2.5e-4 at most.
///
/// Sources: Beylkin and Monzon, "Approximation by exponential sums revisited" (2010), for the sum;
/// Greengard and Lee, "Accelerating the nonuniform fast Fourier transform" (2004), for Gaussians as
/// sums of products; Hardy, Stone and Schulten, "Multilevel summation of electrostatic potentials
/// using graphics processing units" (2009), for the meshes.
#ifndef GaussianSum_h
#define GaussianSum_h

namespace spherepacking
{
/// The relative error of what is above, for each charge.
constexpr double GaussianSumError = 1e-3;

/// Charges are spread to this many of the largest steps on each side.
constexpr double SpreadSteps = 4.0;

class GaussianSum
{
public:
  /// Of the power v of the distance, for a mesh whose largest step is h.
  GaussianSum(int power, double step);

  double Rate(int m) const;     ///< u(m)
  double Weight(int m) const;   ///< w(m)
  double Variance(int m) const; ///< 1 / (2 u^2)

  /// What charges and fields of mesh l have been spread by: `Spread` for charges of mesh 0.
  double SpreadOf(int mesh) const;

  /// Of the terms from m = 0 on, all together, at a distance.
  double Smooth(double distance) const;

  /// One term for all from m on, where m is so large that the distances are all short for it.
  void Rest(int m, double& rate, double& weight) const;

  double Reach;

private:
  const int Power;
  const double Step;
  const double Alpha;
};
}

#endif
