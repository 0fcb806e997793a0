// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/PictureArrays.h"

#include "base/HugePages.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <new>

namespace spherepacking
{
namespace
{
template <typename ArrayT>
auto* AddPixels(vtkImageData* image, const char* name, int components)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  using Value = typename ArrayT::ValueType;
  const vtkIdType count = components * image->GetNumberOfPoints();
  void* memory = AllocateHugePages(count * sizeof(Value));
  if (!memory)
  {
    throw std::bad_alloc();
  }
  array->SetArray(static_cast<Value*>(memory), count, 0, ArrayT::VTK_DATA_ARRAY_FREE);
  image->GetPointData()->AddArray(array);
  return array->GetPointer(0);
}
}

//------------------------------------------------------------------------------
Picture AddPictureArrays(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  const Picture picture = { size[0], size[1], AddPixels<vtkUnsignedCharArray>(image, "color", 4),
    AddPixels<vtkFloatArray>(image, "depth", 1), AddPixels<vtkFloatArray>(image, "normal", 3),
    AddPixels<vtkTypeInt64Array>(image, "sphere_id", 1) };
  image->GetPointData()->SetActiveScalars("color");
  return picture;
}

//------------------------------------------------------------------------------
void AddPathPictureArrays(vtkImageData* image)
{
  for (const char* name : { "radiance", "albedo", "normal" })
  {
    AddPixels<vtkFloatArray>(image, name, 3);
  }
  for (const char* name : { "depth", "coverage", "variance" })
  {
    AddPixels<vtkFloatArray>(image, name, 1);
  }
  AddPixels<vtkTypeInt64Array>(image, "sphere_id", 1);
  AddPixels<vtkUnsignedIntArray>(image, "samples", 1);
  AddPixels<vtkUnsignedCharArray>(image, "color", 4);
}

//------------------------------------------------------------------------------
void AddTileExtents(vtkDataObject* output, const std::vector<Tile>& tiles)
{
  vtkNew<vtkIntArray> array;
  array->SetName("tile_extents");
  array->SetNumberOfComponents(4);
  for (const Tile& tile : tiles)
  {
    const int extent[4] = { tile.X, tile.X + tile.Width - 1, tile.Y, tile.Y + tile.Height - 1 };
    array->InsertNextTypedTuple(extent);
  }
  output->GetFieldData()->AddArray(array);
}

//------------------------------------------------------------------------------
void ClearTile(const Picture& picture, const Tile& tile)
{
  for (int y = tile.Y; y < tile.Y + tile.Height; ++y)
  {
    const std::int64_t first = static_cast<std::int64_t>(y) * picture.Width + tile.X;
    std::fill_n(picture.Color + 4 * first, 4 * tile.Width, static_cast<unsigned char>(0));
    std::fill_n(picture.Depth + first, tile.Width, Miss::Depth);
    std::fill_n(picture.Normal + 3 * first, 3 * tile.Width, 0.0f);
    std::fill_n(picture.Id + first, tile.Width, Miss::Id);
  }
}
}
