#include "MaskFolderFit.h"

#include "CaseNames.h"
#include "CohortManifest.h"
#include "FitStructure.h"
#include "InputError.h"
#include "ModelFile.h"
#include "OutputFolder.h"
#include "SegmentationFile.h"
#include "SurfaceFile.h"

#include <utility>
#include <vector>

namespace palpate
{
namespace
{
// An empty label is taken from the mask, if that can be read.
FitResult FitMaskFile(const std::filesystem::path& mask, std::string& label,
                      const FitSettings& settings, const ProgressFunction& progress)
{
  try
  {
    if (IsSurfaceFile(mask))
    {
      return FitSurfaceFile(mask, ReadSurface(mask), settings, progress);
    }
    const Segmentation segmentation = ReadSegmentation(mask);
    label = label.empty() ? std::to_string(segmentation.Segments.front().Label) : label;
    return FitStructure(segmentation, segmentation.Find(label), settings, progress);
  }
  catch (const InputError& error)
  {
    FitResult refused;
    refused.Input = mask;
    refused.State = FitResult::Outcome::BadInput;
    refused.Message = error.what();
    return refused;
  }
}
} // namespace

CohortTable FitMaskFolder(const std::filesystem::path& masks, const std::filesystem::path& output,
                          const FitSettings& settings, const std::string& program,
                          const ProgressFunction& progress)
{
  std::vector<std::string> files;
  for (const std::filesystem::path& mask : FindMasks(masks))
  {
    files.push_back(mask.string());
  }
  const CaseNames names(files);
  MakeOutputFolder(output);
  CohortTable table;
  std::string label;
  for (std::size_t n = 0; n < files.size(); ++n)
  {
    const auto count = static_cast<double>(files.size());
    const std::string place = std::to_string(n + 1) + " of " + std::to_string(files.size());
    const auto report = [&](double part, const std::string& stage) {
      return !progress || progress((static_cast<double>(n) + part) / count, place + ": " + stage);
    };
    ReportProgress(report, 0.0, "reading");
    FitResult result = FitMaskFile(files[n], label, settings, report);
    const OrganModel model = result.Model;
    const bool isFitted = result.State == FitResult::Outcome::Fitted;
    CohortRow row = RowOf(names.OfInput(n), std::move(result));
    if (isFitted)
    {
      row.Model = std::to_string(n + 1) + ".json";
      ModelProvenance provenance;
      provenance.Program = program;
      provenance.Input = std::filesystem::path(files[n]).filename().string();
      provenance.Label = label;
      WriteModel(output / row.Model, {model, provenance});
    }
    table.Add({row});
  }
  table.Write(output / "cohort.csv");
  return table;
}
} // namespace palpate
