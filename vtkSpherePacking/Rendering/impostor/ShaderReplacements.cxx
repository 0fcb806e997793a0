// SPDX-License-Identifier: BSD-3-Clause
#include "impostor/ShaderReplacements.h"

#include "vtkHardwareSelector.h"
#include "vtkShaderProgram.h"

#include "GBufferReadFS.h"

namespace spherepacking
{
namespace
{
void Substitute(
  const ShaderMap& shaders, vtkShader::Type type, const char* token, const std::string& text)
{
  std::string source = shaders.at(type)->GetSource();
  vtkShaderProgram::Substitute(source, token, text);
  shaders.at(type)->SetSource(source);
}
}

//------------------------------------------------------------------------------
void ReplaceVertexShader(const ShaderMap& shaders, ProgramKind kind, bool colors)
{
  std::string vertex = VertexShader(kind);
  if (colors && kind != ProgramKind::Lighting)
  {
    AddColors(vertex, false);
  }
  AddRealTypes(vertex);
  shaders.at(vtkShader::Vertex)->SetSource(vertex);
  shaders.at(vtkShader::Geometry)->SetSource("");
  std::string fragment = shaders.at(vtkShader::Fragment)->GetSource();
  AddRealTypes(fragment);
  shaders.at(vtkShader::Fragment)->SetSource(fragment);
}

//------------------------------------------------------------------------------
void ReplacePosition(const ShaderMap& shaders, const ShaderVariant& variant, ProgramKind kind)
{
  std::string declarations;
  const char* hit;
  const char* depth;
  if (kind == ProgramKind::Lighting)
  {
    declarations = ParallelViewDeclaration(variant.Parallel) + GBufferReadFS;
    hit = "  readGBuffer();\n"
          "  vec4 vertexVC = vec4(gBufferPosition(), 1.0);\n";
    depth = "  gl_FragDepth = gBufferDepth;\n";
  }
  else
  {
    declarations = RaySphereDeclarations(variant, kind);
    hit = "  intersectSphere();\n"
          "  vec4 vertexVC = vec4(hitPosition(), 1.0);\n"
          "  vertexVC.z -= depthRange.x;\n";
    depth = "  gl_FragDepth = max(hitDepth() - depthBias, 0.0);\n";
  }
  // Code of VTK's render passes reads this uniform.
  Substitute(shaders, vtkShader::Fragment, "//VTK::Camera::Dec", "uniform int cameraParallel;\n");
  Substitute(shaders, vtkShader::Fragment, "//VTK::PositionVC::Dec", declarations);
  Substitute(shaders, vtkShader::Fragment, "//VTK::PositionVC::Impl", hit);
  Substitute(shaders, vtkShader::Fragment, "//VTK::Depth::Impl", depth);
}

//------------------------------------------------------------------------------
void ReplaceNormal(const ShaderMap& shaders, ProgramKind kind)
{
  Substitute(shaders, vtkShader::Fragment, "//VTK::Normal::Impl",
    kind == ProgramKind::Lighting ? "  vec3 normalVCVSOutput = gBufferNormal();\n"
                                  : "  vec3 normalVCVSOutput = hitNormal();\n");
}

//------------------------------------------------------------------------------
void ReplaceColor(const ShaderMap& shaders, ProgramKind kind)
{
  const bool lighting = kind == ProgramKind::Lighting;
  const std::string color = lighting ? "gBufferColor()" : "sphereColorVSOutput";
  Substitute(shaders, vtkShader::Fragment, "//VTK::Edges::Dec",
    lighting ? "" : "flat in vec4 sphereColorVSOutput;\n");
  Substitute(shaders, vtkShader::Fragment, "//VTK::Edges::Impl",
    "  vec4 sphereColor = " + color +
      ";\n"
      "  ambientColor = ambientIntensity * sphereColor.rgb;\n"
      "  diffuseColor = diffuseIntensity * sphereColor.rgb;\n"
      "  opacity = opacityUniform * sphereColor.a;\n");
}

//------------------------------------------------------------------------------
void AdaptLights(const ShaderMap& shaders, bool specular)
{
  // Upstream: VTK 9.7: vtkShadowMapBakerPass takes the depth of a fragment from gl_FragCoord, which
  // is that of a point or quad here, not that of the hit.
  Substitute(shaders, vtkShader::Fragment, "1.0/gl_FragCoord.w", "-vertexVC.z");
  Substitute(shaders, vtkShader::Fragment, "gl_FragCoord.z", "gl_FragDepth");
  // Upstream: VTK 9.7: vtkOpenGLPolyDataMapper::ReplaceShaderLight() computes pow() for each light
  // also where the specular intensity, a uniform, is 0. As a constant 0 the compiler removes all of
  // it, which halves the time of a frame under PyVista's five lights on llvmpipe.
  if (!specular)
  {
    Substitute(shaders, vtkShader::Fragment, "uniform float specularIntensity;",
      "const float specularIntensity = 0.0;");
  }
}

//------------------------------------------------------------------------------
bool ReplacePicking(const ShaderMap& shaders, int selectionPass)
{
  const char* value = nullptr;
  switch (selectionPass)
  {
    case vtkHardwareSelector::POINT_ID_LOW24:
    case vtkHardwareSelector::CELL_ID_LOW24:
      value = "vec4(sphereIdVSOutput.xyz / 255.0, 1.0)";
      break;
    case vtkHardwareSelector::POINT_ID_HIGH24:
    case vtkHardwareSelector::CELL_ID_HIGH24:
      value = "vec4(sphereIdVSOutput.w / 255.0, 0.0, 0.0, 1.0)";
      break;
    default:
      return false;
  }
  Substitute(shaders, vtkShader::Vertex, "//VTK::Picking::Dec",
    "in vec4 sphereId;\nflat out vec4 sphereIdVSOutput;\n");
  Substitute(shaders, vtkShader::Vertex, "//VTK::Picking::Impl", "sphereIdVSOutput = sphereId;\n");
  Substitute(
    shaders, vtkShader::Fragment, "//VTK::Picking::Dec", "flat in vec4 sphereIdVSOutput;\n");
  Substitute(shaders, vtkShader::Fragment, "//VTK::Picking::Impl",
    std::string("gl_FragData[0] = ") + value + ";\n");
  return true;
}
}
