// SPDX-License-Identifier: BSD-3-Clause
/// The shader programs of impostors: their sources and uniforms.
#ifndef ShaderPrograms_h
#define ShaderPrograms_h

#include "impostor/ViewTransform.h"

#include <string>

class vtkShaderProgram;

namespace spherepacking
{
enum class ProgramKind
{
  PointSprites, ///< a ray/sphere test in each fragment of a point
  Quads,        ///< the same in double precision, in each fragment of an impostor quad
  Lighting      ///< deferred shading: lights what is in the G-buffer
};

/// What a program is compiled for besides its kind: the options of a shader variant.
struct ShaderVariant
{
  bool Parallel = false; ///< parallel projection
  bool Colors = false;   ///< per sphere
  /// Whether the near hit may not be what is seen: the near or far plane or a clipping plane may
  /// cut it off, or only the other one is drawn.
  bool MayBeCut = false;
  int ClippingPlanes = 0;

  bool operator==(const ShaderVariant& other) const;
  bool operator!=(const ShaderVariant& other) const { return !(*this == other); }
};

/// The source of a vertex shader. AddColors() has to follow if spheres have colours.
const char* VertexShader(ProgramKind kind);

/// Defines REAL and its vectors in place of //VTK::System::Dec, which stays for VTK to replace:
/// double precision where there is any, else float.
void AddRealTypes(std::string& source);

/// Passes a sphere's colour on, in place of //VTK::Color::Dec and //VTK::Color::Impl: as
/// vec4 sphereColorVSOutput or, packed, as the RGBA bytes of uint packedColorVSOutput.
void AddColors(std::string& vertexShader, bool packed);

/// RaySphereFS.glsl with the definitions that it needs, for point sprites or quads.
std::string RaySphereDeclarations(const ShaderVariant& variant, ProgramKind kind);

/// Declares the constant parallelView of the fragment shaders.
std::string ParallelViewDeclaration(bool parallel);

/// Sets the uniforms of PointSpriteVS.glsl, but for those of the Hi-Z buffer.
void SetSpriteUniforms(
  vtkShaderProgram* program, const ViewTransform& view, float maximumPointSize);

/// Sets the uniforms that all fragment shaders share.
void SetRayUniforms(vtkShaderProgram* program, const ViewTransform& view);
}

#endif
