#include "ChosenValues.h"

#include "AvailableMemory.h"
#include "DecimalText.h"
#include "ImageGrid.h"
#include "Refusal.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkSetGet.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

namespace palpate
{
namespace
{
template <typename T>
vtkIdType Binarise(const T* values, vtkIdType count, double threshold, unsigned char* mask)
{
  std::transform(values, values + count, mask,
                 [threshold](T value) -> unsigned char
                 { return static_cast<double>(value) >= threshold ? 1 : 0; });
  return std::count(mask, mask + count, 1);
}

void ApplyThreshold(double threshold, Volume& volume)
{
  vtkDataArray* voxels = volume.Image->GetPointData()->GetScalars();
  const vtkIdType count = voxels->GetNumberOfValues();
  CheckMemory(volume.Source, static_cast<double>(count));
  auto mask = vtkSmartPointer<vtkUnsignedCharArray>::New();
  mask->SetNumberOfTuples(count);
  vtkIdType inside = 0;
  switch (voxels->GetDataType())
  {
    vtkTemplateMacro(inside = Binarise(static_cast<const VTK_TT*>(voxels->GetVoidPointer(0)), count,
                                       threshold, mask->GetPointer(0)));
  }
  if (inside == 0)
  {
    const double* range = voxels->GetFiniteRange();
    Refuse(volume.Source,
           "has no voxel of at least " + SignificantText(threshold) + " (its largest value is " +
               SignificantText(range[1]) + ")",
           "choose a smaller --threshold");
  }
  volume.Image = MakeImage(GridOf(volume.Image), mask);
  volume.Notes.push_back(std::to_string(inside) + " voxels of at least " +
                         SignificantText(threshold) + " were taken as inside.");
}

// In the image's precision: -0.1 in single precision is not the -0.1 of double precision.
template <typename T>
bool IsEqual(T value, double other)
{
  if constexpr (std::is_same_v<T, float>)
  {
    return value == static_cast<float>(other);
  }
  return static_cast<double>(value) == other;
}

template <typename T>
vtkIdType Clear(T* values, vtkIdType count, const std::vector<double>& background)
{
  const bool areNotFinite = std::any_of(background.begin(), background.end(),
                                        [](double value) { return std::isnan(value); });
  vtkIdType cleared = 0;
  std::for_each(values, values + count,
                [&](T& value)
                {
                  const auto number = static_cast<double>(value);
                  const bool isBackground =
                      (areNotFinite && !std::isfinite(number)) ||
                      std::any_of(background.begin(), background.end(),
                                  [value](double other) { return IsEqual(value, other); });
                  cleared += isBackground && value != 0 ? 1 : 0;
                  value = isBackground ? T(0) : value;
                });
  return cleared;
}

void ClearBackground(const std::vector<double>& background, Volume& volume)
{
  vtkDataArray* voxels = volume.Image->GetPointData()->GetScalars();
  vtkIdType cleared = 0;
  switch (voxels->GetDataType())
  {
    vtkTemplateMacro(cleared = Clear(static_cast<VTK_TT*>(voxels->GetVoidPointer(0)),
                                     voxels->GetNumberOfValues(), background));
  }
  voxels->Modified();
  volume.Notes.push_back(std::to_string(cleared) + " voxels were taken as background.");
}
} // namespace

void ChooseValues(const ValueChoice& choice, Volume& volume)
{
  if (!choice.Background.empty())
  {
    ClearBackground(choice.Background, volume);
  }
  if (choice.Threshold)
  {
    ApplyThreshold(*choice.Threshold, volume);
  }
}
} // namespace palpate
