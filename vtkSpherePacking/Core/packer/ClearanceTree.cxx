// SPDX-License-Identifier: BSD-3-Clause
#include "packer/ClearanceTree.h"

#include "packer/ClearanceBound.h"

#include <algorithm>
#include <limits>

namespace spherepacking
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

double DistanceTo(const PackedSphere& sphere, const Vector3& point)
{
  return Length(point - sphere.Center) - sphere.Radius;
}

// A sphere that may be the nearest to a point of a cell is nearer to the cell's centre than this:
// both its distance and the clearance change by half of the diagonal at most.
double ReachOf(const ClearanceTree::Cell& cell)
{
  return cell.Clearance + 2.0 * cell.HalfDiagonal();
}

// Bounds are stored in single precision, rounded to the side on which they remain bounds.
float RoundUp(double bound)
{
  const auto rounded = static_cast<float>(bound);
  return rounded < bound ? std::nextafter(rounded, std::numeric_limits<float>::infinity())
                         : rounded;
}

float RoundTowardZero(double distance)
{
  const auto rounded = static_cast<float>(distance);
  return std::abs(rounded) > std::abs(distance) ? std::nextafter(rounded, 0.0f) : rounded;
}

Vector3 CenterOfChild(const Vector3& center, double half, int child)
{
  return { center.X + (child & 1 ? half : -half), center.Y + (child & 2 ? half : -half),
    center.Z + (child & 4 ? half : -half) };
}
}

//------------------------------------------------------------------------------
ClearanceTree::ClearanceTree(
  const TriangleTree& surface, const Vector3& center, float halfSide, double minimumRadius)
  : Surface(surface)
  , MinimumRadius(minimumRadius)
{
  this->Blocks.emplace_back(new Octet);
  Cell& root = this->At(0);
  root.Center = center;
  root.HalfSide = halfSide;
  double distance = Infinity;
  TriangleTree::Nearest nearest;
  surface.FindNearest(center, distance, nearest);
  distance = surface.IsInside(center) ? distance : -distance;
  root.SurfaceDistance = RoundTowardZero(distance);
  root.Clearance = RoundUp(distance);
  root.Bound = RoundUp(root.Clearance + root.HalfDiagonal());
}

//------------------------------------------------------------------------------
ClearanceTree::Octet ClearanceTree::Split(std::int32_t leaf) const
{
  const Cell& parent = (*this)[leaf];
  Octet children;
  std::array<TriangleTree::Nearest, 8> nearest;
  for (int i = 0; i < 8; ++i)
  {
    Cell& child = children[i];
    child.HalfSide = 0.5f * parent.HalfSide;
    child.Center = CenterOfChild(parent.Center, child.HalfSide, i);
    nearest[i] = this->Measure(parent, i > 0 ? nearest[i - 1].Triangle : -1, child);
  }
  for (int i = 0; i < 8; ++i)
  {
    if (!children[i].Pruned)
    {
      this->FindBound(parent, nearest, i, children[i]);
    }
  }
  return children;
}

//------------------------------------------------------------------------------
TriangleTree::Nearest ClearanceTree::Measure(
  const Cell& parent, std::int32_t guess, Cell& child) const
{
  double spheres = Infinity;
  for (const std::int32_t i : parent.Near)
  {
    spheres = std::min(spheres, DistanceTo(this->Packed[i], child.Center));
  }
  const double diagonal = child.HalfDiagonal();
  TriangleTree::Nearest nearest;
  child.Pruned = !(spheres + diagonal > this->MinimumRadius);
  if (child.Pruned)
  {
    return nearest;
  }
  // The centres of parent and child are half of the child's diagonal apart.
  const double bound = std::abs(parent.SurfaceDistance) - diagonal;
  const bool side =
    bound > 0.0 ? parent.SurfaceDistance > 0.0 : this->Surface.IsInside(child.Center);
  double surface = bound;
  if (!(bound > (side ? spheres : diagonal)))
  {
    surface = std::max(spheres, diagonal);
    nearest.Triangle = guess;
    if (!this->Surface.FindNearest(child.Center, surface, nearest))
    {
      nearest.Triangle = -1;
    }
  }
  child.SurfaceDistance = RoundTowardZero(side ? surface : -surface);
  child.Clearance = RoundUp(std::min(spheres, side ? surface : -surface));
  child.Bound = RoundUp(child.Clearance + diagonal);
  child.Pruned = !(child.Bound > this->MinimumRadius);
  return nearest;
}

