#pragma once

#include "ComparedFile.h"
#include "PalpateComparisonModule.h"

#include <string>
#include <vector>

namespace palpate
{
/// Structures of two files that belong together.
struct StructurePairs
{
  struct Pair
  {
    Segment One;
    Segment Other;
  };

  std::vector<Pair> Pairs;
  std::vector<std::string> Unpaired; ///< a sentence for each structure without a partner

  /// With a label (number or name), that structure of each segmentation; `otherLabel` is that of
  /// the second one, if it differs. Without labels, the structures of the same name, if all of both
  /// files have different names and some are in both, else those of the same number; two files of
  /// one structure each are always a pair. Throws InputError if that leaves no pair, if a label is
  /// not found, and if a label is given but neither file is a segmentation.
  PALPATECOMPARISON_EXPORT static StructurePairs Of(const ComparedFile& one,
                                                    const ComparedFile& other,
                                                    const std::string& label,
                                                    const std::string& otherLabel);
};

/// The only structure of a file, or the one that is named; a label means nothing for others than
/// segmentations. Throws InputError, with the advice how to choose one, if there are several.
PALPATECOMPARISON_EXPORT Segment OnlyStructure(const ComparedFile& file, const std::string& label,
                                               const std::string& advice);
} // namespace palpate
