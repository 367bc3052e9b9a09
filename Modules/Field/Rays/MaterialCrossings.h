#pragma once

#include "BernsteinCrossings.h"
#include "CellSegment.h"
#include "ScalarField.h"

namespace palpate
{
/// Where a ray crosses a material's boundary in one cell, in increasing order. `Cell` is the
/// interpolation.
template <typename Cell>
class MaterialCrossings
{
public:
  struct Crossing
  {
    double T;
    int Condition; ///< condition of the material that changes here
  };

  /// The cell's brick must be stored for the material's channels.
  MaterialCrossings(const ScalarField& field, const FieldMaterial& material, std::size_t brick,
                    int firstNode, const CellSegment& segment) noexcept
  {
    bool holds[FieldMaterial::MostConditions] = {};
    int count = 0;
    for (int c = 0; c < material.ConditionCount; ++c)
    {
      double polynomial[Cell::Degree + 1];
      this->Load(field, material.Conditions[c], brick, firstNode, c);
      this->Cells[c].Restrict(segment.U0, segment.U1, polynomial);
      holds[c] = polynomial[0] >= 0.0;
      const BernsteinCrossings<Cell::Degree> crossings(polynomial);
      for (int n = 0; n < crossings.Count(); ++n)
      {
        this->Insert(count++, {segment.At(crossings.Parameter(n)), c});
      }
    }
    this->StartsInside = material.ConditionCount == 1 ? holds[0] : holds[0] && holds[1];
    this->Found = material.ConditionCount == 1 ? count : this->KeepChanges(holds, count);
  }

  bool IsInsideAtStart() const noexcept { return this->StartsInside; }
  int Count() const noexcept { return this->Found; }
  const Crossing& operator[](int n) const noexcept { return this->Crossings[n]; }
  const Cell& Relation(int condition) const noexcept { return this->Cells[condition]; }

private:
  static constexpr int Most = FieldMaterial::MostConditions * Cell::Degree;

  void Load(const ScalarField& field, const FieldCondition& condition, std::size_t brick,
            int firstNode, int number) noexcept
  {
    const BrickedChannel& channel = field.Channel(condition.Channel);
    this->Cells[number].Load(channel, channel.SlotOf(brick).Block, firstNode);
    this->Cells[number].Relate(condition);
  }

  void Insert(int count, const Crossing& crossing) noexcept
  {
    for (; count > 0 && crossing.T < this->Crossings[count - 1].T; --count)
    {
      this->Crossings[count] = this->Crossings[count - 1];
    }
    this->Crossings[count] = crossing;
  }

  // Keeps the crossings at which the conjunction of all conditions changes. Changes at the same T
  // are simultaneous.
  int KeepChanges(bool* holds, int count) noexcept
  {
    int kept = 0;
    bool isInside = this->StartsInside;
    for (int n = 0; n < count; ++n)
    {
      const Crossing crossing = this->Crossings[n];
      holds[crossing.Condition] = !holds[crossing.Condition];
      if (n + 1 < count && this->Crossings[n + 1].T == crossing.T)
      {
        continue;
      }
      if ((holds[0] && holds[1]) != isInside)
      {
        isInside = !isInside;
        this->Crossings[kept++] = crossing;
      }
    }
    return kept;
  }

  bool StartsInside = false;
  int Found = 0;
  Crossing Crossings[Most];
  Cell Cells[FieldMaterial::MostConditions];
};
} // namespace palpate
