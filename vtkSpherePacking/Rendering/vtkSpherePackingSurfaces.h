// SPDX-License-Identifier: BSD-3-Clause
// The surfaces seen through each pixel, found before anything is lit. Private to the module.
//
// Many spheres of a packing are hidden by others, and hidden fragments cannot be told in time since
// each writes its own depth. So only normal, depth and colour are written per fragment, with one
// sample a pixel; the lights follow once a pixel. (Saito and Takahashi, "Comprehensible Rendering
// of 3-D Shapes", 1990.)
#ifndef vtkSpherePackingSurfaces_h
#define vtkSpherePackingSurfaces_h

#include "vtkABINamespace.h"
#include "vtkNew.h"
#include "vtkOpenGLHelper.h"
#include "vtkSpherePackingPrograms.h"
#include "vtkTimeStamp.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLBufferObject;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

class vtkSpherePackingSurfaces
{
public:
  struct Scene
  {
    vtkSpherePackingView View;         // with its viewport's corner at 0, 0
    vtkSpherePackingFeatures Features; // Quads is set here
    std::vector<std::array<float, 4>> ClippingPlanes;
    float MaximumPointSize;
    vtkOpenGLBufferObject* Vertices;
    int NumberOfVertices;
    vtkOpenGLBufferObject* Quads;
    int NumberOfQuadVertices;
    vtkMTimeType BufferTime; // when a buffer was last made anew
  };

  // Fills a texture of the size of the view's viewport.
  void Draw(vtkOpenGLRenderWindow* window, Scene scene);

  // Puts the texture into a unit and tells the program which; Deactivate() after drawing.
  void Activate(vtkShaderProgram* program);
  void Deactivate();

  void ReleaseGraphicsResources(vtkWindow* window);

  vtkSpherePackingSurfaces();
  ~vtkSpherePackingSurfaces();

private:
  // A program for points or quads and what it was made for.
  struct Stage
  {
    vtkOpenGLHelper Helper;
    vtkSpherePackingFeatures Features;
  };

  void Prepare(vtkOpenGLRenderWindow* window, const Scene& scene);
  void DrawStage(vtkOpenGLRenderWindow* window, const Scene& scene, Stage& stage);

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Surfaces;
  vtkNew<vtkTextureObject> Depths;
  Stage Points;
  Stage Quads;
};
VTK_ABI_NAMESPACE_END

#endif
