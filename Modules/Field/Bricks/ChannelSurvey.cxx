#include "ChannelSurvey.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace palpate
{
namespace
{
Status NotFinite(const FieldSamples& samples, std::size_t at)
{
  const auto columns = static_cast<std::size_t>(samples.Size[0]);
  const auto rows = static_cast<std::size_t>(samples.Size[1]);
  const std::array<std::size_t, 3> index{at % columns, at / columns % rows, at / columns / rows};
  std::string text;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    text += (axis > 0 ? ", " : "") +
            std::to_string(index[axis] + static_cast<std::size_t>(samples.StartIndex[axis]));
  }
  return Status::Failure("The sample at index (" + text + ") is not a finite number.");
}

template <typename T>
Status SurveyTyped(const T* data, const FieldSamples& samples, ChannelSurvey& survey)
{
  const std::size_t count = samples.Count();
  bool fitsFloat = true;
  for (std::size_t at = 0; at < count; ++at)
  {
    const auto value = static_cast<double>(data[at]);
    if (!std::isfinite(value))
    {
      return NotFinite(samples, at);
    }
    survey.Lowest = std::min(survey.Lowest, value);
    survey.Highest = std::max(survey.Highest, value);
    fitsFloat &= std::abs(value) <= std::numeric_limits<float>::max() &&
                 static_cast<double>(static_cast<float>(value)) == value;
  }
  survey.Exact = fitsFloat ? ScalarType::Float32 : ScalarType::Float64;
  if constexpr (sizeof(T) <= 2)
  {
    const bool fits = samples.Outside >= std::numeric_limits<T>::min() &&
                      samples.Outside <= std::numeric_limits<T>::max() &&
                      samples.Outside == std::floor(samples.Outside);
    survey.Exact = fits ? samples.Type : ScalarType::Float64;
  }
  return Status::Success();
}

bool FillsGrid(const FieldSamples& samples, const FieldGrid& grid)
{
  return samples.Count() == grid.NodeCount();
}
} // namespace

Status Survey(const FieldSamples& samples, const FieldGrid& grid, ChannelSurvey& survey)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int start = samples.StartIndex[axis];
    if (start < 0 || samples.Size[axis] < 1 || samples.Size[axis] > grid.Size()[axis] - start)
    {
      return Status::Failure("The samples of a channel do not lie inside the grid.");
    }
  }
  if (samples.Data == nullptr)
  {
    return Status::Failure("A channel has no samples.");
  }
  if (!FillsGrid(samples, grid))
  {
    if (!std::isfinite(samples.Outside))
    {
      return Status::Failure("The value outside the samples of a channel is not finite.");
    }
    survey.Lowest = samples.Outside;
    survey.Highest = samples.Outside;
  }
  Status status = VisitScalars(samples.Data, samples.Type,
                               [&samples, &survey](const auto* data)
                               { return SurveyTyped(data, samples, survey); });
  const auto outsideFloat = static_cast<float>(samples.Outside);
  if (survey.Exact == ScalarType::Float32 && static_cast<double>(outsideFloat) != samples.Outside)
  {
    survey.Exact = ScalarType::Float64;
  }
  return status;
}
} // namespace palpate
