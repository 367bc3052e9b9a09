#pragma once

#include "BrickNodes.h"
#include "FieldBuilder.h"
#include "SurfaceCells.h"

namespace palpate
{
/// One run of FieldBuilder::Build, with what is in the making.
class FieldBuild
{
public:
  FieldBuild(const FieldGrid& grid, const FieldForm& form,
             const std::vector<FieldMaterial>& materials, const FieldBuilder::Progress& progress);

  void AddChannel(const FieldSamples& samples, ScalarType stored);
  /// What the last channel's nodes are instead of its samples.
  void UseCoefficients(std::vector<float>&& coefficients);
  Status Run(double margin, std::shared_ptr<const ScalarField>& field);

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
  void ClassifyMaterial(int number, const BrickPlace& brick, const CellSet& inGrid,
                        SurfaceBrick& surface);
  ConditionCells CellsOf(const FieldCondition& condition) const;
  ConditionCells CellsOf(const FieldMaterial& material) const;
  CellSet CellsInGrid(const BrickPlace& brick) const;
  Status CheckSurfaces() const;
  void WidenWanted(double margin);
  void StoreWanted(const BrickPlace& brick);

  std::shared_ptr<ScalarField> Field;
  const FieldBuilder::Progress& Report;
  std::vector<Source> Sources;
  MaterialSet WithSurface = 0;
};
} // namespace palpate
