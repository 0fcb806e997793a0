#!/usr/bin/env bash
# VTK 9.6.2 (PyPI) on OSMesa (libOSMesa.so.8): vtkSSAAPass, which PyVista's "ssaa" is, filters across the edges
# of a texture that repeats, so that a white bar along the left edge of the picture is seen at the right edge,
# too (0.05), and takes 0.05 from its own first column; and the picture is stretched about its middle, so that
# the column in which a bar's edge lies is not covered symmetrically: a bar of 60 columns sums up to 60.2.
# Fails when that changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"${PYTHON:-python3}" -m venv venv
venv/bin/pip install -q vtk==9.6.2 numpy==2.2.6
cat >bars.py <<'PY'
import vtkmodules.vtkInteractionStyle
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter,
)
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass, vtkSSAAPass

SIZE = 100


def columns(first, last, antialias):
    """Brightness of the columns of a picture of a white bar that begins and ends between pixels."""
    bar = vtkPlaneSource(origin=(first, 0, 0), point1=(last, 0, 0), point2=(first, SIZE, 0))
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(bar.GetOutputPort())
    actor = vtkActor(mapper=mapper)
    actor.property.LightingOff()
    renderer = vtkRenderer(background=(0, 0, 0))
    renderer.AddActor(actor)
    window = vtkRenderWindow(off_screen_rendering=True, size=(SIZE, SIZE), multi_samples=0)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetPosition(SIZE / 2, SIZE / 2, 10)
    camera.SetFocalPoint(SIZE / 2, SIZE / 2, 0)
    camera.SetParallelScale(SIZE / 2)
    renderer.ResetCameraClippingRange()
    if antialias:
        renderer.SetPass(vtkSSAAPass(delegate_pass=vtkRenderStepsPass()))
    window.Render()
    grab = vtkWindowToImageFilter(input=window, read_front_buffer=False)
    grab.Update()
    pixels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(SIZE, SIZE, 3)[SIZE // 2, :, 0] / 255


for name, antialias in (("plain", False), ("SSAA", True)):
    left = columns(0, 10, antialias)
    print(f"{name}: bar 0..10 at column 0 {left[0]:.2f}, at column 99 {left[99]:.2f};",
          f"bar 20..80 sums up to {columns(20, 80, antialias).sum():.1f}")
PY
VTK_DEFAULT_OPENGL_WINDOW=vtkOSOpenGLRenderWindow venv/bin/python bars.py 2>log >seen || { cat log; exit 1; }
cat seen
diff seen - <<'SEEN'
plain: bar 0..10 at column 0 1.00, at column 99 0.00; bar 20..80 sums up to 60.0
SSAA: bar 0..10 at column 0 0.95, at column 99 0.05; bar 20..80 sums up to 60.2
SEEN
