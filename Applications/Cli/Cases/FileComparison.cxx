#include "FileComparison.h"

#include "ComparedFile.h"
#include "ComparisonFiles.h"
#include "ComparisonJson.h"
#include "ComparisonText.h"
#include "Console.h"
#include "InputError.h"
#include "Interruption.h"
#include "StructurePairs.h"

#include <ostream>
#include <utility>

namespace palpate::cli
{
namespace
{
void NoteChanges(const ComparedFile& file, Console& console)
{
  for (const std::string& note : file.Notes())
  {
    console.Note(file.Path().filename().string() + ": " + note);
  }
}

// Of images over time, the volume.
VolumeChoice ChoiceOf(const CompareSettings& settings, const std::string& series)
{
  VolumeChoice choice = settings.Images.Choice();
  choice.Series = series.empty() ? choice.Series : series;
  return choice;
}

void FinishPair(PairComparison& pair, const CompareSettings& settings, bool isOfMany, bool isOnly,
                Console& console)
{
  std::filesystem::path folder;
  if (pair.IsCompared() && !settings.Output.empty())
  {
    folder = isOnly ? settings.Output : settings.Output / PairFolder(pair);
    WriteComparisonFiles(pair, folder);
  }
  PrintPair(pair, settings, isOfMany, folder, console);
  pair.Forget();
}
} // namespace

std::vector<PairComparison> CompareFiles(const CasePairs::Pair& files,
                                         const CompareSettings& settings, bool isOfMany,
                                         const ComparisonPart& part, Console& console)
{
  const ComparedFile one = ComparedFile::Read(files.One, ChoiceOf(settings, files.Series));
  const ComparedFile other = ComparedFile::Read(files.Other, ChoiceOf(settings, files.OtherSeries));
  if (one.Labels() == nullptr && other.Labels() == nullptr && !settings.Images.ValueText().empty())
  {
    throw InputError("--threshold and --background are for images; leave them out");
  }
  NoteChanges(one, console);
  NoteChanges(other, console);
  // A cohort's models are one structure each, whatever labels are asked for.
  const bool hasLabels = one.Labels() != nullptr || other.Labels() != nullptr || !isOfMany;
  const std::string label = !hasLabels ? "" : files.Label.empty() ? settings.Label : files.Label;
  const StructurePairs structures =
      StructurePairs::Of(one, other, label, hasLabels ? settings.ReferenceLabel : std::string());
  const bool isOnly = structures.Pairs.size() == 1 && !isOfMany;
  const double share = (part.To - part.From) / static_cast<double>(structures.Pairs.size());
  double from = part.From;
  std::vector<PairComparison> results;
  for (const StructurePairs::Pair& two : structures.Pairs)
  {
    const auto progress = [&](double fraction, const std::string& stage)
    {
      console.Progress(from + share * fraction,
                       part.Title + (part.Title.empty() ? "" : ": ") + stage);
      return !Interruption::WasAsked();
    };
    results.push_back(ComparePair(one, two.One, other, two.Other, settings.Pair, progress));
    results.back().Case = files.Case;
    results.back().Time = files.Time;
    from += share;
    FinishPair(results.back(), settings, isOfMany, isOnly, console);
  }
  results.front().Unpaired = structures.Unpaired;
  return results;
}

void PrintPair(const PairComparison& pair, const CompareSettings& settings, bool isOfMany,
               const std::filesystem::path& folder, Console& console)
{
  console.EndProgress();
  if (settings.Json)
  {
    console.Output() << ComparisonJson(pair, folder.string()) << '\n' << std::flush;
  }
  else if (pair.IsCompared())
  {
    console.Output() << (isOfMany ? ComparisonLine(pair) : ComparisonText(pair)) << std::flush;
  }
  for (const std::string& note : pair.Notes)
  {
    console.Note((pair.Case.empty() ? "" : pair.Case + ": ") + note);
  }
  if (!pair.IsCompared())
  {
    console.Error(pair.Message);
  }
}
} // namespace palpate::cli
