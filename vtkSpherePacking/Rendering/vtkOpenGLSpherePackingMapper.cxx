#include "vtkOpenGLSpherePackingMapper.h"
#include "vtkObjectFactory.h"
vtkStandardNewMacro(vtkOpenGLSpherePackingMapper);
