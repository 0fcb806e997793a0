// SPDX-License-Identifier: BSD-3-Clause
// The mapper's state that no other code sees. Private to the module.
#ifndef vtkOpenGLSpherePackingMapperInternals_h
#define vtkOpenGLSpherePackingMapperInternals_h

#include "vtkOpenGLSpherePackingMapper.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkSpherePackingInput.h"
#include "vtkSpherePackingPrograms.h"
#include "vtkSpherePackingQuads.h"
#include "vtkSpherePackingSurfaces.h"
#include "vtkSpherePackingVertices.h"
#include "vtkSpherePackingView.h"
#include "vtkTimeStamp.h"

#include <memory>
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
  vtkIdType NumberOfQuadVertices = 0;
  bool HasColors = false;
  bool IdsUploaded = false;
  bool MayBeCut = true; // by the near or far plane, a clipping plane, or for want of a side
  float MaximumPointSize = 1.0f;
  HitModes HitMode = FirstHit;
  vtkNew<vtkOpenGLBufferObject> VertexBuffer;
  vtkNew<vtkOpenGLBufferObject> IdBuffer; // four bytes a vertex, made when something selects
  vtkNew<vtkOpenGLBufferObject> QuadBuffer;
  vtkTimeStamp BufferTime; // when the set of attributes last changed

  // Surfaces are found first and lit in a triangle over the viewport, or drawn and lit in one go.
  // A new one after each release: VTK's framebuffers remember what was attached in another context.
  std::unique_ptr<vtkSpherePackingSurfaces> Surfaces{ new vtkSpherePackingSurfaces };
  vtkOpenGLHelper Screen;
  vtkSpherePackingFeatures ShaderFeatures; // what VTK's shaders were last built for

  vtkSpherePackingFeatures GetFeatures(int numberOfClippingPlanes) const;
  void UploadIds();
};

#endif
