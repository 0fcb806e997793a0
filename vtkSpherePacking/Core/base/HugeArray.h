// SPDX-License-Identifier: BSD-3-Clause
#ifndef HugeArray_h
#define HugeArray_h

#include "base/HugePages.h"

#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace spherepacking
{
/// An array on large pages where there are any, whose values mean nothing before they are set:
/// setting them to 0 first would take as long as what comes after.
template <typename T>
class HugeArray
{
  static_assert(std::is_trivially_copyable<T>::value, "values are not constructed");

public:
  HugeArray() = default;
  explicit HugeArray(std::size_t size)
    : Memory(size > 0 ? static_cast<T*>(AllocateHugePages(size * sizeof(T))) : nullptr)
    , Size(size)
  {
    if (size > 0 && !this->Memory)
    {
      throw std::bad_alloc();
    }
  }

  std::size_t size() const { return this->Size; }
  bool empty() const { return this->Size == 0; }
  T* data() { return this->Memory.get(); }
  const T* data() const { return this->Memory.get(); }
  T& operator[](std::size_t i) { return this->Memory.get()[i]; }
  const T& operator[](std::size_t i) const { return this->Memory.get()[i]; }

private:
  struct Free
  {
    void operator()(T* memory) const { std::free(memory); }
  };

  std::unique_ptr<T, Free> Memory;
  std::size_t Size = 0;
};
}

#endif
