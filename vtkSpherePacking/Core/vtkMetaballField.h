// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMetaballField
 * @brief   the implicit field of a packing on a grid, within a bound on its error
 *
 * At each point of a regular grid, sums over the spheres of a packing a kernel of the distance d to
 * the sphere's centre. With the sphere's radius r and weight w, the kernel is
 *
 * - INVERSE: w r / d, the potential of a charge, constant below d = r / 1024;
 * - INVERSE_SQUARE: w r^2 / d^2, constant below d = r / 1024;
 * - GAUSSIAN: w exp(2 - 2 d^2 / r^2) (Blinn 1982);
 * - WYVILL: 2 w (1 - u)^2 (1 - 4 u / 9) with u = d^2 / (2 r)^2, 0 from d = 2 r on (Wyvill et al.
 *   1986).
 *
 * All are w on the surface of the sphere. Spheres of radius or weight 0 add nothing.
 *
 * Point arrays of the output: `field`, float; if wanted `gradient`, three floats, in world
 * coordinates; `strongest`, 64-bit integer, the id of the sphere that adds most, -1 where none
 * adds anything; and `blend`, three unsigned chars, the mean of the spheres' colours, weighted by
 * what each adds.
 *
 * The error of the field is at most RelativeError times the field; with GAUSSIAN and WYVILL, whose
 * tails are truncated, 10^-6 times the largest weight is added to that. INVERSE and INVERSE_SQUARE
 * are not truncated. They are summed by the fast multipole method, whose error is proven in
 * metaballs/multipole/TruncationError.h; or, if an error of 10^-3 is allowed and neither gradient
 * nor strongest is wanted, by multilevel summation (metaballs/multilevel/GaussianSum.h), provided
 * that its grids take little memory beside the spheres and that the largest spacing is at most
 * twice the smallest. Where the error allows it, from 3.8e-4 on, near spheres are added with the
 * processor's estimate of a reciprocal square root, which differs between makes; gradients are not.
 *
 * Blocks of the grid are summed on all cores through vtkSMPTools. Progress events come between
 * blocks, in the thread that called Update(). An observer may call SetAbortExecute(): then no
 * further block is begun, and the values of those that were not summed are 0. Field arrays of the
 * output: `build_seconds`, `sum_seconds`, and `meshes`, the number of grids of the multilevel
 * summation, 0 for other methods.
 *
 * An error leaves an empty output, is reported through vtkErrorMacro and sets GetErrorCode().
 * GetErrorMessage() is the sentence.
 *
 * @sa vtkFlyingEdges3D
 */
#ifndef vtkMetaballField_h
#define vtkMetaballField_h

#include "vtkImageAlgorithm.h"
#include "vtkSpherePackingCoreModule.h" // for the export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string
#include <vector> // for weights

class vtkDataArray;
class vtkFloatArray;
class vtkPolyData;
class vtkUnsignedCharArray;

namespace spherepacking
{
class PackingCharges;
struct FieldBlock;
struct FieldScene;
struct GridGeometry;
struct GridRequest;
}

class VTKSPHEREPACKINGCORE_EXPORT vtkMetaballField : public vtkImageAlgorithm
{
public:
  static vtkMetaballField* New();
  vtkTypeMacro(vtkMetaballField, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum KernelType
  {
    INVERSE,
    INVERSE_SQUARE,
    GAUSSIAN,
    WYVILL
  };

  /**
   * The kernel, default INVERSE. Other numbers become the nearest of these.
   */
  vtkSetClampMacro(Kernel, int, INVERSE, WYVILL);
  vtkGetMacro(Kernel, int);

  /**
   * Number of points of the grid along x, y and z, at least 1, default 64 x 64 x 64. Other numbers,
   * and more points than fit in half of the memory, are an error when the filter runs. Not used if
   * there is a spacing.
   */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);

  /**
   * Distance of the grid's points along x, y and z in world coordinates, in place of their number,
   * or 0 0 0, the default, for none. Other numbers that are not above 0 are an error when the
   * filter runs. The grid begins at the lower bounds; its last point is at the upper ones or
   * beyond.
   */
  vtkSetVector3Macro(Spacing, double);
  vtkGetVector3Macro(Spacing, double);

  /**
   * Bounds of the grid: x min, x max, y min, ... By default, when x min is above x max, they are
   * found when the filter runs: with a threshold so that its isosurface is closed inside, else as
   * the bounds of the packing with a margin of a tenth of their longest side. Bounds with another
   * minimum above its maximum, or that are not finite, are an error when the filter runs.
   */
  vtkSetVector6Macro(ModelBounds, double);
  vtkGetVector6Macro(ModelBounds, double);

