// SPDX-License-Identifier: BSD-3-Clause
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
/// A path on its way from the camera, at the outside of a sphere.
struct Path
{
  Double3 Point;
  Double3 Normal;
  std::int64_t Id;     ///< of the sphere, negative for none
  float Throughput[3]; ///< what part of the light that leaves here reaches the camera
  float Radiance[3];
  float FirstAlbedo[3];
  float FirstNormal[3];
  std::uint64_t Seed;  ///< of the pixel
  std::uint32_t Index; ///< of the sample
  int Ray;             ///< of the block

  /// Puts the path on a sphere, where its normal is `Normal`.
  void PlaceOn(const Sphere& sphere, std::int64_t id)
  {
    // From the sphere, which keeps its digits however far the ray has come.
    this->Point[0] = sphere.X + sphere.R * this->Normal[0];
    this->Point[1] = sphere.Y + sphere.R * this->Normal[1];
    this->Point[2] = sphere.Z + sphere.R * this->Normal[2];
    this->Id = id;
  }
};

/// Traces the paths of a block, all of them bounce by bounce, so that their rays make streams.
class PathBlock
{
public:
  Path Paths[RayStream::Maximum];
  int Count = 0;

  PathBlock(const Scene& scene, const PathLight& light)
    : Input(scene)
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
      albedo[channel] = this->Linear[this->Input.Colors[4 * id + channel]];
    }
  }

  /// Adds to the radiance of each path what comes from all later spheres, the sky and the sun.
  void Trace()
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
      const int dimension = PairsPerBounce * (bounce - 1);
      if (this->Light.Sun.Shines())
      {
        this->SampleSun(active, dimension + SunPair);
      }
      if (this->Light.Sky.CanSample())
      {
        this->SampleSky(active, dimension + SkyPair);
      }
      if (bounce > BouncesBeforeRoulette)
      {
        active = this->RussianRoulette(active, dimension + RoulettePair);
      }
      active = this->Scatter(active, dimension + DirectionPair, bounce == this->Light.MaxBounces);
    }
  }

