#include "MaskChecks.h"

#include "CaseMasks.h"
#include "CaseNames.h"
#include "CohortManifest.h"
#include "ImageIndexToWorld.h"
#include "InputError.h"
#include "LabelMask.h"
#include "MaskFolder.h"
#include "OrderedTasks.h"
#include "SegmentationFile.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <mutex>
#include <system_error>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t MostDoubtfulMasks = 60; // kept for pictures

bool IsFolder(const std::filesystem::path& path)
{
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored);
}

std::vector<std::filesystem::path> FoldersOfMasksIn(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> found;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
  {
    if (IsFolder(entry->path()) && IsMaskFolder(entry->path()))
    {
      found.push_back(entry->path());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

// The cases that an input stands for.
std::vector<std::filesystem::path> CasesOf(const std::filesystem::path& input,
                                           const CheckSettings& settings,
                                           std::vector<std::string>& notes)
{
  if (!IsFolder(input) || settings.As == "structures")
  {
    return {input};
  }
  if (!IsMaskFolder(input))
  {
    std::vector<std::filesystem::path> folders = FoldersOfMasksIn(input);
    return folders.empty() ? std::vector{input} : folders; // DICOM, or refused when it is read
  }
  if (settings.As == "cases")
  {
    return FindMasks(input);
  }
  const MaskFolder folder(input, settings.Images, true);
  folder.RequireClear();
  if (folder.IsOneSegmentation())
  {
    notes.push_back(folder.TakenText());
    return {input};
  }
  return FindMasks(input);
}

CheckedMask MaskOf(const Segmentation& labels, const Segment& structure)
{
  vtkImageData* const layer = labels.Layers[static_cast<std::size_t>(structure.Layer)];
  CheckedMask mask;
  mask.Voxels = CopyLabelMask(layer, structure.Value, 1).Mask;
  mask.ToWorld = IndexToWorldOf(layer);
  layer->GetDimensions(mask.ImageSize.data());
  return mask;
}

bool AreOnOneGrid(const Segmentation& labels)
{
  return std::all_of(labels.Layers.begin(), labels.Layers.end(),
                     [&](vtkImageData* layer)
                     {
                       const int* const size = layer->GetDimensions();
                       return std::equal(size, size + 3, labels.Layers.front()->GetDimensions());
                     });
}

CaseMasks MasksOf(const Segmentation& labels)
{
  CaseMasks masks;
  for (const Segment& structure : labels.Segments)
  {
    masks.Structures.push_back({structure.Name, structure.Label, structure.Layer});
  }
  masks.MaskOf = [&labels](std::size_t n) { return MaskOf(labels, labels.Segments[n]); };
  masks.IsOriented = labels.IsOriented;
  masks.AreOnOneGrid = AreOnOneGrid(labels);
  masks.LayerCount = labels.Layers.size();
  return masks;
}

// Reads and measures cases; used by several threads.
class CaseReader
{
public:
  CaseReader(const CheckSettings& settings, std::size_t cases)
      : Settings(settings), JobsInCase(cases > 1 ? 1 : settings.Jobs)
  {
  }

  CaseCheck Measure(const std::filesystem::path& file, const std::string& name)
  {
    CaseCheck check;
    check.File = file;
    check.Name = name;
    try
    {
      this->MeasureLabels(this->Read(file), {}, check);
    }
    catch (const Cancelled&)
    {
      throw;
    }
    catch (const std::exception& error)
    {
      check.Message = error.what();
      check.Patient.Organs.clear();
    }
    return check;
  }

  void MeasureLabels(const Segmentation& labels, const ProgressFunction& progress, CaseCheck& check)
  {
    const CaseMasks masks = MasksOf(labels);
    check.Notes = labels.Notes;
    check.Refused = labels.Refused;
    check.Patient =
        MeasureCase(masks, this->Probe, this->JobsInCase,
                    [&progress](double part) { ReportProgress(progress, part, "checking"); });
    check.Judgements = JudgeCase(check.Patient, this->Settings.Group, this->Settings.Rate);
    for (std::size_t n = 0; n < check.Judgements.size(); ++n)
    {
      if (check.Judgements[n].Is != OrganJudgement::Verdict::Plausible &&
          check.Doubtful.size() < MostDoubtfulMasks)
      {
        check.Doubtful[n] = check.Patient.Organs[n].IsWhole ? masks.Union() : masks.MaskOf(n);
      }
    }
  }

private:
  Segmentation Read(const std::filesystem::path& file)
  {
    const std::lock_guard<std::mutex> lock(this->Reading); // the readers are not all thread-safe
    if (this->Settings.As != "structures" || !IsMaskFolder(file))
    {
      return ReadSegmentation(file, this->Settings.Images);
    }
    const MaskFolder folder(file, this->Settings.Images, false);
    Segmentation all = folder.Structures();
    all.Refused = folder.LeftOut();
    return all;
  }

  const CheckSettings& Settings;
  std::size_t JobsInCase;
  RadialProbe Probe;
  std::mutex Reading;
};
} // namespace

OrganJudgement::Verdict CaseCheck::Worst() const
{
  OrganJudgement::Verdict worst = OrganJudgement::Verdict::Plausible;
  for (const OrganJudgement& one : this->Judgements)
  {
    worst = std::max(worst, one.Is);
  }
  return worst;
}

MaskChecks MaskChecks::Measure(const std::vector<std::filesystem::path>& inputs,
                               const CheckSettings& settings, const ProgressFunction& progress)
{
  MaskChecks checks;
  checks.Rate = settings.Rate;
  checks.IsByGroup = settings.Group != nullptr;
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path& input : inputs)
  {
    const std::vector<std::filesystem::path> cases = CasesOf(input, settings, checks.Notes);
    files.insert(files.end(), cases.begin(), cases.end());
  }
  std::vector<std::string> texts(files.size());
  std::transform(files.begin(), files.end(), texts.begin(),
                 [](const std::filesystem::path& file) { return file.string(); });
  const CaseNames names(texts);
  CaseReader reader(settings, files.size());
  OrderedTasks<CaseCheck> tasks(files.size(), settings.Jobs,
                                [&](std::size_t n)
                                { return reader.Measure(files[n], names.OfInput(n)); });
  std::size_t doubtful = 0;
  for (std::size_t n = 0; n < files.size(); ++n)
  {
    checks.Cases.push_back(tasks.Next());
    doubtful += checks.Cases.back().Doubtful.size();
    if (doubtful > MostDoubtfulMasks)
    {
      checks.Cases.back().Doubtful.clear();
    }
    ReportProgress(progress, static_cast<double>(n + 1) / static_cast<double>(files.size()),
                   "checking");
  }
  return checks;
}

MaskChecks MaskChecks::Of(const Segmentation& labels, const CheckSettings& settings,
                          const ProgressFunction& progress)
{
  MaskChecks checks;
  checks.Rate = settings.Rate;
  checks.IsByGroup = settings.Group != nullptr;
  CaseCheck check;
  check.File = labels.Source;
  CaseReader(settings, 1).MeasureLabels(labels, progress, check);
  checks.Cases.push_back(std::move(check));
  return checks;
}

MaskChecks MaskChecks::Of(const std::vector<std::filesystem::path>& inputs,
                          const CheckSettings& settings, const ProgressFunction& progress)
{
  MaskChecks checks = Measure(inputs, settings, progress);
  const auto scoreOf = [](const CaseCheck& check)
  {
    double score = std::numeric_limits<double>::infinity();
    for (const OrganJudgement& one : check.Judgements)
    {
      score = std::min(score, one.Score);
    }
    return score;
  };
  std::stable_sort(checks.Cases.begin(), checks.Cases.end(),
                   [&](const CaseCheck& a, const CaseCheck& b)
                   {
                     if (a.IsChecked() != b.IsChecked())
                     {
                       return a.IsChecked();
                     }
                     return a.Worst() != b.Worst() ? a.Worst() > b.Worst()
                                                   : scoreOf(a) < scoreOf(b);
                   });
  return checks;
}
} // namespace palpate
