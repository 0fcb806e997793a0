// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMetaballField
 * @brief   the implicit field of a packing on a grid, within a bound on its error
 *
 * Sums over the spheres of a packing, at each point of a regular grid, a kernel of the distance d
 * to the sphere's centre. With its radius r and its weight w, that is
 *
 * - INVERSE: w r / d, the potential of a charge; below d = r / 1024 it does not grow any more;
 * - INVERSE_SQUARE: w r^2 / d^2, below d = r / 1024 likewise;
 * - GAUSSIAN: w exp(2 - 2 d^2 / r^2) (Blinn 1982);
 * - WYVILL: 2 w (1 - u)^2 (1 - 4 u / 9) with u = d^2 / (2 r)^2, 0 from d = 2 r on (Wyvill et al.
 *   1986).
 *
 * All are w on the surface of the sphere. Spheres of radius or weight 0 add nothing.
 *
 * Point arrays of the output: `field`, float; if wanted `gradient`, three floats, by world
 * coordinates; `strongest`, 64-bit integer, the id of the sphere that adds most, -1 where none
 * adds anything; and `blend`, three unsigned chars, the mean of the spheres' colours, weighted by
 * what each adds.
 *
 * The error of the field is at most RelativeError times the field; with GAUSSIAN and WYVILL 10^-6
 * times the largest weight is added to that. The sums of INVERSE and INVERSE_SQUARE go through a
 * tree of charges whose far parts are expanded (see metaballs/TruncationError.h for the proof), or,
 * if the error may be 10^-3 and neither gradient nor strongest is wanted, through meshes
 * (metaballs/GaussianSum.h), where these are small beside the spheres, and the steps of the grid
 * differ by less than two. Nothing is cut off. Where the error allows it, from 3.8e-4 on, near
 * spheres are added with the processor's own estimate of a root, which differs between makes;
 * gradients are not.
 *
 * Work is done on all cores through vtkSMPTools, in blocks of the grid. Progress events come
 * between blocks, in the thread that called Update(); an observer may call SetAbortExecute(), then
 * no block is begun any more, and those that were not made are 0. Field arrays: `build_seconds`,
 * `sum_seconds`, and `meshes`, how many the field went through, 0 if it did through the tree.
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
class FieldInput;
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
   * What a sphere adds, default INVERSE. Other numbers become the nearest of these.
   */
  vtkSetClampMacro(Kernel, int, INVERSE, WYVILL);
  vtkGetMacro(Kernel, int);

  /**
   * Points of the grid along x, y and z, from 1 on, default 64 x 64 x 64. Other numbers, and more
   * points than fit in half of the memory, are an error when the filter runs. Not used if there is
   * a spacing.
   */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);

  /**
   * Distance of the grid's points along x, y and z, in the unit of the packing, instead of their
   * number; 0 0 0, the default, for none. Others must be above 0, or it is an error when the filter
   * runs. The grid begins at the lower bounds and has one point at the upper ones or beyond.
   */
  vtkSetVector3Macro(Spacing, double);
  vtkGetVector3Macro(Spacing, double);

  /**
   * The box of the grid: x min, x max, y min, ... By default, when x min is above x max, it is
   * found when the filter runs: with a threshold so that the surface there closes inside, else a
   * tenth of the longest side of the packing's bounds around these. Bounds of which others are the
   * wrong way round, or that are not finite, are an error when the filter runs.
   */
  vtkSetVector6Macro(ModelBounds, double);
  vtkGetVector6Macro(ModelBounds, double);

  /**
   * The value of the surface that is to close inside the grid, above 0, or 0, the default, for
   * none. It has no effect if there are bounds. Other numbers are an error when the filter runs.
   */
  vtkSetMacro(Threshold, double);
  vtkGetMacro(Threshold, double);

  /**
   * How many of the largest spheres are used, or 0, the default, for all. More than there are are
   * all of them; negative numbers are an error when the filter runs.
   */
  vtkSetMacro(Count, vtkIdType);
  vtkGetMacro(Count, vtkIdType);

  /**
   * Weights, each for an equal share of the used spheres from the largest to the smallest; none,
   * the default, is a weight of 1 for all. Negative weights and those that are not finite are an
   * error when the filter runs.
   */
  void SetNumberOfWeights(int number);
  int GetNumberOfWeights() const { return static_cast<int>(this->Weights.size()); }
  void SetWeight(int i, double weight);
  double GetWeight(int i) const;

  /**
   * Relative error that the field may have, from 2e-5 to 0.5, default 1e-3, or 0 for sums charge by
   * charge, whose error is below 1e-5. Other numbers are an error when the filter runs.
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
   * Name of the point array with the spheres' colours, three or four unsigned chars, to make
   * `blend` of; default none. Another array, or none, of that name is an error when the filter
   * runs.
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

  struct PlacedGrid;

  spherepacking::GridRequest Request() const;
  void Check() const;
  std::string OutOfMemory() const;
  const spherepacking::GridGeometry& FindGrid(vtkPolyData* packing, vtkDataArray* radii);
  vtkUnsignedCharArray* FindColors(vtkPolyData* packing) const;

  // The spheres, with one channel of their colours as a further weight if there are any.
  spherepacking::FieldScene Prepare(const spherepacking::FieldInput& input,
    const spherepacking::GridGeometry& geometry, const unsigned char* colors, int channel,
    int components);

  struct Blocks
  {
    const spherepacking::FieldBlock* First;
    const spherepacking::FieldBlock* Last; // one past
  };

  // Whether all blocks were made.
  bool Run(const spherepacking::FieldScene& scene, Blocks blocks, double from, double to);
  void Make(const spherepacking::FieldInput& input, const spherepacking::GridGeometry& geometry,
    vtkUnsignedCharArray* colors, vtkImageData* output);
  bool Blend(const spherepacking::FieldInput& input, const spherepacking::GridGeometry& geometry,
    vtkUnsignedCharArray* colors, int channel, vtkFloatArray* field, vtkUnsignedCharArray* blend);

  std::unique_ptr<PlacedGrid> Placed;
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
