#include "ModelSoftening.h"

#include "DecimalText.h"
#include "FilterRun.h"
#include "ImageGrid.h"
#include "KernelWatch.h"
#include "Refusal.h"
#include "SphereQuadrature.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
constexpr double PerKilopascal = 1e-3; // N/mm^2
constexpr const char* Stage = "elasticity";

// Whether the organ's tissue differs from its own somewhere.
bool Changes(const TissueMap& tissue, const SphericalHarmonicModel& model, double own)
{
  constexpr int Degree = 30;
  constexpr int Shells = 25;
  for (const Vector3& direction : SphereQuadrature(Degree).Directions)
  {
    const double radius = model.Radius(direction);
    for (int shell = 0; shell < Shells; ++shell)
    {
      const double part = (shell + 0.5) / Shells;
      if (tissue.Modulus(model.CenterWorld() + part * radius * direction) != own)
      {
        return true;
      }
    }
  }
  return false;
}

// The moduli of an elastography image, N/mm^2.
std::shared_ptr<const TissueMap::Samples> ModuliOf(const Volume& image)
{
  const ImageGrid grid = GridOf(image.Image);
  vtkDataArray* values = image.Image->GetPointData()->GetScalars();
  auto samples = std::make_shared<TissueMap::Samples>();
  samples->Grid = FieldGrid(grid.Size, grid.OriginWorld, grid.Spacing, grid.Direction);
  samples->Values.reserve(static_cast<std::size_t>(values->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    samples->Values.push_back(static_cast<float>(PerKilopascal * values->GetComponent(i, 0)));
  }
  return samples;
}

// Visits the voxels of a box, the first index axis fastest.
template <typename Visit>
void ForEachVoxel(const std::array<int, 3>& first, const std::array<int, 3>& last,
                  const Visit& visit)
{
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      for (int i = first[0]; i <= last[0]; ++i)
      {
        visit(std::array<int, 3>{i, j, k});
      }
    }
  }
}

// 1 in a structure, 0 outside: the box around it with a voxel of margin, since label maps are
// mostly background. Null without a voxel.
std::shared_ptr<const TissueMap::Samples> FractionOf(vtkImageData* layer, int value)
{
  const ImageGrid grid = GridOf(layer);
  vtkDataArray* voxels = layer->GetPointData()->GetScalars();
  const auto isInside = [&](const std::array<int, 3>& at)
  {
    const vtkIdType row = at[1] + static_cast<vtkIdType>(grid.Size[1]) * at[2];
    return voxels->GetComponent(at[0] + grid.Size[0] * row, 0) == value;
  };
  std::array<int, 3> first = grid.Size;
  std::array<int, 3> last{{-1, -1, -1}};
  ForEachVoxel({{0, 0, 0}}, {{grid.Size[0] - 1, grid.Size[1] - 1, grid.Size[2] - 1}},
               [&](const std::array<int, 3>& at)
               {
                 const std::size_t axes = isInside(at) ? 3 : 0;
                 for (std::size_t axis = 0; axis < axes; ++axis)
                 {
                   first[axis] = std::min(first[axis], std::max(0, at[axis] - 1));
                   last[axis] = std::max(last[axis], std::min(grid.Size[axis] - 1, at[axis] + 1));
                 }
               });
  if (last[0] < 0)
  {
    return nullptr;
  }
  auto samples = std::make_shared<TissueMap::Samples>();
  const FieldGrid whole(grid.Size, grid.OriginWorld, grid.Spacing, grid.Direction);
  samples->Grid = FieldGrid(
      {{last[0] - first[0] + 1, last[1] - first[1] + 1, last[2] - first[2] + 1}},
      whole.PointWorld(Vector3(first[0], first[1], first[2])), grid.Spacing, grid.Direction);
  samples->Values.reserve(samples->Grid.NodeCount());
  ForEachVoxel(first, last,
               [&](const std::array<int, 3>& at)
               { samples->Values.push_back(isInside(at) ? 1.0F : 0.0F); });
  return samples;
}

// How much of a place of a model's surface is next to a structure: the largest share on the way
// out.
double PartNextTo(const std::vector<std::shared_ptr<const TissueMap::Samples>>& structure,
                  const SphericalHarmonicModel& model, const Vector3& direction)
{
  constexpr double Step = 0.5; // mm
  const auto sample = model.EvaluateSecondOrder(direction);
  const Vector3 normal = (sample.Radius * direction - sample.SurfaceGradient).normalized();
  const Vector3 foot = model.CenterWorld() + sample.Radius * direction;
  double part = 0.0;
  for (double away = 0.0; away <= SofteningSettings::Neighbour::Reach; away += Step)
  {
    double share = 0.0; // of the structure's segments together
    for (const auto& image : structure)
    {
      share += image->At(foot + away * normal);
    }
    part = std::max(part, share);
  }
  return std::min(part, 1.0);
}

// Makes the solid of a model, and says what of the settings is in it.
class Composition
{
public:
  Composition(const SofteningSettings& settings, const SphericalHarmonicModel& model,
              ModelSoftness& made)
      : Settings(settings), Model(model), Made(made), Own(PerKilopascal * settings.TissueKilopascal)
  {
    made.Tissue = SignificantText(settings.TissueKilopascal) + " kPa";
  }

