#include "ProtectedSurface.h"

#include "CaseText.h"
#include "FilterRun.h"
#include "FitHints.h"
#include "InputError.h"
#include "ModelSurface.h"
#include "OwnCopy.h"
#include "SceneLabels.h"
#include "VoxelMinimum.h"

namespace palpate
{
namespace
{
// Throws an error that names the label if it has too few voxels.
void RequireVoxels(const Segmentation& segmentation, const Segment& segment)
{
  if (const std::string reason = TooFewVoxels(segmentation, segment); !reason.empty())
  {
    throw InputError(WithHint(CaseMessage(segmentation.Source, segment, reason), ChooseAnother));
  }
}
} // namespace

vtkSmartPointer<vtkPolyData> ProtectedSurfaceOf(const SceneStructure& structure,
                                                const SceneProduct& source,
                                                const ProgressFunction& progress)
{
  if (const auto read = ProductAs<Segmentation>(&source))
  {
    const Segment& segment = SegmentOf(structure, *read);
    RequireVoxels(*read, segment);
    try
    {
      return MakeForbiddenSurface(*read, segment, progress);
    }
    catch (const FilterError& error)
    {
      throw InputError(CaseMessage(read->Source, segment, error.what()));
    }
  }
  if (const auto model = ProductAs<FitResult>(&source))
  {
    constexpr int Frequency = 40;
    return DrawModel(model->Model, Frequency);
  }
  return OwnCopy(ProductAs<FitSurface>(&source)->Found.Surface.Get());
}
} // namespace palpate