private:
  // Pairs of dimensions of the sampler, per bounce. Pair 0 is the point in the pixel, and pair 1
  // makes four-dimensional points with it.
  static constexpr int DirectionPair = 1;
  static constexpr int SunPair = 2;
  static constexpr int SkyPair = 3;
  static constexpr int RoulettePair = 4;
  static constexpr int PairsPerBounce = 4;
  static constexpr int BouncesBeforeRoulette = 3;
  static constexpr double InversePi = 0.3183098861837907;

  static Point2 PointOf(const Path& path, int pair)
  {
    return OwenSobol(path.Seed).At(path.Index, pair);
  }

  void PushRay(const Path& path, const Double3& d)
  {
    const int i = this->Stream.Count++;
    this->Stream.Rays[i] = { { path.Point[0], path.Point[1], path.Point[2] },
      { d[0], d[1], d[2] } };
    this->Stream.OriginSphere[i] = path.Id;
  }

  // Russian roulette: ends paths by chance, and lets the survivors count for them. Returns how many
  // these are.
  int RussianRoulette(int active, int pair)
  {
    int survivors = 0;
    for (int k = 0; k < active; ++k)
    {
      Path& path = this->Paths[this->Active[k]];
      const float largest =
        std::max(path.Throughput[0], std::max(path.Throughput[1], path.Throughput[2]));
      const float survival = std::min(1.0f, largest);
      if (PointOf(path, pair).X < survival)
      {
        for (float& channel : path.Throughput)
        {
          channel /= survival;
        }
        this->Active[survivors++] = this->Active[k];
      }
    }
    return survivors;
  }

  // Samples the BSDF (Lambert): sends each path on to the closest sphere, or, after its last
  // bounce, to see whether there is any. Those that escape see the sky. Returns how many hit a
  // sphere.
  int Scatter(int active, int pair, bool last)
  {
    this->Stream.Count = 0;
    for (int k = 0; k < active; ++k)
    {
      const Path& path = this->Paths[this->Active[k]];
      Double3 d;
      CosineDirection(path.Normal, PointOf(path, pair), d);
      this->PushRay(path, d);
    }
    if (last)
    {
      this->Stream.Trace<true>(this->Input);
    }
    else
    {
      this->Stream.Trace<false>(this->Input);
    }
    for (int k = 0; k < active && !last; ++k)
    {
      __builtin_prefetch(
        this->Input.Colors + 4 * std::max<std::int64_t>(this->Stream.Hits[k].Id, 0));
    }
    int scattered = 0;
    for (int k = 0; k < active; ++k)
    {
      Path& path = this->Paths[this->Active[k]];
      const Hit& hit = this->Stream.Hits[k];
      const Ray& ray = this->Stream.Rays[k];
      if (hit.Id < 0)
      {
        this->AddSkyRadiance(path, ray.D, this->MisWeight(path, ray.D));
      }
      else if (!last)
      {
        this->MoveTo(path, ray, hit);
        this->Active[scattered++] = this->Active[k];
      }
    }
    return scattered;
  }

  void MoveTo(Path& path, const Ray& ray, const Hit& hit) const
  {
    const Sphere& sphere = hit.On;
    NormalAt(ray, sphere, InverseSquare(ray), hit.T, path.Normal);
    path.PlaceOn(sphere, hit.Id);
    float albedo[3];
    this->AlbedoOf(hit.Id, albedo);
    for (int channel = 0; channel < 3; ++channel)
    {
      path.Throughput[channel] *= albedo[channel];
    }
  }

  void AddSkyRadiance(Path& path, const Double3& d, double weight) const
  {
    float sky[3];
    this->Light.Sky.Radiance(d, sky);
    for (int channel = 0; channel < 3; ++channel)
    {
      path.Radiance[channel] +=
        static_cast<float>(weight) * path.Throughput[channel] * sky[channel];
    }
  }

  // Next-event estimation: `draw` makes a direction to the light of each path and returns its
  // density; where it lies above the surface a shadow ray is traced, and for those that are not
  // occluded `add` is called with the path, the direction and the density.
  template <typename Draw, typename Add>
  void SampleLight(int active, int pair, const Draw& draw, const Add& add)
  {
    this->Stream.Count = 0;
    for (int k = 0; k < active; ++k)
    {
      const Path& path = this->Paths[this->Active[k]];
      Double3 d;
      const double density = draw(PointOf(path, pair), d);
      if (Dot(path.Normal, d) > 0.0 && density > 0.0)
      {
        this->LightSamples[this->Stream.Count] = { this->Active[k], density };
        this->PushRay(path, d);
      }
    }
    this->Stream.Trace<true>(this->Input);
    for (int k = 0; k < this->Stream.Count; ++k)
    {
      if (this->Stream.Hits[k].Id < 0)
      {
        const LightSample& sample = this->LightSamples[k];
        add(this->Paths[sample.Path], this->Stream.Rays[k].D, sample.Density);
      }
    }
  }

  // The sun is not seen by scattered rays, so that its samples have the weight 1.
  void SampleSun(int active, int pair)
  {
    const Sun& sun = this->Light.Sun;
    this->SampleLight(
      active, pair,
      [&](const Point2& point, Double3& d)
      {
        ConeDirection(sun.Direction, sun.OneMinusCosine, point, d);
        return 1.0;
      },
      [&](Path& path, const Double3& d, double)
      {
        const auto cosine = static_cast<float>(Dot(path.Normal, d));
        for (int channel = 0; channel < 3; ++channel)
        {
          path.Radiance[channel] += cosine * path.Throughput[channel] * sun.Radiance[channel];
        }
      });
  }

  void SampleSky(int active, int pair)
  {
    this->SampleLight(
      active, pair,
      [&](const Point2& point, Double3& d) { return this->Light.Sky.Sample(point.X, point.Y, d); },
      [&](Path& path, const Double3& d, double density)
      {
        // The MIS weight density / (density + bsdf), times bsdf / density.
        const double bsdf = Dot(path.Normal, d) * InversePi;
        this->AddSkyRadiance(path, d, bsdf / (density + bsdf));
      });
  }

  // MIS weight of a scattered direction beside next-event estimation of the sky, by the balance
  // heuristic; 1 where the sky is not sampled.
  double MisWeight(const Path& path, const Double3& d) const
  {
    if (!this->Light.Sky.CanSample())
    {
      return 1.0;
    }
    const double bsdf = Dot(path.Normal, d) * InversePi;
    return bsdf / (this->Light.Sky.Density(d) + bsdf);
  }

  struct LightSample
  {
    int Path;
    double Density; // per solid angle
  };

  const Scene& Input;
  const PathLight& Light;
  std::array<float, 256> Linear;  // albedo of a channel of a colour
  int Active[RayStream::Maximum]; // paths that are not over
  LightSample LightSamples[RayStream::Maximum];
  RayStream Stream;
};
}
}

#endif
