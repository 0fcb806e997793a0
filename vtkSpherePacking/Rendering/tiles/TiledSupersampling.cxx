// SPDX-License-Identifier: BSD-3-Clause
#include "tiles/TiledSupersampling.h"

#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkSSAAPass.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <string>

namespace spherepacking
{
namespace
{
// The pass draws rows first, columns second; only the latter go through CopyToFrameBuffer().
const std::string NotStretched = R"(
vec2 notStretched(vec2 at)
{
  vec2 texels = vec2(textureSize(source, 0));
  return texelWidthOffset == 0.0 ? (at - 0.5) * texels / max(texels - 1.0, 1.0) + 0.5 : at;
}
#define tcoordVC notStretched(tcoordVC)
)";

// Reaches the protected members of another pass.
struct Members : vtkSSAAPass
{
  static vtkSmartPointer<vtkTextureObject>& FirstOf(vtkSSAAPass* pass)
  {
    return pass->*(&Members::Pass1);
  }
  static vtkSmartPointer<vtkTextureObject>& SecondOf(vtkSSAAPass* pass)
  {
    return pass->*(&Members::Pass2);
  }
  static vtkOpenGLHelper& HelperOf(vtkSSAAPass* pass) { return *(pass->*(&Members::SSAAHelper)); }
};

void UseProgram(vtkOpenGLHelper& helper, vtkShaderProgram* program)
{
  helper.Program = program;
  helper.VAO->ShaderProgramChanged();
  helper.ShaderSourceTime.Modified();
}
}

//------------------------------------------------------------------------------
void TiledSupersampling::StopRepeating(vtkRenderPass* pass, vtkOpenGLRenderWindow* window)
{
  auto* supersampling = vtkSSAAPass::SafeDownCast(pass);
  if (!supersampling)
  {
    return;
  }
  for (auto* texture : { &Members::FirstOf(supersampling), &Members::SecondOf(supersampling) })
  {
    if (!*texture)
    {
      *texture = vtkSmartPointer<vtkTextureObject>::New();
      (*texture)->SetContext(window);
    }
    (*texture)->SetWrapS(vtkTextureObject::ClampToEdge);
    (*texture)->SetWrapT(vtkTextureObject::ClampToEdge);
  }
}

//------------------------------------------------------------------------------
void TiledSupersampling::StopStretching(vtkRenderPass* pass, vtkOpenGLRenderWindow* window)
{
  auto* supersampling = vtkSSAAPass::SafeDownCast(pass);
  vtkOpenGLHelper* helper = supersampling ? &Members::HelperOf(supersampling) : nullptr;
  if (!helper || !helper->Program)
  {
    return;
  }
  std::string source = helper->Program->GetFragmentShader()->GetSource();
  const std::size_t main = source.find("void main");
  if (main == std::string::npos || source.find("notStretched") != std::string::npos)
  {
    return;
  }
  source.insert(main, NotStretched);
  window->MakeCurrent();
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    helper->Program->GetVertexShader()->GetSource().c_str(), source.c_str(), "");
  if (program)
  {
    UseProgram(*helper, program);
  }
}

//------------------------------------------------------------------------------
void TiledSupersampling::StretchAgain(vtkRenderPass* pass)
{
  if (auto* supersampling = vtkSSAAPass::SafeDownCast(pass))
  {
    // The pass fetches its own one again, from the window's cache.
    UseProgram(Members::HelperOf(supersampling), nullptr);
  }
}
}
