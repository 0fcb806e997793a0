// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpherePackingWindowCheck
 * @brief   what a window can draw, and whether it did
 *
 * VTK draws into a framebuffer that is incomplete, or for which there was no memory, as into any
 * other, and the picture is black. It says so in its log at most.
 */
#ifndef vtkSpherePackingWindowCheck_h
#define vtkSpherePackingWindowCheck_h

#include "vtkObject.h"
#include "vtkSmartPointer.h"                 // for the window
#include "vtkSpherePackingRenderingModule.h" // for the export macro

class vtkOutputWindow;
class vtkRenderWindow;

class VTKSPHEREPACKINGRENDERING_EXPORT vtkSpherePackingWindowCheck : public vtkObject
{
public:
  static vtkSpherePackingWindowCheck* New();
  vtkTypeMacro(vtkSpherePackingWindowCheck, vtkObject);

  /**
   * The longest side in pixels that OpenGL has for a texture, a renderbuffer and a viewport alike;
   * 0 for a window that has no OpenGL. The window is initialized if it was not.
   */
  static int GetLargestSide(vtkRenderWindow* window);

  /**
   * Watch what is drawn from now on. Errors of OpenGL that are there already are taken away.
   */
  void Begin(vtkRenderWindow* window);

  /**
   * What went wrong since Begin(), as a phrase; empty if the window could draw. Looks at OpenGL's
   * errors, whether the window's framebuffers are complete, and what VTK has logged about others.
   * Makes no texts, since there may be no memory for any.
   */
  const char* End();

protected:
  vtkSpherePackingWindowCheck();
  ~vtkSpherePackingWindowCheck() override;

private:
  vtkSpherePackingWindowCheck(const vtkSpherePackingWindowCheck&) = delete;
  void operator=(const vtkSpherePackingWindowCheck&) = delete;

  void Hear(vtkObject* caller, unsigned long event, void* text);
  void StopListening();

  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkOutputWindow> Log;
  unsigned long Tag = 0;
  const char* Logged = "";
};

#endif
