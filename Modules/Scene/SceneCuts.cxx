#include "SceneCuts.h"

#include "ImageIndexToWorld.h"
#include "LabelMask.h"

#include "vtkImageData.h"

#include <array>

namespace palpate
{
std::vector<ScanCut> CutsOf(const Segmentation& segmentation, const Segment& structure)
{
  constexpr double MostVoxels = 2.0;
  vtkImageData* layer = segmentation.Layers[static_cast<std::size_t>(structure.Layer)];
  const std::array<bool, 6> faces = CopyLabelMask(layer, structure.Value, 0).TouchesFace;
  const IndexToWorld toWorld = IndexToWorldOf(layer);
  const Matrix3 outwards = toWorld.Axes.inverse().transpose();
  std::vector<ScanCut> cuts;
  for (int face = 0; face < 6; ++face)
  {
    if (!faces[static_cast<std::size_t>(face)])
    {
      continue;
    }
    const int axis = face / 2;
    const bool isLast = face % 2 == 1;
    Vector3 border = Vector3::Zero();
    border[axis] = isLast ? layer->GetDimensions()[axis] - 0.5 : -0.5;
    ScanCut cut;
    cut.NormalWorld = (isLast ? 1.0 : -1.0) * outwards.col(axis).normalized();
    cut.Offset = toWorld(border).dot(cut.NormalWorld);
    cut.Depth = MostVoxels / outwards.col(axis).norm();
    cuts.push_back(cut);
  }
  return cuts;
}
} // namespace palpate
