#include "StructureTrade.h"

#include "ElasticRepresentation.h"
#include "FilterRun.h"
#include "InputError.h"
#include "SceneLabels.h"
#include "SceneTissue.h"
#include "ShapeContact.h"
#include "TradeMeasure.h"
#include "Units.h"
#include "VoxelMinimum.h"

#include <algorithm>
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

// Whether it may change the elasticity of others.
bool IsSurrounding(const SceneStructure& structure)
{
  const std::vector<SceneNumber> numbers = SurroundingNumbers();
  return std::any_of(numbers.begin(), numbers.end(),
                     [&structure](const SceneNumber& number)
                     { return structure.Number(number.Key) > 0.0; });
}

// With what changes its elasticity, which is itself neither seen nor touched.
std::vector<SceneStructure> WithSurroundings(const SceneSettings& scene,
                                             const SceneStructure& structure)
{
  std::vector<SceneStructure> structures{structure};
  if (structure.Representation != TouchRepresentation::Elastic)
  {
    return structures;
  }
  for (SceneStructure one : scene.Structures)
  {
    if (one.Id != structure.Id && IsSurrounding(one))
    {
      one.IsVisible = one.IsTouchable = one.IsForbidden = false;
      structures.push_back(std::move(one));
    }
  }
  return structures;
}
} // namespace

