#include "StudyBrush.h"

#include "MaskSurface.h"
#include "MeshConversion.h"
#include "VoxelValue.h"

#include "vtkImageData.h"

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace palpate
{
namespace
{
constexpr double LeastStep = 0.1; // radii
} // namespace

Status StudyBrush::Begin(const StudyCorrected& corrected, const BrushStroke& like,
                         const Vector3& placeWorld, vtkImageData* edges)
{
  this->GiveUp();
  const CorrectedMask* mask = corrected.Voxels();
  if (mask == nullptr)
  {
    return Status::Failure(corrected.Surface() != nullptr
                               ? "A model has no voxels to paint; pull its surface."
                               : "There is no mask yet.");
  }
  this->Grid = mask->Grid();
  this->ImageSize = mask->ImageSize();
  this->Edges = edges;
  this->Stroke = like;
  this->Path = {placeWorld};
  return this->Update();
}

Status StudyBrush::Move(const Vector3& placeWorld, double radius)
{
  const std::size_t count = this->Path.size();
  const bool isNear =
      count > 1 && ((this->Path[count - 1] - this->Path[count - 2]).norm() < LeastStep * radius ||
                    count >= BrushStroke::MostPoints);
  if (isNear)
  {
    this->Path.back() = placeWorld;
  }
  else
  {
    this->Path.push_back(placeWorld);
  }
  this->Stroke->Radius = radius;
  return this->Update();
}

Status StudyBrush::Update()
{
  this->Stroke->PointsWorld = std::make_shared<const BrushStroke::Path>(this->Path);
  const auto value = [this](const std::array<int, 3>& index)
  {
    const Vector3 place = this->Grid(Vector3(index[0], index[1], index[2]));
    return VoxelValueAt(this->Edges, place).value_or(std::numeric_limits<double>::quiet_NaN());
  };
  Status status =
      this->Edges != nullptr
          ? MakeStrokeToEdges(*this->Stroke, this->Grid, this->ImageSize, value, this->Voxels)
          : MakeStroke(*this->Stroke, this->Grid, this->ImageSize, this->Voxels);
  IndexedMesh boundary;
  this->Drawn = nullptr; // of no voxels
  if (status.IsOk() && MakeMaskBoundary(this->Voxels, this->Grid, boundary).IsOk())
  {
    this->Drawn = ToPolyData(boundary);
  }
  if (!status.IsOk())
  {
    this->GiveUp();
  }
  return status;
}

std::optional<CorrectionStep> StudyBrush::End()
{
  std::optional<CorrectionStep> step;
  if (this->Stroke && this->Voxels.Count() > 0)
  {
    step = *this->Stroke;
    if (this->Edges != nullptr)
    {
      step = VoxelEdit{std::make_shared<const std::vector<IndexRun>>(ImageRunsOf(this->Voxels)),
                       this->Stroke->Erases};
    }
  }
  this->GiveUp();
  return step;
}

void StudyBrush::GiveUp()
{
  this->Stroke.reset();
  this->Path.clear();
  this->Edges = nullptr;
  this->Voxels = {};
  this->Drawn = nullptr;
}
} // namespace palpate
