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

double DistanceTo(const PackedSphere& sphere, const Vector3& place)
{
  return Length(place - sphere.Center) - sphere.Radius;
}

// Bounds are kept in single precision, rounded to the side on which they stay bounds.
float Above(double bound)
{
  const auto rounded = static_cast<float>(bound);
  return rounded < bound ? std::nextafter(rounded, std::numeric_limits<float>::infinity())
                         : rounded;
}

float TowardsZero(double distance)
{
  const auto rounded = static_cast<float>(distance);
  return std::abs(rounded) > std::abs(distance) ? std::nextafter(rounded, 0.0f) : rounded;
}

Vector3 MiddleOfChild(const Vector3& middle, double half, int child)
{
  return { middle.X + (child & 1 ? half : -half), middle.Y + (child & 2 ? half : -half),
    middle.Z + (child & 4 ? half : -half) };
}
}

//------------------------------------------------------------------------------
ClearanceTree::ClearanceTree(
  const TriangleTree& surface, const Vector3& middle, float half, double least)
  : Surface(surface)
  , Least(least)
{
  this->Blocks.emplace_back(new Eight);
  Cell& root = this->Of(0);
  root.Middle = middle;
  root.Half = half;
  double distance = Infinity;
  TriangleTree::Nearest nearest;
  surface.Closest(middle, distance, nearest);
  distance = surface.IsInside(middle) ? distance : -distance;
  root.Surface = TowardsZero(distance);
  root.Clearance = Above(distance);
  root.Bound = Above(root.Clearance + root.Diagonal());
}

//------------------------------------------------------------------------------
ClearanceTree::Eight ClearanceTree::Split(std::int32_t leaf) const
{
  const Cell& parent = (*this)[leaf];
  Eight children;
  std::array<TriangleTree::Nearest, 8> nearest;
  for (int i = 0; i < 8; ++i)
  {
    Cell& child = children[i];
    child.Half = 0.5f * parent.Half;
    child.Middle = MiddleOfChild(parent.Middle, child.Half, i);
    nearest[i] = this->Measure(parent, i > 0 ? nearest[i - 1].Triangle : -1, child);
  }
  for (int i = 0; i < 8; ++i)
  {
    if (!children[i].Dead)
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
    spheres = std::min(spheres, DistanceTo(this->Packed[i], child.Middle));
  }
  const double diagonal = child.Diagonal();
  TriangleTree::Nearest nearest;
  child.Dead = !(spheres + diagonal > this->Least);
  if (child.Dead)
  {
    return nearest;
  }
  // The middles of parent and child are half of the child's diagonal apart.
  const double bound = std::abs(parent.Surface) - diagonal;
  const bool side = bound > 0.0 ? parent.Surface > 0.0 : this->Surface.IsInside(child.Middle);
  double surface = bound;
  if (!(bound > (side ? spheres : diagonal)))
  {
    surface = std::max(spheres, diagonal);
    nearest.Triangle = guess;
    if (!this->Surface.Closest(child.Middle, surface, nearest))
    {
      nearest.Triangle = -1;
    }
  }
  child.Surface = TowardsZero(side ? surface : -surface);
  child.Clearance = Above(std::min(spheres, side ? surface : -surface));
  child.Bound = Above(child.Clearance + diagonal);
  child.Dead = !(child.Bound > this->Least);
  return nearest;
}

//------------------------------------------------------------------------------
void ClearanceTree::FindBound(const Cell& parent,
  const std::array<TriangleTree::Nearest, 8>& nearest, int number, Cell& child) const
{
  const double diagonal = child.Diagonal();
  const double most = child.Clearance + 2.0 * diagonal;
  ClearanceBound clearances(diagonal);
  for (const std::int32_t i : parent.Near)
  {
    const PackedSphere& sphere = this->Packed[i];
    const Vector3 away = child.Middle - sphere.Center;
    const double length = Length(away);
    if (length - sphere.Radius < most)
    {
      child.Near.Add(i);
      clearances.Add(away, length, sphere.Radius);
    }
  }
  child.Bound = std::min(child.Bound, Above(clearances.Value()));
  child.Dead = !(child.Bound > this->Least);
  if (child.Dead)
  {
    child.Near.Clear();
    return;
  }
  // What is nearest to its neighbours may lie on the other side of it.
  for (int other = 0; other < 8 && child.Surface > 0.0f; ++other)
  {
    const std::int32_t triangle = nearest[other].Triangle;
    if (triangle >= 0 && triangle != nearest[number].Triangle)
    {
      bool inside;
      const TriangleTree::Nearest on = this->Surface.ClosestOn(triangle, child.Middle, inside);
      const Vector3 away = child.Middle - on.Point;
      const double distance = Length(away);
      if (inside && distance < most && distance > diagonal)
      {
        clearances.AddPlane((1.0 / distance) * away, distance);
      }
    }
  }
  float guess = Above(clearances.Value());
  if (nearest[number].Triangle >= 0)
  {
    guess = std::min(guess, this->GuessBySurface(child, nearest[number], clearances));
  }
  // A guess only says that others come first.
  child.Bound =
    std::min(child.Bound, std::max({ guess, child.Clearance, Above(1.001 * this->Least) }));
}

