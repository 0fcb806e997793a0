// SPDX-License-Identifier: BSD-3-Clause
/// From linear light to the bytes of a picture.
#ifndef ToneMap_h
#define ToneMap_h

#include <algorithm>
#include <cmath>

namespace spherepacking
{
class ToneMapper
{
public:
  /// Light counts 2^exposure times; a filmic curve leaves bright parts some contrast instead of
  /// cutting them off at white.
  ToneMapper(double exposure, bool filmic)
    : Factor(std::exp2(exposure))
    , Filmic(filmic)
  {
  }

  /// A byte of sRGB (IEC 61966-2-1).
  unsigned char Byte(double light) const
  {
    double x = std::max(0.0, light * this->Factor);
    if (this->Filmic)
    {
      // Source: Narkowicz, "ACES Filmic Tone Mapping Curve" (2015).
      x = x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
    }
    x = std::min(x, 1.0);
    const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    return static_cast<unsigned char>(255.0 * encoded + 0.5);
  }

private:
  double Factor;
  bool Filmic;
};
}

#endif
