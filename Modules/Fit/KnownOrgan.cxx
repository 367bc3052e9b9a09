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
OrganModel FittedModel(const std::filesystem::path& file, const std::string& structure,
                       const VolumeChoice& choice)
{
  const Segmentation segmentation = ReadSegmentation(file, choice);
  if (structure.empty() && segmentation.Segments.size() != 1)
  {
    throw InputError(file.string() + " has " + std::to_string(segmentation.Segments.size()) +
                     " structures; choose the known organ with --known-label");
  }
  const Segment segment =
      structure.empty() ? segmentation.Segments.front() : segmentation.Find(structure);
  const FitResult fit = FitStructure(segmentation, segment, {});
  if (fit.State != FitResult::Outcome::Fitted)
  {
    throw InputError(file.string() + ": " + fit.Message);
  }
  return fit.Model;
}
} // namespace

LogSurface ReadKnownOrgan(const std::filesystem::path& file, const std::string& structure,
                          const VolumeChoice& choice)
{
  const OrganModel model =
      IsModelFile(file) ? ReadModel(file).Surface : FittedModel(file, structure, choice);
  LogSurface known;
  RequireInput(FindLogSurface(model, known), file.string());
  return known;
}
} // namespace palpate
