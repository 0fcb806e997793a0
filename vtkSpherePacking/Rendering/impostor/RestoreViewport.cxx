// SPDX-License-Identifier: BSD-3-Clause
#include "impostor/RestoreViewport.h"

#include "vtkOpenGLState.h"
#include "vtk_glad.h"

namespace spherepacking
{
//------------------------------------------------------------------------------
void RestoreViewport(vtkOpenGLState* state)
{
  int viewport[4];
  int scissor[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  state->vtkglGetIntegerv(GL_SCISSOR_BOX, scissor);
  state->ResetGLViewportState();
  state->ResetGLScissorState();
  state->vtkglViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  state->vtkglScissor(scissor[0], scissor[1], scissor[2], scissor[3]);
}
}
