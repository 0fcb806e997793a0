// SPDX-License-Identifier: BSD-3-Clause
#ifndef TiledSupersampling_h
#define TiledSupersampling_h

class vtkOpenGLRenderWindow;
class vtkRenderPass;

namespace spherepacking
{
/// Makes VTK's supersampling fit for tiles, whose edges are within the picture; no other pass.
///
/// Upstream: VTK 9.7: vtkSSAAPass averages across the edges of its textures, which repeat, so that
/// at an edge shows what is at the opposite one. And it stretches what it draws by a pixel:
/// vtkTextureObject::CopyToFrameBuffer() reads from the middle of the first texel to the middle of
/// the last one, but draws from edge to edge.
class TiledSupersampling
{
public:
  /// Stops the textures from repeating. It stays so, since it is better for whole pictures, too.
  static void StopRepeating(vtkRenderPass* pass, vtkOpenGLRenderWindow* window);

  /// Stops the stretching, once the pass has drawn for the first time.
  static void StopStretching(vtkRenderPass* pass, vtkOpenGLRenderWindow* window);

  /// Lets the pass stretch again, as in pictures before.
  static void StretchAgain(vtkRenderPass* pass);
};
}

#endif
