// SPDX-License-Identifier: BSD-3-Clause
// Spheres through Embree: a scene, and pictures of it with the same arrays as
// vtkSpherePackingTracer, in plain C functions for Python's ctypes.

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <thread>
#include <vector>

namespace
{
struct Peer
{
  RTCDevice Device = nullptr;
  RTCScene Scene = nullptr;
  const float* Spheres = nullptr; // x, y, z, r; kept by the caller
  int Threads = 1;
  std::atomic<std::int64_t> Bytes{ 0 };
};

bool CountBytes(void* peer, ssize_t bytes, bool)
{
  static_cast<Peer*>(peer)->Bytes += bytes;
  return true;
}

// Rays through pixels: from Origin along D0 + x DX + y DY, whose t is the depth.
struct View
{
  const double* Origin;
  const double* D0;
  const double* DX;
  const double* DY;
  const double* ToEye;
};

struct Picture
{
  int Width;
  int Height;
  const unsigned char* Colors;
  unsigned char* Color;
  float* Depth;
  float* Normal;
  long long* Id;
};

void Direction(const View& view, int x, int y, float (&direction)[3])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    direction[axis] =
      static_cast<float>(view.D0[axis] + (x + 0.5) * view.DX[axis] + (y + 0.5) * view.DY[axis]);
  }
}

void Write(const View& view, const Picture& picture, int x, int y, unsigned id, float depth,
  float (&normal)[3])
{
  const std::int64_t pixel = static_cast<std::int64_t>(y) * picture.Width + x;
  if (id == RTC_INVALID_GEOMETRY_ID)
  {
    picture.Id[pixel] = -1;
    picture.Depth[pixel] = std::numeric_limits<float>::infinity();
    std::fill_n(picture.Normal + 3 * pixel, 3, 0.0f);
    std::fill_n(picture.Color + 4 * pixel, 4, static_cast<unsigned char>(0));
    return;
  }
  const float scale =
    1.0f / std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  float light = 0.0f;
  for (int axis = 0; axis < 3; ++axis)
  {
    picture.Normal[3 * pixel + axis] = normal[axis] * scale;
    light += normal[axis] * scale * static_cast<float>(view.ToEye[axis]);
  }
  light = std::min(std::abs(light), 1.0f);
  picture.Id[pixel] = id;
  picture.Depth[pixel] = depth;
  const unsigned char* color = picture.Colors + 4 * static_cast<std::int64_t>(id);
  for (int channel = 0; channel < 3; ++channel)
  {
    picture.Color[4 * pixel + channel] =
      static_cast<unsigned char>(static_cast<float>(color[channel]) * light + 0.5f);
  }
  picture.Color[4 * pixel + 3] = color[3];
}

// Calls rtcIntersect1, 4, 8 or 16 for a block of so many pixels, as square as it can be.
template <typename RayHit, int Number, int Columns, typename Intersect>
void TracePacket(
  const View& view, const Picture& picture, int x0, int y0, const Intersect& intersect)
{
  alignas(64) RayHit packet;
  alignas(64) int valid[Number];
  auto& ray = packet.ray;
  for (int i = 0; i < Number; ++i)
  {
    const int x = x0 + i % Columns;
    const int y = y0 + i / Columns;
    valid[i] = x < picture.Width && y < picture.Height ? -1 : 0;
    float direction[3];
    Direction(view, x, y, direction);
    ray.org_x[i] = static_cast<float>(view.Origin[0]);
    ray.org_y[i] = static_cast<float>(view.Origin[1]);
    ray.org_z[i] = static_cast<float>(view.Origin[2]);
    ray.dir_x[i] = direction[0];
    ray.dir_y[i] = direction[1];
    ray.dir_z[i] = direction[2];
    ray.tnear[i] = 0.0f;
    ray.tfar[i] = std::numeric_limits<float>::infinity();
    ray.time[i] = 0.0f;
    ray.mask[i] = -1;
    ray.flags[i] = 0;
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.primID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  intersect(valid, packet);
  for (int i = 0; i < Number; ++i)
  {
    if (valid[i] != 0)
    {
      float normal[3] = { packet.hit.Ng_x[i], packet.hit.Ng_y[i], packet.hit.Ng_z[i] };
      Write(view, picture, x0 + i % Columns, y0 + i / Columns,
        packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? RTC_INVALID_GEOMETRY_ID
                                                        : packet.hit.primID[i],
        ray.tfar[i], normal);
    }
  }
}

void TraceSingle(const View& view, const Picture& picture, int x, int y, RTCScene scene,
  RTCIntersectContext& context)
{
  RTCRayHit one;
  std::memset(&one, 0, sizeof(one));
  float direction[3];
  Direction(view, x, y, direction);
  one.ray.org_x = static_cast<float>(view.Origin[0]);
  one.ray.org_y = static_cast<float>(view.Origin[1]);
  one.ray.org_z = static_cast<float>(view.Origin[2]);
  one.ray.dir_x = direction[0];
  one.ray.dir_y = direction[1];
  one.ray.dir_z = direction[2];
  one.ray.tfar = std::numeric_limits<float>::infinity();
  one.ray.mask = -1;
  one.hit.geomID = one.hit.primID = one.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &context, &one);
  float normal[3] = { one.hit.Ng_x, one.hit.Ng_y, one.hit.Ng_z };
  Write(view, picture, x, y,
    one.hit.geomID == RTC_INVALID_GEOMETRY_ID ? one.hit.geomID : one.hit.primID, one.ray.tfar,
    normal);
}

