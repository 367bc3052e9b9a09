#pragma once

#include "BodyRelation.h"
#include "PalpateComparisonModule.h"
#include "Progress.h"
#include "RelatedOrgan.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
struct OrganRelationSettings
{
  RelationSettings Relation;
  OrganMeasures Measures;
  std::vector<std::string> Labels; ///< of segmentations, by number or name; empty for all
  std::string Of;                  ///< only pairs with the organ of this name; empty for all
  VolumeChoice Images;
  std::size_t Jobs = 1; ///< threads
};

/// Two organs, by their places in the list, and how they lie to each other, without maps.
struct OrganPair
{
  std::size_t One;
  std::size_t Other;
  BodyRelation Relation;
};

/// The organs of one patient, each measured, and all pairs of them.
struct OrganRelations
{
  std::vector<RelatedOrgan> Organs;
  std::vector<OrganPair> Pairs;   ///< in the order of the organs
  std::vector<std::string> Notes; ///< on the files
  RelationSettings Settings;
  OrganMeasures Measures;

  /// Files as ComparedFile::Read takes them, folders of masks, and folders in which `fit` has
  /// written models. Throws InputError if nothing can be measured or a name is unknown, and
  /// Cancelled.
  PALPATECOMPARISON_EXPORT static OrganRelations Of(const std::vector<std::filesystem::path>& files,
                                                    const OrganRelationSettings& settings,
                                                    const ProgressFunction& progress);

  /// The same of surfaces; of the settings, those of labels and images do not count.
  PALPATECOMPARISON_EXPORT static OrganRelations Of(const std::vector<NamedSurface>& surfaces,
                                                    const OrganRelationSettings& settings,
                                                    const ProgressFunction& progress);

  /// The places of the pairs within the reach, the nearest first.
  PALPATECOMPARISON_EXPORT std::vector<std::size_t> NearPairs() const;
};

/// "apart", "overlapping", "inside" or "around": how the first of a pair lies to the other.
PALPATECOMPARISON_EXPORT const char* RelationWord(BodyRelation::Kind kind);
/// "spheres" or "rays".
PALPATECOMPARISON_EXPORT const char* ThicknessWord(ThicknessRule rule);
/// The side of the patient to which an offset (mm, LPS) points most: "left"; and the angle
/// (degrees) between them.
struct OffsetSide
{
  const char* Name;
  double Degrees;
};
PALPATECOMPARISON_EXPORT OffsetSide OffsetSideOf(const Vector3& offset);
} // namespace palpate
