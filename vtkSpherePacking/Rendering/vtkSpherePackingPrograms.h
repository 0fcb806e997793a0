// SPDX-License-Identifier: BSD-3-Clause
// Sources, uniforms and attributes that the mapper's programs share. Private to the module.
#ifndef vtkSpherePackingPrograms_h
#define vtkSpherePackingPrograms_h

#include "vtkABINamespace.h"
#include "vtkSpherePackingView.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLBufferObject;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;

// What a program for spheres is compiled for.
struct vtkSpherePackingFeatures
{
  bool Quads = false; // else points
  bool Parallel = false;
  bool Colors = false;   // one a sphere
  bool MayBeCut = false; // by the near or far plane or a clipping plane, or for want of a side
  int ClippingPlanes = 0;

  bool operator==(const vtkSpherePackingFeatures& other) const;
  bool operator!=(const vtkSpherePackingFeatures& other) const { return !(*this == other); }
};

// To put behind //VTK::System::Dec: REAL and its vectors are double precision where there is any.
extern const char* const vtkSpherePackingRealTypes;

// The fragment shader's declarations for a hit.
std::string vtkSpherePackingHitDeclarations(const vtkSpherePackingFeatures& features);

// Passes a sphere's colour on in place of //VTK::Color::Dec and //VTK::Color::Impl: as
// vec4 sphereColorVSOutput, or packed in bytes as uint packedColorVSOutput.
std::string vtkSpherePackingWithColors(std::string vertexShader, bool packed);

// Uniforms of a vertex shader for points.
void vtkSpherePackingSetPointUniforms(
  vtkShaderProgram* program, const vtkSpherePackingView& view, float maximumPointSize);

// Uniforms of every fragment shader.
void vtkSpherePackingSetRayUniforms(vtkShaderProgram* program, const vtkSpherePackingView& view);

// Attributes of points, made of vtkSpherePackingVertex; `ids` has four bytes a vertex.
void vtkSpherePackingAddPointAttributes(vtkOpenGLVertexArrayObject* vao, vtkShaderProgram* program,
  vtkOpenGLBufferObject* vertices, vtkOpenGLBufferObject* ids);

// Attributes of quads, made of vtkSpherePackingQuadVertex.
void vtkSpherePackingAddQuadAttributes(
  vtkOpenGLVertexArrayObject* vao, vtkShaderProgram* program, vtkOpenGLBufferObject* quads);
VTK_ABI_NAMESPACE_END

#endif
