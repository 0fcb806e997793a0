// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOpenGLSpherePackingMapper_h
#define vtkOpenGLSpherePackingMapper_h
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkSpherePackingRenderingModule.h"
class VTKSPHEREPACKINGRENDERING_EXPORT vtkOpenGLSpherePackingMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkOpenGLSpherePackingMapper* New();
  vtkTypeMacro(vtkOpenGLSpherePackingMapper, vtkOpenGLPolyDataMapper);
protected:
  vtkOpenGLSpherePackingMapper() = default;
  ~vtkOpenGLSpherePackingMapper() override = default;
};
#endif
