// SPDX-License-Identifier: BSD-3-Clause
#include "io/DumpBox.h"

#include "io/Number.h"

#include <algorithm>

namespace spherepacking
{
namespace
{
/// How far a box reaches beyond its sides since it is tilted.
struct Overhang
{
  double Low[2];
  double High[2];
};

Overhang OverhangOf(double xy, double xz, double yz)
{
  return { { std::min({ 0.0, xy, xz, xy + xz }), std::min(0.0, yz) },
    { std::max({ 0.0, xy, xz, xy + xz }), std::max(0.0, yz) } };
}

BoxRows BoundsOf(const SimulationCell& cell, bool tilted)
{
  BoxRows rows;
  for (int i = 0; i < 3; ++i)
  {
    rows[i] = { cell.Origin[i], cell.Origin[i] + cell.Vectors[i][i] };
  }
  if (tilted)
  {
    const double tilt[3] = { cell.Vectors[1][0], cell.Vectors[2][0], cell.Vectors[2][1] };
    const Overhang over = OverhangOf(tilt[0], tilt[1], tilt[2]);
    for (int i = 0; i < 3; ++i)
    {
      rows[i][0] += i < 2 ? over.Low[i] : 0.0;
      rows[i][1] += i < 2 ? over.High[i] : 0.0;
      rows[i].push_back(tilt[i]);
    }
  }
  return rows;
}

BoxRows VectorsOf(const SimulationCell& cell)
{
  BoxRows rows;
  for (int i = 0; i < 3; ++i)
  {
    rows[i].assign(cell.Vectors[i], cell.Vectors[i] + 3);
    rows[i].push_back(cell.Origin[i]);
  }
  return rows;
}

bool Holds(const BoxRows& rows, const SimulationCell& cell)
{
  SimulationCell read{};
  SetCellOfBox(rows, read);
  const auto same = [](const double* a, const double* b, int count)
  { return std::equal(a, a + count, b); };
  return same(read.Origin, cell.Origin, 3) && same(read.Vectors[0], cell.Vectors[0], 9) &&
    rows[0][1] > rows[0][0] && rows[1][1] > rows[1][0] && rows[2][1] > rows[2][0];
}
}

//------------------------------------------------------------------------------
void SetCellOfBox(const BoxRows& rows, SimulationCell& cell)
{
  std::fill_n(cell.Vectors[0], 9, 0.0);
  if (rows[0].size() == 4)
  {
    for (int i = 0; i < 3; ++i)
    {
      std::copy_n(rows[i].begin(), 3, cell.Vectors[i]);
      cell.Origin[i] = rows[i][3];
    }
    return;
  }
  const bool tilted = rows[0].size() == 3;
  const double xy = tilted ? rows[0][2] : 0.0;
  const double xz = tilted ? rows[1][2] : 0.0;
  const double yz = tilted ? rows[2][2] : 0.0;
  const Overhang over = OverhangOf(xy, xz, yz);
  for (int i = 0; i < 3; ++i)
  {
    cell.Origin[i] = rows[i][0] - (i < 2 ? over.Low[i] : 0.0);
    cell.Vectors[i][i] = rows[i][1] - (i < 2 ? over.High[i] : 0.0) - cell.Origin[i];
  }
  cell.Vectors[1][0] = xy;
  cell.Vectors[2][0] = xz;
  cell.Vectors[2][1] = yz;
}

//------------------------------------------------------------------------------
std::string BoxOfCell(const SimulationCell& cell)
{
  BoxRows rows = BoundsOf(cell, false);
  std::string text = "ITEM: BOX BOUNDS";
  if (!Holds(rows, cell))
  {
    rows = BoundsOf(cell, true);
    text += " xy xz yz";
    if (!Holds(rows, cell))
    {
      rows = VectorsOf(cell);
      text = "ITEM: BOX BOUNDS abc origin";
    }
  }
  for (const bool periodic : cell.Periodic)
  {
    text += periodic ? " pp" : " ff";
  }
  for (const std::vector<double>& row : rows)
  {
    text += '\n';
    for (std::size_t k = 0; k < row.size(); ++k)
    {
      text += (k > 0 ? " " : "") + NumberText(row[k]);
    }
  }
  return text + '\n';
}
}