//------------------------------------------------------------------------------
void ClearanceTree::FindBound(const Cell& parent,
  const std::array<TriangleTree::Nearest, 8>& nearest, int number, Cell& child) const
{
  const double reach = ReachOf(child);
  ClearanceBound bound(child.HalfDiagonal());
  for (const std::int32_t i : parent.Near)
  {
    const PackedSphere& sphere = this->Packed[i];
    const Vector3 offset = child.Center - sphere.Center;
    const double length = Length(offset);
    if (length - sphere.Radius < reach)
    {
      child.Near.Add(i);
      bound.Add(offset, length, sphere.Radius);
    }
  }
  child.Bound = std::min(child.Bound, RoundUp(bound.Value()));
  child.Pruned = !(child.Bound > this->MinimumRadius);
  if (child.Pruned)
  {
    child.Near.Clear();
    return;
  }
  this->AddSiblingPlanes(child, nearest, number, bound);
  float estimate = RoundUp(bound.Value());
  if (nearest[number].Triangle >= 0)
  {
    estimate = std::min(estimate, this->EstimateBySurface(child, nearest[number], bound));
  }
  // Above the minimum radius: an estimate puts other leaves first, but prunes none.
  child.Bound = std::min(
    child.Bound, std::max({ estimate, child.Clearance, RoundUp(1.001 * this->MinimumRadius) }));
}

//------------------------------------------------------------------------------
// The triangle that is nearest to a sibling may be the other wall of a gap.
void ClearanceTree::AddSiblingPlanes(const Cell& cell,
  const std::array<TriangleTree::Nearest, 8>& nearest, int number, ClearanceBound& bound) const
{
  const double reach = ReachOf(cell);
  for (int other = 0; other < 8 && cell.SurfaceDistance > 0.0f; ++other)
  {
    const std::int32_t triangle = nearest[other].Triangle;
    if (triangle >= 0 && triangle != nearest[number].Triangle)
    {
      bool inside;
      const TriangleTree::Nearest on = this->Surface.NearestOn(triangle, cell.Center, inside);
      const Vector3 offset = cell.Center - on.Point;
      const double distance = Length(offset);
      if (inside && distance < reach && distance > cell.HalfDiagonal())
      {
        bound.AddPlane((1.0 / distance) * offset, distance);
      }
    }
  }
}

//------------------------------------------------------------------------------
float ClearanceTree::EstimateBySurface(
  const Cell& cell, const TriangleTree::Nearest& nearest, const ClearanceBound& others) const
{
  const double length = Length(cell.Center - nearest.Point);
  if (!(length > 0.0))
  {
    return cell.Bound;
  }
  const double distance = cell.SurfaceDistance > 0.0f ? length : -length;
  const Vector3 inwards = (1.0 / distance) * (cell.Center - nearest.Point);
  ClearanceBound bound = others;
  bound.AddPlane(inwards, distance);
  float estimate = RoundUp(bound.Value());
  const double beyond = cell.HalfDiagonal() - distance;
  if (estimate < cell.Bound && beyond > 0.0)
  {
    // A part of the cell lies beyond the plane. Where that is inside, too, behind another sheet of
    // the surface, the clearance grows the other way.
    if (this->Surface.IsInside(nearest.Point - (0.7 * beyond) * inwards))
    {
      bound = others;
      bound.AddPlane(-1.0 * inwards, -distance);
      estimate = std::max(estimate, RoundUp(bound.Value()));
    }
  }
  return estimate;
}

//------------------------------------------------------------------------------
void ClearanceTree::RefreshBound(std::int32_t leaf)
{
  Cell& cell = this->At(leaf);
  if (cell.Stale)
  {
    ClearanceBound bound(cell.HalfDiagonal());
    for (const std::int32_t i : cell.Near)
    {
      const PackedSphere& sphere = this->Packed[i];
      const Vector3 offset = cell.Center - sphere.Center;
      bound.Add(offset, Length(offset), sphere.Radius);
    }
    cell.Bound = std::min(cell.Bound, RoundUp(bound.Value()));
    cell.Bound = std::min(cell.Bound, RoundUp(cell.Clearance + cell.HalfDiagonal()));
    cell.Stale = false;
  }
}

