#include "StructureTrade.h"

#include "FilterRun.h"
#include "InputError.h"
#include "TradeMeasure.h"
#include "VoxelMinimum.h"

#include <utility>

namespace palpate
{
namespace
{
// Only touched: what it is displayed as, drilled by and protected from takes no part.
SceneStructure OnlyTouched(SceneStructure structure)
{
  structure.IsTouchable = true;
  structure.IsVisible = structure.IsForbidden = false;
  structure.Drill = {};
  for (const SceneEffectKind& kind : SceneEffectKinds())
  {
    structure.SetNumber(kind.Numbers.front().Key, 0.0);
  }
  return structure;
}
} // namespace

StructureTrade::StructureTrade(const SceneSettings& scene, const SceneStructure& structure,
                               SceneRun made, const Settings& settings, const Clock& clock)
    : Scene(scene), Made(std::move(made)), Asked(settings), Time(clock)
{
  this->Scene.Structures = {structure};
  this->Scene.Fit.Tolerance.reset(); // each setting has its own degree
}

StructureTrade::~StructureTrade() = default;

std::shared_ptr<const TouchContact> StructureTrade::ContactFor(const ContactSetting& setting,
                                                               const ProgressFunction& progress)
{
  SceneSettings scene = WithSetting(this->Scene, setting);
  scene.Structures.front() = OnlyTouched(scene.Structures.front());
  this->Made.Make(scene, progress);
  return ProductAs<TouchContact>(
      this->Made.ProductAt(SceneStep::Touch, scene.Structures.front().Id));
}

int StructureTrade::HighestDegree(const ProgressFunction& progress)
{
  const SceneStructure& structure = this->Scene.Structures.front();
  if (structure.Source() == SceneSource::Surface)
  {
    return this->Scene.Fit.MaximumDegree; // no voxels limit it
  }
  if (structure.Source() != SceneSource::Label)
  {
    return 0;
  }
  try
  {
    this->ContactFor(SettingOf(this->Scene, TouchRepresentation::Facets), progress);
  }
  catch (const InputError&)
  {
    // Each setting gives the reason.
  }
  constexpr double CubicMillimetersPerMilliliter = 1000.0;
  const auto surface =
      ProductAs<FitSurface>(this->Made.ProductAt(SceneStep::Surface, structure.Id));
  if (surface == nullptr || surface->IsOver)
  {
    return 0;
  }
  return SupportedDegree(CubicMillimetersPerMilliliter * surface->Found.MaskMilliliters,
                         surface->Found.Mask);
}

std::vector<ContactSetting> StructureTrade::Candidates(const ProgressFunction& progress)
{
  return CandidatesFor(this->Scene, this->HighestDegree(progress));
}

std::unique_ptr<TradeReference> StructureTrade::MakeReference(const ProgressFunction& progress)
{
  const SceneStructure& structure = this->Scene.Structures.front();
  const auto make = [&](const char* representation)
  {
    ContactSetting finest = SettingOf(this->Scene, representation);
    finest.Structure.Interpolation = FieldInterpolation::TricubicBSpline;
    return this->ContactFor(finest, progress);
  };
  switch (structure.Source())
  {
  case SceneSource::Model:
  {
    make(TouchRepresentation::Harmonics);
    const auto fit = ProductAs<FitResult>(this->Made.ProductAt(SceneStep::Model, structure.Id));
    return ModelReference(fit->Model, this->Scene.Tool);
  }
  case SceneSource::Surface:
    return FacetReference(*make(TouchRepresentation::Facets), this->Scene.Tool);
  case SceneSource::Label:
    return FieldReference(*make(TouchRepresentation::SubVoxel),
                          "the mask's smoothed signed distance", this->Scene.Tool);
  default:
    return FieldReference(*make(TouchRepresentation::SubVoxel), "the image's values",
                          this->Scene.Tool);
  }
}

void StructureTrade::Fill(const ContactSetting& setting, TradeRow& row,
                          const ProgressFunction& progress)
{
  const auto contact = this->ContactFor(setting, progress);
  const SceneStructure& structure = this->Scene.Structures.front();
  row.Represented = contact->Represented;
  row.BuildSeconds = this->Made.SecondsOf(structure.Id);
  TradeTouch touch;
  touch.Tool = this->Scene.Tool;
  touch.Tool.Points = setting.ToolPoints;
  // Errors in mm and JND need a force.
  touch.Stiffness = structure.Stiffness > 0.0 ? structure.Stiffness : SceneStructure().Stiffness;
  touch.Runs = this->Asked.Runs;
  MeasureTouch(*contact->Model, touch, this->Path, this->Time, row, progress);
}

TradeRow StructureTrade::Measure(const ContactSetting& setting, const ProgressFunction& progress)
{
  if (this->Path.Ticks.empty())
  {
    this->Reference = this->MakeReference(progress);
    this->Path = MakeTradePath(*this->Reference, this->Scene.Tool, this->Asked.Path, progress);
  }
  TradeRow row;
  row.Structure = TitleOf(this->Scene.Structures.front());
  row.Setting = setting;
  row.Truth = this->Reference->Details();
  const auto refuse = [&row](const std::exception& why)
  {
    row.State = TradeRow::Outcome::Refused;
    row.Message = why.what();
  };
  try
  {
    this->Fill(setting, row, progress);
  }
  catch (const InputError& why)
  {
    refuse(why);
  }
  catch (const FilterError& why)
  {
    refuse(why);
  }
  return row;
}

std::vector<TradeRow> StructureTrade::MeasureAll(const std::vector<ContactSetting>& settings,
                                                 const ProgressFunction& progress)
{
  std::vector<TradeRow> rows;
  const auto count = static_cast<double>(settings.size());
  for (const ContactSetting& setting : settings)
  {
    const auto done = static_cast<double>(rows.size());
    rows.push_back(this->Measure(setting, [&](double part, const std::string& /*stage*/)
                                 { return progress((done + part) / count, Describe(setting)); }));
  }
  return rows;
}
} // namespace palpate
