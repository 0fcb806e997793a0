// SPDX-License-Identifier: BSD-3-Clause
#ifndef ClearanceTree_h
#define ClearanceTree_h

#include "packer/ClearanceBound.h"
#include "packer/IdList.h"
#include "packer/TriangleTree.h"

#include <array>
#include <memory>

namespace spherepacking
{
struct PackedSphere
{
  Vector3 Center;
  double Radius;
};

/// How large a sphere about a place may be: an octree over the clearance.
///
/// The clearance of a place is the distance to the surface, negative outside, or to the nearest
/// sphere, if that is less. It changes by no more than the way between two places, so nowhere in a
/// cell it is above that of the cell's middle plus half of the cell's diagonal: its bound. The
/// spheres around it, see ClearanceBound, and the surface make it lower, where the surface is taken
/// for the planes of its nearest triangles; for that reason alone no leaf dies. A leaf lists the
/// spheres that may be the nearest to a place in it. Leaves whose bound is not above the least
/// radius are dead; eight of them make their parent a dead leaf.
class ClearanceTree
{
public:
  struct Cell
  {
    Vector3 Middle;
    float Half = 0.0f;      ///< of a side
    float Surface = 0.0f;   ///< no more than the distance to the surface, negative outside
    float Clearance = 0.0f; ///< of the middle, or a little more
    float Bound = 0.0f;     ///< of all clearances in it
    std::int32_t Child = -1;
    // There are millions of cells: these share a word.
    std::uint32_t Birth : 30; ///< changes when another cell takes the place of this
    std::uint32_t Dead : 1;
    std::uint32_t Stale : 1; ///< whether spheres have come since the bound was found
    IdList Near;

    Cell()
      : Birth(0)
      , Dead(false)
      , Stale(false)
    {
    }
    double Diagonal() const { return 1.7320508075688774 * this->Half; } ///< half of it
  };
  using Eight = std::array<Cell, 8>;

  /// What At() finds: a clearance, and what it was found from.
  struct Found
  {
    double Clearance;
    std::int32_t Leaf = -1;
    bool BySurface = false;
    TriangleTree::Nearest Nearest; ///< on the surface, where that is nearer than the spheres
  };

  /// Spheres are wanted with radii above `least`.
  ClearanceTree(const TriangleTree& surface, const Vector3& middle, float half, double least);

  const Cell& operator[](std::int32_t cell) const { return (*this->Blocks[cell >> 3])[cell & 7]; }
  bool IsLeaf(std::int32_t cell, std::uint32_t birth) const
  {
    const Cell& at = (*this)[cell];
    return at.Birth == birth && at.Child < 0 && !at.Dead;
  }
  const std::vector<PackedSphere>& Spheres() const { return this->Packed; }

  /// Finds the bound of a leaf anew if spheres have come since.
  void Refresh(std::int32_t leaf);

  /// The eight parts of a leaf; changes nothing, so threads may share the tree.
  Eight Split(std::int32_t leaf) const;

  /// Makes them the children of that leaf, and returns the first.
  std::int32_t Install(std::int32_t leaf, Eight&& children);

  /// At a place where spheres are too large for the least radius, anything that is not above it.
  /// `guess` is a triangle that may be the nearest, or -1.
  Found At(const Vector3& place, std::int32_t guess) const;

  void Insert(const PackedSphere& sphere);

private:
  Cell& Of(std::int32_t cell) { return (*this->Blocks[cell >> 3])[cell & 7]; }
  TriangleTree::Nearest Measure(const Cell& parent, std::int32_t guess, Cell& child) const;
  void FindBound(const Cell& parent, const std::array<TriangleTree::Nearest, 8>& nearest,
    int number, Cell& child) const;
  float GuessBySurface(
    const Cell& cell, const TriangleTree::Nearest& nearest, const ClearanceBound& others) const;
  bool InsertBelow(std::int32_t cell, const PackedSphere& sphere);

  const TriangleTree& Surface;
  const double Least;
  std::vector<std::unique_ptr<Eight>> Blocks;
  std::vector<std::int32_t> Free; ///< blocks
  std::vector<PackedSphere> Packed;
};
}

#endif
