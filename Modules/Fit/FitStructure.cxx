#include "FitStructure.h"

#include "FitStages.h"
#include "ImageFormat.h"
#include "SurfaceFile.h"
#include "SurfaceFileFit.h"

#include <algorithm>

namespace palpate
{
namespace
{
// The stages after the first, which made the surface.
FitResult FitTo(const FitSurface& surface, const FitSettings& settings,
                const ProgressFunction& progress)
{
  const FitSamples samples = MakeFitSamples(surface, settings, PartOf(progress, 0.3, 0.4));
  return MakeFitModel(samples, settings, PartOf(progress, 0.4, 1.0));
}
} // namespace

FitResult FitStructure(const Segmentation& segmentation, const Segment& structure,
                       const FitSettings& settings, const ProgressFunction& progress)
{
  return FitTo(MakeFitSurface(segmentation, structure, settings, PartOf(progress, 0.0, 0.3)),
               settings, progress);
}

FitResult FitSurfaceFile(const std::filesystem::path& file, vtkPolyData* surface,
                         const FitSettings& settings, const ProgressFunction& progress)
{
  return FitTo(MakeFitSurface(file, surface, settings, PartOf(progress, 0.0, 0.3)), settings,
               progress);
}

std::string CaseNameOf(const std::filesystem::path& file)
{
  std::string name = file.filename().string();
  const std::string image = EndingOf(file, ReadableImageEndings());
  const std::string surface = EndingOf(file, SurfaceFormats().ReadEndings());
  name.erase(name.size() - std::max(image.size(), surface.size()));
  return name;
}
} // namespace palpate
