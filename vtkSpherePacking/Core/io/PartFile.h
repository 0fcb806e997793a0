// SPDX-License-Identifier: BSD-3-Clause
#ifndef PartFile_h
#define PartFile_h

#include <cstdio>
#include <string>

namespace spherepacking
{
/**
 * A file that is being written. Where the file system can it has no name (O_TMPFILE of Linux), so
 * that whatever ends the process leaves nothing; else, and for the moment before it takes its
 * final name, it is called .spherepacking-….part and locked (flock), and whoever writes into that
 * folder next removes those that nobody has locked.
 */
class PartFile
{
public:
  /// Opens one that is to replace `target`, which need not exist. Where that cannot be done,
  /// Stream() is null and errno says why.
  explicit PartFile(const std::string& target);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  std::FILE* Stream() const { return this->Opened; }

  /// Puts it on the disk and gives it the name `target`. Otherwise it returns false, and errno says
  /// why.
  bool TakeName(const std::string& target);

private:
  void Open(const std::string& folder, unsigned int permissions);
  bool TakeAnyName(const std::string& folder);

  std::string Name; // empty while it has none
  std::FILE* Opened = nullptr;
};
}

#endif
