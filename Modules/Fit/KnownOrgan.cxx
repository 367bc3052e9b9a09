#include "KnownOrgan.h"

#include "FitStructure.h"
#include "InputError.h"
#include "ModelFile.h"
#include "Refusal.h"
#include "SegmentationFile.h"

namespace palpate
{
namespace
{
LogSurface ReadFitted(const std::filesystem::path& file, const std::string& structure,
                      const VolumeChoice& choice)
{
  const Segmentation segmentation = ReadSegmentation(file, choice);
  if (structure.empty() && segmentation.Segments.size() != 1)
  {
    throw InputError(file.string() + " has " + std::to_string(segmentation.Segments.size()) +
                     " structures; choose the known organ with --known-label");
  }
  return FitKnownOrgan(
      segmentation,
      structure.empty() ? segmentation.Segments.front() : segmentation.Find(structure), file);
}
} // namespace

LogSurface KnownOrganOf(const OrganModel& model, const std::filesystem::path& file)
{
  LogSurface known;
  RequireInput(FindLogSurface(model, known), file.string());
  return known;
}

LogSurface FitKnownOrgan(const Segmentation& segmentation, const Segment& structure,
                         const std::filesystem::path& file)
{
  const FitResult fit = FitStructure(segmentation, structure, {});
  if (fit.State != FitResult::Outcome::Fitted)
  {
    throw InputError(file.string() + ": " + fit.Message);
  }
  return KnownOrganOf(fit.Model, file);
}

LogSurface ReadKnownOrgan(const std::filesystem::path& file, const std::string& structure,
                          const VolumeChoice& choice)
{
  return IsModelFile(file) ? KnownOrganOf(ReadModel(file).Surface, file)
                           : ReadFitted(file, structure, choice);
}
} // namespace palpate
