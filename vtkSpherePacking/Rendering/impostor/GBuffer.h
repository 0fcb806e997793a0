// SPDX-License-Identifier: BSD-3-Clause
/// G-buffer for deferred shading: the geometry pass writes depth, normal and colour of what each
/// pixel shows, and the lights follow once per pixel (T. Saito, T. Takahashi, "Comprehensible
/// Rendering of 3-D Shapes", 1990).
///
/// Most fragments of a packing are hidden by others, and early depth tests find few of them, since
/// each fragment writes a depth of its own. So hidden ones should cost little. There is one sample
/// per pixel, however many the window has: the silhouettes of spheres use no more.
#ifndef GBuffer_h
#define GBuffer_h

#include "impostor/DrawOrder.h"
#include "impostor/HiZBuffer.h"
#include "impostor/ImpostorBuffers.h"
#include "impostor/ShaderPrograms.h"

#include "vtkNew.h"
#include "vtkOpenGLHelper.h"

#include <array>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace spherepacking
{
class GBuffer
{
public:
  /// What is drawn in one frame.
  struct FrameData
  {
    ViewTransform View; ///< with the viewport's corner at 0, 0
    ShaderVariant Variant;
    std::vector<std::array<float, 4>> ClippingPlanes;
    const ImpostorBuffers* Buffers;
    std::vector<DrawRanges> Batches; ///< of sprites, roughly front to back
    float MaximumPointSize;
    int HiZTileSize;
  };

  GBuffer();
  ~GBuffer();

  /// The geometry pass. The G-buffer becomes as large as the view's viewport.
  void Draw(vtkOpenGLRenderWindow* window, const FrameData& frame);

  /// Binds the texture for the program of the lighting pass; Deactivate() after drawing.
  void Activate(vtkShaderProgram* program);
  void Deactivate();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// A program of the geometry pass, and what it was compiled for.
  struct GeometryProgram
  {
    ProgramKind Kind;
    vtkOpenGLHelper Helper;
    ShaderVariant Variant;
  };

  void PrepareFramebuffer(vtkOpenGLRenderWindow* window, const ViewTransform& view);
  bool UseProgram(vtkOpenGLRenderWindow* window, const FrameData& frame, GeometryProgram& program);
  void DrawQuads(vtkOpenGLRenderWindow* window, const FrameData& frame);
  void DrawSprites(vtkOpenGLRenderWindow* window, const FrameData& frame, std::size_t batch);

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Texels; ///< as in GBufferFS.glsl
  vtkNew<vtkTextureObject> Depths; ///< the depth buffer
  HiZBuffer HiZ;
  GeometryProgram Sprites{ ProgramKind::PointSprites, {}, {} };
  GeometryProgram Quads{ ProgramKind::Quads, {}, {} };
};
}

#endif
