// SPDX-License-Identifier: BSD-3-Clause
#ifndef TriangleTree_h
#define TriangleTree_h

#include "packer/SurfaceMesh.h"

namespace spherepacking
{
struct AxisRay;

/// A bounding volume hierarchy of triangles: nearest points, and what is inside of them.
///
/// Unlike Bvh, which rays traverse in single precision, it is searched by distance in double
/// precision, and its nodes have dipoles for winding numbers.
class TriangleTree
{
public:
  explicit TriangleTree(const SurfaceMesh& mesh);

  /// A point of a triangle.
  struct Nearest
  {
    Vector3 Point;
    std::int32_t Triangle = -1; ///< in the order of the tree
  };

  /// Whether a triangle is nearer to a point than `distance`, which becomes that to the nearest. If
  /// `nearest` has a triangle, that is tried first: a good guess prunes most of the search.
  bool FindNearest(const Vector3& point, double& distance, Nearest& nearest) const;

  /// The nearest point of one triangle; `inside` becomes whether its normal points away from
  /// `point`.
  Nearest NearestOn(std::int32_t triangle, const Vector3& point, bool& inside) const;

  /// Of length 1, outwards if the triangle is oriented outwards.
  Vector3 NormalOf(std::int32_t triangle) const;

  /// Whether a point is inside a surface that is oriented outwards, that is whether its generalised
  /// winding number is above 0.5. The tree must have triangles.
  ///
  /// The winding number of a closed surface is the sum of the signed crossings of a ray from the
  /// point. A surface with a few unbalanced edges is first closed by caps, a fan of triangles over
  /// these edges, of which the winding number, found by their solid angles, is taken off again.
  /// Where rounding leaves a crossing in doubt, another ray is cast, and WindingNumber() decides if
  /// all three are in doubt or there are too many unbalanced edges.
  /// Source: Martens and Bessmeltsev, "One-shot method for computing generalized winding numbers"
  /// (2025).
  bool IsInside(const Vector3& point) const;

  /// The generalised winding number: how often the surface winds around a point, 1 inside and 0
  /// outside of one that is closed and oriented outwards. Near open edges, or triangles that are
  /// oriented inwards, it lies in between.
  ///
  /// A node that is farther away than beta times its radius counts as a dipole; beta doubles until
  /// the error leaves no doubt whether the sum is above 0.5. The number itself is therefore only
  /// good to about 0.15, times how often the surface covers the sphere of directions.
  /// Sources: Jacobson, Kavan and Sorkine-Hornung, "Robust inside-outside segmentation using
  /// generalized winding numbers" (2013); Barill, Dickson, Schmidt, Levin and Jacobson, "Fast
  /// winding numbers for soups and clouds" (2018).
  double WindingNumber(const Vector3& point) const;

private:
  struct Node
  {
    double Low[3];
    double High[3];
    Vector3 Centroid;    ///< weighted by area
    Vector3 Area;        ///< the dipole moment: sum of the normals times the areas
    double Radius = 0.0; ///< of a ball around the triangles, about the centroid
    std::int32_t First = 0;
    std::int32_t Count = 0;
    std::int32_t Child = -1; ///< the second; the first is the next node
  };
  struct Corners
  {
    Vector3 Of[3];
  };

  /// A triangle that closes the surface at an unbalanced edge.
  struct Cap
  {
    Corners Triangle;
    int Multiplicity; ///< negative if it is oriented the other way
  };

  static constexpr int MaximumDepth = 64; ///< nodes are split in half by count

  std::array<AxisRay, 3> ShortestRays(const Vector3& point) const;
  void MakeCaps(const SurfaceMesh& mesh);
  bool SumCrossings(const AxisRay& ray, int& sum) const;
  double SumSolidAngles(const Vector3& point, double beta, double& dipoles) const;
  std::int32_t Build(std::int32_t first, std::int32_t count);
  void Measure(Node& node) const;
  static double SquaredDistanceToBox(const Node& node, const Vector3& point);

  std::vector<Cap> Caps;
  bool IsCapped = false;
  std::vector<Corners> Triangles;
  std::vector<Node> Nodes;
};

/// The point of a triangle that is nearest to `point`.
/// Source: Ericson, "Real-time collision detection" (2005), section 5.1.5.
Vector3 NearestOnTriangle(const Vector3& point, const Vector3 (&corners)[3]);

/// The solid angle of a triangle seen from a point, over 4 pi; positive from behind.
/// Source: Van Oosterom and Strackee, "The solid angle of a plane triangle" (1983).
double SolidAngle(const Vector3& point, const Vector3 (&corners)[3]);
}

#endif
