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
/// The material that is cut, and how.
struct DrilledMaterial
{
  int Material = 0;
  FieldCondition Condition; ///< the condition whose channel is cut
  NodeCut Cut;
};

/// Computes a brick's record from its initial record and the removed volume.
class DrilledBrick
{
public:
  /// The channel that is cut must be stored as floating point.
  DrilledBrick(const ScalarField& field, const RecordLayout& records,
               const DrilledMaterial& drilled);

  /// The nodes of the brick (counted along i, j, k) that lie in the grid.
  NodeBox NodesOf(const std::array<int, 3>& brick) const noexcept;

  /// Computes the values of the nodes of `box`, all of which belong to the brick. Returns false if
  /// the record already has them.
  bool FindNodes(const std::array<int, 3>& brick, const NodeBox& box, const DistanceBox& distances,
                 const std::byte* original, const std::byte* record);
  /// Writes the computed nodes, and the resulting surfaces.
  void Write(std::byte* record);

private:
  template <typename T>
  bool FindNodesOf(const DistanceBox& distances, const T* original, const T* record);
  template <typename T>
  void WriteNodesOf(T* nodes) const;
  void WriteSurface(std::byte* record);
  ConditionCells CellsOf(const FieldCondition& condition, const std::byte* record);
  /// Offset of row (j, k) of the box in the brick.
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
