// SPDX-License-Identifier: BSD-3-Clause
#include "impostor/ImpostorBuffers.h"

#include "impostor/ImpostorQuads.h"

#include "vtkOpenGLHelper.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"

#include <cstddef>

namespace spherepacking
{
namespace
{
// Adds the attributes of one interleaved buffer that the program uses.
struct AttributeAdder
{
  vtkOpenGLVertexArrayObject* Vao;
  vtkShaderProgram* Program;
  vtkOpenGLBufferObject* Buffer;
  std::size_t Stride;

  void Floats(const char* name, std::size_t offset, int components) const
  {
    this->Add(name, offset, VTK_FLOAT, components, false);
  }
  void Bytes(const char* name, std::size_t offset, bool normalize) const
  {
    this->Add(name, offset, VTK_UNSIGNED_CHAR, 4, normalize);
  }

private:
  void Add(const char* name, std::size_t offset, int type, int components, bool normalize) const
  {
    if (this->Program->IsAttributeUsed(name))
    {
      this->Vao->AddAttributeArray(this->Program, this->Buffer, name, static_cast<int>(offset),
        this->Stride, type, components, normalize);
    }
  }
};
}

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
void ImpostorBuffers::AddAttributes(vtkOpenGLHelper& helper, ProgramKind kind) const
{
  vtkOpenGLVertexArrayObject* vao = helper.VAO;
  vtkShaderProgram* program = helper.Program;
  vao->Bind();
  if (kind == ProgramKind::Quads)
  {
    using V = QuadVertex;
    const AttributeAdder add{ vao, program, this->QuadBuffer, sizeof(V) };
    add.Floats("corner", offsetof(V, Corner), 3);
    add.Floats("sphereReference", offsetof(V, Reference), 4);
    add.Floats("sphereReferenceLow", offsetof(V, ReferenceLow), 2);
    add.Floats("sphereShape", offsetof(V, Shape), 4);
    add.Floats("sphereShapeLow", offsetof(V, ShapeLow), 4);
    add.Floats("eyePower", offsetof(V, EyePower), 2);
    add.Bytes("sphereColor", offsetof(V, Color), true);
    add.Bytes("sphereId", offsetof(V, Id), false);
    return;
  }
  using V = SpriteVertex;
  const AttributeAdder add{ vao, program, this->SpriteBuffer, sizeof(V) };
  add.Floats("centerHigh", offsetof(V, CenterHigh), 3);
  add.Floats("centerLow", offsetof(V, CenterLow), 3);
  add.Floats("radius", offsetof(V, Radius), 1);
  add.Bytes("sphereColor", offsetof(V, Color), true);
  AttributeAdder{ vao, program, this->IdBuffer, 4 }.Bytes("sphereId", 0, false);
}

//------------------------------------------------------------------------------
void ImpostorBuffers::ReleaseGraphicsResources()
{
  this->SpriteBuffer->ReleaseGraphicsResources();
  this->IdBuffer->ReleaseGraphicsResources();
  this->QuadBuffer->ReleaseGraphicsResources();
}
}