StructureTrade::StructureTrade(const SceneSettings& scene, const SceneStructure& structure,
                               SceneRun made, const Settings& settings, const Clock& clock)
    : Scene(scene), Made(std::move(made)), Asked(settings), Time(clock)
{
  this->Scene.Structures = WithSurroundings(scene, structure);
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

bool StructureTrade::Yields() const
{
  return this->Scene.Structures.front().Representation == TouchRepresentation::Elastic;
}

std::shared_ptr<const FitResult> StructureTrade::ModelFromFile(const ProgressFunction& progress)
{
  ContactSetting rigid = SettingOf(this->Scene, TouchRepresentation::Harmonics);
  rigid.Structure.Mode = RadialContactMode::Nearest;
  this->ContactFor(rigid, progress);
  return ProductAs<FitResult>(
      this->Made.ProductAt(SceneStep::Model, this->Scene.Structures.front().Id));
}

// A scene that leaves the representation of a model open takes it from the model's file.
void StructureTrade::FindElasticity(const ProgressFunction& progress)
{
  SceneStructure& structure = this->Scene.Structures.front();
  const bool isOpen = structure.Representation == TouchRepresentation::Automatic ||
                      structure.Representation == TouchRepresentation::ModelOrField;
  if (isOpen && structure.Source() == SceneSource::Model &&
      this->ModelFromFile(progress)->Elasticity != nullptr)
  {
    structure.Representation = TouchRepresentation::Elastic;
  }
}

int StructureTrade::HighestDegree(const ProgressFunction& progress)
{
  const SceneStructure& structure = this->Scene.Structures.front();
  if (structure.Source() == SceneSource::Model && this->Yields())
  {
    const auto elasticity = this->ModelFromFile(progress)->Elasticity;
    return elasticity != nullptr ? elasticity->Degree : 0;
  }
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
  this->FindElasticity(progress);
  return CandidatesFor(this->Scene, this->HighestDegree(progress));
}

std::unique_ptr<TradeReference>
StructureTrade::MakeElasticReference(const ProgressFunction& progress)
{
  const int inFile = this->Scene.Structures.front().Source() == SceneSource::Model
                         ? this->HighestDegree(progress)
                         : 0;
  const ContactSetting finest =
      FinestElastic(SettingOf(this->Scene, TouchRepresentation::Elastic), inFile);
  const std::string what =
      inFile > 0 ? "the file's own elasticity, maps of degree " + std::to_string(inFile) +
                       "; its tissue is not known here, so that elements and compliance cannot be "
                       "varied"
                 : "a finer setting of the same tissue: " + Describe(finest);
  return ElasticReference(*this->ContactFor(finest, progress), what, this->Scene.Tool);
}

std::shared_ptr<const TouchContact> StructureTrade::FieldOfVoxels(FieldInterpolation interpolation,
                                                                  const ProgressFunction& progress)
{
  ContactSetting setting = SettingOf(this->Scene, TouchRepresentation::SubVoxel);
  setting.Structure.Interpolation = interpolation;
  setting.Structure.Smoothing = SceneStructure().Smoothing; // not one that is to be judged
  try
  {
    return this->ContactFor(setting, progress);
  }
  catch (const InputError&)
  {
    setting.Structure.Smoothing = 0.0; // the structure may be thinner than the smoothing
    return this->ContactFor(setting, progress);
  }
}

// Estimates of what the voxels were taken from: the shape interpolated between slices, the same
// without what one slice alone shows, and the distances that the voxels have.
std::unique_ptr<TradeReference> StructureTrade::MakeMaskReference(const ProgressFunction& progress)
{
  constexpr double SlicesSmoothed = 1.5;
  const SceneStructure& structure = this->Scene.Structures.front();
  const auto voxels = this->FieldOfVoxels(FieldInterpolation::TricubicBSpline, progress);
  const auto read = this->Made.SegmentationOf(structure.File, this->Scene.LeftHanded, progress);
  const auto shape = [&](double smoothing, const std::string& what)
  {
    return FieldReference(MakeShapeContact(*read, SegmentOf(structure, *read), smoothing), what,
                          this->Scene.Tool);
  };
  Vector3 spacing = voxels->Field->Grid().Spacing();
  std::sort(spacing.data(), spacing.data() + 3);
  std::vector<std::unique_ptr<TradeReference>> others;
  others.push_back(
      FieldReference(*voxels, "the tricubic field of its voxels' distances", this->Scene.Tool));
  others.push_back(shape(SlicesSmoothed * spacing[2] / spacing[1], "a smoother shape"));
  return UncertainReference(shape(1.0, "the mask's shape, interpolated between slices"),
                            std::move(others), voxels->Field->Grid().WorldToIndex());
}

std::unique_ptr<TradeReference> StructureTrade::MakeImageReference(const ProgressFunction& progress)
{
  const auto field = [&](FieldInterpolation interpolation, const std::string& what)
  { return FieldReference(*this->FieldOfVoxels(interpolation, progress), what, this->Scene.Tool); };
  std::vector<std::unique_ptr<TradeReference>> others;
  others.push_back(field(FieldInterpolation::Trilinear, "the trilinear field"));
  return UncertainReference(
      field(FieldInterpolation::TricubicBSpline, "the tricubic field of the image's values"),
      std::move(others), std::nullopt);
}

std::unique_ptr<TradeReference> StructureTrade::MakeReference(const ProgressFunction& progress)
{
  const SceneStructure& structure = this->Scene.Structures.front();
  if (this->Yields())
  {
    return this->MakeElasticReference(progress);
  }
  switch (structure.Source())
  {
  case SceneSource::Model:
    return ModelReference(this->ModelFromFile(progress)->Model, this->Scene.Tool);
  case SceneSource::Surface:
    return FacetReference(
        *this->ContactFor(SettingOf(this->Scene, TouchRepresentation::Facets), progress),
        this->Scene.Tool);
  case SceneSource::Label:
    return this->MakeMaskReference(progress);
  default:
    return this->MakeImageReference(progress);
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
  constexpr double Touched = 600.0; // s
  row.CostSeconds =
      row.BuildSeconds + Touched * this->Scene.Rate * SecondsPerNanosecond * row.TickMean;
}

void StructureTrade::Prepare(const ProgressFunction& progress)
{
  if (this->Path.Ticks.empty())
  {
    this->FindElasticity(progress);
    this->Reference = this->MakeReference(progress);
    this->Path = MakeTradePath(*this->Reference, this->Scene.Tool, this->Asked.Path, progress);
  }
}

const TradePath& StructureTrade::MeasuredPath(const ProgressFunction& progress)
{
  this->Prepare(progress);
  return this->Path;
}

TradeRow StructureTrade::Measure(const ContactSetting& setting, const ProgressFunction& progress)
{
  this->Prepare(progress);
  TradeRow row;
  row.Structure = TitleOf(this->Scene.Structures.front());
  row.Setting = setting;
  row.Yields = this->Yields();
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
  const auto count = static_cast<double>(1 + settings.size());
  for (const ContactSetting& setting : settings)
  {
    this->Prepare([&](double part, const std::string& /*stage*/)
                  { return progress(part / count, "reference"); });
    const auto done = static_cast<double>(1 + rows.size());
    rows.push_back(this->Measure(setting, [&](double part, const std::string& /*stage*/)
                                 { return progress((done + part) / count, Describe(setting)); }));
  }
  return rows;
}
} // namespace palpate
