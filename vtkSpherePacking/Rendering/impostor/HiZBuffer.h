// SPDX-License-Identifier: BSD-3-Clause
/// Hi-Z buffer: a coarse depth buffer that holds the farthest depth of each tile of pixels. What
/// lies behind that in all tiles that it covers is occluded, and is culled as a whole, by the
/// vertex shader, before it is rasterized.
///
/// This is one level of the pyramid of N. Greene, M. Kass, G. Miller, "Hierarchical Z-Buffer
/// Visibility" (1993). One is enough where spheres are of similar size: on tiles as large as a
/// sphere is, it covers at most 2 x 2 of them. Culling each sphere at its vertex by maximum depths
/// is from S. Grottel, G. Reina, C. Dachsbacher, T. Ertl, "Coherent Culling and Shading for Large
/// Molecular Dynamics Visualization" (2010).
#ifndef HiZBuffer_h
#define HiZBuffer_h

#include "impostor/ViewTransform.h"

#include "vtkNew.h"
#include "vtkOpenGLHelper.h"

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace spherepacking
{
/// Chooses the pixels along a side of a tile: about as many as a sphere of that radius has in the
/// middle of a box in data coordinates, a power of two from 4 to 32.
int HiZTileSize(const ViewTransform& view, const double bounds[6],
  const std::array<double, 3>& origin, double radius);

class HiZBuffer
{
public:
  HiZBuffer();
  ~HiZBuffer();

  /// Reduces the depths in a texture.
  void Update(vtkOpenGLRenderWindow* window, vtkTextureObject* depths, int tileSize);

  /// Binds the texture for a program that culls; Deactivate() after drawing.
  void Activate(vtkShaderProgram* program);
  void Deactivate();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> FarthestDepths;
  vtkOpenGLHelper Reduction;
};
}

#endif
