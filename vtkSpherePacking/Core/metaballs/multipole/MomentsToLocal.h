// SPDX-License-Identifier: BSD-3-Clause
#ifndef MomentsToLocal_h
#define MomentsToLocal_h

#include "metaballs/multipole/PowerDerivatives.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Eight clusters whose moments are translated into one local expansion together, one per lane.
struct ClusterBatch
{
  int Count = 0; ///< of lanes in use
  const float* Moments[8];
  float X[8]; ///< of the unit vector from the cluster's centre to that of the expansion
  float Y[8];
  float Z[8];
  float InverseDistance[8]; ///< of the centres
  float RadiusRatio[8];     ///< the cluster's radius, the unit of its moments, over the distance
};

/// sums[n] += sum over m of derivatives[n + m] moments[m], for all n + m <= Degree: a correlation,
/// with the sums in registers.
template <int Degree>
inline void Correlate(const Float8* derivatives, const Float8* moments, Float8* sums)
{
  Float8 totals[Degree + 1];
#pragma GCC unroll 16
  for (int n = 0; n <= Degree; ++n)
  {
    totals[n] = sums[n];
  }
#pragma GCC unroll 16
  for (int m = 0; m <= Degree; ++m)
  {
    const Float8 moment = moments[m];
#pragma GCC unroll 16
    for (int n = 0; n <= Degree - m; ++n)
    {
      totals[n] += derivatives[n + m] * moment;
    }
  }
#pragma GCC unroll 16
  for (int n = 0; n <= Degree; ++n)
  {
    sums[n] = totals[n];
  }
}

inline void Correlate(int degree, const Float8* derivatives, const Float8* moments, Float8* sums)
{
  switch (degree)
  {
    case 0:
      return Correlate<0>(derivatives, moments, sums);
    case 1:
      return Correlate<1>(derivatives, moments, sums);
    case 2:
      return Correlate<2>(derivatives, moments, sums);
    case 3:
      return Correlate<3>(derivatives, moments, sums);
    case 4:
      return Correlate<4>(derivatives, moments, sums);
    case 5:
      return Correlate<5>(derivatives, moments, sums);
    case 6:
      return Correlate<6>(derivatives, moments, sums);
    case 7:
      return Correlate<7>(derivatives, moments, sums);
    case 8:
      return Correlate<8>(derivatives, moments, sums);
    case 9:
      return Correlate<9>(derivatives, moments, sums);
    case 10:
      return Correlate<10>(derivatives, moments, sums);
    case 11:
      return Correlate<11>(derivatives, moments, sums);
    case 12:
      return Correlate<12>(derivatives, moments, sums);
    case 13:
      return Correlate<13>(derivatives, moments, sums);
    case 14:
      return Correlate<14>(derivatives, moments, sums);
    default:
      return Correlate<MaxOrder>(derivatives, moments, sums);
  }
}

/// M2L: adds the fields of eight clusters to a local expansion, whose eight lanes are to be summed.
///
/// Moments and expansion are stored by `stored`; of their coefficients those up to the order of
/// `index` are used. `unit` is the length by which the expansion's monomials are divided. Ratios of
/// lengths are formed before anything is raised to a power, so neither small nor large clusters
/// leave the range of single precision.
template <int Power>
inline void MomentsToLocal(const MultiIndex& stored, const TranslationIndex& index,
  const ClusterBatch& clusters, float unit, Float8* expansion)
{
  Float8 derivatives[MaxSums + 1];
  PowerDerivatives(index, Load<Float8>(clusters.X), Load<Float8>(clusters.Y),
    Load<Float8>(clusters.Z), derivatives);

  const int order = index.Reduced.Order;
  const int zDegree = index.Reduced.ZDegree;
  const Float8 inverse = Load<Float8>(clusters.InverseDistance);
  const Float8 ratio = Load<Float8>(clusters.RadiusRatio);
  Float8 ratios[MaxOrder + 1];
  Float8 factors[MaxOrder + 1];
  ratios[0] = Float8{} + 1.0f;
  factors[0] = Power == 1 ? inverse : inverse * inverse;
  for (int n = 1; n <= order; ++n)
  {
    ratios[n] = ratios[n - 1] * ratio;
    factors[n] = factors[n - 1] * (inverse * unit);
  }

  Float8 moments[MaxReduced];
  ForEachMonomial(index.Reduced,
    [&](int i, int j, int k, int n)
    {
      const int at = stored(i, j, k);
      moments[n] = ratios[i + j + k] * Gather(clusters.Moments, at);
    });

  for (int k = 0; k <= zDegree; ++k)
  {
    for (int j = 0; j + k <= order; ++j)
    {
      const int maxI = order - j - k;
      Float8 sums[MaxOrder + 1];
      std::fill_n(sums, maxI + 1, Float8{});
      for (int c = 0; c <= std::min(zDegree, maxI); ++c)
      {
        for (int b = 0; b + c <= maxI; ++b)
        {
          Correlate(maxI - b - c, derivatives + index.Derivatives.Rows[k + c][j + b],
            moments + index.Reduced.Rows[c][b], sums);
        }
      }
      Float8* row = expansion + stored.Rows[k][j];
      for (int i = 0; i <= maxI; ++i)
      {
        row[i] += factors[i + j + k] * sums[i];
      }
    }
  }
}
}
}

#endif