  ElasticSolid Solid(const ProgressFunction& progress)
  {
    constexpr double Radian = 3.14159265358979323846 / 180.0;
    ElasticSolid solid{TissueMap(this->Own), this->Settings.PoissonRatio,
                       ElasticBed(PerKilopascal * this->Settings.BedPerMillimeter)};
    for (const Vector3& side : this->Settings.FreeSides)
    {
      solid.Bed.Free(side, Radian * this->Settings.FreeDegrees);
    }
    for (const SofteningSettings::Neighbour& neighbour : this->Settings.Neighbours)
    {
      this->AddNeighbour(neighbour, solid.Bed);
    }
    if (this->Settings.Elastography != nullptr)
    {
      this->AddImage(*this->Settings.Elastography, solid.Tissue);
    }
    std::string inclusions;
    for (const SofteningSettings::Inclusion& inclusion : this->Settings.Inclusions)
    {
      if (progress && !progress(0.0, Stage))
      {
        throw Cancelled();
      }
      if (this->AddInclusion(inclusion, solid.Tissue))
      {
        inclusions += (inclusions.empty() ? ", inclusions of " : ", ") +
                      SignificantText(inclusion.Kilopascal);
      }
    }
    this->Made.Tissue += inclusions.empty() ? inclusions : inclusions + " kPa";
    if (this->Settings.Exaggeration != 1.0)
    {
      solid.Tissue.Exaggerate(this->Settings.Exaggeration);
      this->Made.Tissue += ExaggerationText(this->Settings.Exaggeration);
    }
    return solid;
  }

private:
  void AddNeighbour(const SofteningSettings::Neighbour& neighbour, ElasticBed& bed)
  {
    constexpr int Degree = 30;
    std::vector<std::shared_ptr<const TissueMap::Samples>> images;
    for (const Segment& segment : neighbour.Segments)
    {
      vtkImageData* layer = neighbour.Read->Layers[static_cast<std::size_t>(segment.Layer)];
      if (auto image = FractionOf(layer, segment.Value))
      {
        images.push_back(std::move(image));
      }
    }
    const auto part = [images, &model = this->Model](const Vector3& direction)
    { return PartNextTo(images, model, direction); };
    const std::vector<Vector3> around = SphereQuadrature(Degree).Directions;
    if (std::none_of(around.begin(), around.end(),
                     [&part](const Vector3& direction) { return part(direction) > 0.0; }))
    {
      this->Made.Notes.push_back(neighbour.Read->Source.string() +
                                 " is not next to the model and does not hold it");
    }
    bed.Hold(part, PerKilopascal * neighbour.KilopascalPerMillimeter);
  }

  void AddImage(const Volume& image, TissueMap& tissue)
  {
    tissue.AddImage(ModuliOf(image));
    RequireInput(tissue.Check(), image.Source.string());
    if (Changes(tissue, this->Model, this->Own))
    {
      this->Made.Tissue += ", elastography";
    }
    else
    {
      this->Made.Notes.push_back(image.Source.string() +
                                 " has no moduli within the model and does not change it");
    }
  }

  // Whether it lies in the model.
  bool AddInclusion(const SofteningSettings::Inclusion& inclusion, TissueMap& tissue)
  {
    const double modulus = PerKilopascal * inclusion.Kilopascal;
    TissueMap alone(this->Own);
    for (const Segment& segment : inclusion.Segments)
    {
      vtkImageData* layer = inclusion.Read->Layers[static_cast<std::size_t>(segment.Layer)];
      if (const auto fraction = FractionOf(layer, segment.Value))
      {
        tissue.AddInclusion(fraction, modulus);
        alone.AddInclusion(fraction, modulus);
      }
    }
    const std::string file = inclusion.Read->Source.string();
    RequireInput(alone.Check(), file);
    const bool isEqual = inclusion.Kilopascal == this->Settings.TissueKilopascal;
    const bool isInside = isEqual || Changes(alone, this->Model, this->Own);
    if (!isInside)
    {
      this->Made.Notes.push_back(file + " lies outside of the model and does not change it");
    }
    return isInside && !isEqual;
  }

  const SofteningSettings& Settings;
  const SphericalHarmonicModel& Model;
  ModelSoftness& Made;
  double Own; // N/mm^2
};
} // namespace

ModelSoftness SoftenModel(const SurfaceModel& model, const std::string& name,
                          const SofteningSettings& settings, const ProgressFunction& progress)
{
  const auto* radial = std::get_if<SphericalHarmonicModel>(&model);
  if (radial == nullptr)
  {
    Refuse(name, "is a surface model, and only a star-shaped one can yield",
           "fit it as a radial model, or let it be rigid");
  }
  RequireInput(settings.Check(), name);
  ModelSoftness made;
  const ElasticSolid solid = Composition(settings, *radial, made).Solid(progress);
  KernelWatch watch(progress, Stage);
  ComplianceMaps maps;
  const Status status =
      settings.Numbers.Make(*radial, solid, watch.Of(0.0, 1.0), maps, made.Account);
  watch.Require();
  RequireInput(status, name);
  made.Elasticity = std::make_shared<const ComplianceMaps>(std::move(maps));
  return made;
}
} // namespace palpate
