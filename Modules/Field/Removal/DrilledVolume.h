#pragma once

#include "EditedField.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace palpate
{
/// Removed volume of a material, by brick. Fractions of cells are counted in units of 2^-32, so
/// that a volume depends on the current state alone, to the last bit, and not on the order of
/// removal.
class DrilledVolume
{
public:
  DrilledVolume(const EditedField& field, int material);

  /// Marks a brick as changed.
  void Forget(std::size_t brick);
  /// mm^3.
  double Removed(const EditedField& field);

private:
  static constexpr std::int64_t NotKnown = -1;
  struct Part
  {
    std::int64_t Original = NotKnown;
    std::int64_t Removed = 0;
    bool IsStale = false;
  };
  std::int64_t InsideOf(const RecordLayout& records, std::size_t brick, const std::byte* record);
  std::int64_t InsideOfCells(const CellSet& inGrid) const;
  std::int64_t UnitsInside(int i, int j, int k) const;
  void LoadNodes(const RecordLayout& records, const std::byte* record);

  int Number;
  FieldMaterial Material;
  BrickLayout Layout;
  double CellVolume;                           // mm^3
  std::unordered_map<std::size_t, Part> Parts; // of all bricks ever changed
  std::vector<std::size_t> Stale;
  std::int64_t Total = 0;
  std::vector<double> Nodes[FieldMaterial::MostConditions]; // margins of the conditions in a brick
};
} // namespace palpate
