#include "CorrectedShape.h"

#include "BodyOverlap.h"
#include "ComparedBody.h"
#include "IcosahedronDirections.h"
#include "ImageIndexToWorld.h"
#include "InputError.h"
#include "LabelMask.h"
#include "MeshDistances.h"
#include "ModelCorrection.h"
#include "Refusal.h"
#include "Units.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
constexpr int PulledFrequency = 24; // 5,762 points that can be pulled

std::string StepName(std::size_t number)
{
  return "step " + std::to_string(number + 1);
}

// Mean without sign over the area of a surface.
double MeanOver(const IndexedMesh& mesh, const std::vector<double>& distances)
{
  const std::vector<double> areas = PointAreas(mesh);
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t n = 0; n < areas.size(); ++n)
  {
    sum += areas[n] * std::abs(distances[n]);
    area += areas[n];
  }
  return area > 0.0 ? sum / area : 0.0;
}

double LargestOf(const std::vector<double>& distances)
{
  double largest = 0.0;
  for (const double distance : distances)
  {
    largest = std::max(largest, std::abs(distance));
  }
  return largest;
}

void Measure(const ComparedBody& start, const ComparedBody& result, CorrectionChange& change)
{
  change.Surface = result.Surface();
  RequireInput(start.DistancesOf(change.Surface.Points, {}, change.Distances), "the change");
  std::vector<double> back;
  RequireInput(result.DistancesOf(start.Surface().Points, {}, back), "the change");
  change.MeanDistance = MeanOver(change.Surface, change.Distances);
  change.LargestDistance = std::max(LargestOf(change.Distances), LargestOf(back));
  BodyOverlap overlap;
  RequireInput(FindBodyOverlap(start, result, overlap), "the change");
  change.Dice = overlap.Dice();
  change.StartMilliliters = start.Volume() / CubicMillimetersPerMilliliter;
  change.Milliliters = result.Volume() / CubicMillimetersPerMilliliter;
}

ComparedBody BodyOfMask(const VoxelMask& mask, const IndexToWorld& toWorld)
{
  ComparedBody body;
  if (!ComparedBody::OfMaskShape(mask, toWorld, body).IsOk())
  {
    RequireInput(ComparedBody::OfMask(mask, toWorld, body), "the mask");
  }
  return body;
}
} // namespace

CorrectedShape CorrectedShape::OfMask(std::shared_ptr<const Segmentation> start,
                                      const Segment& structure, NeighborPolicy neighbors)
{
  vtkImageData* const image = start->Layers[static_cast<std::size_t>(structure.Layer)];
  std::array<int, 3> size{};
  image->GetDimensions(size.data());
  CorrectedShape shape;
  shape.Mask =
      CorrectedMask(CopyLabelMask(image, structure.Value, 1).Mask, IndexToWorldOf(image), size,
                    neighbors == NeighborPolicy::Stop ? OtherVoxels(*start, structure)
                                                      : MaskCorrection::Barrier());
  shape.Source = std::move(start);
  return shape;
}

CorrectedShape CorrectedShape::OfModel(const ModelDocument& start)
{
  CorrectedShape shape;
  shape.Model = start.Surface;
  shape.ModelPulls = StartOfModel(start.Surface, PulledFrequency);
  shape.ModelTriangles = std::make_shared<const std::vector<std::array<int, 3>>>(
      IcosahedronDirections(PulledFrequency).Triangles());
  return shape;
}

const SurfaceCorrection& CorrectedShape::Pulls()
{
  const SurfaceCorrection* pulls = &this->ModelPulls;
  const MaskCorrection* surface = nullptr;
  if (this->Mask)
  {
    RequireInput(this->Mask->Surface(surface, pulls), "the mask");
  }
  return *pulls;
}

const std::vector<std::array<int, 3>>& CorrectedShape::Triangles()
{
  if (!this->Mask)
  {
    return *this->ModelTriangles;
  }
  const SurfaceCorrection* pulls = nullptr;
  const MaskCorrection* surface = nullptr;
  RequireInput(this->Mask->Surface(surface, pulls), "the mask");
  return surface->Surface().Triangles;
}

Status CorrectedShape::Apply(const CorrectionStep& step)
{
  if (this->Mask)
  {
    return this->Mask->Apply(step);
  }
  const auto* pull = std::get_if<SurfacePull>(&step);
  return pull != nullptr
             ? this->ModelPulls.Pull(*pull)
             : Status::Failure("is an edit of voxels; a model can be pulled, or give a mask");
}

void CorrectedShape::TakeBack()
{
  this->List.pop_back();
  if (this->Mask)
  {
    this->Mask->Undo();
  }
  else
  {
    this->ModelPulls.Undo();
  }
}

void CorrectedShape::Do(const std::vector<CorrectionStep>& steps)
{
  const auto [mine, others] =
      std::mismatch(this->List.begin(), this->List.end(), steps.begin(), steps.end());
  const auto common = static_cast<std::size_t>(others - steps.begin());
  while (this->List.size() > common)
  {
    this->TakeBack();
  }
  for (std::size_t n = common; n < steps.size(); ++n)
  {
    RequireInput(this->Apply(steps[n]), StepName(n));
    this->List.push_back(steps[n]);
  }
  this->Pulls();
}

OrganModel CorrectedShape::ResultModel() const
{
  OrganModel model = this->Model;
  if (!this->List.empty())
  {
    RequireInput(ModelCorrection::Apply(this->Model, this->ModelPulls, model), "the model");
  }
  return model;
}

BodyComparison CorrectedShape::CompareWith(const ComparedBody& other)
{
  ComparedBody result;
  RequireInput(ComparedBody::OfMask(this->Mask->Mask(), this->Mask->Grid(), result), "the mask");
  BodyComparison comparison;
  RequireInput(CompareBodies(result, other, {}, {}, comparison), "the comparison");
  return comparison;
}

CorrectionChange CorrectedShape::Change()
{
  CorrectionChange change;
  if (this->Mask)
  {
    const VoxelMask& result = this->Mask->Mask();
    ForEachChange(this->Mask->Start(), result,
                  [&change](const std::array<int, 3>&, bool isAdded)
                  { (isAdded ? change.AddedVoxels : change.RemovedVoxels) += 1; });
    Measure(BodyOfMask(this->Mask->Start(), this->Mask->Grid()),
            BodyOfMask(result, this->Mask->Grid()), change);
    return change;
  }
  ComparedBody before;
  ComparedBody after;
  RequireInput(ComparedBody::OfModel(this->Model, before), "the model");
  RequireInput(ComparedBody::OfModel(this->ResultModel(), after), "the corrected model");
  Measure(before, after, change);
  return change;
}
} // namespace palpate
