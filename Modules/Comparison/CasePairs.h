#pragma once

#include "PalpateComparisonModule.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// Files of two folders, or of a list, that belong together.
struct CasePairs
{
  struct Pair
  {
    std::string Case;
    std::filesystem::path One;
    std::filesystem::path Other;
    std::string Label; ///< by number or name; empty for all
    ///@{ Of images over time; otherwise empty: see VolumeChoice, and the first one's time.
    std::string Series = {};
    std::string OtherSeries = {};
    std::optional<double> Time = {};
    ///@}
  };

  std::vector<Pair> Pairs;           ///< by case
  std::vector<std::string> Unpaired; ///< a sentence for each file without a partner

  /// Pairs the files of two folders that have the same name without endings. A folder's files are
  /// its segmentations, or its surfaces if it has none, or else its models; of a folder that `fit`
  /// wrote for a cohort, the models of its cohort.csv, by case. Throws InputError if a folder has
  /// none, or if no two belong together.
  PALPATECOMPARISON_EXPORT static CasePairs OfFolders(const std::filesystem::path& one,
                                                      const std::filesystem::path& other);

  /// The volumes of an image over time, each with its first one. `times` has a number for each, or
  /// one step. Throws InputError for other numbers of times, and a file of one volume.
  PALPATECOMPARISON_EXPORT static CasePairs OfTimes(const std::filesystem::path& file,
                                                    const std::vector<double>& times);

  /// The rows of a table with the columns `first` and `reference` (paths relative to the table's
  /// folder), and optionally `case` and `label`. Throws InputError.
  PALPATECOMPARISON_EXPORT static CasePairs OfTable(const std::filesystem::path& file);
};
} // namespace palpate
