#include "ModelSoftening.h"

#include "DecimalText.h"
#include "ImageGrid.h"
#include "KernelWatch.h"
#include "Progress.h"
#include "Refusal.h"
#include "SofteningKey.h"
#include "SphereQuadrature.h"
#include "Units.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
constexpr const char* Stage = "elasticity";

// Whether the organ's tissue differs from its own somewhere.
bool Changes(const TissueMap& tissue, const RadialModel& model, double own)
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
    samples->Values.push_back(
        static_cast<float>(MegapascalsPerKilopascal * values->GetComponent(i, 0)));
  }
  return samples;
}

// How much of a place of a model's surface is next to a structure: the largest share on the way
// out.
double PartNextTo(const InclusionFractions& structure, const RadialModel& model,
                  const Vector3& direction)
{
  constexpr int Steps = 6;
  const Vector3 normal = model.Normal(direction);
  const Vector3 foot = model.PointWorld(direction);
  double part = 0.0;
  for (int step = 0; step <= Steps; ++step)
  {
    const double away = SofteningSettings::Neighbour::Reach * step / Steps;
    double share = 0.0; // of the structure's segments together
    for (const auto& image : structure)
    {
      share += image->At(foot + away * normal);
    }
    part = std::max(part, share);
  }
  return std::min(part, 1.0);
}

// Measured in a notch of 90 degrees (TestElasticNotch), for a hollow that the harmonics of the
// compliance do not resolve.
std::string HollowNote(const RadialModel& model, int degree)
{
  const double radius = OrganSoftening::SharpestHollow(model);
  return radius < OrganSoftening::SharpHollow && degree < OrganSoftening::DegreeInHollows
             ? "the surface has a hollow with a radius of " + FixedText(radius, 1) +
                   " mm: where a ball touches both sides of it, its force may be off by 14 %; a "
                   "compliance of degree 20, with at least 10 elements across, makes that 8 %"
             : std::string();
}

// Makes the solid of a model, and says what of the settings is in it.
class Composition
{
public:
  Composition(const SofteningSettings& settings, const RadialModel& model, ModelSoftness& made)
      : Settings(settings), Model(model), Made(made), Inputs(model, settings),
        Own(MegapascalsPerKilopascal * settings.TissueKilopascal)
  {
    made.Tissue = SignificantText(settings.TissueKilopascal) + " kPa";
  }

  ElasticSolid Solid(const ProgressFunction& progress)
  {
    constexpr double Radian = 3.14159265358979323846 / 180.0;
    ElasticSolid solid{TissueMap(this->Own), this->Settings.PoissonRatio,
                       ElasticBed(MegapascalsPerKilopascal * this->Settings.BedPerMillimeter)};
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
      ReportProgress(progress, 0.0, Stage);
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

  /// After Solid: of all that it is made of.
  std::string Key() const { return this->Inputs.Text(); }

private:
  void AddNeighbour(const SofteningSettings::Neighbour& neighbour, ElasticBed& bed)
  {
    constexpr int Degree = 30;
    const InclusionFractions images = FractionsOf(*neighbour.Read, neighbour.Segments);
    for (const auto& image : images)
    {
      this->Inputs.Add("neighbour", *image, neighbour.KilopascalPerMillimeter);
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
    bed.Hold(part, MegapascalsPerKilopascal * neighbour.KilopascalPerMillimeter);
  }

  void AddImage(const Volume& image, TissueMap& tissue)
  {
    const std::shared_ptr<const TissueMap::Samples> moduli = ModuliOf(image);
    this->Inputs.Add("moduli", *moduli, 0.0);
    tissue.AddImage(moduli);
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

  // Whether it changes the tissue.
  bool AddInclusion(const SofteningSettings::Inclusion& inclusion, TissueMap& tissue)
  {
    const double modulus = MegapascalsPerKilopascal * inclusion.Kilopascal;
    const InclusionFractions fractions = FractionsOf(*inclusion.Read, inclusion.Segments);
    TissueMap alone(this->Own);
    for (const auto& fraction : fractions)
    {
      alone.AddInclusion(fraction, modulus);
    }
    RequireInput(alone.Check(), inclusion.Read->Source.string());
    this->Made.Inclusions.push_back(
        ShareOf(this->Model, *inclusion.Read, inclusion.Segments, fractions));
    const bool isInside = this->Made.Inclusions.back().IsInside();
    for (std::size_t i = 0; isInside && i < fractions.size(); ++i)
    {
      this->Inputs.Add("inclusion", *fractions[i], inclusion.Kilopascal);
      tissue.AddInclusion(fractions[i], modulus);
    }
    return isInside && inclusion.Kilopascal != this->Settings.TissueKilopascal;
  }

  const SofteningSettings& Settings;
  const RadialModel& Model;
  ModelSoftness& Made;
  SofteningKey Inputs;
  double Own; // N/mm^2
};
} // namespace

std::vector<std::string> ModelSoftness::Warnings() const
{
  std::vector<std::string> warnings = this->Notes;
  for (const InclusionShare& inclusion : this->Inclusions)
  {
    const std::string note = inclusion.Note("the model");
    if (!note.empty())
    {
      warnings.push_back(note);
    }
  }
  return warnings;
}

ModelSoftness SoftenModel(const OrganModel& model, const std::string& name,
                          const SofteningSettings& settings, const ProgressFunction& progress,
                          const SofteningCache* cache)
{
  const auto* radial = std::get_if<RadialModel>(&model);
  if (radial == nullptr)
  {
    Refuse(name, "is a surface model, and only a radial one can yield",
           "fit it as a radial model, or let it be rigid");
  }
  RequireInput(settings.Check(), name);
  RequireInput(settings.CheckSupportOf(*radial), name);
  ModelSoftness made;
  Composition composition(settings, *radial, made);
  const ElasticSolid solid = composition.Solid(progress);
  made.ComplianceDegree = settings.Numbers.DegreeFor(*radial);
  if (const std::string note = HollowNote(*radial, made.ComplianceDegree); !note.empty())
  {
    made.Notes.push_back(note);
  }
  const std::string key = composition.Key();
  if (auto kept = cache != nullptr ? cache->Find(key, *radial) : std::nullopt)
  {
    made.Elasticity = std::move(kept->Elasticity);
    made.Account = kept->Account;
    made.IsFromCache = true;
    return made;
  }
  KernelWatch watch(progress, Stage);
  ComplianceMaps maps;
  const Status status =
      settings.Numbers.Make(*radial, solid, watch.Of(0.0, 1.0), maps, made.Account);
  watch.Require();
  RequireInput(status, name);
  made.Elasticity = std::make_shared<const ComplianceMaps>(std::move(maps));
  if (cache != nullptr)
  {
    cache->Store(key, *radial, {made.Elasticity, made.Account});
  }
  return made;
}
} // namespace palpate
