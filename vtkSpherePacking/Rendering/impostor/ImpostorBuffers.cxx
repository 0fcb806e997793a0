// SPDX-License-Identifier: BSD-3-Clause
#include "impostor/ImpostorBuffers.h"

#include "impostor/ImpostorQuads.h"

namespace spherepacking
{
//------------------------------------------------------------------------------
void ImpostorBuffers::UploadSprites(
  vtkPolyData* packing, vtkDataArray* radii, vtkUnsignedCharArray* colors)
{
  const std::vector<SpriteVertex> vertices = this->Sprites.Build(packing, radii, colors);
  this->NumberOfSprites = static_cast<vtkIdType>(vertices.size());
  this->SpriteBuffer->Upload(vertices, vtkOpenGLBufferObject::ArrayBuffer);
  this->HasIds = false;
  this->BufferTime.Modified();
}

//------------------------------------------------------------------------------
void ImpostorBuffers::UploadQuads(vtkPolyData* packing, vtkDataArray* radii,
  vtkUnsignedCharArray* colors, const ViewTransform& view, double maximumPointSize)
{
  const std::vector<QuadVertex> quads =
    MakeImpostorQuads(packing, radii, colors, this->Sprites, view, maximumPointSize);
  this->NumberOfQuadVertices = static_cast<vtkIdType>(quads.size());
  if (!quads.empty())
  {
    this->QuadBuffer->Upload(quads, vtkOpenGLBufferObject::ArrayBuffer);
  }
}

//------------------------------------------------------------------------------
void ImpostorBuffers::UploadIds()
{
  if (this->HasIds)
  {
    return;
  }
  const std::vector<vtkIdType>& ids = this->Sprites.GetPointIds();
  std::vector<unsigned char> bytes(4 * ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    PackId(&bytes[4 * i], ids[i]);
  }
  this->IdBuffer->Upload(bytes, vtkOpenGLBufferObject::ArrayBuffer);
  this->HasIds = true;
  this->BufferTime.Modified();
}

//------------------------------------------------------------------------------
void ImpostorBuffers::ReleaseGraphicsResources()
{
  this->SpriteBuffer->ReleaseGraphicsResources();
  this->IdBuffer->ReleaseGraphicsResources();
  this->QuadBuffer->ReleaseGraphicsResources();
}
}
