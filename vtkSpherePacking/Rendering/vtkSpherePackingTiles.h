// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpherePackingTiles
 * @brief   draws a picture that is larger than its window, piece by piece
 *
 * Between Begin() and End() the window's renderers take themselves to be as large as in a window of
 * the picture's size, so that texts and scalar bars are where and as large as there. Each Render()
 * draws the part of the picture that starts at a pixel and is as large as the window.
 *
 * vtkWindowToImageFilter does the same for whole multiples of the window's size. It halves the
 * view's angle and the like in single precision, which shows at seams, and for a view whose centre
 * has been moved it takes a wrong part; and it gives the tile's camera to widgets that follow the
 * camera.
 */
#ifndef vtkSpherePackingTiles_h
#define vtkSpherePackingTiles_h

#include "vtkObject.h"
#include "vtkSpherePackingRenderingModule.h" // for the export macro

#include <memory> // for std::unique_ptr

class vtkRenderWindow;

class VTKSPHEREPACKINGRENDERING_EXPORT vtkSpherePackingTiles : public vtkObject
{
public:
  static vtkSpherePackingTiles* New();
  vtkTypeMacro(vtkSpherePackingTiles, vtkObject);

  /**
   * Start a picture of `size` pixels in the window, whose own size becomes `tile`. Texts are
   * `scale` times as large as they would be in a window of that size. Returns false, and changes
   * nothing, if the view cannot be divided: that of a window in stereo, or of a camera that is set
   * by the corners of a screen (off-axis projection); and for numbers below 1.
   */
  bool Begin(vtkRenderWindow* window, const int size[2], const int tile[2], int scale);

  /**
   * Draw what the picture shows from the pixel (x, y) on, seen from its lower left corner. What
   * the window holds beyond the picture is undefined.
   */
  void Render(int x, int y);

  /// Give window and renderers back as they were.
  void End();

protected:
  vtkSpherePackingTiles();
  ~vtkSpherePackingTiles() override;

private:
  vtkSpherePackingTiles(const vtkSpherePackingTiles&) = delete;
  void operator=(const vtkSpherePackingTiles&) = delete;

  struct State;
  std::unique_ptr<State> Internals;
};

#endif
