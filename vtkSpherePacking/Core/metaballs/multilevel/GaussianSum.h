// SPDX-License-Identifier: BSD-3-Clause
/// d^-v, for v = 1 or 2, as a sum of Gaussians of the distance d, and how multilevel summation
/// evaluates that sum on a hierarchy of grids.
///
/// With u = e^t, d^-v = 2 / Gamma(v / 2) times the integral of u^v e^(-u^2 d^2) over all t. The
/// trapezoidal rule with the step ln(2) / 2 gives
///
///   d^-v = sum of w(m) e^(-u(m)^2 d^2) over all integers m, u(m) = a 2^(-m/2), w(m) ~ u(m)^v.
///
/// By Poisson's summation formula its relative error is the sum over k > 0 of 2 |Gamma(v / 2 +
/// i pi k / step)| / Gamma(v / 2), below 1e-5, at any d. No term is negative. So the relative error
/// of a field of positive charges is at most that of one charge, and that is at most, at any d, the
/// mean of the relative errors of the terms, weighted by the terms.
///
/// Terms with m < 0 are short-range. They are summed directly, as d^-v minus the other terms, up to
/// the distance Cutoff, and neglected beyond, where they are at most 4.2e-4 of d^-v (2.5e-4 for
/// v = 2).
///
/// The other terms are long-range, and so smooth that they are evaluated on grids. A Gaussian of
/// the variance A + B is the convolution of two, of the variances A and B; the integral is replaced
/// by a sum over grid points a spacing h apart. By Poisson's formula the sum is the Gaussian times
/// a factor between 1 - e and 1 + e along each axis, where e = 2 exp(-2 pi^2 s / h^2) + ... and
/// 1 / s = 1 / A + 1 / B. Sums of such sums stay within the product of the factors. The steps, each
/// of which adds a part of the variance, are:
///
/// - Anterpolation. Charges become charges at the points of level 0, among which are those where
///   the field is wanted, by Gaussians of the variance s0 = 1 / (4 a^2).
/// - Restriction. Charges of level l - 1 become charges at the points of level l, whose spacing is
///   h 2^l, which brings their variance to 4^l h^2.
/// - Level 0 evaluates the terms m = 0, 1 and 2 from its charges, level l the terms 2 l + 1 and
///   2 l + 2, by Gaussians of the variance that is missing to 1 / (2 u^2) in the end.
/// - Prolongation. The field of level l is interpolated at the points of level l - 1 and added to
///   its field. From level l to level 0 this adds the variance 4^l h^2, that of the charges.
///
/// For a h = 0.55, s0 = 0.83 h^2. e is largest for m = 0, 5.8e-4, but that term is at most 0.17 of
/// d^-1 (0.26 of d^-2) at any d. Gaussians are truncated, at 4 h for anterpolation and at sqrt(22)
/// standard deviations elsewhere. Of a term at the distance d this loses the part of the product of
/// two Gaussians that lies beyond; as the product is centred between charge and point, the loss is
/// large only where the term is nearly 0. Terms that hardly decay over the scene are merged into
/// one on the coarsest grid, and within Cutoff the long-range terms are a polynomial. All this
/// together is at most 7e-4 of d^-v at any d; tests/core/test_gaussian_sum.py adds it up. Sums in
/// single precision, see AddInBatches(), add at most 2.5e-4.
///
/// Sources: Brandt and Lubrecht, "Multilevel matrix multiplication and fast solution of integral
/// equations" (1990), and Hardy, Stone and Schulten, "Multilevel summation of electrostatic
/// potentials using graphics processing units" (2009), for the hierarchy; Beylkin and Monzon,
/// "Approximation by exponential sums revisited" (2010), for the sum; Greengard and Lee,
/// "Accelerating the nonuniform fast Fourier transform" (2004), for Gaussians as sums of products.
#ifndef GaussianSum_h
#define GaussianSum_h

namespace spherepacking
{
/// Bound for the relative error of all of the above, of each charge's field.
constexpr double GaussianSumError = 1e-3;

/// Gaussians of anterpolation are truncated at this distance in units of the largest spacing.
constexpr double AnterpolationRadius = 4.0;

/// The terms of the sum, and the variances of the steps.
class GaussianSum
{
public:
  /// `power` is v, `spacing` is h, the largest of the finest grid.
  GaussianSum(int power, double spacing);

  double Rate(int m) const;   ///< u(m)
  double Weight(int m) const; ///< w(m)

  /// Variance of the Gaussians into which the charges of a level have spread.
  double ChargeVariance(int level) const;

  /// The sum of all terms from m = 0 on at a distance.
  double LongRange(double distance) const;

  /// Rate and weight of one term in place of all from m = `first` on: exact up to the square of the
  /// distance, which is accurate for distances far below 1 / u(first).
  void MergeTerms(int first, double& rate, double& weight) const;

  double Cutoff;

private:
  const int Power;
  const double Spacing;
  const double Alpha; // a
};
}

#endif
