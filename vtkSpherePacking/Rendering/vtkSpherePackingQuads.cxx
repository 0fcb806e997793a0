// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingQuads.h"

#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSpherePackingSplit.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// The vertex shader and this code round differently; in the band between, a sphere is drawn
// twice, which is better than not at all.
constexpr double Slack = 1.0 + 1e-6;
constexpr double FullWindow = 1e30;

struct Outline
{
  double Low[2];
  double High[2];
};

// The outline's bounds in pixels along each axis, or everything where the sphere reaches behind
// the eye.
Outline ComputeOutline(
  const std::array<double, 3>& c, double distance, double r, const vtkSpherePackingView& view)
{
  Outline outline;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double scale = view.PixelMap[axis];
    const double offset = view.PixelMap[axis + 2];
    double low = -FullWindow;
    double high = FullWindow;
    if (view.Parallel)
    {
      low = scale * (c[axis] - r) + offset;
      high = scale * (c[axis] + r) + offset;
    }
    else if (distance > Slack * r)
    {
      const double along = (distance - r) * (distance + r);
      const double spread = r * std::sqrt(c[axis] * c[axis] + along);
      low = scale * (c[axis] * distance - spread) / along + offset;
      high = scale * (c[axis] * distance + spread) / along + offset;
    }
    outline.Low[axis] = low;
    outline.High[axis] = high;
  }
  return outline;
}

// Whether the sphere lies wholly outside a side plane of a perspective view volume.
bool OutsideSides(
  const std::array<double, 3>& c, double distance, double r, const vtkSpherePackingView& view)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    for (const double edge : { 0.0, view.Viewport[2 + axis] })
    {
      const double slope = (edge - view.PixelMap[2 + axis]) / view.PixelMap[axis];
      const double outward = edge > 0.0 ? 1.0 : -1.0;
      if (outward * (c[axis] - slope * distance) > r * std::sqrt(1.0 + slope * slope))
      {
        return true;
      }
    }
  }
  return false;
}

struct Sphere
{
  std::array<double, 3> View;
  double Distance;
  double Radius;
  Outline Pixels;
};

// Whether a sphere of that depth is one for a quad whatever its size in pixels.
bool IsClose(double distance, double r, const vtkSpherePackingView& view)
{
  const double length = view.Far - view.Near;
  if (view.Parallel)
  {
    return Slack * r >= vtkSpherePackingMaximumDepthShare * length;
  }
  return distance < 4.0 * Slack * r ||
    Slack * r * view.Near * view.Far >=
    vtkSpherePackingMaximumDepthShare * length * distance * distance;
}

bool NeedsQuad(const std::array<double, 3>& model, double radius, const vtkSpherePackingView& view,
  double maximumPointSize, Sphere& sphere)
{
  const double r = radius * view.RadiusScale;
  const std::array<double, 3> c = view.ToView(model);
  const double distance = -c[2];
  if (!(r > 0.0) || distance + r < view.Near || distance - r > view.Far)
  {
    return false;
  }
  const bool close = IsClose(distance, r, view);
  const Outline pixels = ComputeOutline(c, distance, r, view);
  double size = 0.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double low = std::max(pixels.Low[axis], 0.0);
    const double high = std::min(pixels.High[axis], view.Viewport[2 + axis]);
    if (low > high)
    {
      return false;
    }
    size = std::max(size, high - low);
  }
  // A point counts pixel centres: at most one more than its length, and at least one less.
  if ((!close && size < maximumPointSize - 1.0) ||
    (!view.Parallel && OutsideSides(c, distance, r, view)))
  {
    return false;
  }
  sphere = { c, distance, r, pixels };
  return true;
}

vtkSpherePackingQuadVertex MakeVertex(const Sphere& sphere, const vtkSpherePackingView& view)
{
  vtkSpherePackingQuadVertex vertex = {};
  const double reach = view.Parallel ? 1.0 : sphere.Distance;
  const double front = std::max(sphere.Distance - sphere.Radius - view.Near, 0.0);
  const double depth = view.Parallel
    ? front / (view.Far - view.Near)
    : front / (front + view.Near) * view.Far / (view.Far - view.Near);
  vertex.Corner[2] = static_cast<float>(2.0 * depth * (1.0 - 1e-6) - 1.0);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double scale = view.PixelMap[axis];
    const double offset = view.PixelMap[axis + 2];
    // Where the ray passes nearest to the centre, kept near the window to bound rounding.
    double pixel = 0.5 * view.Viewport[2 + axis];
    if (view.Parallel || sphere.Distance > 0.0)
    {
      pixel = scale * sphere.View[axis] / reach + offset;
    }
    pixel = 0.5 + std::floor(std::clamp(pixel, 0.0, view.Viewport[2 + axis]));
    vertex.Reference[axis] = static_cast<float>(pixel + view.Viewport[axis]);
    const double miss = reach * (pixel - offset) / scale - sphere.View[axis];
    vtkSpherePackingSplit(miss, vertex.Reference[2 + axis], vertex.Rest[axis]);
  }
  const double shape[4] = { reach, sphere.Radius, sphere.Distance - view.Near,
    view.Far - sphere.Distance };
  for (int i = 0; i < 4; ++i)
  {
    vtkSpherePackingSplit(shape[i], vertex.Shape[i], vertex.ShapeLow[i]);
  }
  if (!view.Parallel && sphere.Distance < 3.0 * sphere.Radius)
  {
    const auto& c = sphere.View;
    const double length = std::hypot(c[0], c[1], c[2]);
    vtkSpherePackingSplit(
      (length - sphere.Radius) * (length + sphere.Radius), vertex.Rest[2], vertex.Rest[3]);
  }
  return vertex;
}

