#include "DegreeMemory.h"

#include "FitStructure.h"
#include "HarmonicSurface.h"
#include "ModelFile.h"
#include "ResidentMemory.h"
#include "Segmentation.h"
#include "TemporaryFolder.h"
#include "TouchRun.h"

#include <malloc.h>

namespace palpate::bench
{
namespace
{
constexpr const char* Atlas = "/usr/share/mricron/templates/aal.nii.gz";

bool GoOn(double, const std::string&)
{
  return true;
}

// Of every structure that a radius can say anything of; how well does not matter here.
std::vector<TouchStructureSettings> WriteModels(const test::TemporaryFolder& folder)
{
  const Segmentation atlas = ReadSegmentation(Atlas);
  FitSettings settings;
  settings.MaximumHiddenPercent = 100.0;
  settings.MinimumDice = 0.0;
  std::vector<TouchStructureSettings> written;
  for (const Segment& structure : atlas.Segments)
  {
    const FitResult fit = FitStructure(atlas, structure, settings);
    std::shared_ptr<const HarmonicSurface> surface;
    if (fit.State == FitResult::Outcome::Fitted &&
        HarmonicSurface::Make(std::make_shared<const SphericalHarmonicModel>(fit.Model),
                              EvaluationPrecision::Double, surface)
            .IsOk())
    {
      TouchStructureSettings entry;
      entry.File = folder / (std::to_string(structure.Label) + ".json");
      entry.IsSeen = false;
      WriteModel(entry.File, {fit.Model, {}});
      written.push_back(entry);
    }
  }
  return written;
}

// What is felt from the beginning on: models, stand-ins and trackers.
std::uintmax_t BytesOf(const TouchStructures& made, const TouchSettings& settings)
{
  std::uintmax_t bytes = AccountForServo(made, settings).Bytes;
  for (const SceneStructureAccount& structure : made.Account.Structures)
  {
    bytes += structure.Contact.Bytes;
  }
  return bytes;
}

DegreeRow Measure(TouchSettings settings, std::optional<double> megabytes,
                  const std::filesystem::path& recording)
{
  settings.MemoryMegabytes = megabytes;
  DegreeRow row{};
  row.Structures = static_cast<int>(settings.Structures.size());
  row.BudgetMegabytes = megabytes;
  row.KeptBytes = BytesOf(MakeTouchStructures(settings, false, GoOn), settings);
  malloc_trim(0);
  const double before = ResidentMebibytes();
  TouchScript script;
  script.SweepSpeed = 90.0;
  script.Duration = 20.0;
  const PreparedTouch touch = PrepareTouch(settings, script, GoOn);
  TouchRunSettings run;
  run.Recording = megabytes ? std::filesystem::path() : recording;
  const TouchResult result = RunTouch(touch, run, GoOn);
  row.ResidentMebibytes = ResidentMebibytes() - before;
  row.CoarseTicks = result.CoarseTicks;
  if (touch.Degrees != nullptr)
  {
    const DegreeCounts counts = touch.Degrees->Counts();
    row.MostBytes = counts.MostBytes;
    row.Brought = counts.Brought;
  }
  const TouchComparison comparison = CompareTouch(touch, recording);
  row.Ticks = comparison.Ticks;
  row.DifferentTicks = comparison.DifferentTicks;
  return row;
}
} // namespace

std::vector<DegreeRow> MeasureDegrees()
{
  std::vector<DegreeRow> rows;
  if (!std::filesystem::exists(Atlas))
  {
    return rows;
  }
  const test::TemporaryFolder folder;
  TouchSettings settings;
  settings.Structures = WriteModels(folder);
  settings.Scale = 1.0;
  const auto recording = folder / "all.touch";
  rows.push_back(Measure(settings, {}, recording));
  for (const double megabytes : {50.0, 30.0, 15.0})
  {
    rows.push_back(Measure(settings, megabytes, recording));
  }
  return rows;
}
} // namespace palpate::bench
