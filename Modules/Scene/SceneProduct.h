#pragma once

#include "FitStages.h"
#include "PalpateSceneModule.h"
#include "ScalarField.h"
#include "SceneEffect.h"
#include "SceneInclusions.h"
#include "SceneProtection.h"
#include "Segmentation.h"
#include "StructureDistance.h"
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
/// The product could not be made: a message, the same as on the command line.
struct SceneFailure
{
  std::string Message;
};
inline bool operator==(const SceneFailure& a, const SceneFailure& b)
{
  return a.Message == b.Message;
}

/// The product of a step: shared and immutable. Pass a shallow copy to VTK pipelines, since they
/// modify the information of their input.
using SceneProduct =
    std::variant<SceneFailure, std::shared_ptr<const Volume>, std::shared_ptr<const Segmentation>,
                 std::shared_ptr<const FitSurface>, std::shared_ptr<const FitSamples>,
                 std::shared_ptr<const FitResult>, std::shared_ptr<const ScalarField>,
                 std::shared_ptr<const TouchContact>, std::shared_ptr<const TouchCost>,
                 std::shared_ptr<const ImageEffects>, std::shared_ptr<const SceneProtection>,
                 std::shared_ptr<const SurfaceTool>, std::shared_ptr<const SceneInclusions>,
                 std::shared_ptr<const StructureDistance>>;

/// The product if it has this type, otherwise null.
template <typename T>
std::shared_ptr<const T> ProductAs(const SceneProduct* product)
{
  const auto* held = product != nullptr ? std::get_if<std::shared_ptr<const T>>(product) : nullptr;
  return held != nullptr ? *held : nullptr;
}

/// The error message if the product could not be made, or if a fit refused the structure. Empty if
/// later steps can use the product.
PALPATESCENE_EXPORT std::string FailureOf(const SceneProduct& product);

/// The same without the name of the file or structure: a predicate ("is not star-shaped"), or a
/// clause.
PALPATESCENE_EXPORT std::string ReasonOf(const SceneProduct& product);

/// Approximate memory, without the products that it was made from.
PALPATESCENE_EXPORT std::size_t BytesOf(const SceneProduct& product);
} // namespace palpate