void AppendQuad(std::vector<vtkSpherePackingQuadVertex>& quads, vtkSpherePackingQuadVertex vertex,
  const Sphere& sphere, const vtkSpherePackingView& view)
{
  double corners[2][2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double size = view.Viewport[2 + axis];
    // Half a pixel of margin for the rasteriser's fixed point.
    corners[0][axis] = 2.0 * std::max(std::floor(sphere.Pixels.Low[axis]) - 0.5, -1.0) / size - 1.0;
    corners[1][axis] =
      2.0 * std::min(std::ceil(sphere.Pixels.High[axis]) + 0.5, size + 1.0) / size - 1.0;
  }
  static constexpr int Order[6][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 0 }, { 1, 1 }, { 0, 1 } };
  for (const auto& at : Order)
  {
    vertex.Corner[0] = static_cast<float>(corners[at[0]][0]);
    vertex.Corner[1] = static_cast<float>(corners[at[1]][1]);
    quads.push_back(vertex);
  }
}

// Whether any sphere of the block can need a quad. The size of a point is at most
// 2 r f / sqrt(d^2 - r^2) with d the distance to the eye and f the larger pixel factor, stretched
// towards the corners of the window by at most 1 + slope^2.
bool MayNeedQuads(const vtkSpherePackingBlock& block, const vtkSpherePackingView& view,
  const std::array<double, 3>& origin, double maximumPointSize)
{
  const double r = block.MaximumRadius * view.RadiusScale;
  const double pixels = std::max(std::abs(view.PixelMap[0]), std::abs(view.PixelMap[1]));
  if (view.Parallel)
  {
    return IsClose(0.0, r, view) || 2.0 * r * pixels >= maximumPointSize - 2.0;
  }
  double squared = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double eye = origin[axis] + view.Eye[axis];
    const double outside =
      std::max({ block.Bounds[2 * axis] - eye, eye - block.Bounds[2 * axis + 1], 0.0 });
    squared += outside * outside;
  }
  double corner = 1.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double slope = std::max(std::abs(view.PixelMap[2 + axis]),
                           std::abs(view.Viewport[2 + axis] - view.PixelMap[2 + axis])) /
      view.PixelMap[axis];
    corner += slope * slope;
  }
  // In front of the eye, depth >= distance / corner for what is in the window.
  const double depth = std::sqrt(squared) * view.RadiusScale / std::sqrt(corner) - r;
  return depth <= 0.0 || IsClose(depth, r, view) ||
    2.0 * r * pixels * corner / depth >= maximumPointSize - 2.0;
}
}

//------------------------------------------------------------------------------
std::vector<vtkSpherePackingQuadVertex> vtkSpherePackingMakeQuads(vtkPolyData* packing,
  vtkDataArray* radii, vtkUnsignedCharArray* colors, const vtkSpherePackingVertices& vertices,
  const vtkSpherePackingView& view, double maximumPointSize)
{
  const std::vector<vtkSpherePackingBlock>& blocks = vertices.GetBlocks();
  const std::array<double, 3>& origin = vertices.GetOrigin();
  vtkPoints* points = packing->GetPoints();
  std::vector<vtkSpherePackingQuadVertex> quads;
  for (const vtkSpherePackingBlock& block : blocks)
  {
    if (!MayNeedQuads(block, view, origin, maximumPointSize))
    {
      continue;
    }
    for (vtkIdType i = block.Begin; i < block.End; ++i)
    {
      const vtkIdType id = vertices.GetPointIds()[i];
      std::array<double, 3> model;
      points->GetPoint(id, model.data());
      for (int axis = 0; axis < 3; ++axis)
      {
        model[axis] -= origin[axis];
      }
      Sphere sphere;
      if (NeedsQuad(model, radii->GetTuple1(id), view, maximumPointSize, sphere))
      {
        vtkSpherePackingQuadVertex vertex = MakeVertex(sphere, view);
        vtkSpherePackingFillColor(vertex.Color, colors, id);
        vtkSpherePackingFillId(vertex.Id, id);
        AppendQuad(quads, vertex, sphere, view);
      }
    }
  }
  return quads;
}
VTK_ABI_NAMESPACE_END
