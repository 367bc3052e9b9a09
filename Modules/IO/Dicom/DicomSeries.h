#pragma once

#include "DicomPixels.h"
#include "PalpateIOModule.h"
#include "SliceStack.h"
#include "Volume.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// The slices of a folder that may be one volume: same series, orientation, size, pixel spacing.
struct DicomSeries
{
  std::string Uid;         ///< series instance UID; not unique if a series mixes orientations
  std::string Description; ///< series description, as the scanner wrote it; no patient data
  int Number = 0;          ///< series number
  std::string Date;        ///< of its first file, 2026-05-31; empty if not stated
  std::vector<std::filesystem::path> Files;
  std::vector<StackedSlice> Planes;      ///< of each file
  std::vector<DicomPixelFormat> Formats; ///< of each file

  /// "axial", "oblique coronal", ...
  std::string OrientationName() const;
  /// Description, number of slices and orientation, for lists.
  std::string Summary() const;
};

/// All image series of a folder (not of its subfolders), by ascending series number. Files that are
/// not DICOM images are skipped. Throws InputError if no image is left.
PALPATEIO_EXPORT std::vector<DicomSeries> FindDicomSeries(const std::filesystem::path& folder);

/// The series that the user chose, or the only one. Throws InputError with the list of all.
PALPATEIO_EXPORT const DicomSeries& ChooseSeries(const std::filesystem::path& folder,
                                                 const std::vector<DicomSeries>& all,
                                                 const VolumeChoice& choice);

/// The series of one of the folder's files; throws InputError if the file is not a slice.
PALPATEIO_EXPORT const DicomSeries& SeriesOfFile(const std::filesystem::path& file,
                                                 const std::vector<DicomSeries>& all);
} // namespace palpate
