#pragma once

#include "DicomPreview.h"
#include "PalpateIOModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// A series to choose among those of a folder and its subfolders.
struct DicomSeriesChoice
{
  std::filesystem::path Folder; ///< that has its slices
  /// As VolumeChoice takes it; empty for the only series of its folder.
  std::string Series;
  DicomSeries Slices;
  std::string Subfolder; ///< relative to the folder of the choice; empty for its own series
  DicomPreview Preview;  ///< for whoever shows it; empty after FindDicomSeriesBelow

  /// Description, number of slices, orientation, date and subfolder, for lists.
  PALPATEIO_EXPORT std::string Text() const;
};

/// The image series of a folder and of its subfolders, in the order of their paths; links to
/// folders are not followed, and folders that cannot be read are skipped. At least one. Throws the
/// InputError of FindDicomSeries if there is none, and InputError for more than 10,000 subfolders.
PALPATEIO_EXPORT std::vector<DicomSeriesChoice>
FindDicomSeriesBelow(const std::filesystem::path& folder);
} // namespace palpate
