#pragma once

#include "PalpateIOModule.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// Which voxels of a set count as joined.
enum class Neighborhood
{
  Faces,            ///< 6 neighbours
  FacesEdgesCorners ///< 26 neighbours
};

/// Voxels along the first axis that belong to a set: First <= x < End.
struct RowRun
{
  int First;
  int End;
};

/// A set of voxels, row by row. Row y + z * RowsPerSlice keeps the runs RowStarts[row] up to
/// RowStarts[row + 1], in rising order and not touching each other.
struct RunSet
{
  int RowsPerSlice = 0;
  int Slices = 0;
  std::vector<RowRun> Runs;
  std::vector<std::size_t> RowStarts;
};

/// The component of each run, from 0, numbered by their first runs. Union-find over runs of
/// adjacent rows: linear in the number of runs, whatever their length.
PALPATEIO_EXPORT std::vector<int> LabelRunComponents(const RunSet& set, Neighborhood neighborhood);
} // namespace palpate
