// SPDX-License-Identifier: BSD-3-Clause
/// The paths of a block of pixels on their way from sphere to sphere.
#ifndef PathBlock_h
#define PathBlock_h

#include "light/Hemisphere.h"
#include "light/TracePaths.h"
#include "trace/TraceBvhStream.h"

#include <array>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// A path on its way, at the outside of a sphere.
struct Path
{
  Vector Point;
  Vector Normal;
  std::int64_t Id;
  float Weight[3]; ///< what light counts that goes from here to the camera
  float Radiance[3];
  float FirstAlbedo[3];
  float FirstNormal[3];
  std::uint64_t Seed;  ///< of the pixel
  std::uint32_t Index; ///< of the sample
  int Ray;             ///< of the block

  /// Puts the path on a sphere, where its normal is `Normal`.
  void Start(const Sphere& sphere, std::int64_t id)
  {
    // From the sphere, which keeps its digits however far the ray has come.
    this->Point[0] = sphere.X + sphere.R * this->Normal[0];
    this->Point[1] = sphere.Y + sphere.R * this->Normal[1];
    this->Point[2] = sphere.Z + sphere.R * this->Normal[2];
    this->Id = id;
  }
};

/// Follows the paths of a block, all from sphere to sphere at the same time.
class PathBlock
{
public:
  Path Paths[RayStream::Maximum];
  int Count = 0;

  PathBlock(const Scene& scene, const PathLight& light)
    : In(scene)
    , Light(light)
  {
    // Colours are sRGB (IEC 61966-2-1).
    for (std::size_t i = 0; i < this->Linear.size(); ++i)
    {
      const double x = static_cast<double>(i) / 255.0;
      const double linear = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
      this->Linear[i] = static_cast<float>(linear * light.Albedo);
    }
  }

  void AlbedoOf(std::int64_t id, float (&albedo)[3]) const
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      albedo[channel] = this->Linear[this->In.Colors[4 * id + channel]];
    }
  }

  /// Adds to the radiance of each path what comes from all later spheres, the sky and the sun.
  void Follow()
  {
    int active = 0;
    for (int i = 0; i < this->Count; ++i)
    {
      if (this->Paths[i].Id >= 0)
      {
        this->Active[active++] = i;
      }
    }
    for (int bounce = 1; bounce <= this->Light.MaxBounces && active > 0; ++bounce)
    {
      const int pair = PairsPerBounce * (bounce - 1);
      if (this->Light.Sun.Shines())
      {
        this->AddSun(active, pair + SunPair);
      }
      if (this->Light.Sky.CanSample())
      {
        this->AddSky(active, pair + SkyPair);
      }
      if (bounce > FirstBounces)
      {
        active = this->EndByChance(active, pair + RoulettePair);
      }
      active = this->GoOn(active, pair + DirectionPair, bounce == this->Light.MaxBounces);
    }
  }

