#pragma once

#include "FitStages.h"
#include "PalpateSceneModule.h"
#include "ScalarField.h"
#include "SceneEffect.h"
#include "SceneProtection.h"
#include "Segmentation.h"
#include "SurfaceTool.h"
#include "TouchContact.h"
#include "TouchCost.h"
#include "Volume.h"

#include <cstddef>
#include <memory>
#include <string>
#include <variant>

namespace palpate
{
/// Why there is no product: one sentence, the command line's.
struct SceneFailure
{
  std::string Sentence;
};
inline bool operator==(const SceneFailure& a, const SceneFailure& b)
{
  return a.Sentence == b.Sentence;
}

/// What a step makes. Shared with whoever shows or touches it, and never changed: a view that gives
/// it to a VTK pipeline gives it a shallow copy, since pipelines note things on their input.
using SceneProduct =
    std::variant<SceneFailure, std::shared_ptr<const Volume>, std::shared_ptr<const Segmentation>,
                 std::shared_ptr<const FitSurface>, std::shared_ptr<const FitSamples>,
                 std::shared_ptr<const FitResult>, std::shared_ptr<const ScalarField>,
                 std::shared_ptr<const TouchContact>, std::shared_ptr<const TouchCost>,
                 std::shared_ptr<const ImageEffects>, std::shared_ptr<const SceneProtection>,
                 std::shared_ptr<const SurfaceTool>>;

/// The product of a type; empty for another one.
template <typename T>
std::shared_ptr<const T> ProductAs(const SceneProduct* product)
{
  const auto* held = product != nullptr ? std::get_if<std::shared_ptr<const T>>(product) : nullptr;
  return held != nullptr ? *held : nullptr;
}

/// The sentence of what failed: there is no product, or the structure stood in the way. Empty for
/// one that later steps can go on from.
PALPATESCENE_EXPORT std::string FailureOf(const SceneProduct& product);

/// The same without naming the file or the structure: a predicate ("is not star-shaped"), or a
/// clause.
PALPATESCENE_EXPORT std::string ReasonOf(const SceneProduct& product);

/// What it occupies beyond the products that it was made from, about.
PALPATESCENE_EXPORT std::size_t BytesOf(const SceneProduct& product);
} // namespace palpate
