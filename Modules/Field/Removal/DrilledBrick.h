#pragma once

#include "BrickRecords.h"
#include "DistanceBox.h"
#include "NodeCut.h"
#include "SurfaceCells.h"

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace palpate
{
/// What is cut, and how.
struct DrilledMaterial
{
  int Material = 0;
  FieldCondition Condition; ///< of its conditions the one whose channel is cut
  NodeCut Cut;
};

/// Makes the record of a brick from what it was in the beginning and from what was removed.
class DrilledBrick
{
public:
  /// Floating point is what the channel that is cut is kept in.
  DrilledBrick(const ScalarField& field, const RecordLayout& records,
               const DrilledMaterial& drilled);

  /// The nodes of the brick (counted along i, j, k), but for those beyond the grid.
  NodeBox NodesOf(const std::array<int, 3>& brick) const noexcept;

  /// Finds what the nodes of `box`, which the brick has, are now. False where that is what the
  /// record says already.
  bool FindNodes(const std::array<int, 3>& brick, const NodeBox& box, const DistanceBox& distances,
                 const std::byte* original, const std::byte* record);
  /// Writes what was found, and the surfaces that follow.
  void Write(std::byte* record);

private:
  template <typename T>
  bool FindNodesOf(const DistanceBox& distances, const T* original, const T* record);
  template <typename T>
  void WriteNodesOf(T* nodes) const;
  void WriteSurface(std::byte* record);
  ConditionCells CellsOf(const FieldCondition& condition, const std::byte* record);
  /// Where row (j, k) of the box begins in the brick.
  std::size_t RowOf(int j, int k) const noexcept;

  BrickLayout Layout;
  RecordLayout Records;
  std::vector<FieldMaterial> Materials;
  DrilledMaterial Drilled;
  ScalarType Type;

  std::array<int, 3> Brick{};
  NodeBox Box;
  std::tuple<std::vector<float>, std::vector<double>> Found; // nodes of the box, in one type
  std::vector<double> Nodes;                                 // of the brick, one channel
};
} // namespace palpate
