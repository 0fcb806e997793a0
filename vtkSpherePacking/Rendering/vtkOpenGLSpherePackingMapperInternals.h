// SPDX-License-Identifier: BSD-3-Clause
// The mapper's state that no other code sees. Private to the module.
#ifndef vtkOpenGLSpherePackingMapperInternals_h
#define vtkOpenGLSpherePackingMapperInternals_h

#include "vtkOpenGLSpherePackingMapper.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkSpherePackingInput.h"
#include "vtkSpherePackingQuads.h"
#include "vtkSpherePackingVertices.h"
#include "vtkSpherePackingView.h"
#include "vtkTimeStamp.h"

#include <string>

struct vtkOpenGLSpherePackingMapper::Internals
{
  // As `hitMode` in vtkSpherePackingFSDeclarations.glsl.
  enum HitModes
  {
    FirstHit = 0,
    NearHit = 1,
    FarHit = 2
  };

  vtkNew<vtkSpherePackingInput> Input;
  vtkPolyData* CheckedInput = nullptr; // only compared, never read
  vtkTimeStamp CheckTime;
  vtkDataArray* Radii = nullptr; // belongs to the input that was checked
  std::string ErrorMessage;

  vtkSpherePackingView View;
  vtkSpherePackingVertices Vertices;
  vtkIdType NumberOfVertices = 0;
  bool HasColors = false;
  bool MayBeCut = true; // by the near or far plane, a clipping plane, or for want of a side
  bool IdsUploaded = false;
  float MaximumPointSize = 1.0f;
  HitModes HitMode = FirstHit;
  vtkNew<vtkOpenGLBufferObject> VertexBuffer;
  vtkNew<vtkOpenGLBufferObject> IdBuffer; // four bytes a vertex, made when something selects
  vtkNew<vtkOpenGLBufferObject> QuadBuffer;
  vtkTimeStamp BufferTime; // when the set of attributes last changed
  // What the shaders were built for.
  bool ShadersHaveColors = false;
  bool ShadersMayCut = true;

  void UploadIds();
};

#endif
