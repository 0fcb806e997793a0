// SPDX-License-Identifier: BSD-3-Clause
#ifndef MomentsToLocal_h
#define MomentsToLocal_h

#include "metaballs/multipole/PowerDerivatives.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Eight clusters of charges that act on one place. Those beyond `Count` have no charge.
struct Clusters
{
  int Count = 0;
  const float* Moments[8];
  float X[8]; ///< of the unit vector from the cluster's centre to the place
  float Y[8];
  float Z[8];
  float InverseDistance[8];
  float Shrink[8]; ///< the cluster's radius, the unit of its moments, over the distance
};

/// sums[n] += sum over m of derivatives[n + m] moments[m], for all n + m <= Degree.
template <int Degree>
inline void Correlate(const Float8* derivatives, const Float8* moments, Float8* sums)
{
  Float8 kept[Degree + 1];
#pragma GCC unroll 16
  for (int n = 0; n <= Degree; ++n)
  {
    kept[n] = sums[n];
  }
#pragma GCC unroll 16
  for (int m = 0; m <= Degree; ++m)
  {
    const Float8 moment = moments[m];
#pragma GCC unroll 16
    for (int n = 0; n <= Degree - m; ++n)
    {
      kept[n] += derivatives[n + m] * moment;
    }
  }
#pragma GCC unroll 16
  for (int n = 0; n <= Degree; ++n)
  {
    sums[n] = kept[n];
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
      return Correlate<MostOrder>(derivatives, moments, sums);
  }
}

/// Adds the fields of eight clusters to an expansion about one place, up to a total degree.
///
/// Moments and expansion have coefficients up to the degree of `full`, of which those up to the
/// degree of `index` are used. `unit` is the length by which the expansion's monomials are divided.
/// Lengths are divided out before anything is raised to a power: neither small nor large clusters
/// leave the range of single precision.
template <int Power>
inline void TranslateMoments(const MultiIndex& full, const TranslationIndex& index,
  const Clusters& clusters, float unit, Float8* expansion)
{
  Float8 derivatives[MostSums + 1];
  PowerDerivatives(index, Load<Float8>(clusters.X), Load<Float8>(clusters.Y),
    Load<Float8>(clusters.Z), derivatives);

  const int order = index.Kept.Order;
  const int top = index.Kept.Top;
  const Float8 inverse = Load<Float8>(clusters.InverseDistance);
  const Float8 shrink = Load<Float8>(clusters.Shrink);
  Float8 shrinks[MostOrder + 1];
  Float8 grows[MostOrder + 1];
  shrinks[0] = Float8{} + 1.0f;
  grows[0] = Power == 1 ? inverse : inverse * inverse;
  for (int n = 1; n <= order; ++n)
  {
    shrinks[n] = shrinks[n - 1] * shrink;
    grows[n] = grows[n - 1] * (inverse * unit);
  }

  Float8 moments[MostKept];
  ForEachMonomial(index.Kept,
    [&](int i, int j, int k, int place)
    {
      const int at = full(i, j, k);
      moments[place] = shrinks[i + j + k] * Gather(clusters.Moments, at);
    });

  for (int k = 0; k <= top; ++k)
  {
    for (int j = 0; j + k <= order; ++j)
    {
      const int most = order - j - k;
      Float8 sums[MostOrder + 1];
      std::fill_n(sums, most + 1, Float8{});
      for (int c = 0; c <= std::min(top, most); ++c)
      {
        for (int b = 0; b + c <= most; ++b)
        {
          Correlate(most - b - c, derivatives + index.Sums.Rows[k + c][j + b],
            moments + index.Kept.Rows[c][b], sums);
        }
      }
      Float8* row = expansion + full.Rows[k][j];
      for (int i = 0; i <= most; ++i)
      {
        row[i] += grows[i + j + k] * sums[i];
      }
    }
  }
}
}
}

#endif