//------------------------------------------------------------------------------
float ClearanceTree::GuessBySurface(
  const Cell& cell, const TriangleTree::Nearest& nearest, const ClearanceBound& others) const
{
  const double length = Length(cell.Middle - nearest.Point);
  if (!(length > 0.0))
  {
    return cell.Bound;
  }
  const double distance = cell.Surface > 0.0f ? length : -length;
  const Vector3 inwards = (1.0 / distance) * (cell.Middle - nearest.Point);
  ClearanceBound clearances = others;
  clearances.AddPlane(inwards, distance);
  float guess = Above(clearances.Value());
  const double beyond = cell.Diagonal() - distance;
  if (guess < cell.Bound && beyond > 0.0)
  {
    // Some places of the cell lie beyond the triangle's plane. Where these are inside, too, behind
    // another sheet of the surface, their distance grows the other way.
    if (this->Surface.IsInside(nearest.Point - (0.7 * beyond) * inwards))
    {
      clearances = others;
      clearances.AddPlane(-1.0 * inwards, -distance);
      guess = std::max(guess, Above(clearances.Value()));
    }
  }
  return guess;
}

//------------------------------------------------------------------------------
void ClearanceTree::Refresh(std::int32_t leaf)
{
  Cell& cell = this->Of(leaf);
  if (cell.Stale)
  {
    ClearanceBound clearances(cell.Diagonal());
    for (const std::int32_t i : cell.Near)
    {
      const PackedSphere& sphere = this->Packed[i];
      const Vector3 away = cell.Middle - sphere.Center;
      clearances.Add(away, Length(away), sphere.Radius);
    }
    cell.Bound = std::min(cell.Bound, Above(clearances.Value()));
    cell.Bound = std::min(cell.Bound, Above(cell.Clearance + cell.Diagonal()));
    cell.Stale = false;
  }
}

//------------------------------------------------------------------------------
std::int32_t ClearanceTree::Install(std::int32_t leaf, Eight&& children)
{
  std::int32_t block;
  if (this->Free.empty())
  {
    block = static_cast<std::int32_t>(this->Blocks.size());
    this->Blocks.emplace_back(new Eight);
  }
  else
  {
    block = this->Free.back();
    this->Free.pop_back();
  }
  for (int i = 0; i < 8; ++i)
  {
    Cell& to = (*this->Blocks[block])[i];
    const std::uint32_t birth = to.Birth + 1;
    to = std::move(children[i]);
    to.Birth = birth;
  }
  Cell& parent = this->Of(leaf);
  parent.Child = 8 * block;
  parent.Near.Clear();
  return parent.Child;
}

//------------------------------------------------------------------------------
ClearanceTree::Found ClearanceTree::At(const Vector3& place, std::int32_t guess) const
{
  std::int32_t at = 0;
  while ((*this)[at].Child >= 0)
  {
    const Vector3& middle = (*this)[at].Middle;
    at = (*this)[at].Child + (place.X > middle.X ? 1 : 0) + (place.Y > middle.Y ? 2 : 0) +
      (place.Z > middle.Z ? 4 : 0);
  }
  const Cell& leaf = (*this)[at];
  Found found;
  found.Leaf = at;
  found.Clearance = Infinity;
  const Vector3 away = place - leaf.Middle;
  if (leaf.Dead ||
    std::max(std::max(std::abs(away.X), std::abs(away.Y)), std::abs(away.Z)) > leaf.Half)
  {
    found.Clearance = 0.0;
    return found;
  }
  for (const std::int32_t i : leaf.Near)
  {
    found.Clearance = std::min(found.Clearance, DistanceTo(this->Packed[i], place));
  }
  const double bound = std::abs(leaf.Surface) - Length(away);
  const bool inside = bound > 0.0 ? leaf.Surface > 0.0 : this->Surface.IsInside(place);
  if (!inside)
  {
    found.Clearance = 0.0;
    return found;
  }
  if (bound < found.Clearance)
  {
    TriangleTree::Nearest nearest;
    nearest.Triangle = guess;
    found.BySurface = this->Surface.Closest(place, found.Clearance, nearest);
    found.Nearest = nearest;
  }
  return found;
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
  Cell& cell = this->Of(at);
  if (cell.Dead)
  {
    return true;
  }
  // Elsewhere something else is nearer to all places of the cell.
  const double distance = DistanceTo(sphere, cell.Middle);
  if (!(distance < cell.Clearance + 2.0 * cell.Diagonal()))
  {
    return false;
  }
  cell.Clearance = std::min(cell.Clearance, Above(distance));
  cell.Dead = !(cell.Clearance + cell.Diagonal() > this->Least);
  if (cell.Child >= 0)
  {
    bool dead = true;
    const std::int32_t first = cell.Child;
    for (std::int32_t child = first; child < first + 8; ++child)
    {
      dead = this->InsertBelow(child, sphere) && dead;
    }
    cell.Dead = dead;
    if (dead)
    {
      this->Free.push_back(first / 8);
      cell.Child = -1;
    }
  }
  else if (cell.Dead)
  {
    cell.Near.Clear();
  }
  else
  {
    cell.Stale = true;
    cell.Near.Add(static_cast<std::int32_t>(this->Packed.size()) - 1);
  }
  return cell.Dead;
}
}
