#include "CaseFit.h"

#include "CaseText.h"
#include "Console.h"
#include "FitHints.h"
#include "FitJson.h"
#include "FitStructure.h"
#include "Interruption.h"
#include "VolumeCoverage.h"

#include <algorithm>
#include <iomanip>
#include <numeric>
#include <ostream>
#include <sstream>

namespace palpate::cli
{
namespace
{
std::string Line(const FitResult& result)
{
  std::ostringstream text;
  text << CaseTitle(result.Input, result.Structure) << ": ";
  text << std::fixed << "degree " << result.Model.Degree() << ", Dice " << std::setprecision(4)
       << result.Dice << ", distance to the mask's boundary mean " << std::setprecision(3)
       << result.ModelToMask.Mean << " / 95 % " << result.ModelToMask.Percentile95 << " / max "
       << result.ModelToMask.Maximum << " mm, volume " << std::setprecision(2)
       << result.ModelMilliliters << " ml (mask " << result.MaskMilliliters << " ml), "
       << (result.StarShaped ? "star-shaped" : "not quite star-shaped") << " ("
       << result.HiddenPercent << " % hidden)\n";
  return text.str();
}

// Until its model is there, a case fails by what the structure is and what the options ask of it:
// no such component, too thin for a surface, too few samples for the degree.
void BlameInput(FitResult& result)
{
  const bool isFitReached = std::any_of(result.Seconds.begin(), result.Seconds.end(),
                                        [](const auto& stage) { return stage.first == "fit"; });
  if (result.State == FitResult::Outcome::Failed && !isFitReached)
  {
    result.State = FitResult::Outcome::BadInput;
  }
}
} // namespace

std::string ShortTitle(const Segment& structure)
{
  return structure.Name.empty() ? "label " + std::to_string(structure.Label) : structure.Name;
}

FitResult FitCase(const Segmentation& segmentation, const Segment& structure,
                  const FitSettings& settings, double readSeconds, const CaseShare& share,
                  Console& console)
{
  FitResult result =
      FitStructure(segmentation, structure, settings,
                   [&](double fraction, const std::string& stage)
                   {
                     console.Progress(share.From + (share.To - share.From) * fraction,
                                      share.Title + ": " + stage);
                     return !Interruption::WasAsked();
                   });
  result.Message = WithHint(result.Message, result.OptionHint);
  result.Seconds.insert(result.Seconds.begin(), {"read", readSeconds});
  BlameInput(result);
  return result;
}

FitResult UnreadCase(const std::string& input, const Segment& structure, const std::string& message,
                     const FitSettings& settings)
{
  FitResult result;
  result.Input = input;
  result.CaseName = CaseNameOf(input);
  result.Structure = structure;
  result.Settings = settings;
  result.State = FitResult::Outcome::BadInput;
  result.Message = message;
  return result;
}

void RemarkOnVolume(const Volume& volume, FitResult& result)
{
  if (result.Surface == nullptr || result.Surface->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (const std::string note = CoverageNote(volume.Image, result.Surface->GetBounds());
      !note.empty())
  {
    result.Notes.push_back(note);
  }
}

void AddTotalSeconds(FitResult& result)
{
  const double total =
      std::accumulate(result.Seconds.begin(), result.Seconds.end(), 0.0,
                      [](double sum, const auto& stage) { return sum + stage.second; });
  result.Seconds.emplace_back("total", total);
}

void TellCase(const FitResult& result, bool json, const std::string& folder, std::size_t fileNotes,
              Console& console)
{
  console.EndProgress();
  if (json)
  {
    console.Output() << FitResultJson(result, folder) << '\n' << std::flush;
  }
  else if (result.State == FitResult::Outcome::Fitted)
  {
    console.Output() << Line(result) << std::flush;
  }
  // What was said of the whole file comes first in a result's notes; it is not said again.
  for (std::size_t n = fileNotes; n < result.Notes.size(); ++n)
  {
    console.Note(CaseTitle(result.Input, result.Structure) + ": " + result.Notes[n]);
  }
}
} // namespace palpate::cli
