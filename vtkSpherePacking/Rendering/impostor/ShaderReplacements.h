// SPDX-License-Identifier: BSD-3-Clause
/// What replaces the tags (//VTK::...) in the shader templates of vtkOpenGLPolyDataMapper, so that
/// its fragment shader lights, peels and picks the spheres that the impostors' shaders find.
#ifndef ShaderReplacements_h
#define ShaderReplacements_h

#include "impostor/ShaderPrograms.h"

#include "vtkShader.h"

#include <map>

namespace spherepacking
{
using ShaderMap = std::map<vtkShader::Type, vtkShader*>;

/// Replaces the vertex shader as a whole.
void ReplaceVertexShader(const ShaderMap& shaders, ProgramKind kind, bool colors);

/// Finds the hit, or reads it from the G-buffer, as vertexVC and gl_FragDepth.
void ReplacePosition(const ShaderMap& shaders, const ShaderVariant& variant, ProgramKind kind);

void ReplaceNormal(const ShaderMap& shaders, ProgramKind kind);

/// Takes a sphere's own colour instead of the material's.
void ReplaceColor(const ShaderMap& shaders, ProgramKind kind);

/// Changes the code of VTK's lights, which has to be there already.
void AdaptLights(const ShaderMap& shaders, bool specular);

/// Writes the sphere's id in passes of vtkHardwareSelector for ids of points or cells. Returns
/// whether the pass is one of these.
bool ReplacePicking(const ShaderMap& shaders, int selectionPass);
}

#endif
