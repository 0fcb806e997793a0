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

/// An octree over the clearance, for a branch-and-bound search of its maxima.
///
/// The clearance of a point is the radius of the largest free sphere about it: the distance to the
/// surface, negative outside, or to the nearest packed sphere, if that is smaller. It is Lipschitz
/// continuous with constant 1, so that of no point in a cell is above that of the cell's centre
/// plus half of the cell's diagonal. The spheres around a cell give a lower bound, see
/// ClearanceBound, and the surface gives an estimate, see EstimateBySurface().
///
/// A leaf lists the spheres that may be the nearest to a point in it. Leaves without a clearance
/// above the minimum radius are pruned; eight of them make their parent a pruned leaf.
class ClearanceTree
{
public:
  struct Cell
  {
    Vector3 Center;
    float HalfSide = 0.0f;
    float SurfaceDistance = 0.0f; ///< of the centre or nearer to 0, negative outside
    float Clearance = 0.0f;       ///< of the centre or above
    float Bound = 0.0f;           ///< of all clearances, or their estimate if that is lower
    std::int32_t Child = -1;      ///< the first of eight, or -1 in a leaf
    // There are millions of cells: these have 32 bits together.
    std::uint32_t Generation : 30; ///< changes when the memory is used for another cell
    std::uint32_t Pruned : 1;
    std::uint32_t Stale : 1; ///< whether spheres have been inserted since the bound was found
    IdList Near;             ///< spheres that may be the nearest, of a leaf

    Cell()
      : Generation(0)
      , Pruned(false)
      , Stale(false)
    {
    }

    /// The radius of the ball around the cell.
    double HalfDiagonal() const { return 1.7320508075688774 * this->HalfSide; }
  };
  using Octet = std::array<Cell, 8>;

  /// The clearance of a point, and what it was found from.
  struct Sample
  {
    double Clearance;
    std::int32_t Leaf = -1;
    bool BySurface = false;        ///< whether the surface is nearer than the spheres
    TriangleTree::Nearest Nearest; ///< on the surface if so
  };

  /// Leaves are pruned unless a sphere of a radius above `minimumRadius` may fit.
  ClearanceTree(
    const TriangleTree& surface, const Vector3& center, float halfSide, double minimumRadius);

  const Cell& operator[](std::int32_t cell) const { return (*this->Blocks[cell >> 3])[cell & 7]; }

  /// Whether `cell` is a leaf that is not pruned, and still the one of that generation.
  bool IsLeaf(std::int32_t cell, std::uint32_t generation) const
  {
    const Cell& at = (*this)[cell];
    return at.Generation == generation && at.Child < 0 && !at.Pruned;
  }
  const std::vector<PackedSphere>& Spheres() const { return this->Packed; }

  /// Finds the bound of a leaf anew if spheres have been inserted since.
  void RefreshBound(std::int32_t leaf);

  /// Returns the octants of a leaf; changes nothing, so threads may share the tree.
  Octet Split(std::int32_t leaf) const;

  /// Makes the octants of a leaf its children, and returns the first.
  std::int32_t Install(std::int32_t leaf, Octet&& children);

  /// Finds the clearance of a point. Where that is not above the minimum radius, any value up to
  /// the minimum radius is returned. `guess` is a triangle that may be the nearest, or -1.
  Sample SampleAt(const Vector3& point, std::int32_t guess) const;

  void Insert(const PackedSphere& sphere);

private:
  Cell& At(std::int32_t cell) { return (*this->Blocks[cell >> 3])[cell & 7]; }
  TriangleTree::Nearest Measure(const Cell& parent, std::int32_t guess, Cell& child) const;
  void FindBound(const Cell& parent, const std::array<TriangleTree::Nearest, 8>& nearest,
    int number, Cell& child) const;
  void AddSiblingPlanes(const Cell& cell, const std::array<TriangleTree::Nearest, 8>& nearest,
    int number, ClearanceBound& bound) const;

  /// Estimates the largest clearance in a cell from the plane of its nearest triangle, besides
  /// `others`, which the cell has around it.
  ///
  /// With p the surface's nearest point to the centre, d its distance and n the direction from it,
  /// the distance to p alone bounds the clearance at an offset u by d + n.u + |u|^2 / (2 d). Next
  /// to the surface d is smaller than the cell, the last term large, and every leaf along a gap
  /// looks as if a sphere of its size fitted. The surface taken for a plane has not this term: its
  /// distance is d + n.u, and together with the plane of the other wall, which has the opposite n,
  /// it gives about half the width of the gap, while leaves are still as large as that.
  ///
  /// This is no bound: around an edge or a spike that points into the solid, the clearance grows
  /// along the plane, too. Therefore no leaf is pruned by it, it only has to wait for others, and
  /// an estimate is no lower than the clearance at the centre. Each split halves the cell, so the
  /// error goes to 0 with the cell's size, and a maximum is found once the bounds of others have
  /// come down to it. The price is that a sphere may be preferred to a larger one, see PackSpheres.
  float EstimateBySurface(
    const Cell& cell, const TriangleTree::Nearest& nearest, const ClearanceBound& others) const;

  bool InsertBelow(std::int32_t cell, const PackedSphere& sphere);

  const TriangleTree& Surface;
  const double MinimumRadius;
  std::vector<std::unique_ptr<Octet>> Blocks;
  std::vector<std::int32_t> FreeBlocks;
  std::vector<PackedSphere> Packed;
};
}

#endif
