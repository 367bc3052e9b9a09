#include "CaseFit.h"

#include "AvailableMemory.h"
#include "CaseText.h"
#include "Console.h"
#include "ExceptionMessage.h"
#include "FitFiles.h"
#include "FitHints.h"
#include "FitJson.h"
#include "FitStructure.h"
#include "ImageOptions.h"
#include "InputError.h"
#include "Interruption.h"
#include "LabelParts.h"
#include "OrderedTasks.h"
#include "ProgramVersion.h"
#include "Progress.h"
#include "Refusal.h"
#include "SegmentationFile.h"
#include "StageClock.h"
#include "StructureChanges.h"
#include "StructureChoice.h"
#include "SurfaceFile.h"
#include "VolumeFile.h"
#include "VoxelValue.h"

#include "vtkBoundingBox.h"

#include <algorithm>
#include <exception>
#include <iomanip>
#include <mutex>
#include <numeric>
#include <ostream>
#include <sstream>

namespace palpate::cli
{
namespace
{
void AppendShape(const FitResult& result, std::ostream& text)
{
  const SurfaceModelDetails& details = result.Details;
  if (details.Mapped == nullptr)
  {
    text << (result.StarShaped ? "star-shaped" : "not quite star-shaped") << " ("
         << result.HiddenPercent << " % hidden)";
    return;
  }
  text << "surface model, " << details.Mapped->Topology.ChangedPercent() << " % repaired, "
       << (details.Crossings == 0 ? std::string("no") : std::to_string(details.Crossings))
       << " crossings";
}

std::string Line(const FitResult& result)
{
  std::ostringstream text;
  text << CaseTitle(result.Input, result.Structure) << ": ";
  const SurfaceDistances& distances = result.ModelToInput();
  text << std::fixed << "degree " << DegreeOf(result.Model) << ", Dice " << std::setprecision(4)
       << result.Dice << ", distance to the "
       << (result.IsOfSurface ? "surface" : "mask's boundary") << " mean " << std::setprecision(3)
       << distances.Mean << " / 95 % " << distances.Percentile95 << " / max " << distances.Maximum
       << " mm, volume " << std::setprecision(2) << result.ModelMilliliters << " ml ("
       << (result.IsOfSurface ? "surface " : "mask ") << result.InputMilliliters() << " ml), ";
  AppendShape(result, text);
  if (const std::string changes = ChangeText(result); !changes.empty())
  {
    text << ", " << changes;
  }
  text << '\n';
  return text.str();
}

// A failure before the fit is caused by the structure or the options: no such component, too thin
// for a surface, too few samples for the degree.
void BlameInput(FitResult& result)
{
  const bool isFitReached = std::any_of(result.Seconds.begin(), result.Seconds.end(),
                                        [](const auto& stage) { return stage.first == "fit"; });
  if (result.State == FitResult::Outcome::Failed && !isFitReached)
  {
    result.State = FitResult::Outcome::BadInput;
  }
}

// Whether a box (patient LPS) lies in an image's voxels, which are convex: its corners decide. They
// are moved inwards a little, since a structure at the border of the same grid touches the limit.
bool Covers(vtkImageData* image, const double* boundsWorld)
{
  vtkBoundingBox box(boundsWorld);
  box.ScaleAboutCenter(23.0 / 24.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector3 point;
    box.GetCorner(corner, point.data());
    if (!VoxelValueAt(image, point))
    {
      return false;
    }
  }
  return true;
}

void RemarkOnVolume(const Volume& volume, FitResult& result)
{
  if (result.Surface == nullptr || result.Surface->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (!Covers(volume.Image, result.Surface->GetBounds()))
  {
    result.Notes.emplace_back(
        "the volume does not cover the whole structure; check that it belongs to it");
  }
}

// The structures of one mask, one after the other.
class MaskLoop
{
public:
  MaskLoop(const MaskToFit& mask, const ImageOptions& images, Console& console,
           const TakeResult& take)
      : Mask(mask), Images(images), Output(console), Take(take)
  {
  }

  void Run()
  {
    FitResult lost = this->Unread({}, {});
    try
    {
      this->FitStructures();
      return;
    }
    catch (const Cancelled&)
    {
      throw;
    }
    catch (const InputError& error)
    {
      lost.Message = error.what();
    }
    catch (const std::exception& error)
    {
      lost.State = FitResult::Outcome::Failed;
      lost.Message =
          this->Mask.Mask.string() + (SaysMemoryIsShort(error)
                                          ? " needs more memory than there is; crop or resample it."
                                          : ": " + MessageOf(error));
    }
    this->Finish(std::move(lost), {}, false);
  }

private:
  FitResult Unread(const Segment& structure, const std::string& message) const
  {
    FitResult result;
    result.Input = this->Mask.Mask;
    result.CaseName = CaseNameOf(this->Mask.Mask);
    result.Structure = structure;
    result.Settings = this->Mask.Settings;
    result.State = FitResult::Outcome::BadInput;
    result.Message = message;
    return result;
  }

  // What only masks have is refused, not ignored.
  void CheckSurfaceOptions() const
  {
    const FitSettings& settings = this->Mask.Settings;
    const FitSettings defaults;
    if (!this->Mask.Labels.empty() || settings.Method != defaults.Method ||
        settings.Smoothing != defaults.Smoothing)
    {
      Refuse(this->Mask.Mask, "is a surface",
             "leave out --label, --method and --smoothing, which are for masks");
    }
  }

  void CheckMaskOptions() const
  {
    const FitSettings& settings = this->Mask.Settings;
    if (settings.Repairs && settings.Model == FitSettings::ModelKind::Radial && settings.Rules < 2)
    {
      Refuse(this->Mask.Mask, "is a mask, which a radial model needs no repair of",
             "leave out --repair or --model radial");
    }
  }

  void FitSurfaceOfFile()
  {
    this->CheckSurfaceOptions();
    std::vector<std::pair<std::string, double>> readTime;
    StageClock clock(readTime);
    const vtkSmartPointer<vtkPolyData> surface = ReadSurface(this->Mask.Mask);
    this->ReadSlices();
    clock.EndStage("read");
    this->IsOnly = this->Mask.IsAlone;
    Segment structure;
    structure.Name = CaseNameOf(this->Mask.Mask);
    FitSettings settings = this->Mask.Settings;
    settings.IsAlone = settings.IsAlone || this->Mask.KeepsLargestPart;
    this->Begin(structure, 0, 1);
    this->Conclude(structure, readTime.front().second,
                   FitSurfaceFile(this->Mask.Mask, surface, settings,
                                  [this](double fraction, const std::string& stage)
                                  { return this->GoesOn(0, fraction, stage); }));
  }

  void FitStructures()
  {
    if (this->Mask.Read == nullptr && SurfaceFormats().Reader(this->Mask.Mask) != nullptr)
    {
      this->FitSurfaceOfFile();
      return;
    }
    this->CheckMaskOptions();
    std::vector<std::pair<std::string, double>> readTime;
    StageClock clock(readTime);
    const Segmentation segmentation = this->Mask.Read != nullptr
                                          ? *this->Mask.Read
                                          : ReadSegmentation(this->Mask.Mask, this->ChoiceOfMask());
    this->ReadSlices();
    clock.EndStage("read");
    for (const std::string& note : segmentation.Remarks())
    {
      this->Output.Note(this->Mask.Name + ": " + note);
    }
    const StructureChoice choice = ChooseStructures(segmentation, this->Mask.Labels);
    for (const StructureChoice::Missing& missing : choice.Lost)
    {
      this->Finish(this->Unread(missing.Structure, missing.Message), {}, false);
    }
    this->IsOnly = this->Mask.IsAlone && choice.Found.size() == 1 && choice.Lost.empty();
    this->FileNotes = segmentation.Notes.size();
    const std::vector<StructureToFit> structures = this->Expanded(segmentation, choice.Found);
    this->IsOnly = this->IsOnly && structures.size() == 1;
    OrderedTasks<FitResult> fits(
        structures.size(), this->Mask.AtATime,
        [&](std::size_t n)
        {
          return FitStructure(segmentation, structures[n].Structure, structures[n].Settings,
                              [&, n](double fraction, const std::string& stage)
                              { return this->GoesOn(n, fraction, stage); });
        });
    for (std::size_t n = 0; n < structures.size(); ++n)
    {
      this->Begin(structures[n].Structure, n, structures.size());
      this->Conclude(structures[n].Structure, readTime.front().second, fits.Next());
    }
  }

  // Several structures are fitted at a time; the next one to end is shown.
  void Begin(const Segment& structure, std::size_t number, std::size_t count)
  {
    const std::scoped_lock lock(this->ProgressLock);
    this->Shown = {number, count, this->Mask.TitleOf(number + 1, count, structure)};
  }

  bool GoesOn(std::size_t number, double fraction, const std::string& stage)
  {
    const std::scoped_lock lock(this->ProgressLock);
    if (number == this->Shown.Number)
    {
      const double part =
          (this->Mask.To - this->Mask.From) / static_cast<double>(this->Shown.Count);
      const double from = this->Mask.From + static_cast<double>(number) * part;
      this->Output.Progress(from + part * fraction, this->Shown.Title + ": " + stage);
    }
    return !Interruption::WasAsked();
  }

  // The structures, or their parts (--component each).
  std::vector<StructureToFit> Expanded(const Segmentation& segmentation,
                                       const std::vector<Segment>& chosen)
  {
    std::vector<StructureToFit> structures;
    for (const Segment& structure : chosen)
    {
      if (this->Mask.Settings.Component != FitSettings::EachPart)
      {
        structures.push_back({structure, this->Mask.Settings});
        continue;
      }
      std::string leftOut;
      for (StructureToFit& part : PartsOf(segmentation, structure, this->Mask.Settings, leftOut))
      {
        structures.push_back(std::move(part));
      }
      if (!leftOut.empty())
      {
        this->Output.Note(CaseTitle(this->Mask.Mask, structure) + ": " + leftOut);
      }
    }
    return structures;
  }

  // A series that is chosen is that of the slices' volume, if there is one.
  VolumeChoice ChoiceOfMask() const
  {
    const bool hasSlices = this->Mask.Slices != nullptr || !this->Mask.SlicesFile.empty();
    VolumeChoice choice = this->Images.Choice();
    choice.Series = hasSlices ? std::string() : choice.Series;
    return choice;
  }

  void ReadSlices()
  {
    this->Slices = this->Mask.Slices;
    if (!this->Mask.SlicesFile.empty())
    {
      this->OwnSlices = ReadVolume(this->Mask.SlicesFile, this->Images.ChoiceOfVolume());
      this->Slices = &this->OwnSlices;
    }
  }

  void Conclude(const Segment& structure, double readSeconds, FitResult result)
  {
    result.Message = WithHint(result.Message, result.OptionHint);
    result.Seconds.insert(result.Seconds.begin(), {"read", readSeconds});
    BlameInput(result);
    if (this->Slices != nullptr)
    {
      RemarkOnVolume(*this->Slices, result);
    }
    const std::filesystem::path place =
        this->IsOnly ? std::filesystem::path() : this->Mask.PlaceOf(structure);
    const bool isWritten = this->Write(result, place);
    this->Finish(std::move(result), place, isWritten);
  }

  bool Write(FitResult& result, const std::filesystem::path& place) const
  {
    if (this->Mask.Output.empty() || result.State == FitResult::Outcome::BadInput)
    {
      return false;
    }
    StageClock clock(result.Seconds);
    try
    {
      WriteFitFiles(result, this->Slices, this->Mask.Output / place, ProgramVersion());
    }
    catch (const InputError& error)
    {
      result.State = this->IsOnly ? FitResult::Outcome::BadInput : FitResult::Outcome::Failed;
      result.Message = error.what();
      return false;
    }
    clock.EndStage("write");
    return true;
  }

  void Finish(FitResult&& result, const std::filesystem::path& place, bool isWritten)
  {
    const double total =
        std::accumulate(result.Seconds.begin(), result.Seconds.end(), 0.0,
                        [](double sum, const auto& stage) { return sum + stage.second; });
    result.Seconds.emplace_back("total", total);
    this->ReportOnce(result, isWritten ? FolderText(place) : std::string());
    this->Take(std::move(result), place, isWritten);
  }
  std::string FolderText(const std::filesystem::path& place) const
  {
    return (place.empty() ? this->Mask.Output : this->Mask.Output / place).string();
  }

  void ReportOnce(const FitResult& result, const std::string& folder)
  {
    this->Output.EndProgress();
    if (this->Mask.Json)
    {
      this->Output.Output() << FitResultJson(result, folder) << '\n' << std::flush;
    }
    else if (result.State == FitResult::Outcome::Fitted)
    {
      this->Output.Output() << Line(result) << std::flush;
    }
    // Notes on the whole file come first in a result's notes; they are not repeated.
    for (std::size_t n = this->FileNotes; n < result.Notes.size(); ++n)
    {
      this->Output.Note(CaseTitle(result.Input, result.Structure) + ": " + result.Notes[n]);
    }
  }

  const MaskToFit& Mask;
  const ImageOptions& Images;
  Console& Output;
  const TakeResult& Take;
  Volume OwnSlices;
  const Volume* Slices = nullptr;
  bool IsOnly = false;
  std::size_t FileNotes = 0;
  struct InProgress
  {
    std::size_t Number = 0; // from 0
    std::size_t Count = 1;
    std::string Title;
  };
  std::mutex ProgressLock;
  InProgress Shown;
};
} // namespace

std::string ShortTitle(const Segment& structure)
{
  return structure.Name.empty() ? "label " + std::to_string(structure.Label) : structure.Name;
}

void FitMask(const MaskToFit& mask, const ImageOptions& images, Console& console,
             const TakeResult& take)
{
  MaskLoop(mask, images, console, take).Run();
}
} // namespace palpate::cli