private:
  // Pairs of a bounce; pair 0 is the point in the pixel, pair 1 hangs together with it.
  static constexpr int DirectionPair = 1;
  static constexpr int SunPair = 2;
  static constexpr int SkyPair = 3;
  static constexpr int RoulettePair = 4;
  static constexpr int PairsPerBounce = 4;
  static constexpr int FirstBounces = 3; // after which paths may be ended by chance
  static constexpr double InversePi = 0.3183098861837907;

  static Point2 PointOf(const Path& path, int pair)
  {
    return OwenSobol(path.Seed).At(path.Index, pair);
  }

  void Send(const Path& path, const Vector& d)
  {
    const int i = this->Stream.Count++;
    this->Stream.Rays[i] = { { path.Point[0], path.Point[1], path.Point[2] },
      { d[0], d[1], d[2] } };
    this->Stream.Left[i] = path.Id;
  }

  // Ends paths, or lets them count for those that were.
  int EndByChance(int active, int pair)
  {
    int left = 0;
    for (int k = 0; k < active; ++k)
    {
      Path& path = this->Paths[this->Active[k]];
      const float largest = std::max(path.Weight[0], std::max(path.Weight[1], path.Weight[2]));
      const float share = std::min(1.0f, largest);
      if (PointOf(path, pair).X < share)
      {
        for (float& channel : path.Weight)
        {
          channel /= share;
        }
        this->Active[left++] = this->Active[k];
      }
    }
    return left;
  }

  // Sends the paths to the next sphere, or after the last one to see whether there is any. Returns
  // how many arrive.
  int GoOn(int active, int pair, bool last)
  {
    this->Stream.Count = 0;
    for (int k = 0; k < active; ++k)
    {
      const Path& path = this->Paths[this->Active[k]];
      Vector d;
      CosineDirection(path.Normal, PointOf(path, pair), d);
      this->Send(path, d);
    }
    if (last)
    {
      this->Stream.Trace<true>(this->In);
    }
    else
    {
      this->Stream.Trace<false>(this->In);
    }
    for (int k = 0; k < active && !last; ++k)
    {
      __builtin_prefetch(this->In.Colors + 4 * std::max<std::int64_t>(this->Stream.Hits[k].Id, 0));
    }
    int left = 0;
    for (int k = 0; k < active; ++k)
    {
      Path& path = this->Paths[this->Active[k]];
      const Hit& hit = this->Stream.Hits[k];
      const Ray& ray = this->Stream.Rays[k];
      if (hit.Id < 0)
      {
        this->AddRadiance(path, ray.D, this->ChanceShare(path, ray.D));
      }
      else if (!last)
      {
        this->Move(path, ray, hit);
        this->Active[left++] = this->Active[k];
      }
    }
    return left;
  }

  void Move(Path& path, const Ray& ray, const Hit& hit) const
  {
    const Sphere& sphere = hit.On;
    NormalAt(ray, sphere, InverseSquare(ray), path.Normal);
    path.Start(sphere, hit.Id);
    float albedo[3];
    this->AlbedoOf(hit.Id, albedo);
    for (int channel = 0; channel < 3; ++channel)
    {
      path.Weight[channel] *= albedo[channel];
    }
  }

  void AddRadiance(Path& path, const Vector& d, double share) const
  {
    float sky[3];
    this->Light.Sky.Radiance(d, sky);
    for (int channel = 0; channel < 3; ++channel)
    {
      path.Radiance[channel] += static_cast<float>(share) * path.Weight[channel] * sky[channel];
    }
  }

  // Sends a ray from each path on whose side the direction is that `draw` gives; calls `add` with
  // the path, the direction, what `draw` returned and the cosine, for those that hit nothing.
  template <typename Draw, typename Add>
  void SendOnPurpose(int active, int pair, const Draw& draw, const Add& add)
  {
    this->Stream.Count = 0;
    for (int k = 0; k < active; ++k)
    {
      const Path& path = this->Paths[this->Active[k]];
      Vector d;
      const double density = draw(PointOf(path, pair), d);
      if (Dot(path.Normal, d) > 0.0 && density > 0.0)
      {
        this->Purposes[this->Stream.Count] = { this->Active[k], density };
        this->Send(path, d);
      }
    }
    this->Stream.Trace<true>(this->In);
    for (int k = 0; k < this->Stream.Count; ++k)
    {
      if (this->Stream.Hits[k].Id < 0)
      {
        add(this->Paths[this->Purposes[k].Path], this->Stream.Rays[k].D, this->Purposes[k].Density);
      }
    }
  }

  void AddSun(int active, int pair)
  {
    const Sun& sun = this->Light.Sun;
    this->SendOnPurpose(
      active, pair,
      [&](const Point2& point, Vector& d)
      {
        ConeDirection(sun.Direction, sun.OneMinusCosine, point, d);
        return 1.0;
      },
      [&](Path& path, const Vector& d, double)
      {
        const auto cosine = static_cast<float>(Dot(path.Normal, d));
        for (int channel = 0; channel < 3; ++channel)
        {
          path.Radiance[channel] += cosine * path.Weight[channel] * sun.Radiance[channel];
        }
      });
  }

  void AddSky(int active, int pair)
  {
    this->SendOnPurpose(
      active, pair,
      [&](const Point2& point, Vector& d) { return this->Light.Sky.Sample(point.X, point.Y, d); },
      [&](Path& path, const Vector& d, double density)
      {
        const double chance = Dot(path.Normal, d) * InversePi;
        this->AddRadiance(path, d, chance / (density + chance));
      });
  }

  // What a direction that came by chance counts beside one that was sent on purpose.
  double ChanceShare(const Path& path, const Vector& d) const
  {
    if (!this->Light.Sky.CanSample())
    {
      return 1.0;
    }
    const double chance = Dot(path.Normal, d) * InversePi;
    return chance / (this->Light.Sky.Density(d) + chance);
  }

  struct Purpose
  {
    int Path;
    double Density;
  };

  const Scene& In;
  const PathLight& Light;
  std::array<float, 256> Linear;
  int Active[RayStream::Maximum];
  Purpose Purposes[RayStream::Maximum];
  RayStream Stream;
};
}
}

#endif
