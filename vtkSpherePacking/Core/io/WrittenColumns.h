// SPDX-License-Identifier: BSD-3-Clause
#ifndef WrittenColumns_h
#define WrittenColumns_h

#include "io/WritePacking.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkStringArray;

namespace spherepacking
{
/// An array that is written: one of these two, and the names of its components as columns.
struct WrittenArray
{
  vtkDataArray* Numbers = nullptr;
  vtkStringArray* Texts = nullptr;
  std::string Name;
  std::vector<std::string> Columns;
};

/// The arrays that the format can hold, in the order of the file: centres and radii first, but
/// after texts in extended XYZ, which others write so. Vectors are left out where their parts are
/// there, since the reader joins them. Throws a ContentError for names or texts that would not read
/// back.
std::vector<WrittenArray> ChooseArrays(const WriteOptions& options);
}

#endif
