#include "LabelMap.h"

#include "ImageGrid.h"
#include "LabelNamesFile.h"
#include "LabelValues.h"
#include "SegmentCompletion.h"

#include "vtkPointData.h"
#include "vtkSetGet.h"

#include <cmath>
#include <unordered_set>

namespace palpate
{
namespace
{
constexpr std::size_t MostLabels = 1024;
constexpr std::size_t FewLabels = 16;
constexpr double LeastEqualPairs = 0.4;

struct ValueSurvey
{
  bool AllWhole = true;
  bool AnyNegative = false;
  std::unordered_set<double> Distinct; // stops growing just above MostLabels
  vtkIdType Pairs = 0;
  vtkIdType EqualPairs = 0;
};

template <typename T>
void Survey(const T* values, vtkIdType count, int rowLength, ValueSurvey& survey)
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto value = static_cast<double>(values[i]);
    const bool rowStarts = i % rowLength == 0;
    if (!rowStarts && (values[i] != 0 || values[i - 1] != 0))
    {
      ++survey.Pairs;
      survey.EqualPairs += values[i] == values[i - 1] ? 1 : 0;
    }
    if (i > 0 && values[i] == values[i - 1])
    {
      continue;
    }
    survey.AllWhole = survey.AllWhole && std::floor(value) == value;
    survey.AnyNegative = survey.AnyNegative || value < 0.0;
    survey.Distinct.insert(value);
    if (!survey.AllWhole || survey.AnyNegative || survey.Distinct.size() > MostLabels)
    {
      return;
    }
  }
}
} // namespace

Segmentation LabelMapOf(const Volume& volume)
{
  vtkDataArray* voxels = volume.Image->GetPointData()->GetScalars();
  const vtkSmartPointer<vtkDataArray> labels = ToLabels(volume.Source, voxels);
  Segmentation segmentation;
  segmentation.Source = volume.Source;
  segmentation.Notes = volume.Notes;
  segmentation.IsOriented = volume.IsOriented;
  segmentation.Layers.push_back(labels == voxels ? volume.Image
                                                 : MakeImage(GridOf(volume.Image), labels));
  CompleteSegments(segmentation);
  ApplyLabelNames(segmentation);
  return segmentation;
}

std::string WhyNoLabelMap(const Volume& volume)
{
  vtkDataArray* voxels = volume.Image->GetPointData()->GetScalars();
  ValueSurvey survey;
  switch (voxels->GetDataType())
  {
    vtkTemplateMacro(Survey(static_cast<const VTK_TT*>(voxels->GetVoidPointer(0)),
                            voxels->GetNumberOfValues(), volume.Image->GetDimensions()[0], survey));
  }
  if (!survey.AllWhole)
  {
    return "its values are not whole numbers";
  }
  if (survey.AnyNegative)
  {
    return "it has negative values";
  }
  if (survey.Distinct.size() > MostLabels)
  {
    return "it has more than " + std::to_string(MostLabels) + " different values";
  }
  if (survey.Distinct.size() > FewLabels + 1 &&
      static_cast<double>(survey.EqualPairs) < LeastEqualPairs * static_cast<double>(survey.Pairs))
  {
    return "it has " + std::to_string(survey.Distinct.size()) +
           " different values that vary from voxel to voxel";
  }
  if (survey.Pairs == 0)
  {
    return "all its voxels are 0";
  }
  return {};
}
} // namespace palpate
