// SPDX-License-Identifier: BSD-3-Clause
#include "impostor/ImpostorQuads.h"

#include "impostor/SplitDouble.h"

#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
namespace
{
// The vertex shader and this code round differently. A sphere in the band in between is drawn
// twice, which is better than not at all.
constexpr double Slack = 1.0 + 1e-6;
constexpr double Unbounded = 1e30;

struct PixelBounds
{
  double Low[2];
  double High[2];
};

// In view coordinates, and in pixels from the corner of the viewport.
struct ProjectedSphere
{
  std::array<double, 3> Center;
  double Distance; // of the centre from the eye, along the direction of view
  double Radius;
  PixelBounds Bounds;
};

// The bounds of the projected outline: projectBounds() in PointSpriteVS.glsl, which has the
// formula. Unbounded where the sphere reaches behind the eye.
PixelBounds ProjectBounds(
  const std::array<double, 3>& c, double distance, double r, const ViewTransform& view)
{
  PixelBounds bounds;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double scale = view.SlopeToPixel[axis];
    const double offset = view.SlopeToPixel[axis + 2];
    double low = -Unbounded;
    double high = Unbounded;
    if (view.Parallel)
    {
      low = scale * (c[axis] - r) + offset;
      high = scale * (c[axis] + r) + offset;
    }
    else if (distance > Slack * r)
    {
      const double denominator = (distance - r) * (distance + r);
      const double root = r * std::sqrt(c[axis] * c[axis] + denominator);
      low = scale * (c[axis] * distance - root) / denominator + offset;
      high = scale * (c[axis] * distance + root) / denominator + offset;
    }
    bounds.Low[axis] = low;
    bounds.High[axis] = high;
  }
  return bounds;
}

// Whether the sphere lies wholly outside a side plane of a perspective view frustum.
bool IsOutsideFrustum(
  const std::array<double, 3>& c, double distance, double r, const ViewTransform& view)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    for (const double edge : { 0.0, view.Viewport[2 + axis] })
    {
      const double slope = (edge - view.SlopeToPixel[2 + axis]) / view.SlopeToPixel[axis];
      const double outward = edge > 0.0 ? 1.0 : -1.0;
      if (outward * (c[axis] - slope * distance) > r * std::sqrt(1.0 + slope * slope))
      {
        return true;
      }
    }
  }
  return false;
}

// Whether a sphere at that distance needs a quad whatever its size in pixels: it is within four
// radii of the eye, or a radius is more than MaximumDepthFraction of the depth range. In
// perspective, depth n f / (f - n) (1 / n - 1 / z) changes by r n f / ((f - n) z^2) along a radius
// at the depth z.
bool NeedsDoublePrecision(double distance, double r, const ViewTransform& view)
{
  const double range = view.Far - view.Near;
  if (view.Parallel)
  {
    return Slack * r >= MaximumDepthFraction * range;
  }
  return distance < 4.0 * Slack * r ||
    Slack * r * view.Near * view.Far >= MaximumDepthFraction * range * distance * distance;
}

// Whether a sphere needs a quad, and its projection if so.
bool NeedsQuad(const std::array<double, 3>& model, double radius, const ViewTransform& view,
  double maximumPointSize, ProjectedSphere& sphere)
{
  const double r = radius * view.RadiusScale;
  const std::array<double, 3> c = view.ToView(model);
  const double distance = -c[2];
  if (!(r > 0.0) || distance + r < view.Near || distance - r > view.Far)
  {
    return false;
  }
  const PixelBounds bounds = ProjectBounds(c, distance, r, view);
  double size = 0.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double low = std::max(bounds.Low[axis], 0.0);
    const double high = std::min(bounds.High[axis], view.Viewport[2 + axis]);
    if (low > high)
    {
      return false;
    }
    size = std::max(size, high - low);
  }
  // A point's size is a count of pixel centres: the length of the bounds, give or take one.
  if ((!NeedsDoublePrecision(distance, r, view) && size < maximumPointSize - 1.0) ||
    (!view.Parallel && IsOutsideFrustum(c, distance, r, view)))
  {
    return false;
  }
  sphere = { c, distance, r, bounds };
  return true;
}

// The reference pixel, where the ray passes nearest to the centre, and the offset of that ray.
void SetReference(QuadVertex& vertex, const ProjectedSphere& sphere, const ViewTransform& view)
{
  const double reach = view.Parallel ? 1.0 : sphere.Distance;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double scale = view.SlopeToPixel[axis];
    const double offset = view.SlopeToPixel[axis + 2];
    double pixel = 0.5 * view.Viewport[2 + axis];
    if (view.Parallel || sphere.Distance > 0.0)
    {
      pixel = scale * sphere.Center[axis] / reach + offset;
    }
    // In the window, since rounding grows with the distance from the reference to a pixel.
    pixel = 0.5 + std::floor(std::clamp(pixel, 0.0, view.Viewport[2 + axis]));
    vertex.Reference[axis] = static_cast<float>(pixel + view.Viewport[axis]);
    const double rayOffset = reach * (pixel - offset) / scale - sphere.Center[axis];
    SplitDouble(rayOffset, vertex.Reference[2 + axis], vertex.ReferenceLow[axis]);
  }
}

// frontDepth() of PointSpriteVS.glsl.
double FrontDepth(const ProjectedSphere& sphere, const ViewTransform& view)
{
  const double front = std::max(sphere.Distance - sphere.Radius - view.Near, 0.0);
  const double depth = view.Parallel
    ? front / (view.Far - view.Near)
    : front / (front + view.Near) * view.Far / (view.Far - view.Near);
  return depth * (1.0 - 1e-6);
}

