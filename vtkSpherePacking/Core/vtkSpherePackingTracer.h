// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpherePackingTracer
 * @brief   pictures of a packing by casting rays, without a window
 *
 * Casts the rays of a camera at the spheres of a packing and fills a vtkImageData of the size of
 * the window, from the lower left corner:
 *
 * - `color`, four unsigned chars: the sphere's colour, lit from the camera, and its opacity as it
 *   is, without what lies behind; 0 where nothing is hit;
 * - `depth`, float: the distance of the hit from the camera along the direction of view, infinite
 *   where nothing is hit;
 * - `normal`, three floats: of length 1, out of the sphere, in world space; 0 where nothing is hit;
 * - `sphere_id`, 64-bit integer: the sphere's point in the packing, -1 where nothing is hit.
 *
 * The camera's clipping planes do not count. From inside a sphere its far side is seen. Where two
 * surfaces are equally far the lower id is seen. The structure never changes the picture, to the
 * last bit, unless the camera is more than 10^9 times as far away as the packing is large; how
 * exact the picture is says trace/RaySphere.h. Packings smaller than 10^-30 and coordinates
 * beyond 10^30 are an error.
 *
 * Spheres have the colour that the lookup table gives their scalars, or random colours of their
 * own, or are white.
 *
 * The picture is made in tiles, on all cores through vtkSMPTools. A progress event follows each
 * tile, in the thread that called Update(); an observer may call SetAbortExecute(), then no tile is
 * begun any more, and those that were not made show nothing. Field arrays: `tile_extents` (first
 * and last pixel along x, then y), `compute_seconds` of each tile, `partial_seconds` from its begin
 * until its progress has been reported, `complete_seconds` of the picture, `build_seconds` and
 * `memory_bytes` of the structure, which is built once for a packing until that changes.
 *
 * An error leaves an empty output, is reported through vtkErrorMacro and sets GetErrorCode().
 * GetErrorMessage() is the sentence.
 *
 * @sa vtkSpherePackingPathTracer, vtkSpherePackingBVH, vtkSpherePackingGrid
 */
#ifndef vtkSpherePackingTracer_h
#define vtkSpherePackingTracer_h

#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h"            // for the camera and the colours
#include "vtkSpherePackingCoreModule.h" // for the export macro

#include <functional> // for rays that are still to be checked
#include <memory>     // for std::unique_ptr
#include <string>     // for std::string

class vtkCamera;
class vtkPolyData;
class vtkScalarsToColors;

namespace spherepacking
{
class PreparedScene;
struct CameraView;
struct Ray;
}

