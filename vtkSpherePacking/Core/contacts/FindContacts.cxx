// SPDX-License-Identifier: BSD-3-Clause
#include "contacts/FindContacts.h"

#include "contacts/SphereLevels.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace spherepacking
{
namespace
{
constexpr std::int64_t Chunk = 1 << 10;

// What is found in reach is tested exactly; the reaches are larger by more than rounding can be,
// and by what is lost where squares underflow.
constexpr double RelativeSlack = 1e-12;
constexpr double AbsoluteSlack = 1e-150;

// Images of a sphere that are searched for its neighbours, far more than of any cell in use.
constexpr double MostImages = 1e5;

CellShift operator+(const CellShift& a, const CellShift& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

CellShift operator-(const CellShift& a, const CellShift& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

constexpr CellShift None{ 0, 0, 0 };

/// Finds the contacts of a packing, spheres wrapped into the cell first.
class ContactFinder
{
public:
  ContactFinder(const SphereArrays& spheres, double gap, const PeriodicImages& images,
    const ParallelFor& parallelFor)
    : Spheres(spheres)
    , Gap(gap)
    , Images(images)
    , Wraps(images.Any() ? static_cast<std::size_t>(spheres.Count) : 0)
    , Slack(AbsoluteSlack + this->Wrap(parallelFor))
    , Levels(
        spheres.Count, [this](std::int64_t i) { return this->Wrapped(i); },
        0.5 * std::max(gap, 0.0) + this->Slack, parallelFor)
  {
    this->CheckImages();
  }

  // Appends the contacts of the sphere at a place with others of its level or coarser ones.
  void Find(int level, std::int64_t at, std::vector<Contact>& contacts) const
  {
    const NumberedSphere& sphere = this->Levels[at];
    for (int other = level; other < this->Levels.LevelCount(); ++other)
    {
      const double largest = this->Levels.LargestRadius(other);
      // No slack for a negative gap: one of more than the radii is beyond what any two have.
      const double gap = std::max(this->Gap, 0.0);
      const double reach =
        sphere.Radius + gap + RelativeSlack * (largest + sphere.Radius + gap) + this->Slack;
      this->ForEachImage(sphere.Center, reach + largest,
        [&](const CellShift& shift)
        {
          // Within a level either of two would find the other: without a shift that at the earlier
          // place does, with a shift that of the smaller number.
          const bool same = level == other;
          const bool earlier = same && shift == None;
          this->Levels.ForEachNeighbor(other, sphere.Center - this->Images.Sum(shift), reach,
            earlier ? at + 1 : 0,
            [&](const NumberedSphere& neighbor)
            {
              const bool twice =
                same && !earlier && std::tie(sphere.Id, None) >= std::tie(neighbor.Id, shift);
              if (!twice)
              {
                this->Add(sphere, neighbor, shift, contacts);
              }
            });
        });
    }
  }

  const SphereLevels& AllLevels() const { return this->Levels; }

private:
  // Finds the vectors by which spheres lie outside the cell, and returns how far rounding may move
  // spheres that are wrapped into it.
  double Wrap(const ParallelFor& parallelFor)
  {
    if (!this->Images.Any())
    {
      return 0.0;
    }
    const std::int64_t chunks = (this->Spheres.Count + Chunk - 1) / Chunk;
    std::vector<double> farthest(chunks, 0.0);
    parallelFor(chunks,
      [&](std::int64_t chunk)
      {
        const std::int64_t end = std::min((chunk + 1) * Chunk, this->Spheres.Count);
        for (std::int64_t i = chunk * Chunk; i < end; ++i)
        {
          const Sphere s = this->Spheres[i];
          const Vector3 center{ s.X, s.Y, s.Z };
          CellShift wrap = None;
          for (int axis = 0; axis < 3; ++axis)
          {
            wrap[axis] = this->WrapOf(center, axis);
          }
          this->Wraps[i] = wrap;
          const double far = Length(center) + Length(this->Images.Sum(wrap));
          farthest[chunk] = std::max(farthest[chunk], far);
        }
      });
    double far = this->Images.Longest();
    for (const double one : farthest)
    {
      far = std::max(far, one);
    }
    return 16.0 * std::numeric_limits<double>::epsilon() * far;
  }

  std::int32_t WrapOf(const Vector3& center, int axis) const
  {
    if (!this->Images.IsPeriodic(axis))
    {
      return 0;
    }
    const double wrap = std::floor(this->Images.Fraction(center, axis));
    if (!(std::abs(wrap) < 1e9))
    {
      std::ostringstream message;
      message << "cell_vectors: found a sphere " << wrap << " cells away, expected one within 1e9";
      throw std::invalid_argument(message.str());
    }
    return static_cast<std::int32_t>(wrap);
  }

  CellShift WrapAt(std::int64_t i) const { return this->Wraps.empty() ? None : this->Wraps[i]; }

  NumberedSphere Wrapped(std::int64_t i) const
  {
    const Sphere s = this->Spheres[i];
    return { Vector3{ s.X, s.Y, s.Z } - this->Images.Sum(this->WrapAt(i)), s.R,
      static_cast<std::int32_t>(i) };
  }

  void CheckImages() const
  {
    const int levels = this->Levels.LevelCount();
    const double reach =
      std::max(this->Gap, 0.0) + (levels > 0 ? 2.0 * this->Levels.LargestRadius(levels - 1) : 0.0);
    double images = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      images *= 2.0 * reach * this->Images.DualLength(axis) + 1.0;
    }
    if (images > MostImages)
    {
      std::ostringstream message;
      message << "cell_vectors: found a cell so small that a sphere reaches " << images
              << " of its images, expected fewer than " << MostImages;
      throw std::invalid_argument(message.str());
    }
  }

  // Calls visit(shift) for the shifts by which a centre in the cell may come so near to this one.
  template <typename Visit>
  void ForEachImage(const Vector3& center, double distance, const Visit& visit) const
  {
    if (!this->Images.Any())
    {
      visit(None);
      return;
    }
    std::int32_t low[3];
    std::int32_t high[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double fraction = this->Images.Fraction(center, axis);
      const double reach = distance * this->Images.DualLength(axis) + 1e-9;
      low[axis] = static_cast<std::int32_t>(std::ceil(fraction - 1.0 - reach));
      high[axis] = static_cast<std::int32_t>(std::floor(fraction + reach));
      if (!this->Images.IsPeriodic(axis))
      {
        low[axis] = high[axis] = 0;
      }
    }
    for (std::int32_t a = low[0]; a <= high[0]; ++a)
    {
      for (std::int32_t b = low[1]; b <= high[1]; ++b)
      {
        for (std::int32_t c = low[2]; c <= high[2]; ++c)
        {
          visit({ a, b, c });
        }
      }
    }
  }

  // Adds the contact of two spheres, the second moved by `shift` after both were wrapped, if it is
  // one.
  void Add(const NumberedSphere& a, const NumberedSphere& b, const CellShift& shift,
    std::vector<Contact>& contacts) const
  {
    if (this->Wraps.empty())
    {
      // The very numbers of the packing, which lie far apart in its arrays.
      if (GapOf(b.Center - a.Center, a.Radius, b.Radius) <= this->Gap)
      {
        contacts.push_back({ std::min(a.Id, b.Id), std::max(a.Id, b.Id), None });
      }
      return;
    }
    Contact contact{ a.Id, b.Id, shift + this->WrapAt(a.Id) - this->WrapAt(b.Id) };
    if (a.Id > b.Id)
    {
      contact = { b.Id, a.Id, None - contact.Shift };
    }
    if (GapOf(this->Spheres, contact.I, contact.J, this->Images.Sum(contact.Shift)) <= this->Gap)
    {
      contacts.push_back(contact);
    }
  }

  const SphereArrays& Spheres;
  double Gap;
  const PeriodicImages& Images;
  HugeArray<CellShift> Wraps; // empty if nothing is periodic
  double Slack;
  SphereLevels Levels;
};

// Puts the contacts of all pieces into order: by the first sphere by counting, then each few.
HugeArray<Contact> Sorted(const std::vector<std::vector<Contact>>& parts, std::int64_t count,
  std::int64_t spheres, const ParallelFor& parallelFor)
{
  // After the second pass the place after a sphere's contacts has become that of the first.
  std::unique_ptr<std::atomic<std::int64_t>[]> starts(new std::atomic<std::int64_t>[spheres + 1]());
  const std::int64_t pieces = static_cast<std::int64_t>(parts.size());
  const auto forEach = [&](const auto& work)
  {
    parallelFor(pieces,
      [&](std::int64_t piece)
      {
        for (const Contact& contact : parts[piece])
        {
          work(contact);
        }
      });
  };
  forEach(
    [&](const Contact& contact) { starts[contact.I].fetch_add(1, std::memory_order_relaxed); });
  std::int64_t sum = 0;
  for (std::int64_t i = 0; i <= spheres; ++i)
  {
    sum += starts[i].load(std::memory_order_relaxed);
    starts[i].store(sum, std::memory_order_relaxed);
  }
  HugeArray<Contact> contacts(count);
  forEach([&](const Contact& contact)
    { contacts[starts[contact.I].fetch_sub(1, std::memory_order_relaxed) - 1] = contact; });
  parallelFor((spheres + Chunk - 1) / Chunk,
    [&](std::int64_t chunk)
    {
      const std::int64_t end = std::min((chunk + 1) * Chunk, spheres);
      for (std::int64_t i = chunk * Chunk; i < end; ++i)
      {
        std::sort(contacts.data() + starts[i], contacts.data() + starts[i + 1],
          [](const Contact& a, const Contact& b)
          { return std::tie(a.J, a.Shift) < std::tie(b.J, b.Shift); });
      }
    });
  return contacts;
}

// Consecutive places of a level, for one piece of work.
struct Piece
{
  int Level;
  std::int64_t Begin;
  std::int64_t End;
};

std::vector<Piece> PiecesOf(const SphereLevels& levels)
{
  std::vector<Piece> pieces;
  for (int level = 0; level < levels.LevelCount(); ++level)
  {
    for (std::int64_t at = levels.Begin(level); at < levels.End(level); at += Chunk)
    {
      pieces.push_back({ level, at, std::min(at + Chunk, levels.End(level)) });
    }
  }
  return pieces;
}
}

//------------------------------------------------------------------------------
HugeArray<Contact> FindContacts(
  const SphereArrays& spheres, double gap, const PeriodicImages& images, const ContactWork& work)
{
  const ContactFinder finder(spheres, gap, images, work.For);
  const std::vector<Piece> pieces = PiecesOf(finder.AllLevels());
  std::vector<std::vector<Contact>> parts(pieces.size());
  std::atomic<std::int64_t> count{ 0 };
  const auto search = [&](std::int64_t k)
  {
    std::vector<Contact>& part = parts[k];
    part.reserve(4 * (pieces[k].End - pieces[k].Begin));
    std::size_t before = 0;
    for (std::int64_t at = pieces[k].Begin; at < pieces[k].End; ++at)
    {
      finder.Find(pieces[k].Level, at, part);
      const std::int64_t added = static_cast<std::int64_t>(part.size() - before);
      before = part.size();
      if (static_cast<double>(count += added) > work.Most)
      {
        std::ostringstream message;
        message << "gap: found more than " << work.Most << " contacts within " << gap
                << ", which do not fit in half of the memory, expected fewer";
        throw std::invalid_argument(message.str());
      }
    }
  };
  if (!work.Interruptible(static_cast<std::int64_t>(pieces.size()), search))
  {
    return {};
  }
  return Sorted(parts, count, spheres.Count, work.For);
}
}
