#pragma once

#include "ChannelSurvey.h"
#include "FieldMaterial.h"
#include "FieldSamples.h"
#include "ScalarField.h"
#include "Status.h"

#include <functional>
#include <memory>
#include <vector>

namespace palpate
{
/// Collects what a field is made of, and builds it. The samples have to live until then.
class FieldBuilder
{
public:
  /// Told what part of the work is done, from 0 to 1; answers whether to go on.
  using Progress = std::function<bool(double)>;

  explicit FieldBuilder(const FieldGrid& grid) : Grid(grid) {}

  /// Both give the number, counted from 0, by which the field knows it.
  int AddChannel(const FieldSamples& samples);
  int AddMaterial(const FieldCondition& condition);
  /// Where both conditions hold: for example an iso-value inside a label.
  int AddMaterial(const FieldCondition& condition, const FieldCondition& limit);

  void SetForm(const FieldForm& form) { this->Form = form; }
  void SetInterpolation(FieldInterpolation interpolation)
  {
    this->Form.Interpolation = interpolation;
  }
  /// Within this distance (mm) of a surface, FieldSampler has samples of the channels that the
  /// surface's material is made of. 0 by default.
  void SetMargin(double margin) { this->Margin = margin; }
  /// Stores the bricks that a material fills too, with all channels that it is made of: what is to
  /// be drilled has to be known inside. Without, they take a number each; with, what their nodes
  /// take (of 8 cells, 729 numbers).
  void KeepInside(int material) { this->Kept |= OnlyMaterial(material); }

  /// Refuses, with `field` untouched: a grid or samples that are none, samples too large or too
  /// alike to be computed with (beyond 1e140 and 1e-140; for the B-spline, whose coefficients are
  /// floats, 1e36 and 1e-30), an iso-value that not some but all or none of the samples reach, a
  /// material without a surface, too many materials, too little memory, and what the caller
  /// cancels.
  Status Build(std::shared_ptr<const ScalarField>& field, const Progress& progress = {}) const;

private:
  Status SurveyChannels(std::vector<ChannelSurvey>& surveys) const;
  Status CheckMaterials(const std::vector<ChannelSurvey>& surveys) const;
  Status CheckCondition(const FieldCondition& condition,
                        const std::vector<ChannelSurvey>& surveys) const;

  FieldGrid Grid;
  FieldForm Form = FieldInterpolation::Trilinear;
  double Margin = 0.0;
  MaterialSet Kept = 0;
  std::vector<FieldSamples> Channels;
  std::vector<FieldMaterial> Materials;
};
} // namespace palpate
