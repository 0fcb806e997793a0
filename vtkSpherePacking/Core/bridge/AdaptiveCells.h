// SPDX-License-Identifier: BSD-3-Clause
#ifndef AdaptiveCells_h
#define AdaptiveCells_h

#include "light/TracePaths.h"

#include <vector>

namespace spherepacking
{
/// The cells of a path-traced picture that still get samples, in adaptive sampling.
class AdaptiveCells
{
public:
  /// All cells of the picture.
  explicit AdaptiveCells(const PathPicture& picture);

  /// Drops the cells whose pixels all have this number of samples and whose relative error, the
  /// root of the mean variance over the mean luminance, is no more than `target`.
  void DropConverged(unsigned samples, double target);

  bool Any() const;
  PathCells Get() const { return { this->Active.data(), this->Columns }; }

private:
  bool IsConverged(int column, int row, unsigned samples, double target) const;

  const PathPicture& Picture;
  int Columns;
  int Rows;
  std::vector<unsigned char> Active;
};
}

#endif
