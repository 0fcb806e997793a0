// SPDX-License-Identifier: BSD-3-Clause
#ifndef ImpostorBuffers_h
#define ImpostorBuffers_h

#include "impostor/PointSprites.h"
#include "impostor/ShaderPrograms.h"
#include "impostor/ViewTransform.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkTimeStamp.h"

class vtkOpenGLHelper;

namespace spherepacking
{
/// The vertex buffers of a packing's impostors.
struct ImpostorBuffers
{
  PointSprites Sprites;
  vtkIdType NumberOfSprites = 0;
  vtkIdType NumberOfQuadVertices = 0;
  bool HasIds = false;
  vtkNew<vtkOpenGLBufferObject> SpriteBuffer; ///< of SpriteVertex
  vtkNew<vtkOpenGLBufferObject> IdBuffer;   ///< four bytes per sprite, filled before one is picked
  vtkNew<vtkOpenGLBufferObject> QuadBuffer; ///< of QuadVertex
  vtkTimeStamp BufferTime;                  ///< when the set of attributes last changed

  /// `colors` may be null.
  void UploadSprites(vtkPolyData* packing, vtkDataArray* radii, vtkUnsignedCharArray* colors);
  void UploadQuads(vtkPolyData* packing, vtkDataArray* radii, vtkUnsignedCharArray* colors,
    const ViewTransform& view, double maximumPointSize);

  /// Fills the buffer of ids, unless that has been done since UploadSprites().
  void UploadIds();

  /// Adds the vertex attributes of a program for sprites or quads to its vertex array.
  void AddAttributes(vtkOpenGLHelper& helper, ProgramKind kind) const;

  void ReleaseGraphicsResources();
};
}

#endif
