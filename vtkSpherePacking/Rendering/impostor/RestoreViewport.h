// SPDX-License-Identifier: BSD-3-Clause
#ifndef RestoreViewport_h
#define RestoreViewport_h

class vtkOpenGLState;

namespace spherepacking
{
/// Sets the viewport and the scissor box to what VTK believes that they are.
///
/// Upstream: VTK 9.7: vtkOSOpenGLRenderWindow and vtkEGLRenderWindow inherit a PopContext() that
/// does nothing. So when one window releases what it holds in the middle of another one's
/// rendering, as vtkOpenGLResourceFreeCallback does when an actor moves to another window, its
/// context remains current, and the viewport that VTK sets next goes there, whatever the
/// vtkOpenGLState of the other window believes.
void RestoreViewport(vtkOpenGLState* state);
}

#endif
