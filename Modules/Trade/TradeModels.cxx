#include "TradeModels.h"

#include "CaseText.h"
#include "DecimatedSurface.h"
#include "FilterRun.h"
#include "FitHints.h"
#include "InputError.h"
#include "ModelSurface.h"
#include "ModelTable.h"
#include "Refusal.h"
#include "SceneField.h"
#include "SceneIsoSurface.h"
#include "SupportedDegree.h"
#include "VoxelMinimum.h"
#include "vtkSphericalHarmonicFit.h"

#include "vtkNew.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
// Of a surface without voxels: what 4,002 directions tell with room to spare.
constexpr int SurfaceDegree = 24;
constexpr int FacesOfIcosahedron = 20;

const TradeSource::Mask* MaskOf(const TradeSource& source)
{
  return std::get_if<TradeSource::Mask>(&source.Is);
}
const TradeSource::Image* ImageOf(const TradeSource& source)
{
  return std::get_if<TradeSource::Image>(&source.Is);
}
const SphericalHarmonicModel* ModelOf(const TradeSource& source)
{
  const auto* model = std::get_if<TradeSource::Model>(&source.Is);
  return model == nullptr ? nullptr : model->get();
}

void RequireFit(const FitResult& found, bool isOver, const TradeSource& source)
{
  if (isOver && found.State == FitResult::Outcome::BadInput)
  {
    throw InputError(
        WithHint(CaseSentence(found.Input, found.Structure, found.Message), ChooseAnother));
  }
  if (isOver)
  {
    throw InputError(source.Name + " " + found.Message);
  }
}
} // namespace

TradeModels::TradeModels(TradeSource source, const Clock& clock)
    : Structure(std::move(source)), Time(clock)
{
}

template <typename Part>
const Part& TradeModels::Counted(const Made<Part>& made, double& seconds)
{
  seconds += made.Seconds;
  return made.Content;
}

double TradeModels::SecondsSince(std::int64_t start) const
{
  constexpr double SecondsPerNanosecond = 1e-9;
  return SecondsPerNanosecond * static_cast<double>(this->Time.Now() - start);
}

void TradeModels::RefuseRepresentation(const std::string& what) const
{
  throw InputError(this->Structure.Name + " cannot be represented by " + what +
                   "; measure another representation");
}

const TradeModels::Made<FitSurface>& TradeModels::MaskSurface(const ProgressFunction& progress)
{
  if (!this->OwnMaskSurface)
  {
    const std::int64_t start = this->Time.Now();
    const TradeSource::Mask& mask = *MaskOf(this->Structure);
    FitSurface made = MakeFitSurface(*mask.Voxels, mask.Structure, FitSettings(), progress);
    RequireFit(made.Found, made.IsOver, this->Structure);
    this->OwnMaskSurface = {std::move(made), this->SecondsSince(start)};
  }
  return *this->OwnMaskSurface;
}

const TradeModels::Made<vtkSmartPointer<vtkPolyData>>&
TradeModels::Surface(const ProgressFunction& progress)
{
  if (!this->OwnSurface)
  {
    if (MaskOf(this->Structure) != nullptr)
    {
      const Made<FitSurface>& made = this->MaskSurface(progress);
      this->OwnSurface = {made.Content.Found.Surface, made.Seconds};
    }
    else if (const auto* image = ImageOf(this->Structure))
    {
      const std::int64_t start = this->Time.Now();
      auto surface = MakeIsoSurface(image->Voxels->Image, image->Iso, progress);
      this->OwnSurface = {std::move(surface), this->SecondsSince(start)};
    }
    else if (const auto* surface = std::get_if<TradeSource::Surface>(&this->Structure.Is))
    {
      this->OwnSurface = {*surface, 0.0};
    }
    else
    {
      this->RefuseRepresentation("a surface of its own, since it is a model");
    }
  }
  return *this->OwnSurface;
}

const TradeModels::Made<FitSamples>& TradeModels::Samples(const ProgressFunction& progress)
{
  if (!this->OwnSamples)
  {
    FitSurface surface;
    double seconds = 0.0;
    if (MaskOf(this->Structure) != nullptr)
    {
      surface = Counted(this->MaskSurface(progress), seconds);
    }
    else
    {
      surface.Found.Surface = Counted(this->Surface(progress), seconds);
    }
    const std::int64_t start = this->Time.Now();
    FitSamples made = MakeFitSamples(surface, FitSettings(), progress);
    RequireFit(made.Found, made.IsOver, this->Structure);
    this->OwnSamples = {std::move(made), seconds + this->SecondsSince(start)};
  }
  return *this->OwnSamples;
}

const TradeModels::Made<std::shared_ptr<const ScalarField>>&
TradeModels::Field(const TradeSetting& setting, const ProgressFunction& progress)
{
  const FieldInterpolation form = setting.Interpolation;
  const auto found = this->Fields.find(form);
  if (found != this->Fields.end())
  {
    return found->second;
  }
  const std::int64_t start = this->Time.Now();
  std::shared_ptr<const ScalarField> field;
  if (const auto* mask = MaskOf(this->Structure))
  {
    field = MakeSegmentField(*mask->Voxels, {mask->Structure}, form, this->Structure.Smoothing,
                             progress);
  }
  else if (const auto* image = ImageOf(this->Structure))
  {
    field = MakeIsoField(image->Voxels->Image, {image->Iso}, form, progress);
  }
  else
  {
    this->RefuseRepresentation("a sub-voxel field, since it has no voxels");
  }
  return this->Fields[form] = {std::move(field), this->SecondsSince(start)};
}

