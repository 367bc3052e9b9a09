#include "MaskTruth.h"

#include "ImageIndexToWorld.h"
#include "LabelMask.h"
#include "Refusal.h"
#include "SceneLabels.h"
#include "SegmentationFile.h"

#include <memory>

namespace palpate
{
const SceneStructure& CorrectedStructure(const TaskTarget& target, const SceneSettings& scene)
{
  const bool isLabel = !scene.Structures.empty() &&
                       scene.Structures.front().Source() == SceneSource::Label &&
                       scene.Structures.front().Labels.size() == 1;
  if (!isLabel)
  {
    Refuse(target.Scene, "does not begin with a mask that could be corrected",
           "name a segmentation and one of its labels in its first structure");
  }
  return scene.Structures.front();
}

CorrectedShape ReadWrongMask(const TaskTarget& target, const SceneSettings& scene)
{
  const SceneStructure& structure = CorrectedStructure(target, scene);
  const auto labels =
      std::make_shared<const Segmentation>(ReadSegmentation(structure.File, scene.LeftHanded));
  return CorrectedShape::OfMask(labels, SegmentOf(structure, *labels), NeighborPolicy::Stop);
}

ComparedBody ReadTrueMask(const TaskTarget& target, const SceneSettings& scene)
{
  SceneStructure same = CorrectedStructure(target, scene);
  same.File = target.Mask;
  const Segmentation labels = ReadSegmentation(target.Mask, scene.LeftHanded);
  const Segment& segment = SegmentOf(same, labels);
  vtkImageData* layer = labels.Layers[static_cast<std::size_t>(segment.Layer)];
  ComparedBody truth;
  RequireInput(ComparedBody::OfMask(CopyLabelMask(layer, segment.Value, 1).Mask,
                                    IndexToWorldOf(layer), truth),
               target.Mask.string());
  return truth;
}

TaskAnswer MaskAnswer(CorrectedShape& corrected, const ComparedBody& truth)
{
  const BodyComparison comparison = corrected.CompareWith(truth);
  TaskAnswer answer;
  answer.Dice = comparison.Overlap->Dice();
  answer.MeanDistance = comparison.Both.Mean;
  return answer;
}
} // namespace palpate
