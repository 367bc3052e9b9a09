#include "FieldBuild.h"

#include <algorithm>

namespace palpate
{
FieldBuild::FieldBuild(const FieldGrid& grid, const FieldForm& form,
                       const std::vector<FieldMaterial>& materials,
                       const FieldBuilder::Progress& progress)
    : Field(new ScalarField), Report(progress)
{
  this->Field->NodeGrid = grid;
  this->Field->Method = form.Interpolation;
  this->Field->LabelSmoothing = form.Smoothing;
  this->Field->Bricks = BrickLayout(grid.Size(), form.Interpolation);
  this->Field->BrickEntries = BrickDirectory(this->Field->Bricks);
  this->Field->Materials = materials;
  this->Field->Maps.assign(materials.size(), MaterialMap(this->Field->Bricks.BrickCount()));
}

void FieldBuild::AddChannel(const FieldSamples& samples, ScalarType stored)
{
  const BrickLayout& layout = this->Field->Bricks;
  this->Field->Channels.emplace_back(layout, stored);
  this->Sources.push_back(
      {{}, BrickNodes(layout, samples), std::vector<unsigned char>(layout.BrickCount(), 0)});
}

void FieldBuild::UseCoefficients(std::vector<float>&& coefficients)
{
  Source& source = this->Sources.back();
  source.Coefficients = std::move(coefficients);
  source.Nodes = BrickNodes(this->Field->Bricks,
                            SamplesOfGrid(source.Coefficients.data(), this->Field->NodeGrid));
}

Status FieldBuild::Run(bool keepsAll, MaterialSet kept, std::shared_ptr<const ScalarField>& field)
{
  this->Kept = kept;
  Status cancelled = Status::Failure("Building the field was cancelled.");
  if (!this->ForEachBrick(0.0, [this](const BrickPlace& brick) { this->Classify(brick); }))
  {
    return cancelled;
  }
  Status status = this->CheckSurfaces();
  if (!status.IsOk())
  {
    return status;
  }
  this->Field->BrickEntries.FindLeaps(this->Field->Bricks);
  this->ReserveWanted(keepsAll);
  if (!this->ForEachBrick(0.5, [this](const BrickPlace& brick) { this->StoreWanted(brick); }))
  {
    return cancelled;
  }
  field = this->Field;
  return status;
}

// Returns false if the caller has cancelled.
template <typename Function>
bool FieldBuild::ForEachBrick(double progressBefore, const Function& function)
{
  const BrickLayout& layout = this->Field->Bricks;
  std::size_t number = 0;
  for (int k = 0; k < layout.Bricks[2]; ++k)
  {
    const double done = progressBefore + 0.5 * k / layout.Bricks[2];
    if (this->Report && !this->Report(done))
    {
      return false;
    }
    for (int j = 0; j < layout.Bricks[1]; ++j)
    {
      for (int i = 0; i < layout.Bricks[0]; ++i)
      {
        function(BrickPlace{i, j, k, number++});
      }
    }
  }
  return true;
}

// Cells of the most recently gathered brick.
ConditionCells FieldBuild::CellsOf(const FieldCondition& condition) const
{
  const BrickNodes& nodes = this->Sources[static_cast<std::size_t>(condition.Channel)].Nodes;
  const bool isAtLeast = condition.Sense == FieldSense::AtLeast;
  const bool all = isAtLeast ? nodes.Lowest() >= condition.Iso : nodes.Highest() <= condition.Iso;
  const bool any = isAtLeast ? nodes.Highest() >= condition.Iso : nodes.Lowest() <= condition.Iso;
  if (all == any)
  {
    return UniformCells(all);
  }
  ConditionCells cells = ClassifyCells(nodes.Values(), this->Field->Bricks, condition);
  if (this->Field->Method == FieldInterpolation::TricubicBSpline)
  {
    TightenBSplineCells(nodes.Values(), this->Field->Bricks, condition, cells);
  }
  return cells;
}

ConditionCells FieldBuild::CellsOf(const FieldMaterial& material) const
{
  ConditionCells cells = this->CellsOf(material.Conditions[0]);
  for (int c = 1; c < material.ConditionCount; ++c)
  {
    cells.Restrict(this->CellsOf(material.Conditions[c]));
  }
  return cells;
}

void FieldBuild::Classify(const BrickPlace& brick)
{
  for (std::size_t channel = 0; channel < this->Sources.size(); ++channel)
  {
    BrickNodes& nodes = this->Sources[channel].Nodes;
    nodes.Gather(brick.I, brick.J, brick.K);
    this->Field->Channels[channel].SetConstant(brick.Number, nodes.Middle());
  }
  const CellSet inGrid = CellsInGrid(this->Field->Bricks, {brick.I, brick.J, brick.K});
  SurfaceBrick surface;
  surface.Cells.Fill(false);
  for (int m = 0; m < this->Field->MaterialCount(); ++m)
  {
    const FieldMaterial& material = this->Field->Material(m);
    AddMaterial(m, this->CellsOf(material), inGrid, surface);
    if (Contains(surface.Materials | (surface.Inside & this->Kept), m))
    {
      this->Want(material, brick.Number);
    }
  }
  this->WithSurface |= surface.Materials;
  if (surface.Materials != 0)
  {
    this->Field->BrickEntries.AddSurface(brick.Number, surface);
  }
  else
  {
    this->Field->SetInside(brick.Number, surface.Inside);
  }
}

void FieldBuild::Want(const FieldMaterial& material, std::size_t brick)
{
  for (int c = 0; c < material.ConditionCount; ++c)
  {
    const auto channel = static_cast<std::size_t>(material.Conditions[c].Channel);
    this->Sources[channel].IsWanted[brick] = 1;
  }
}

Status FieldBuild::CheckSurfaces() const
{
  for (int m = 0; m < this->Field->MaterialCount(); ++m)
  {
    if (!Contains(this->WithSurface, m))
    {
      return Status::Failure("Material " + std::to_string(m) +
                             " has no surface: no point satisfies its conditions, or "
                             "every point does.");
    }
  }
  return Status::Success();
}

void FieldBuild::ReserveWanted(bool keepsAll)
{
  for (std::size_t channel = 0; channel < this->Sources.size(); ++channel)
  {
    std::vector<unsigned char>& isWanted = this->Sources[channel].IsWanted;
    if (keepsAll)
    {
      std::fill(isWanted.begin(), isWanted.end(), 1);
    }
    this->Field->Channels[channel].Reserve(
        static_cast<std::size_t>(std::count(isWanted.begin(), isWanted.end(), 1)));
  }
}

void FieldBuild::StoreWanted(const BrickPlace& brick)
{
  for (std::size_t channel = 0; channel < this->Sources.size(); ++channel)
  {
    Source& source = this->Sources[channel];
    if (source.IsWanted[brick.Number] != 0)
    {
      source.Nodes.Gather(brick.I, brick.J, brick.K);
      this->Field->Channels[channel].Store(brick.Number, source.Nodes.Values());
    }
  }
  const BrickDirectory& directory = this->Field->BrickEntries;
  if (directory[brick.Number].Leap == 0)
  {
    this->Field->MapSurface(brick.Number, directory.Surface(directory[brick.Number]));
  }
}
} // namespace palpate
