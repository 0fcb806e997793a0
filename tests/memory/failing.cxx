// Lets the n-th allocation fail that this package's libraries ask for, or VTK's arrays for them.
//
// Preloaded into a process. Where an allocation comes from is told by the address that it returns
// to. Left out are those of less than `Least` bytes, among them VTK's records of what its threads
// have to do, whose failure ends the process within VTK ("Proxy not joined. Terminating."), and the
// makers of our objects, which VTK's wrappers call without a guard.
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <execinfo.h>
#include <link.h>
#include <new>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace
{
constexpr std::size_t Least = 40;

struct Range
{
  std::uintptr_t Low;
  std::uintptr_t High;
  bool Ours;
};
Range Ranges[16];
int NumberOfRanges = 0;
std::atomic<long> Remaining{ 0 };
std::atomic<bool> Armed{ false };
std::atomic<bool> Fired{ false };
bool Lasting = false;
thread_local bool Asking = false;

int AddRange(dl_phdr_info* info, std::size_t, void*)
{
  const bool ours = std::strstr(info->dlpi_name, "vtkSpherePacking") != nullptr;
  if (!ours && !std::strstr(info->dlpi_name, "vtkCommonCore"))
  {
    return 0;
  }
  for (int i = 0; i < info->dlpi_phnum && NumberOfRanges < 16; ++i)
  {
    const ElfW(Phdr) & part = info->dlpi_phdr[i];
    if (part.p_type == PT_LOAD && (part.p_flags & PF_X))
    {
      const std::uintptr_t low = info->dlpi_addr + part.p_vaddr;
      Ranges[NumberOfRanges++] = { low, low + part.p_memsz, ours };
    }
  }
  return 0;
}

const Range* RangeOf(const void* address)
{
  const auto at = reinterpret_cast<std::uintptr_t>(address);
  for (int i = 0; i < NumberOfRanges; ++i)
  {
    if (Ranges[i].Low <= at && at < Ranges[i].High)
    {
      return &Ranges[i];
    }
  }
  return nullptr;
}

bool IsMaker(const void* address)
{
  Dl_info info{};
  if (!dladdr(address, &info) || !info.dli_sname)
  {
    return false;
  }
  const char* name = info.dli_sname;
  return std::strstr(name, "3NewEv") || std::strstr(name, "C1Ev") || std::strstr(name, "C2Ev");
}

bool CalledByUs()
{
  void* frames[64];
  const int count = backtrace(frames, 64);
  for (int i = 0; i < count; ++i)
  {
    const Range* range = RangeOf(frames[i]);
    if (range && range->Ours)
    {
      return true;
    }
  }
  return false;
}

bool Fails(std::size_t size, const void* caller)
{
  if (!Armed.load(std::memory_order_relaxed) || size < Least || Asking)
  {
    return false;
  }
  Asking = true; // what follows may allocate
  const Range* range = RangeOf(caller);
  const bool counts = range && (range->Ours ? !IsMaker(caller) : size >= 1024 && CalledByUs());
  Asking = false;
  if (!counts)
  {
    return false;
  }
  const long left = --Remaining;
  if (left == 0 || (left < 0 && Lasting))
  {
    Fired = true;
    return true;
  }
  return false;
}

void* New(std::size_t size, std::size_t alignment, const void* caller)
{
  void* memory = Fails(size, caller) ? nullptr
    : alignment                      ? __libc_memalign(alignment, size)
                                     : __libc_malloc(size ? size : 1);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}
}

extern "C" {
void arm(long n, int lasting)
{
  NumberOfRanges = 0;
  dl_iterate_phdr(AddRange, nullptr);
  void* frames[2];
  backtrace(frames, 2); // loads a library
  Lasting = lasting != 0;
  Fired = false;
  Remaining = n;
  Armed = true;
}

int disarm()
{
  Armed = false;
  return Fired ? 1 : 0;
}

void* malloc(std::size_t size)
{
  return Fails(size, __builtin_return_address(0)) ? nullptr : __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size)
{
  return Fails(count * size, __builtin_return_address(0)) ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size)
{
  return Fails(size, __builtin_return_address(0)) ? nullptr : __libc_realloc(memory, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size)
{
  return Fails(size, __builtin_return_address(0)) ? nullptr : __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size)
{
  *memory = Fails(size, __builtin_return_address(0)) ? nullptr : __libc_memalign(alignment, size);
  return *memory ? 0 : ENOMEM;
}
}

void* operator new(std::size_t size)
{
  return New(size, 0, __builtin_return_address(0));
}

void* operator new[](std::size_t size)
{
  return New(size, 0, __builtin_return_address(0));
}

void* operator new(std::size_t size, std::align_val_t alignment)
{
  return New(size, static_cast<std::size_t>(alignment), __builtin_return_address(0));
}

void* operator new[](std::size_t size, std::align_val_t alignment)
{
  return New(size, static_cast<std::size_t>(alignment), __builtin_return_address(0));
}
