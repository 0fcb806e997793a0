// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpherePackingPathTracer
 * @brief   pictures of a packing in the light of a sky and a sun
 *
 * Traces paths from the camera from sphere to sphere until they end in the sky. Spheres are opaque
 * and diffuse (Lambert): what they reflect is the albedo times their colour, which the superclass
 * finds. They are lit from outside alone: what is seen from inside of a sphere is as bright as its
 * other side. Next-event estimation, multiple importance sampling and Russian roulette are used as
 * light/TracePaths.h says.
 *
 * The output has the point arrays
 *
 * - `radiance`, three floats: the mean over the samples, linear, red, green and blue of Rec. 709,
 *   the sky included;
 * - `albedo` and `normal`, three floats each: the means over the samples of what is hit first, 0
 *   for the sky;
 * - `depth` and `sphere_id`: of the ray through the pixel's middle, as in the superclass;
 * - `coverage`, float: the fraction of the samples that hit a sphere;
 * - `samples`, unsigned int: how many there are;
 * - `variance`, float: of the mean radiance's luminance, if samples were drawn independently of
 * each other; they are more even than that, so that it is too large rather than too small;
 * - `color`, four unsigned chars: `radiance` in sRGB, and opacity.
 *
 * The picture depends on the seed and not on tiles, threads or the structure, to the last bit. It
 * accumulates: with a larger number of samples only the missing ones are traced, also after an
 * abort or an exhausted time budget; nothing is traced when only the exposure or the like has
 * changed. A picture that has been written into since starts anew. Only with a noise target does it
 * matter where an earlier run ended.
 *
 * Field arrays are those of the superclass without `partial_seconds`, and `traced_samples`, how
 * many the last run added over all pixels. `complete_seconds` and `compute_seconds` are of the last
 * run.
 *
 * `Samples` of the superclass is ignored; use `NumberOfSamples`.
 *
 * @sa vtkSpherePackingTracer
 */
#ifndef vtkSpherePackingPathTracer_h
#define vtkSpherePackingPathTracer_h

#include "vtkSpherePackingTracer.h"

#include <memory> // for std::unique_ptr

class vtkFloatArray;
class vtkImageData;
class vtkUnsignedCharArray;

namespace spherepacking
{
class PathFilm;
struct PathLight;
}

class VTKSPHEREPACKINGCORE_EXPORT vtkSpherePackingPathTracer : public vtkSpherePackingTracer
{
public:
  static vtkSpherePackingPathTracer* New();
  vtkTypeMacro(vtkSpherePackingPathTracer, vtkSpherePackingTracer);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Samples per pixel, from 1 on, default 16. Other numbers are an error when the filter runs, as
   * are wrong values of all that follows.
   */
  vtkSetMacro(NumberOfSamples, int);
  vtkGetMacro(NumberOfSamples, int);

  /**
   * How many spheres a path may visit, 0 or more, default 4. With 1 there is direct light alone,
   * with 0 none.
   */
  vtkSetMacro(MaximumNumberOfBounces, int);
  vtkGetMacro(MaximumNumberOfBounces, int);

  /**
   * The fraction of the light that a white sphere reflects, from 0 to 1, default 0.8.
   */
  vtkSetMacro(Albedo, double);
  vtkGetMacro(Albedo, double);

  /**
   * Seed of the random numbers, 0 by default. The same seed makes the same picture.
   */
  vtkSetMacro(Seed, unsigned int);
  vtkGetMacro(Seed, unsigned int);

  ///@{
  /**
   * Radiance of the sky at +z and at -z, linear red, green and blue, from 0 to 1e15, default 1 1 1.
   * In between it goes with z, the height of the direction's unit vector.
   */
  vtkSetVector3Macro(SkyTop, double);
  vtkGetVector3Macro(SkyTop, double);
  vtkSetVector3Macro(SkyBottom, double);
  vtkGetVector3Macro(SkyBottom, double);
  ///@}

  /**
   * Radiance of the sky instead of that, null by default: the scalars of an image of three
   * components, from 0 to 1e15, in equirectangular projection: rows from -z to +z, the middle
   * column at +x and that at a quarter of the width at +y.
   */
  void SetSkyImage(vtkImageData* image);
  vtkImageData* GetSkyImage();