// Calls trace(x, y) for the lower left corners of blocks of columns x rows pixels, tile by tile.
template <typename Trace>
void ForEachBlock(
  const Peer& peer, const Picture& picture, int columns, int rows, const Trace& trace)
{
  constexpr int side = 64;
  const int across = (picture.Width + side - 1) / side;
  const int count = across * ((picture.Height + side - 1) / side);
  std::atomic<int> next{ 0 };
  const auto work = [&]
  {
    for (int tile = next++; tile < count; tile = next++)
    {
      const int left = tile % across * side;
      const int bottom = tile / across * side;
      for (int y = bottom; y < std::min(bottom + side, picture.Height); y += rows)
      {
        for (int x = left; x < std::min(left + side, picture.Width); x += columns)
        {
          trace(x, y);
        }
      }
    }
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < peer.Threads; ++i)
  {
    threads.emplace_back(work);
  }
  work();
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}
}

extern "C" {
/// Builds a scene of the best quality. `spheres` (count, 4) must stay; null if Embree cannot.
void* spherepacking_embree_build(const float* spheres, std::int64_t count, int threads)
{
  Peer* peer = new Peer;
  peer->Spheres = spheres;
  peer->Threads = threads;
  peer->Device = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
  rtcSetDeviceMemoryMonitorFunction(peer->Device, CountBytes, peer);
  RTCGeometry geometry = rtcNewGeometry(peer->Device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, spheres, 0,
    4 * sizeof(float), static_cast<std::size_t>(count));
  rtcCommitGeometry(geometry);
  peer->Scene = rtcNewScene(peer->Device);
  rtcSetSceneBuildQuality(peer->Scene, RTC_BUILD_QUALITY_HIGH);
  rtcAttachGeometry(peer->Scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(peer->Scene);
  return peer;
}

/// Of the structure, without the spheres.
std::int64_t spherepacking_embree_bytes(void* handle)
{
  return static_cast<Peer*>(handle)->Bytes;
}

/// `view` are five vectors: origin, direction, its steps along x and y, towards the eye. `packet`
/// is the number of rays at once: 1, 4, 8 or 16.
void spherepacking_embree_trace(void* handle, const double* view, int packet, int width, int height,
  const unsigned char* colors, unsigned char* color, float* depth, float* normal, long long* id)
{
  const Peer& peer = *static_cast<Peer*>(handle);
  const View rays = { view, view + 3, view + 6, view + 9, view + 12 };
  const Picture picture = { width, height, colors, color, depth, normal, id };
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCScene scene = peer.Scene;
  switch (packet)
  {
    case 4:
      ForEachBlock(peer, picture, 2, 2,
        [&](int x, int y)
        {
          TracePacket<RTCRayHit4, 4, 2>(rays, picture, x, y,
            [&](int* valid, RTCRayHit4& hits) { rtcIntersect4(valid, scene, &context, &hits); });
        });
      break;
    case 8:
      ForEachBlock(peer, picture, 4, 2,
        [&](int x, int y)
        {
          TracePacket<RTCRayHit8, 8, 4>(rays, picture, x, y,
            [&](int* valid, RTCRayHit8& hits) { rtcIntersect8(valid, scene, &context, &hits); });
        });
      break;
    case 16:
      ForEachBlock(peer, picture, 4, 4,
        [&](int x, int y)
        {
          TracePacket<RTCRayHit16, 16, 4>(rays, picture, x, y,
            [&](int* valid, RTCRayHit16& hits) { rtcIntersect16(valid, scene, &context, &hits); });
        });
      break;
    default:
      ForEachBlock(peer, picture, 1, 1,
        [&](int x, int y)
        {
          RTCIntersectContext own = context;
          TraceSingle(rays, picture, x, y, scene, own);
        });
  }
}

void spherepacking_embree_free(void* handle)
{
  Peer* peer = static_cast<Peer*>(handle);
  rtcReleaseScene(peer->Scene);
  rtcReleaseDevice(peer->Device);
  delete peer;
}
}
