#pragma once

#include "PalpateSceneModule.h"
#include "Progress.h"
#include "ScalarField.h"
#include "SceneEffect.h"

#include <memory>

namespace palpate
{
/// What a force effect needs of its image.
struct EffectFieldSettings
{
  const char* Stage = "image"; ///< of the progress
  double Margin = 0.0;         ///< mm around the structure and the tool
  double Smoothing = 0.0;      ///< mm, standard deviation of a Gaussian; 0: none
  FieldInterpolation Interpolation = FieldInterpolation::Trilinear;
};

/// The part of a force effect's image where tool and structure can meet, as a field with samples
/// everywhere and one channel. Throws InputError for an image that does not reach the structure or
/// has values that are not finite, and Cancelled.
PALPATESCENE_EXPORT std::shared_ptr<const ScalarField>
FieldAround(const SceneEffectSource& source, const EffectFieldSettings& settings,
            const ProgressFunction& progress);
} // namespace palpate
