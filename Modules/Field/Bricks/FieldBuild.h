#pragma once

#include "BrickNodes.h"
#include "FieldBuilder.h"
#include "SurfaceCells.h"

namespace palpate
{
/// One run of FieldBuilder::Build, with its intermediate results.
class FieldBuild
{
public:
  FieldBuild(const FieldGrid& grid, const FieldForm& form,
             const std::vector<FieldMaterial>& materials, const FieldBuilder::Progress& progress);

  void AddChannel(const FieldSamples& samples, ScalarType stored);
  /// Replaces the last channel's samples as the source of its nodes.
  void UseCoefficients(std::vector<float>&& coefficients);
  /// Bricks that the materials of `kept` fill are stored too, or all.
  Status Run(bool keepsAll, MaterialSet kept, std::shared_ptr<const ScalarField>& field);

private:
  struct Source
  {
    std::vector<float> Coefficients;
    BrickNodes Nodes;
    std::vector<unsigned char> IsWanted; ///< for each brick
  };
  struct BrickPlace
  {
    int I, J, K;
    std::size_t Number;
  };

  template <typename Function>
  bool ForEachBrick(double progressBefore, const Function& function);
  void Classify(const BrickPlace& brick);
  ConditionCells CellsOf(const FieldCondition& condition) const;
  ConditionCells CellsOf(const FieldMaterial& material) const;
  void Want(const FieldMaterial& material, std::size_t brick);
  Status CheckSurfaces() const;
  void ReserveWanted(bool keepsAll);
  void StoreWanted(const BrickPlace& brick);

  std::shared_ptr<ScalarField> Field;
  const FieldBuilder::Progress& Report;
  std::vector<Source> Sources;
  MaterialSet WithSurface = 0;
  MaterialSet Kept = 0;
};
} // namespace palpate
