// SPDX-License-Identifier: BSD-3-Clause
#include "io/PartFile.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cinttypes>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string_view>
#include <system_error>
#include <utility>

namespace spherepacking
{
namespace
{
namespace fs = std::filesystem;

constexpr std::string_view Prefix = ".spherepacking-";
constexpr std::string_view Suffix = ".part";
constexpr std::size_t Digits = 16;

// Somebody else cannot foresee it. It does not contain the target's, since a longer one than that
// may be too long.
std::string AnyName(const std::string& folder)
{
  std::random_device source;
  const std::uint64_t bits = static_cast<std::uint64_t>(source()) << 32 | source();
  char digits[Digits + 1];
  std::snprintf(digits, sizeof(digits), "%016" PRIx64, bits);
  return folder + '/' + std::string(Prefix) + digits + std::string(Suffix);
}

bool IsOurs(std::string_view name)
{
  return name.size() == Prefix.size() + Digits + Suffix.size() &&
    name.substr(0, Prefix.size()) == Prefix && name.substr(Prefix.size() + Digits) == Suffix &&
    name.substr(Prefix.size(), Digits).find_first_not_of("0123456789abcdef") ==
    std::string_view::npos;
}

// Removes a file that a process has left which is no more: nobody has locked it.
void RemoveIfLeft(const std::string& name)
{
  const int file = open(name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0)
  {
    return;
  }
  struct stat status;
  if (fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == geteuid() &&
    status.st_nlink == 1 && flock(file, LOCK_EX | LOCK_NB) == 0)
  {
    unlink(name.c_str());
  }
  close(file);
}

void RemoveAllLeft(const std::string& folder)
{
  std::error_code error;
  fs::directory_iterator entry(fs::u8path(folder), error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
  {
    const std::string name = entry->path().filename().u8string();
    if (IsOurs(name))
    {
      RemoveIfLeft(folder + '/' + name);
    }
  }
}

std::string FolderOf(const std::string& target)
{
  const std::string folder = fs::u8path(target).parent_path().u8string();
  return folder.empty() ? "." : folder;
}

// Whether a file that has been locked still has its name, which somebody may have taken for one
// that was left before it was locked.
bool IsThere(int file)
{
  struct stat status;
  return fstat(file, &status) == 0 && status.st_nlink > 0;
}

// Gives `file` the group and the permissions of an earlier one. Where it cannot have its group,
// another group gets no permission.
bool TakePermissions(int file, const std::string& target)
{
  struct stat earlier;
  struct stat status;
  if (stat(target.c_str(), &earlier) != 0)
  {
    return errno == ENOENT;
  }
  const bool sameGroup = fstat(file, &status) == 0 &&
    (status.st_gid == earlier.st_gid || fchown(file, static_cast<uid_t>(-1), earlier.st_gid) == 0);
  return fchmod(file, earlier.st_mode & (sameGroup ? 0777u : 0707u)) == 0;
}
}

//------------------------------------------------------------------------------
PartFile::PartFile(const std::string& target)
{
  const std::string folder = FolderOf(target);
  RemoveAllLeft(folder);
  // What may be private is not to be read by others while it is written.
  constexpr unsigned int privately = 0600;
  constexpr unsigned int asAnyNewFile = 0666;
  this->Open(folder, access(target.c_str(), F_OK) == 0 ? privately : asAnyNewFile);
}

//------------------------------------------------------------------------------
void PartFile::Open(const std::string& folder, unsigned int permissions)
{
  int file = -1;
#ifdef O_TMPFILE
  // A name is given to it through that folder.
  if (access("/proc/self/fd", X_OK) == 0)
  {
    file = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, permissions);
    if (file >= 0)
    {
      flock(file, LOCK_EX);
    }
  }
#endif
  constexpr int attempts = 16;
  for (int attempt = 0; file < 0 && attempt < attempts; ++attempt)
  {
    std::string name = AnyName(folder);
    file = open(name.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, permissions);
    if (file < 0)
    {
      return;
    }
    this->Name = std::move(name);
    // Where a file system has no locks, nobody gets one to remove it either.
    flock(file, LOCK_EX);
    if (!IsThere(file))
    {
      close(file);
      this->Name.clear();
      file = -1;
      errno = EAGAIN;
    }
  }
  if (file >= 0)
  {
    this->Opened = fdopen(file, "wb");
    if (!this->Opened)
    {
      close(file);
    }
  }
}

//------------------------------------------------------------------------------
PartFile::~PartFile()
{
  if (!this->Name.empty())
  {
    unlink(this->Name.c_str());
  }
  if (this->Opened)
  {
    std::fclose(this->Opened);
  }
}

//------------------------------------------------------------------------------
bool PartFile::TakeAnyName(const std::string& folder)
{
  if (!this->Name.empty())
  {
    return true;
  }
  const std::string open = "/proc/self/fd/" + std::to_string(fileno(this->Opened));
  std::string name = AnyName(folder);
  if (linkat(AT_FDCWD, open.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) != 0)
  {
    return false;
  }
  this->Name = std::move(name);
  return true;
}

//------------------------------------------------------------------------------
bool PartFile::TakeName(const std::string& target)
{
  const int file = fileno(this->Opened);
  if (std::fflush(this->Opened) != 0 || !TakePermissions(file, target))
  {
    return false;
  }
  // Else, after a loss of power, the name might stand for a file of which not all is there. Some
  // file systems have no such thing.
  if (fsync(file) != 0 && errno != EINVAL && errno != ENOSYS)
  {
    return false;
  }
  // An earlier file can be replaced by one that has a name, only.
  if (!this->TakeAnyName(FolderOf(target)) || std::rename(this->Name.c_str(), target.c_str()) != 0)
  {
    return false;
  }
  this->Name.clear();
  return true;
}
}
