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
#include "vtkSpherePackingRenderingModule.h" // for the export macro

#include <string> // for the return value

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
   * What is wrong with what the window has just drawn into, as a phrase; empty if nothing is.
   * Takes the errors of OpenGL, so whoever calls it before drawing, too, learns of new ones only.
   */
  static std::string FindProblem(vtkRenderWindow* window);

protected:
  vtkSpherePackingWindowCheck() = default;
  ~vtkSpherePackingWindowCheck() override = default;

private:
  vtkSpherePackingWindowCheck(const vtkSpherePackingWindowCheck&) = delete;
  void operator=(const vtkSpherePackingWindowCheck&) = delete;
};

#endif
