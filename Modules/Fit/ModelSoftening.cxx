#include "ModelSoftening.h"

#include "DecimalText.h"
#include "ImageGrid.h"
#include "KernelWatch.h"
#include "Refusal.h"
#include "SegmentationFile.h"
#include "SphereQuadrature.h"
#include "VolumeFile.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr double PerKilopascal = 1e-3; // N/mm^2

FieldGrid FieldGridOf(vtkImageData* image)
{
  const ImageGrid grid = GridOf(image);
  return {grid.Size, grid.OriginWorld, grid.Spacing, grid.Direction};
}

// What a value of the image contributes.
template <typename Contribution>
std::shared_ptr<const TissueMap::Samples> SamplesOf(vtkImageData* image,
                                                    const Contribution& contribution)
{
  auto samples = std::make_shared<TissueMap::Samples>();
  samples->Grid = FieldGridOf(image);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  samples->Values.reserve(static_cast<std::size_t>(values->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    samples->Values.push_back(contribution(values->GetComponent(i, 0)));
  }
  return samples;
}

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

void AddInclusion(const SofteningSettings::Inclusion& inclusion, const SofteningSettings& settings,
                  const SphericalHarmonicModel& model, TissueMap& tissue,
                  std::vector<std::string>& notes)
{
  const double modulus = PerKilopascal * inclusion.Kilopascal;
  const Segmentation read = ReadSegmentation(inclusion.File, settings.Choice);
  notes.insert(notes.end(), read.Notes.begin(), read.Notes.end());
  std::vector<Segment> segments = read.Segments;
  if (!inclusion.Label.empty())
  {
    segments = {read.Find(inclusion.Label)};
  }
  TissueMap alone(PerKilopascal * settings.TissueKilopascal);
  for (const Segment& segment : segments)
  {
    const auto fraction =
        SamplesOf(read.Layers[static_cast<std::size_t>(segment.Layer)].Get(),
                  [&segment](double value) { return value == segment.Value ? 1.0F : 0.0F; });
    tissue.AddInclusion(fraction, modulus);
    alone.AddInclusion(fraction, modulus);
  }
  RequireInput(alone.Check(), inclusion.File.string());
  if (inclusion.Kilopascal != settings.TissueKilopascal &&
      !Changes(alone, model, PerKilopascal * settings.TissueKilopascal))
  {
    notes.push_back(inclusion.File.string() + " lies outside of the model and does not change it");
  }
}

ElasticSolid SolidOf(const SofteningSettings& settings, const SphericalHarmonicModel& model,
                     std::vector<std::string>& notes)
{
  constexpr double Radian = 3.14159265358979323846 / 180.0;
  ElasticSolid solid{TissueMap(PerKilopascal * settings.TissueKilopascal), settings.PoissonRatio,
                     ElasticBed(PerKilopascal * settings.BedPerMillimeter)};
  for (const Vector3& side : settings.FreeSides)
  {
    solid.Bed.Free(side, Radian * settings.FreeDegrees);
  }
  if (!settings.Elastography.empty())
  {
    const Volume image = ReadVolume(settings.Elastography, settings.Choice);
    notes.insert(notes.end(), image.Notes.begin(), image.Notes.end());
    solid.Tissue.AddImage(SamplesOf(image.Image.Get(), [](double kilopascal)
                                    { return static_cast<float>(PerKilopascal * kilopascal); }));
    if (!Changes(solid.Tissue, model, PerKilopascal * settings.TissueKilopascal))
    {
      notes.push_back(settings.Elastography.string() +
                      " has no moduli within the model and does not change it");
    }
  }
  for (const SofteningSettings::Inclusion& inclusion : settings.Inclusions)
  {
    AddInclusion(inclusion, settings, model, solid.Tissue, notes);
  }
  return solid;
}

std::vector<std::pair<std::string, std::string>> TextOf(const SofteningSettings& settings)
{
  std::vector<std::pair<std::string, std::string>> lines{
      {"tissue_kpa", SignificantText(settings.TissueKilopascal)},
      {"poisson_ratio", SignificantText(settings.PoissonRatio)},
      {"bed_kpa_per_mm", SignificantText(settings.BedPerMillimeter)},
      {"elements_across", std::to_string(settings.Numbers.ElementsAcross)},
      {"compliance_degree", std::to_string(settings.Numbers.Degree)}};
  for (const SofteningSettings::Inclusion& inclusion : settings.Inclusions)
  {
    lines.emplace_back("inclusion", inclusion.File.filename().string() + " " +
                                        SignificantText(inclusion.Kilopascal) + " kPa");
  }
  return lines;
}
} // namespace

SoftenedModel SoftenModel(const ModelDocument& model, const std::string& name,
                          const SofteningSettings& settings, const ProgressFunction& progress)
{
  const auto* radial = std::get_if<SphericalHarmonicModel>(&model.Surface);
  if (radial == nullptr)
  {
    Refuse(name, "is a surface model, and only a star-shaped one can yield",
           "fit it with --model radial");
  }
  SoftenedModel softened;
  softened.Document = model;
  const ElasticSolid solid = SolidOf(settings, *radial, softened.Notes);
  KernelWatch watch(progress, "elasticity");
  ComplianceMaps maps;
  const Status status =
      settings.Numbers.Make(*radial, solid, watch.Of(0.0, 1.0), maps, softened.Account);
  watch.Require();
  RequireInput(status, name);
  softened.Document.Elasticity = std::make_shared<const ComplianceMaps>(std::move(maps));
  auto& lines = softened.Document.Provenance.Settings;
  const auto added = TextOf(settings);
  lines.insert(lines.end(), added.begin(), added.end());
  return softened;
}
} // namespace palpate