class VTKSPHEREPACKINGCORE_EXPORT vtkSpherePackingTracer : public vtkImageAlgorithm
{
public:
  static vtkSpherePackingTracer* New();
  vtkTypeMacro(vtkSpherePackingTracer, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The camera, null by default, which is an error when the filter runs; so is one that has no
   * direction of view.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();

  /**
   * Width and height of the picture in pixels, from 1 on, default 300 x 300. Other sizes are an
   * error when the filter runs.
   */
  vtkSetVector2Macro(WindowSize, int);
  vtkGetVector2Macro(WindowSize, int);

  enum StructureType
  {
    NONE,
    GRID,
    BVH
  };

  /**
   * How rays find spheres: all are tested (NONE), those along the ray in a uniform grid (GRID), or
   * in a bounding volume hierarchy (BVH, the default). Other numbers become the nearest of these.
   */
  vtkSetClampMacro(Structure, int, NONE, BVH);
  vtkGetMacro(Structure, int);

  /**
   * How often the grid cuts each axis, 0 or more, or -1, the default, for twice as many cells as
   * spheres, fewer when spheres overlap so much that cells hold dozens. Other numbers, and more
   * cells than fit in half of the memory with their spheres, are an error when the filter runs.
   */
  vtkSetMacro(Cuts, int);
  vtkGetMacro(Cuts, int);

  /**
   * n for n x n rays per pixel, whose colours are averaged; from 1, the default, to 16. Other
   * numbers become the nearest of these. Everything but the colour is of the ray through the
   * middle.
   */
  vtkSetClampMacro(Samples, int, 1, 16);
  vtkGetMacro(Samples, int);

  /**
   * Width and height of the tiles in pixels, from 1 on, default 64 x 64. Other sizes are an error
   * when the filter runs.
   */
  vtkSetVector2Macro(TileSize, int);
  vtkGetVector2Macro(TileSize, int);

  /**
   * Name of the point array that holds the radii, default "radius".
   */
  vtkSetStdStringFromCharMacro(RadiusArrayName);
  vtkGetCharFromStdStringMacro(RadiusArrayName);

  /**
   * Name of the point array that holds the scalars to colour by, empty by default: no scalars. A
   * name of no array is an error when the filter runs.
   */
  vtkSetStdStringFromCharMacro(ColorArrayName);
  vtkGetCharFromStdStringMacro(ColorArrayName);

  /**
   * What turns the scalars into colours; by default a grey ramp over their range.
   */
  void SetLookupTable(vtkScalarsToColors* table);
  vtkScalarsToColors* GetLookupTable();

  /**
   * Red, green and blue of all spheres when there are no scalars, from 0 to 1, default white. Other
   * numbers become the nearest of these.
   */
  vtkSetVector3Macro(Color, double);
  vtkGetVector3Macro(Color, double);

  /**
   * One random colour per sphere, the same at every run, instead of scalars. Off by default.
   */
  vtkSetMacro(RandomColors, bool);
  vtkGetMacro(RandomColors, bool);
  vtkBooleanMacro(RandomColors, bool);

  /**
   * Casts one ray at the packing, the points `origin` + t `direction` for t > 0. Returns the id of
   * the sphere that is hit first, and t and the normal there, or -1.
   */
  vtkIdType CastRay(const double origin[3], const double direction[3], double& t, double normal[3]);

  /**
   * The same with the ray of the camera through a point of the picture, in pixels from the lower
   * left corner; (0.5, 0.5) is the middle of the first pixel. t is the depth.
   */
  vtkIdType CastPixel(double x, double y, double& t, double normal[3]);

  /**
   * Centre and radius of the sphere that the last cast hit.
   */
  vtkGetVector4Macro(CastSphere, double);

  /**
   * Looks at up to 64 spheres all over the packing of the last run or cast, and notifies VTK of a
   * change of their arrays if any of them has changed. Otherwise the filter goes by what VTK has
   * been notified of: writing into an array without Modified() leaves the picture as it was, as a
   * whole.
   */
  void NoticeChanges();

  /**
   * What was wrong in the last run or cast; empty when nothing was.
   */
  const char* GetErrorMessage() const { return this->ErrorMessage.c_str(); }

  /**
   * Also that of the camera and the lookup table.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkSpherePackingTracer();
  ~vtkSpherePackingTracer() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /**
   * Throws a std::invalid_argument that names the first setting that makes no picture.
   */
  virtual void Check() const;

  /**
   * Bytes of the output's arrays.
   */
  virtual double BytesPerPixel() const { return 28.0; }

  /**
   * Makes the picture, when all that it takes is there and has been checked.
   */
  virtual void Trace(vtkImageData* output);

  /**
   * The rays of the camera; a std::invalid_argument for one that sees nothing.
   */
  spherepacking::CameraView FindView() const;

  std::unique_ptr<spherepacking::PreparedScene> Prepared;

private:
  vtkSpherePackingTracer(const vtkSpherePackingTracer&) = delete;
  void operator=(const vtkSpherePackingTracer&) = delete;
  void Prepare(vtkPolyData* packing);
  void UpdateColors(vtkPolyData* packing);
  vtkIdType Cast(const std::function<spherepacking::Ray()>& makeRay, double& t, double normal[3]);

  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkScalarsToColors> LookupTable;
  int WindowSize[2] = { 300, 300 };
  int TileSize[2] = { 64, 64 };
  int Structure = BVH;
  int Cuts = -1;
  int Samples = 1;
  double Color[3] = { 1.0, 1.0, 1.0 };
  bool RandomColors = false;
  std::string RadiusArrayName = "radius";
  std::string ColorArrayName;
  std::string ErrorMessage;
  double CastSphere[4] = {};
};

#endif
