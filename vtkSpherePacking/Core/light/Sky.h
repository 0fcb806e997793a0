// SPDX-License-Identifier: BSD-3-Clause
/// The light that comes from infinitely far away: a sky in all directions, and a sun.
#ifndef Sky_h
#define Sky_h

#include <cstdint>
#include <vector>

namespace spherepacking
{
/// Radiance by direction: from `Bottom` at -z to `Top` at +z, in proportion to z, or an image.
class Sky
{
public:
  float Bottom[3] = { 1.0f, 1.0f, 1.0f };
  float Top[3] = { 1.0f, 1.0f, 1.0f };

  /// Takes an image in equirectangular projection: rows from +z to -z, red, green and blue of a
  /// pixel after each other, no number negative; the middle column is at +x, that at three quarters
  /// of the width at -y. Empty for none. The light is bilinear between the middles of the pixels,
  /// and within half a pixel of the poles that of the row there.
  void SetImage(std::vector<float> pixels, int width, int height);

  bool HasImage() const { return this->Width > 0; }

  /// Whether Sample() can be used: there is an image, and not a black one.
  bool CanSample() const { return !this->Rows.empty(); }

  /// Along the unit vector d.
  void Radiance(const double (&d)[3], float (&radiance)[3]) const;

  /// Importance sampling of the image: makes a unit vector of two numbers between 0 and 1, with a
  /// density about in proportion to its radiance, and returns that density per solid angle.
  ///
  /// Source: Pharr and Humphreys, "Infinite Area Light Source with Importance Sampling" (2004).
  double Sample(double x, double y, double (&d)[3]) const;

  /// The density per solid angle with which Sample() makes d.
  double Density(const double (&d)[3]) const;

private:
  double MeanWithin(int column, int row) const;
  const float* PixelAt(int column, int row) const;
  double PixelDensity(int column, int row) const;

  std::vector<float> Pixels;
  int Width = 0;
  int Height = 0;
  // Cumulative distributions of the rows, and of the pixels within each row; both end with 1.
  std::vector<double> Rows;
  std::vector<float> Columns;
};

/// A disc in the sky that lights spheres and is not seen itself.
struct Sun
{
  double Direction[3] = { 0.0, 0.0, 1.0 };  ///< towards it; a unit vector
  float Radiance[3] = { 0.0f, 0.0f, 0.0f }; ///< of a white surface that faces it
  double OneMinusCosine = 0.0; ///< of the angle from its middle to its edge, which keeps its digits

  bool Shines() const
  {
    return this->Radiance[0] > 0.0f || this->Radiance[1] > 0.0f || this->Radiance[2] > 0.0f;
  }
};
}

#endif
