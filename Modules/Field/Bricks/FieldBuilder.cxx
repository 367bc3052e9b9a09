#include "FieldBuilder.h"

#include "BSplineCoefficients.h"
#include "FieldBuild.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <sstream>

namespace palpate
{
namespace
{
// Converts the samples of the whole grid to B-spline coefficients.
std::vector<float> CoefficientsOf(const FieldSamples& samples, const FieldGrid& grid)
{
  std::vector<float> coefficients(grid.NodeCount(), static_cast<float>(samples.Outside));
  const FieldSamples whole = SamplesOfGrid(coefficients.data(), grid);
  VisitScalars(
      samples.Data, samples.Type,
      [&samples, &whole, &coefficients](const auto* data)
      {
        for (int k = 0; k < samples.Size[2]; ++k)
        {
          for (int j = 0; j < samples.Size[1]; ++j)
          {
            const auto* row = data + samples.Offset(0, j, k);
            float* target = &coefficients[whole.Offset(
                samples.StartIndex[0], samples.StartIndex[1] + j, samples.StartIndex[2] + k)];
            std::transform(row, row + samples.Size[0], target,
                           [](auto value) { return static_cast<float>(value); });
          }
        }
      });
  FindBSplineCoefficients(grid.Size(), coefficients);
  return coefficients;
}

std::string Range(const ChannelSurvey& survey)
{
  std::ostringstream text;
  text << "its samples run from " << survey.Lowest << " to " << survey.Highest;
  return text.str();
}

// Gradients are differences over spacings, and their squares are summed. The B-spline's
// coefficients are floats, up to 27 times the largest sample.
Status CheckRange(const ChannelSurvey& survey, std::size_t channel,
                  FieldInterpolation interpolation)
{
  const bool isTrilinear = interpolation == FieldInterpolation::Trilinear;
  const double largest = isTrilinear ? 1e140 : 1e36;
  const double smallest = isTrilinear ? 1e-140 : 1e-30;
  const double magnitude = std::max(std::abs(survey.Lowest), std::abs(survey.Highest));
  const double spread = survey.Highest - survey.Lowest;
  // Without any difference there is no surface either, which is checked with the conditions.
  if (magnitude <= largest && (spread >= smallest || spread == 0.0))
  {
    return Status::Success();
  }
  std::ostringstream text;
  text << "Channel " << channel << " is out of range: " << Range(survey)
       << "; supported are differences of at least " << smallest << " and values up to " << largest
       << "; rescale them.";
  return Status::Failure(text.str());
}
} // namespace

int FieldBuilder::AddChannel(const FieldSamples& samples)
{
  this->Channels.push_back(samples);
  return static_cast<int>(this->Channels.size()) - 1;
}

int FieldBuilder::AddMaterial(const FieldCondition& condition)
{
  this->Materials.push_back({1, {condition, {}}});
  return static_cast<int>(this->Materials.size()) - 1;
}

int FieldBuilder::AddMaterial(const FieldCondition& condition, const FieldCondition& limit)
{
  this->Materials.push_back({2, {condition, limit}});
  return static_cast<int>(this->Materials.size()) - 1;
}

Status FieldBuilder::SurveyChannels(std::vector<ChannelSurvey>& surveys) const
{
  surveys.resize(this->Channels.size());
  for (std::size_t channel = 0; channel < surveys.size(); ++channel)
  {
    Status status = Survey(this->Channels[channel], this->Grid, surveys[channel]);
    if (!status.IsOk())
    {
      return status;
    }
    if (this->Form.Interpolation == FieldInterpolation::TricubicBSpline)
    {
      surveys[channel].Exact = ScalarType::Float32;
    }
    status = CheckRange(surveys[channel], channel, this->Form.Interpolation);
    if (!status.IsOk())
    {
      return status;
    }
  }
  return Status::Success();
}

Status FieldBuilder::CheckCondition(const FieldCondition& condition,
                                    const std::vector<ChannelSurvey>& surveys) const
{
  if (condition.Channel < 0 || condition.Channel >= static_cast<int>(this->Channels.size()))
  {
    return Status::Failure("A material names channel " + std::to_string(condition.Channel) +
                           ", which the field does not have.");
  }
  const ChannelSurvey& survey = surveys[static_cast<std::size_t>(condition.Channel)];
  const bool isAtLeast = condition.Sense == FieldSense::AtLeast;
  const bool somewhere =
      isAtLeast ? survey.Highest >= condition.Iso : survey.Lowest <= condition.Iso;
  const bool everywhere =
      isAtLeast ? survey.Lowest >= condition.Iso : survey.Highest <= condition.Iso;
  if (!somewhere || everywhere)
  {
    std::ostringstream text;
    text << "The iso-value " << condition.Iso << " of channel " << condition.Channel
         << " gives no surface: " << Range(survey) << '.';
    return Status::Failure(text.str());
  }
  return Status::Success();
}

Status FieldBuilder::CheckMaterials(const std::vector<ChannelSurvey>& surveys) const
{
  const bool isEmpty = this->Materials.empty() && !this->KeepsAll;
  if (isEmpty || this->Materials.size() > MostMaterials)
  {
    return Status::Failure("A field needs 1 to " + std::to_string(MostMaterials) +
                           " materials; it was given " + std::to_string(this->Materials.size()) +
                           ".");
  }
  for (const FieldMaterial& material : this->Materials)
  {
    for (int c = 0; c < material.ConditionCount; ++c)
    {
      Status status = this->CheckCondition(material.Conditions[c], surveys);
      if (!status.IsOk())
      {
        return status;
      }
    }
  }
  return Status::Success();
}

Status FieldBuilder::Build(std::shared_ptr<const ScalarField>& field,
                           const Progress& progress) const
{
  Status status = this->Grid.Check();
  if (!status.IsOk())
  {
    return status;
  }
  try
  {
    std::vector<ChannelSurvey> surveys;
    status = this->SurveyChannels(surveys);
    status = status.IsOk() ? this->CheckMaterials(surveys) : status;
    if (!status.IsOk())
    {
      return status;
    }
    FieldBuild build(this->Grid, this->Form, this->Materials, progress);
    for (std::size_t channel = 0; channel < surveys.size(); ++channel)
    {
      build.AddChannel(this->Channels[channel], surveys[channel].Exact);
      if (this->Form.Interpolation == FieldInterpolation::TricubicBSpline)
      {
        build.UseCoefficients(CoefficientsOf(this->Channels[channel], this->Grid));
      }
    }
    const auto materials = static_cast<int>(this->Materials.size());
    MaterialSet kept = this->Kept;
    for (int material = 0; this->Form.KeepsInside && material < materials; ++material)
    {
      kept |= OnlyMaterial(material);
    }
    return build.Run(this->KeepsAll, kept, field);
  }
  catch (const std::bad_alloc&)
  {
    return Status::Failure("There is not enough memory to build the field.");
  }
}
} // namespace palpate
