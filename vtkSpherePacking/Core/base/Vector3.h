// SPDX-License-Identifier: BSD-3-Clause
#ifndef Vector3_h
#define Vector3_h

#include <cmath>

namespace spherepacking
{
/// A vector for geometry that is written in vectors.
struct Vector3
{
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;

  double& operator[](int axis) { return axis == 0 ? this->X : axis == 1 ? this->Y : this->Z; }
  double operator[](int axis) const { return axis == 0 ? this->X : axis == 1 ? this->Y : this->Z; }
};

inline Vector3 operator+(const Vector3& a, const Vector3& b)
{
  return { a.X + b.X, a.Y + b.Y, a.Z + b.Z };
}

inline Vector3 operator-(const Vector3& a, const Vector3& b)
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}

inline Vector3 operator*(double s, const Vector3& a)
{
  return { s * a.X, s * a.Y, s * a.Z };
}

inline double Dot(const Vector3& a, const Vector3& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}

inline Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}

inline double Length(const Vector3& a)
{
  return std::sqrt(Dot(a, a));
}

/// A vector for loops over its axes, as a member of arrays that processors load at once.
using Double3 = double[3];

inline double Dot(const Double3& a, const Double3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline void Cross(const Double3& a, const Double3& b, Double3& result)
{
  result[0] = a[1] * b[2] - a[2] * b[1];
  result[1] = a[2] * b[0] - a[0] * b[2];
  result[2] = a[0] * b[1] - a[1] * b[0];
}
}

#endif