  /**
   * Direction towards the sun, of any length but 0, default 0 0 1.
   */
  vtkSetVector3Macro(SunDirection, double);
  vtkGetVector3Macro(SunDirection, double);

  /**
   * Radiance that the sun lends to a white surface (of albedo 1) that faces it, linear red, green
   * and blue, from 0 to 1e15, default 0 0 0, without sun.
   */
  vtkSetVector3Macro(SunRadiance, double);
  vtkGetVector3Macro(SunRadiance, double);

  /**
   * Diameter of the sun in degrees, from 0, for shadows with hard edges, to 180; default 0.53.
   */
  vtkSetMacro(SunDiameter, double);
  vtkGetMacro(SunDiameter, double);

  /**
   * Seconds after which no further tile is begun, 0, the default, for as long as it takes. Every
   * pixel has a sample at least, but with Preview.
   */
  vtkSetMacro(TimeBudget, double);
  vtkGetMacro(TimeBudget, double);

  /**
   * With a time budget, begin with one pixel in four, whose light `color` shows at the other three
   * as well until they have a sample. Off by default.
   */
  vtkSetMacro(Preview, bool);
  vtkGetMacro(Preview, bool);
  vtkBooleanMacro(Preview, bool);

  /**
   * Relative error at which a part of the picture, 32 x 32 pixels, gets no more samples: the root
   * of its mean variance over its mean brightness. 0, the default, gives all the same number.
   */
  vtkSetMacro(NoiseTarget, double);
  vtkGetMacro(NoiseTarget, double);

  /**
   * How many samples a pixel gets before its error is estimated, from 2 on, default 16; then it is
   * estimated after every eighth sample.
   */
  vtkSetMacro(MinimumNumberOfSamples, int);
  vtkGetMacro(MinimumNumberOfSamples, int);

  /**
   * In `color`, light counts 2^Exposure times; from -100 to 100, default 0.
   */
  vtkSetMacro(Exposure, double);
  vtkGetMacro(Exposure, double);

  /**
   * A filmic curve for `color` instead of cutting light off at white. Off by default.
   */
  vtkSetMacro(Filmic, bool);
  vtkGetMacro(Filmic, bool);
  vtkBooleanMacro(Filmic, bool);

  /**
   * Whether `color` shows the sky behind the spheres, without opacity below 255; otherwise its
   * opacity is the coverage. On by default.
   */
  vtkSetMacro(SkyVisible, bool);
  vtkGetMacro(SkyVisible, bool);
  vtkBooleanMacro(SkyVisible, bool);

  /**
   * Tone-maps another radiance than that of the last picture, a denoised one for example, into
   * `color`: three components per pixel. Returns false and changes nothing if there is no picture
   * or the array does not have its size.
   */
  bool Develop(vtkFloatArray* radiance, vtkUnsignedCharArray* color);

  /**
   * Also that of the sky's image.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkSpherePackingPathTracer();
  ~vtkSpherePackingPathTracer() override;
  void Check() const override;
  double BytesPerPixel() const override { return 64.0; }
  void Trace(vtkImageData* output) override;

private:
  vtkSpherePackingPathTracer(const vtkSpherePackingPathTracer&) = delete;
  void operator=(const vtkSpherePackingPathTracer&) = delete;
  void SetLight(spherepacking::PathLight& light) const;
  struct Passes;
  void RunPasses(Passes& run);
  bool IsLate(const Passes& run) const;
  void RunPass(Passes& run, unsigned before, unsigned samples, int stride);
  void ToneMap(const float* radiance, unsigned char* color) const;

  vtkSmartPointer<vtkImageData> SkyImage;
  int NumberOfSamples = 16;
  int MaximumNumberOfBounces = 4;
  int MinimumNumberOfSamples = 16;
  double Albedo = 0.8;
  unsigned int Seed = 0;
  double SkyTop[3] = { 1.0, 1.0, 1.0 };
  double SkyBottom[3] = { 1.0, 1.0, 1.0 };
  double SunDirection[3] = { 0.0, 0.0, 1.0 };
  double SunRadiance[3] = { 0.0, 0.0, 0.0 };
  double SunDiameter = 0.53;
  double TimeBudget = 0.0;
  bool Preview = false;
  double NoiseTarget = 0.0;
  double Exposure = 0.0;
  bool Filmic = false;
  bool SkyVisible = true;
  std::unique_ptr<spherepacking::PathFilm> Film;
};

#endif
