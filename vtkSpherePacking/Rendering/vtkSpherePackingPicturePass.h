// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpherePackingPicturePass
 * @brief   a picture in a scene, at the depths of what it shows
 *
 * Draws a picture that a vtkSpherePackingTracer or a vtkSpherePackingPathTracer made of the
 * renderer's camera, over the whole viewport, so that it hides what is behind its spheres and is
 * hidden by what is before them. It is a step of the opaque part of a vtkRenderStepsPass: what is
 * transparent, and overlays, come after it. Where the picture's opacity is below 255 what was drawn
 * before shows through.
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
   * The picture, with the point arrays `color` (four unsigned chars) and `depth` (float), none by
   * default, for none. One without these arrays is not drawn. Its size should be that of the
   * viewport in pixels.
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

  vtkSmartPointer<vtkImageData> Picture;
  vtkNew<vtkTextureObject> Colors;
  vtkNew<vtkTextureObject> Depths;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  vtkTimeStamp UploadTime;
};

#endif