SphericalHarmonicModel TradeModels::FittedModel(int degree, double& seconds,
                                                const ProgressFunction& progress)
{
  const FitSamples& samples = Counted(this->Samples(progress), seconds);
  const std::int64_t start = this->Time.Now();
  auto shared = vtkSmartPointer<vtkPolyData>::New();
  shared->ShallowCopy(samples.Samples);
  vtkNew<vtkSphericalHarmonicFit> fit;
  fit->SetInputData(shared);
  fit->SetDegree(degree);
  RunFilter(fit, "fit", 0.0, 1.0, progress);
  SphericalHarmonicModel model;
  if (!FromTable(fit->GetOutput(), model))
  {
    this->RefuseRepresentation("harmonics");
  }
  seconds += this->SecondsSince(start);
  return model;
}

SphericalHarmonicModel TradeModels::ModelOf(int degree, const ProgressFunction& progress)
{
  double ignored = 0.0;
  const SphericalHarmonicModel* known = palpate::ModelOf(this->Structure);
  return known != nullptr ? known->WithDegree(degree)
                          : this->FittedModel(degree, ignored, progress);
}

int TradeModels::FacetCount(const ProgressFunction& progress)
{
  return palpate::ModelOf(this->Structure) != nullptr
             ? 0
             : static_cast<int>(this->Surface(progress).Content->GetNumberOfCells());
}

int TradeModels::HighestDegree(const ProgressFunction& progress)
{
  if (const auto* model = palpate::ModelOf(this->Structure))
  {
    return model->Degree();
  }
  if (MaskOf(this->Structure) == nullptr)
  {
    return SurfaceDegree;
  }
  constexpr double CubicMillimetersPerMilliliter = 1000.0;
  const FitResult& found = this->MaskSurface(progress).Content.Found;
  return SupportedDegree(CubicMillimetersPerMilliliter * found.MaskMilliliters, found.Mask);
}

TradeModel TradeModels::MakeHarmonics(const TradeSetting& setting, const ProgressFunction& progress)
{
  TradeModel made;
  const SphericalHarmonicModel* known = palpate::ModelOf(this->Structure);
  const SphericalHarmonicModel model =
      known != nullptr ? known->WithDegree(setting.Degree)
                       : this->FittedModel(setting.Degree, made.Seconds, progress);
  const std::int64_t start = this->Time.Now();
  made.Contact = MakeHarmonicContact(model, setting.Mode, this->Structure.File);
  made.Seconds += this->SecondsSince(start);
  return made;
}

const TradeModels::Made<vtkSmartPointer<vtkPolyData>>&
TradeModels::Facets(int facets, const ProgressFunction& progress)
{
  const auto found = this->FewerFacets.find(facets);
  if (found != this->FewerFacets.end())
  {
    return found->second;
  }
  if (const SphericalHarmonicModel* known = palpate::ModelOf(this->Structure))
  {
    const std::int64_t start = this->Time.Now();
    const double faces = std::max(facets, FacesOfIcosahedron);
    auto surface =
        DrawModel(*known, static_cast<int>(std::lround(std::sqrt(faces / FacesOfIcosahedron))));
    return this->FewerFacets[facets] = {std::move(surface), this->SecondsSince(start)};
  }
  const Made<vtkSmartPointer<vtkPolyData>>& whole = this->Surface(progress);
  if (facets == 0 || facets >= whole.Content->GetNumberOfCells())
  {
    return whole;
  }
  const std::int64_t start = this->Time.Now();
  auto surface = DecimatedSurface(whole.Content, facets, progress);
  return this->FewerFacets[facets] = {std::move(surface),
                                      whole.Seconds + this->SecondsSince(start)};
}

TradeModel TradeModels::MakeFacets(const TradeSetting& setting, const ProgressFunction& progress)
{
  TradeModel made;
  vtkPolyData* surface = Counted(this->Facets(setting.Facets, progress), made.Seconds);
  const std::int64_t start = this->Time.Now();
  made.Contact = MakeFacetContact(surface, this->Structure.File);
  made.Seconds += this->SecondsSince(start);
  return made;
}

TradeModel TradeModels::MakeField(const TradeSetting& setting, const ProgressFunction& progress)
{
  TradeModel made;
  const auto& field = Counted(this->Field(setting, progress), made.Seconds);
  const std::int64_t start = this->Time.Now();
  made.Contact = MakeFieldContact(field, 0, this->Structure.File);
  made.Seconds += this->SecondsSince(start);
  return made;
}

TradeModel TradeModels::Make(const TradeSetting& setting, const ProgressFunction& progress)
{
  switch (setting.Representation)
  {
  case TouchRepresentation::Harmonics:
    return this->MakeHarmonics(setting, progress);
  case TouchRepresentation::Facets:
    return this->MakeFacets(setting, progress);
  default:
    return this->MakeField(setting, progress);
  }
}
} // namespace palpate
