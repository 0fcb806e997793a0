// SPDX-License-Identifier: BSD-3-Clause
#ifndef IdList_h
#define IdList_h

#include <algorithm>
#include <cstdint>
#include <memory>

namespace spherepacking
{
/// A short list of integers in little memory, of a pointer alone if it is empty: there are
/// millions.
class IdList
{
public:
  void Add(std::int32_t id)
  {
    const std::int32_t size = this->Size();
    if (size % Step == 0)
    {
      std::unique_ptr<std::int32_t[]> larger(new std::int32_t[1 + size + Step]);
      std::copy(this->begin(), this->end(), larger.get() + 1);
      this->Values = std::move(larger);
    }
    this->Values[1 + size] = id;
    this->Values[0] = size + 1;
  }
  void Clear() { this->Values.reset(); }

  const std::int32_t* begin() const { return this->Values ? this->Values.get() + 1 : nullptr; }
  const std::int32_t* end() const { return this->begin() + this->Size(); }

private:
  static constexpr std::int32_t Step = 5; // with the size, what fits into the smallest allocation

  std::int32_t Size() const { return this->Values ? this->Values[0] : 0; }

  std::unique_ptr<std::int32_t[]> Values; // the size, then the elements
};
}

#endif
