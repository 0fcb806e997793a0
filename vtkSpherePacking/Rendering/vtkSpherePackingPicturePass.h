// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpherePackingPicturePass
 * @brief   draws a ray-cast picture into a scene, at the depths of what it shows
 *
 * The picture is one that a vtkSpherePackingTracer or a vtkSpherePackingPathTracer made with the
 * renderer's camera. It covers the viewport, is depth-tested and writes depths, so its spheres hide
 * what is behind them and are hidden by what is in front. The pass belongs to the opaque step of a
 * vtkRenderStepsPass: translucent geometry and overlays come after it. Where the alpha of the
 * picture is below 255, what was drawn before shows through.
 *
 * @sa vtkSpherePackingPathTracer, vtkOpenGLSpherePackingMapper
 */
#ifndef vtkSpherePackingPicturePass_h
#define vtkSpherePackingPicturePass_h

#include "vtkNew.h" // for the textures
#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"                 // for the picture
#include "vtkSpherePackingRenderingModule.h" // for the export macro

#include <memory> // for std::unique_ptr

class vtkImageData;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkTextureObject;

class VTKSPHEREPACKINGRENDERING_EXPORT vtkSpherePackingPicturePass : public vtkRenderPass
{
public:
  static vtkSpherePackingPicturePass* New();
  vtkTypeMacro(vtkSpherePackingPicturePass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The picture, null by default. It has the point arrays `color` (RGBA, unsigned char) and `depth`
   * (float); without them it is not drawn. Its size should be that of the viewport in pixels.
   */
  void SetPicture(vtkImageData* picture);
  vtkImageData* GetPicture();

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkSpherePackingPicturePass();
  ~vtkSpherePackingPicturePass() override;

private:
  vtkSpherePackingPicturePass(const vtkSpherePackingPicturePass&) = delete;
  void operator=(const vtkSpherePackingPicturePass&) = delete;

  bool Upload(vtkOpenGLRenderWindow* window);
  bool UseProgram(vtkOpenGLRenderWindow* window);
  void SetUniforms(vtkRenderer* renderer, vtkOpenGLRenderWindow* window);

  vtkSmartPointer<vtkImageData> Picture;
  vtkNew<vtkTextureObject> Colors;
  vtkNew<vtkTextureObject> Depths;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  vtkTimeStamp UploadTime;
};

#endif
