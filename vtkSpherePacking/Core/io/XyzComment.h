// SPDX-License-Identifier: BSD-3-Clause
#ifndef XyzComment_h
#define XyzComment_h

#include "bridge/PackingArrays.h"

#include "vtkType.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherepacking
{
/// The number of which the first line of a frame of XYZ consists, if it does.
std::optional<vtkIdType> XyzCount(std::string_view line);

/**
 * The second line of a frame, which in extended XYZ holds KEY=VALUE, in which a value with blanks
 * is in quotes (A. Larsen et al., "The atomic simulation environment - a Python library for working
 * with atoms", 2017). Keys are known in any letter case.
 */
class XyzComment
{
public:
  explicit XyzComment(std::string_view line);

  /// What `Properties` says of the columns: NAME:TYPE:COUNT:NAME:TYPE:COUNT and so on.
  std::optional<std::string> Properties() const { return this->Find("properties"); }

  /// The values of `Time`, `Timestep` and `Step`.
  std::array<std::optional<double>, 3> Times() const;

  /// `Lattice`, the vectors a, b, c; periodic along all unless `pbc` says otherwise. Throws a
  /// ContentError if any is not as it should be.
  std::optional<SimulationCell> Cell() const;

private:
  std::optional<std::string> Find(std::string_view key) const;
  std::vector<double> Numbers(std::string_view key) const;

  struct Entry
  {
    std::string Key; ///< in lower case
    std::string Value;
  };
  std::vector<Entry> Entries;
};
}

#endif
