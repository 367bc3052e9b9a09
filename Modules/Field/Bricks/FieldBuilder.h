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
/// Collects channels, materials and settings of a field, and builds it. The samples must remain
/// valid until then.
class FieldBuilder
{
public:
  /// Called with the completed fraction, from 0 to 1; returns whether to continue.
  using Progress = std::function<bool(double)>;

  explicit FieldBuilder(const FieldGrid& grid) : Grid(grid) {}

  /// Both return the number, from 0, by which the field identifies it.
  int AddChannel(const FieldSamples& samples);
  int AddMaterial(const FieldCondition& condition);
  /// Both conditions must hold: for example an iso-value inside a label.
  int AddMaterial(const FieldCondition& condition, const FieldCondition& limit);

  void SetForm(const FieldForm& form) { this->Form = form; }
  void SetInterpolation(FieldInterpolation interpolation)
  {
    this->Form.Interpolation = interpolation;
  }
  /// Stores every brick, so that FieldSampler has samples everywhere; such a field needs no
  /// material.
  void KeepAll() { this->KeepsAll = true; }
  /// Also stores the bricks that a material fills, with all its channels, as drilling requires.
  /// Without this they take one number each; with it, the memory of their nodes (729 numbers for
  /// 8^3 cells).
  void KeepInside(int material) { this->Kept |= OnlyMaterial(material); }

  /// Fails, and leaves `field` unchanged, for: an invalid grid or samples; samples too large or too
  /// close to each other for the arithmetic (beyond 1e140 and 1e-140; for the B-spline, whose
  /// coefficients are floats, 1e36 and 1e-30); an iso-value that all or none of the samples reach;
  /// a material without a surface; too many materials; insufficient memory; cancellation by the
  /// caller.
  Status Build(std::shared_ptr<const ScalarField>& field, const Progress& progress = {}) const;

private:
  Status SurveyChannels(std::vector<ChannelSurvey>& surveys) const;
  Status CheckMaterials(const std::vector<ChannelSurvey>& surveys) const;
  Status CheckCondition(const FieldCondition& condition,
                        const std::vector<ChannelSurvey>& surveys) const;

  FieldGrid Grid;
  FieldForm Form = FieldInterpolation::Trilinear;
  bool KeepsAll = false;
  MaterialSet Kept = 0;
  std::vector<FieldSamples> Channels;
  std::vector<FieldMaterial> Materials;
};
} // namespace palpate