  /**
   * The value of an isosurface that is to be closed inside the grid, above 0, or 0, the default,
   * for none. It has no effect if there are bounds. Other numbers are an error when the filter
   * runs.
   */
  vtkSetMacro(Threshold, double);
  vtkGetMacro(Threshold, double);

  /**
   * Number of spheres that are used, the largest ones, or 0, the default, for all. A larger number
   * than there are means all; negative numbers are an error when the filter runs.
   */
  vtkSetMacro(Count, vtkIdType);
  vtkGetMacro(Count, vtkIdType);

  /**
   * Weights: the used spheres, from the largest to the smallest, are divided into as many equal
   * parts as there are weights, and each part gets one. Without any, the default, all weights
   * are 1. Weights that are negative or above 1e20 are an error when the filter runs.
   */
  void SetNumberOfWeights(int number);
  int GetNumberOfWeights() const { return static_cast<int>(this->Weights.size()); }
  void SetWeight(int i, double weight);
  double GetWeight(int i) const;

  /**
   * Relative error that the field may have, from 2e-5 to 0.5, default 1e-3, or 0 for direct
   * summation, whose error is below 1e-5. Other numbers are an error when the filter runs.
   */
  vtkSetMacro(RelativeError, double);
  vtkGetMacro(RelativeError, double);

  /**
   * Whether to make `gradient` and `strongest`. Off by default.
   */
  vtkSetMacro(ComputeGradient, bool);
  vtkGetMacro(ComputeGradient, bool);
  vtkBooleanMacro(ComputeGradient, bool);
  vtkSetMacro(ComputeStrongest, bool);
  vtkGetMacro(ComputeStrongest, bool);
  vtkBooleanMacro(ComputeStrongest, bool);

  /**
   * Name of the point array with the spheres' colours, three or four unsigned chars per sphere,
   * from which `blend` is made; default none. A name without such an array is an error when the
   * filter runs.
   */
  vtkSetStdStringFromCharMacro(ColorArrayName);
  vtkGetCharFromStdStringMacro(ColorArrayName);

  /**
   * Name of the point array that holds the radii, default "radius".
   */
  vtkSetStdStringFromCharMacro(RadiusArrayName);
  vtkGetCharFromStdStringMacro(RadiusArrayName);

  /**
   * What was wrong in the last run; empty when nothing was.
   */
  const char* GetErrorMessage() const { return this->ErrorMessage.c_str(); }

protected:
  vtkMetaballField();
  ~vtkMetaballField() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMetaballField(const vtkMetaballField&) = delete;
  void operator=(const vtkMetaballField&) = delete;

  struct CachedGrid;

  spherepacking::GridRequest Request() const;
  void CheckOptions() const;
  std::string OutOfMemory() const;
  const spherepacking::GridGeometry& FindGrid(vtkPolyData* packing, vtkDataArray* radii);
  vtkUnsignedCharArray* FindColors(vtkPolyData* packing) const;

  // The field on the grid; with `colors`, one channel of which is a further weight of each sphere.
  spherepacking::FieldScene Prepare(const spherepacking::PackingCharges& charges,
    const spherepacking::GridGeometry& geometry, const unsigned char* colors, int channel,
    int components);

  struct Blocks
  {
    const spherepacking::FieldBlock* First;
    const spherepacking::FieldBlock* Last; // one past the end
  };

  // Sums blocks while the progress goes from `from` to `to`; false if it was aborted.
  bool SumBlocks(const spherepacking::FieldScene& scene, Blocks blocks, double from, double to);
  void FillOutput(const spherepacking::PackingCharges& charges,
    const spherepacking::GridGeometry& geometry, vtkUnsignedCharArray* colors,
    vtkImageData* output);
  bool Blend(const spherepacking::PackingCharges& charges,
    const spherepacking::GridGeometry& geometry, vtkUnsignedCharArray* colors, int channel,
    vtkFloatArray* field, vtkUnsignedCharArray* blend);

  std::unique_ptr<CachedGrid> Cached;
  int Kernel = INVERSE;
  int Dimensions[3] = { 64, 64, 64 };
  double Spacing[3] = { 0.0, 0.0, 0.0 };
  double ModelBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  double Threshold = 0.0;
  vtkIdType Count = 0;
  std::vector<double> Weights;
  double RelativeError = 1e-3;
  bool ComputeGradient = false;
  bool ComputeStrongest = false;
  std::string ColorArrayName;
  std::string RadiusArrayName = "radius";
  std::string ErrorMessage;
};

#endif
