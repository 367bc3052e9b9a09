#pragma once

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

/// A set of voxels as runs, row by row; only non-empty rows.
class RunSet
{
public:
  struct Row
  {
    int Y;
    int Z;
    std::size_t Start; ///< its first run
  };

  /// Add runs in increasing order of z, y and x; they must not touch each other.
  void Add(const RowRun& run, int y, int z);

  const std::vector<RowRun>& Runs() const { return this->AllRuns; }
  const std::vector<Row>& Rows() const { return this->AllRows; }
  /// Index after the last run of a row.
  std::size_t RowEnd(std::size_t row) const
  {
    return row + 1 < this->AllRows.size() ? this->AllRows[row + 1].Start : this->AllRuns.size();
  }

private:
  std::vector<RowRun> AllRuns;
  std::vector<Row> AllRows;
};

/// Finds rows of a set that are queried in increasing order of z and y: in all, one pass.
class RowCursor
{
public:
  explicit RowCursor(const RunSet& set) : Set(&set) {}
  /// The index of a row, or the number of rows if the set has none there.
  std::size_t Find(int y, int z);

private:
  const RunSet* Set;
  std::size_t Place = 0;
};

/// The component of each run, from 0, numbered by their first runs. Union-find over runs of
/// adjacent rows: linear in the number of runs, whatever their length.
std::vector<int> LabelRunComponents(const RunSet& set, Neighborhood neighborhood);

/// Voxels of each component.
std::vector<long long> ComponentVoxels(const RunSet& set, const std::vector<int>& components);

/// The voxels between the runs of a set's rows, as 26-connected components.
struct RunGaps
{
  RunSet Set;
  std::vector<int> Components; ///< of each run
  /// Of each component; 0 if it is connected to the outside and so is no cavity.
  std::vector<long long> CavityVoxels;
};

/// The cavities of a set: voxels between its runs from which no 26-connected path outside the set
/// leads to the border.
RunGaps FindCavities(const RunSet& set);
} // namespace palpate