QuadVertex MakeVertex(const ProjectedSphere& sphere, const ViewTransform& view)
{
  QuadVertex vertex = {};
  vertex.Corner[2] = static_cast<float>(2.0 * FrontDepth(sphere, view) - 1.0);
  SetReference(vertex, sphere, view);
  const double shape[4] = { view.Parallel ? 1.0 : sphere.Distance, sphere.Radius,
    sphere.Distance - view.Near, view.Far - sphere.Distance };
  for (int i = 0; i < 4; ++i)
  {
    SplitDouble(shape[i], vertex.Shape[i], vertex.ShapeLow[i]);
  }
  if (!view.Parallel && sphere.Distance < 3.0 * sphere.Radius)
  {
    const auto& c = sphere.Center;
    const double length = std::hypot(c[0], c[1], c[2]);
    SplitDouble(
      (length - sphere.Radius) * (length + sphere.Radius), vertex.EyePower[0], vertex.EyePower[1]);
  }
  return vertex;
}

void AppendQuad(std::vector<QuadVertex>& quads, QuadVertex vertex, const PixelBounds& bounds,
  const ViewTransform& view)
{
  double corners[2][2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double size = view.Viewport[2 + axis];
    // Half a pixel of margin for the rasterizer's fixed point.
    corners[0][axis] = 2.0 * std::max(std::floor(bounds.Low[axis]) - 0.5, -1.0) / size - 1.0;
    corners[1][axis] = 2.0 * std::min(std::ceil(bounds.High[axis]) + 0.5, size + 1.0) / size - 1.0;
  }
  static constexpr int Order[6][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 0 }, { 1, 1 }, { 0, 1 } };
  for (const auto& at : Order)
  {
    vertex.Corner[0] = static_cast<float>(corners[at[0]][0]);
    vertex.Corner[1] = static_cast<float>(corners[at[1]][1]);
    quads.push_back(vertex);
  }
}

// Whether any sphere of the cluster can need a quad.
//
// The visible part of a sphere lies in the cluster's box. A point of it at the depth z is at most
// z l from the eye, where l is the length of the ray through a corner of the window up to depth 1.
// So its depth is at least the distance of the eye to the box, divided by l, and the centre is at
// most r nearer. At a depth z of 4 r or more, an outline is
//
//   2 r f sqrt(x^2 + z^2 - r^2) / (z^2 - r^2)
//
// pixels long, where f is the number of pixels per unit of slope and x / z exceeds the slope of the
// corner by at most l r / z <= l / 4. So the root is at most 1.25 l z and the denominator at least
// 15/16 z^2, which makes 4/3 l 2 r f / z at most. The code takes l^2 >= l for l.
bool MayNeedQuads(const SphereCluster& cluster, const ViewTransform& view,
  const std::array<double, 3>& origin, double maximumPointSize)
{
  const double r = cluster.MaximumRadius * view.RadiusScale;
  const double pixels = std::max(std::abs(view.SlopeToPixel[0]), std::abs(view.SlopeToPixel[1]));
  if (view.Parallel)
  {
    return NeedsDoublePrecision(0.0, r, view) || 2.0 * r * pixels >= maximumPointSize - 2.0;
  }
  double distance2 = 0.0; // of the eye to the box
  for (int axis = 0; axis < 3; ++axis)
  {
    const double eye = origin[axis] + view.Eye[axis];
    const double outside =
      std::max({ cluster.Bounds[2 * axis] - eye, eye - cluster.Bounds[2 * axis + 1], 0.0 });
    distance2 += outside * outside;
  }
  double length2 = 1.0; // of the ray through the corner
  for (int axis = 0; axis < 2; ++axis)
  {
    const double slope = std::max(std::abs(view.SlopeToPixel[2 + axis]),
                           std::abs(view.Viewport[2 + axis] - view.SlopeToPixel[2 + axis])) /
      view.SlopeToPixel[axis];
    length2 += slope * slope;
  }
  const double depth = std::sqrt(distance2) * view.RadiusScale / std::sqrt(length2) - r;
  return depth <= 0.0 || NeedsDoublePrecision(depth, r, view) ||
    1.34 * length2 * 2.0 * r * pixels / depth >= maximumPointSize - 2.0;
}
}

//------------------------------------------------------------------------------
std::vector<QuadVertex> MakeImpostorQuads(vtkPolyData* packing, vtkDataArray* radii,
  vtkUnsignedCharArray* colors, const PointSprites& sprites, const ViewTransform& view,
  double maximumPointSize)
{
  const std::array<double, 3>& origin = sprites.GetOrigin();
  vtkPoints* points = packing->GetPoints();
  std::vector<QuadVertex> quads;
  for (const SphereCluster& cluster : sprites.GetClusters())
  {
    if (!MayNeedQuads(cluster, view, origin, maximumPointSize))
    {
      continue;
    }
    for (vtkIdType i = cluster.Begin; i < cluster.End; ++i)
    {
      const vtkIdType id = sprites.GetPointIds()[i];
      std::array<double, 3> model;
      points->GetPoint(id, model.data());
      for (int axis = 0; axis < 3; ++axis)
      {
        model[axis] -= origin[axis];
      }
      ProjectedSphere sphere;
      if (NeedsQuad(model, radii->GetTuple1(id), view, maximumPointSize, sphere))
      {
        QuadVertex vertex = MakeVertex(sphere, view);
        PackColor(vertex.Color, colors, id);
        PackId(vertex.Id, id);
        AppendQuad(quads, vertex, sphere.Bounds, view);
      }
    }
  }
  return quads;
}
}
