#include "LabelValues.h"

#include "AvailableMemory.h"
#include "DecimalText.h"
#include "Refusal.h"

#include "vtkSetGet.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace palpate
{
namespace
{
[[noreturn]] void RefuseValue(const std::filesystem::path& file, const std::string& value)
{
  Refuse(file, "is not a label map: it holds the value " + value,
         "use whole numbers, one for each structure, or take the voxels from a value on "
         "(--threshold of palpate convert, fit, mesh, compare and soften)");
}

struct LabelSurvey
{
  int Largest = 0;
  double Rounded = 0.0; // largest distance from a whole number
};

// The value as a whole number; throws if it is no label.
template <typename T>
T LabelOf(const std::filesystem::path& file, T value, LabelSurvey& survey)
{
  T label = value;
  if constexpr (std::is_floating_point_v<T>)
  {
    const std::optional<double> whole = WholeValue(static_cast<double>(value));
    if (!whole)
    {
      RefuseValue(file, ExactText(value)); // in full precision: 0.998 is not printed as 1
    }
    survey.Rounded = std::max(survey.Rounded, std::abs(static_cast<double>(value) - *whole));
    label = static_cast<T>(*whole);
  }
  if constexpr (std::is_signed_v<T>)
  {
    if (label < 0)
    {
      const std::string text = SignificantText(static_cast<double>(value));
      Refuse(file, "is not a label map: it holds the negative value " + text,
             "use labels from 1, with 0 for the background, or take this value as background "
             "(--background " +
                 text + " of palpate convert, fit, mesh, compare and soften)");
    }
  }
  return label;
}

// Throws at the first value that is not a label.
template <typename T>
LabelSurvey SurveyLabels(const std::filesystem::path& file, const T* values, vtkIdType count)
{
  LabelSurvey survey;
  T largest = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    largest = std::max(largest, LabelOf(file, values[i], survey));
  }
  constexpr int most = std::numeric_limits<int>::max();
  if (static_cast<long double>(largest) > most)
  {
    Refuse(file, "holds the label " + TextAgainstLimit(static_cast<double>(largest), most, 0),
           "use labels up to " + std::to_string(most));
  }
  survey.Largest = static_cast<int>(largest);
  return survey;
}

template <typename From, typename To>
void ConvertTo(const From* from, vtkDataArray* to)
{
  To* target = static_cast<To*>(to->GetVoidPointer(0));
  std::transform(from, from + to->GetNumberOfValues(), target,
                 [](From value)
                 {
                   if constexpr (std::is_floating_point_v<From>)
                   {
                     return static_cast<To>(std::round(value));
                   }
                   return static_cast<To>(value);
                 });
}

template <typename From>
void Convert(const From* from, vtkDataArray* to)
{
  switch (to->GetDataType())
  {
  case VTK_UNSIGNED_CHAR:
    return ConvertTo<From, unsigned char>(from, to);
  case VTK_UNSIGNED_SHORT:
    return ConvertTo<From, unsigned short>(from, to);
  default:
    return ConvertTo<From, int>(from, to);
  }
}

template <typename T>
std::map<int, vtkIdType> CountSmall(const T* values, vtkIdType count)
{
  std::vector<vtkIdType> counts(std::size_t{1} << (8 * sizeof(T)), 0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    ++counts[values[i]];
  }
  std::map<int, vtkIdType> found;
  for (std::size_t value = 1; value < counts.size(); ++value)
  {
    if (counts[value] > 0)
    {
      found.emplace(static_cast<int>(value), counts[value]);
    }
  }
  return found;
}

// By runs of one value, so that the tree is searched once per run.
std::map<int, vtkIdType> CountLarge(const int* values, vtkIdType count)
{
  std::map<int, vtkIdType> found;
  for (vtkIdType start = 0; start < count;)
  {
    vtkIdType end = start + 1;
    while (end < count && values[end] == values[start])
    {
      ++end;
    }
    found[values[start]] += end - start;
    start = end;
  }
  found.erase(0);
  return found;
}
} // namespace

int LabelType(int largestLabel) noexcept
{
  if (largestLabel <= std::numeric_limits<unsigned char>::max())
  {
    return VTK_UNSIGNED_CHAR;
  }
  return largestLabel <= std::numeric_limits<unsigned short>::max() ? VTK_UNSIGNED_SHORT : VTK_INT;
}

std::optional<double> WholeValue(double value) noexcept
{
  constexpr double MostRounding = 1e-3;
  const double whole = std::round(value);
  return std::isfinite(value) && std::abs(value - whole) <= MostRounding
             ? std::optional<double>(whole + 0.0) // +0 of -0
             : std::nullopt;
}

vtkSmartPointer<vtkDataArray> ToLabels(const std::filesystem::path& file, vtkDataArray* voxels,
                                       std::vector<std::string>& notes)
{
  const void* data = voxels->GetVoidPointer(0);
  LabelSurvey survey;
  switch (voxels->GetDataType())
  {
    vtkTemplateMacro(
        survey = SurveyLabels(file, static_cast<const VTK_TT*>(data), voxels->GetNumberOfValues()));
  }
  if (survey.Rounded > 0.0)
  {
    notes.push_back("Labels are not exactly whole numbers, as after a scale factor; they were "
                    "rounded, by up to " +
                    SignificantText(survey.Rounded, 2) + ".");
  }
  const int type = LabelType(survey.Largest);
  if (type == voxels->GetDataType())
  {
    return voxels;
  }
  auto labels = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  CheckMemory(file, static_cast<double>(voxels->GetNumberOfTuples()) * labels->GetDataTypeSize());
  labels->SetNumberOfTuples(voxels->GetNumberOfTuples());
  switch (voxels->GetDataType())
  {
    vtkTemplateMacro(Convert(static_cast<const VTK_TT*>(data), labels));
  }
  return labels;
}

std::map<int, vtkIdType> CountLabels(vtkDataArray* labels)
{
  const vtkIdType count = labels->GetNumberOfValues();
  const void* data = labels->GetVoidPointer(0);
  switch (labels->GetDataType())
  {
  case VTK_UNSIGNED_CHAR:
    return CountSmall(static_cast<const unsigned char*>(data), count);
  case VTK_UNSIGNED_SHORT:
    return CountSmall(static_cast<const unsigned short*>(data), count);
  default:
    return CountLarge(static_cast<const int*>(data), count);
  }
}
} // namespace palpate
