#include "LabelMap.h"

#include "ImageGrid.h"
#include "LabelNamesFile.h"
#include "LabelValues.h"
#include "SegmentCompletion.h"

#include "vtkPointData.h"
#include "vtkSetGet.h"

#include <cmath>
#include <type_traits>
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
  bool AnyRounded = false; // up to WholeValue's tolerance
  bool AnyNegative = false;
  std::unordered_set<double> Distinct; // stops growing just above MostLabels
  vtkIdType Pairs = 0;
  vtkIdType EqualPairs = 0;
};

// As a whole number, if it is one up to rounding.
template <typename T>
T Whole(T value)
{
  if constexpr (std::is_floating_point_v<T>)
  {
    return static_cast<T>(WholeValue(static_cast<double>(value)).value_or(value));
  }
  return value;
}

template <typename T>
void Survey(const T* values, vtkIdType count, int rowLength, ValueSurvey& survey)
{
  T last = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const T whole = Whole(values[i]);
    const auto value = static_cast<double>(whole);
    const bool rowStarts = i % rowLength == 0;
    const bool isEqual = i > 0 && whole == last;
    if (!rowStarts && (whole != 0 || last != 0))
    {
      ++survey.Pairs;
      survey.EqualPairs += isEqual ? 1 : 0;
    }
    last = whole;
    survey.AnyRounded = survey.AnyRounded || whole != values[i];
    if (isEqual)
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
  Segmentation segmentation;
  segmentation.Source = volume.Source;
  segmentation.Notes = volume.Notes;
  const vtkSmartPointer<vtkDataArray> labels = ToLabels(volume.Source, voxels, segmentation.Notes);
  segmentation.IsOriented = volume.IsOriented;
  segmentation.Layers.push_back(labels == voxels ? volume.Image
                                                 : MakeImage(GridOf(volume.Image), labels));
  CompleteSegments(segmentation);
  ApplyLabelNames(segmentation, volume.Labels);
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
    // Such as a map of very small numbers, which no rounding of labels explains.
    if (survey.AnyRounded)
    {
      return "its values are not whole numbers";
    }
    return "all its voxels are 0";
  }
  return {};
}
} // namespace palpate
