// SPDX-License-Identifier: BSD-3-Clause
#ifndef TriangleTree_h
#define TriangleTree_h

#include "packer/SurfaceMesh.h"

namespace spherepacking
{
struct AxisLine;

/// Distances to triangles, and on which side of them a place lies, through a tree of boxes.
class TriangleTree
{
public:
  explicit TriangleTree(const SurfaceMesh& mesh);

  struct Nearest
  {
    Vector3 Point;
    std::int32_t Triangle = -1; ///< in the order of the tree
  };

  /// Whether a triangle is nearer than `distance`, which becomes that of the nearest, and its
  /// nearest point. If `nearest` has a triangle, that is looked at first: a good guess saves time.
  bool Closest(const Vector3& place, double& distance, Nearest& nearest) const;

  /// The nearest point of one triangle, and whether the place is on the triangle's inner side.
  Nearest ClosestOn(std::int32_t triangle, const Vector3& place, bool& inside) const;

  /// Of length 1, outwards if the triangle is turned outwards.
  Vector3 NormalOf(std::int32_t triangle) const;

  /// Whether a place lies inside of a surface that is turned outwards: whether its winding number
  /// is above 0.5.
  ///
  /// Of a closed surface that is how often half a line from the place leaves it, less how often it
  /// enters. Where a few edges have not as many triangles that go one way as such that go the
  /// other, caps close the surface, and what they add is taken off again. What rounding leaves in
  /// doubt is left to another line and, in the end, to WindingNumber(), and so are surfaces that
  /// have many such edges. There are triangles.
  /// Source: Martens and Bessmeltsev, "One-shot method for computing generalized winding numbers"
  /// (2025).
  bool IsInside(const Vector3& place) const;

  /// How often the surface goes around a place: 1 inside and 0 outside of one that is closed and
  /// turned outwards. Near to open edges, or to triangles that are turned the wrong way, it is in
  /// between.
  ///
  /// Groups of triangles that are far away, compared with their size, count as one dipole, from
  /// farther away as long as that leaves in doubt whether it is above 0.5. So it is right to about
  /// 0.15 for each time that the surface is seen, and no more than that.
  /// Sources: Jacobson, Kavan and Sorkine-Hornung, "Robust inside-outside segmentation using
  /// generalized winding numbers" (2013); Barill, Dickson, Schmidt, Levin and Jacobson, "Fast
  /// winding numbers for soups and clouds" (2018).
  double WindingNumber(const Vector3& place) const;

private:
  struct Node
  {
    double Low[3];
    double High[3];
    Vector3 Middle;      ///< of the triangles' areas
    Vector3 Area;        ///< sum of the triangles' areas times their normals
    double Radius = 0.0; ///< of a ball about the middle
    std::int32_t First = 0;
    std::int32_t Count = 0;
    std::int32_t Child = -1; ///< the second; the first comes next
  };
  struct Corners
  {
    Vector3 Of[3];
  };

  // A triangle that counts so many times.
  struct Cap
  {
    Corners Triangle;
    int Times;
  };

  static constexpr int MostDepth = 64; ///< nodes are halved by their number

  std::array<AxisLine, 3> ShortestLines(const Vector3& place) const;
  void MakeCaps(const SurfaceMesh& mesh);
  bool SumCrossings(const AxisLine& line, int& turns) const;
  double SumAngles(const Vector3& place, double far, double& dipoles) const;
  std::int32_t Build(std::int32_t first, std::int32_t count);
  void Measure(Node& node) const;
  static double SquareToBox(const Node& node, const Vector3& place);

  std::vector<Cap> Caps;
  bool IsCapped = false;
  std::vector<Corners> Triangles;
  std::vector<Node> Nodes;
};

/// The point of a triangle that is nearest to a place.
/// Source: Ericson, "Real-time collision detection" (2005), section 5.1.5.
Vector3 ClosestOnTriangle(const Vector3& place, const Vector3 (&corners)[3]);

/// The solid angle of a triangle seen from a place, over 4 pi; positive from behind.
/// Source: Van Oosterom and Strackee, "The solid angle of a plane triangle" (1983).
double SolidAngle(const Vector3& place, const Vector3 (&corners)[3]);
}

#endif