//------------------------------------------------------------------------------
std::int32_t ClearanceTree::Install(std::int32_t leaf, Octet&& children)
{
  std::int32_t block;
  if (this->FreeBlocks.empty())
  {
    block = static_cast<std::int32_t>(this->Blocks.size());
    this->Blocks.emplace_back(new Octet);
  }
  else
  {
    block = this->FreeBlocks.back();
    this->FreeBlocks.pop_back();
  }
  for (int i = 0; i < 8; ++i)
  {
    Cell& to = (*this->Blocks[block])[i];
    const std::uint32_t generation = to.Generation + 1;
    to = std::move(children[i]);
    to.Generation = generation;
  }
  Cell& parent = this->At(leaf);
  parent.Child = 8 * block;
  parent.Near.Clear();
  return parent.Child;
}

//------------------------------------------------------------------------------
ClearanceTree::Sample ClearanceTree::SampleAt(const Vector3& point, std::int32_t guess) const
{
  std::int32_t at = 0;
  while ((*this)[at].Child >= 0)
  {
    const Vector3& center = (*this)[at].Center;
    at = (*this)[at].Child + (point.X > center.X ? 1 : 0) + (point.Y > center.Y ? 2 : 0) +
      (point.Z > center.Z ? 4 : 0);
  }
  const Cell& leaf = (*this)[at];
  Sample sample;
  sample.Leaf = at;
  sample.Clearance = Infinity;
  const Vector3 offset = point - leaf.Center;
  if (leaf.Pruned ||
    std::max(std::max(std::abs(offset.X), std::abs(offset.Y)), std::abs(offset.Z)) > leaf.HalfSide)
  {
    sample.Clearance = 0.0;
    return sample;
  }
  for (const std::int32_t i : leaf.Near)
  {
    sample.Clearance = std::min(sample.Clearance, DistanceTo(this->Packed[i], point));
  }
  const double bound = std::abs(leaf.SurfaceDistance) - Length(offset);
  const bool inside = bound > 0.0 ? leaf.SurfaceDistance > 0.0 : this->Surface.IsInside(point);
  if (!inside)
  {
    sample.Clearance = 0.0;
    return sample;
  }
  if (bound < sample.Clearance)
  {
    TriangleTree::Nearest nearest;
    nearest.Triangle = guess;
    sample.BySurface = this->Surface.FindNearest(point, sample.Clearance, nearest);
    sample.Nearest = nearest;
  }
  return sample;
}

//------------------------------------------------------------------------------
void ClearanceTree::Insert(const PackedSphere& sphere)
{
  this->Packed.push_back(sphere);
  this->InsertBelow(0, sphere);
}

//------------------------------------------------------------------------------
bool ClearanceTree::InsertBelow(std::int32_t at, const PackedSphere& sphere)
{
  Cell& cell = this->At(at);
  if (cell.Pruned)
  {
    return true;
  }
  const double distance = DistanceTo(sphere, cell.Center);
  if (!(distance < ReachOf(cell)))
  {
    return false;
  }
  cell.Clearance = std::min(cell.Clearance, RoundUp(distance));
  cell.Pruned = !(cell.Clearance + cell.HalfDiagonal() > this->MinimumRadius);
  if (cell.Child >= 0)
  {
    bool pruned = true;
    const std::int32_t first = cell.Child;
    for (std::int32_t child = first; child < first + 8; ++child)
    {
      pruned = this->InsertBelow(child, sphere) && pruned;
    }
    cell.Pruned = pruned;
    if (pruned)
    {
      this->FreeBlocks.push_back(first / 8);
      cell.Child = -1;
    }
  }
  else if (cell.Pruned)
  {
    cell.Near.Clear();
  }
  else
  {
    cell.Stale = true;
    cell.Near.Add(static_cast<std::int32_t>(this->Packed.size()) - 1);
  }
  return cell.Pruned;
}
}
