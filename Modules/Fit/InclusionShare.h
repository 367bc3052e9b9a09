#pragma once

#include "PalpateFitModule.h"
#include "RadialModel.h"
#include "Segmentation.h"
#include "TissueMap.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// How much of an inclusion lies in a model, by the centres of its voxels. One whose voxels all lie
/// outside is no part of the model's tissue.
struct InclusionShare
{
  std::string Name; ///< file, and structure if the file has several
  double Milliliters = 0.0;
  double InsideMilliliters = 0.0;

  bool IsInside() const { return this->InsideMilliliters > 0.0; }
  /// What a user has to know: that it lies outside of `organ` ("the model"), or that most of it
  /// does. Empty if at least half of it lies inside.
  PALPATEFIT_EXPORT std::string Note(const std::string& organ) const;
};

/// Voxels of an inclusion with a voxel of margin: 1 inside, 0 outside; one for each structure.
using InclusionFractions = std::vector<std::shared_ptr<const TissueMap::Samples>>;

/// Of some structures of a segmentation.
PALPATEFIT_EXPORT InclusionFractions FractionsOf(const Segmentation& read,
                                                 const std::vector<Segment>& segments);

/// The share of those structures in a model; `fractions` are theirs.
PALPATEFIT_EXPORT InclusionShare ShareOf(const RadialModel& model, const Segmentation& read,
                                         const std::vector<Segment>& segments,
                                         const InclusionFractions& fractions);
} // namespace palpate
