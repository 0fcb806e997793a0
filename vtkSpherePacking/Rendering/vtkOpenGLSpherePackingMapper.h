// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLSpherePackingMapper
 * @brief   draws a packing as exact spheres: ray-cast impostors
 *
 * The input's points are the centres, a point array of one component holds the radii. Nothing is
 * tessellated: the vertex shader bounds each sphere's outline, which is an ellipse in a perspective
 * view, and the fragment shader intersects the ray through the pixel's centre with the sphere and
 * writes the colour, normal and depth of the hit. Spheres that the near plane or a clipping plane
 * cuts show their inside, and so do all spheres around the camera.
 *
 * All of vtkOpenGLPolyDataMapper's means of colouring points, its lights, properties, opacity,
 * render passes (shadow maps among them) and clipping planes apply. A parallel view that is
 * sheared, as by stereo, is an error. Several samples per pixel smooth no silhouette, which is
 * exact at the pixel's centre. A sphere has one colour, so InterpolateScalarsBeforeMapping is
 * always off. Cells are ignored; representation, edges and textures have no meaning for spheres,
 * and where one is cut its opaque inside is seen whatever the culling, in the colours of its
 * outside. A vtkHardwareSelector that looks for points finds point ids; one that looks for cells
 * finds the same ids, which are those of the cells where the input has one vertex cell per point in
 * order.
 *
 * The actor's matrix may rotate, translate and scale uniformly. With any other matrix, or with
 * radii that vtkSpherePackingInput refuses, an error is reported and nothing is drawn.
 *
 * @par Precision
 * Centres are transformed to window and depth coordinates in double precision (on the GPU where it
 * has GL_ARB_gpu_shader_fp64), and everything after that is relative to the sphere, so that
 * coordinates of 1e7 with radii of 1e-3 show no jitter.
 *
 * @par Deferred shading and culling
 * Opaque spheres of a large packing, or in a window with several samples per pixel or several
 * lights, are drawn into a G-buffer and lit once per pixel. They are drawn roughly front to back,
 * and those behind what has been drawn are culled in the vertex shader.
 *
 * @par Source
 * C. Sigg, T. Weyrich, M. Botsch, M. Gross, "GPU-Based Ray-Casting of Quadratic Surfaces", 2006;
 * E. Haines, J. Guenther, T. Akenine-Moller, "Precision Improvements for Ray/Sphere
 * Intersection", Ray Tracing Gems, chapter 7, 2019; T. Saito, T. Takahashi, "Comprehensible
 * Rendering of 3-D Shapes", 1990; S. Grottel, G. Reina, C. Dachsbacher, T. Ertl, "Coherent Culling
 * and Shading for Large Molecular Dynamics Visualization", 2010.
 *
 * @sa vtkSpherePackingInput, vtkSpherePackingReader
 */
#ifndef vtkOpenGLSpherePackingMapper_h
#define vtkOpenGLSpherePackingMapper_h

#include "vtkOpenGLPolyDataMapper.h"
#include "vtkSpherePackingRenderingModule.h" // for the export macro

#include <memory> // for the private state

class VTKSPHEREPACKINGRENDERING_EXPORT vtkOpenGLSpherePackingMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkOpenGLSpherePackingMapper* New();
  vtkTypeMacro(vtkOpenGLSpherePackingMapper, vtkOpenGLPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The name of the point array that holds the radii, in the space of the points: any numeric
   * type, one component, finite and not negative. A radius of 0 is legal and draws nothing.
   * Default "radius". A name that the input does not have is an error when drawing.
   */
  vtkSetStringMacro(RadiusArrayName);
  vtkGetStringMacro(RadiusArrayName);
  ///@}

  /**
   * Always off: a sphere has one colour.
   */
  void SetInterpolateScalarsBeforeMapping(vtkTypeBool) override {}

  ///@{
  /**
   * Whether the spheres are drawn, on by default. When off they still count for the scene's bounds
   * and are found by selection: for when something else shows them.
   */
  void SetDrawn(bool drawn) { this->Drawn = drawn; }
  bool GetDrawn() const { return this->Drawn; }
  ///@}

  /**
   * The error that prevented the last drawing, or empty.
   */
  const char* GetErrorMessage() const;

  void RenderPiece(vtkRenderer* ren, vtkActor* act) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void ShallowCopy(vtkAbstractMapper* mapper) override;
  void ProcessSelectorPixelBuffers(
    vtkHardwareSelector* selector, std::vector<unsigned int>& offsets, vtkProp* prop) override;

protected:
  vtkOpenGLSpherePackingMapper();
  ~vtkOpenGLSpherePackingMapper() override;

  void ComputeBounds() override;

  void RenderPieceStart(vtkRenderer* ren, vtkActor* act) override;
  void RenderPieceDraw(vtkRenderer* ren, vtkActor* act) override;
  void BuildBufferObjects(vtkRenderer* ren, vtkActor* act) override;

  bool GetNeedToRebuildShaders(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act) override;
  void GetShaderTemplate(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderPositionVC(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderNormal(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderLight(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderEdges(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderClip(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderPicking(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderCoincidentOffset(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act) override;
  void SetMapperShaderParameters(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act) override;
  void SetCameraShaderParameters(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act) override;
  void UpdateMaximumPointCellIds(vtkRenderer* ren, vtkActor* act) override;

  char* RadiusArrayName = nullptr;

private:
  vtkOpenGLSpherePackingMapper(const vtkOpenGLSpherePackingMapper&) = delete;
  void operator=(const vtkOpenGLSpherePackingMapper&) = delete;

  bool PrepareInput();

  /**
   * Runs `work`; that memory is lacking becomes the error message.
   */
  template <typename Work>
  void RunGuarded(const Work& work);
  void Fail(const std::string& message);
  void DrawForward(vtkRenderer* ren, vtkActor* act);
  void DrawDeferred(vtkRenderer* ren, vtkActor* act);

  bool Drawn = true;
  struct Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
