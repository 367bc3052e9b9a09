#pragma once

#include "ImageGrid.h"
#include "PalpateIOModule.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

class DcmDataset;
class DcmItem;

namespace palpate
{
/// The image series that a result was made on: what a DICOM object derived from it takes over.
/// Attributes of patient, study and frame of reference come from the series' first slice and from
/// nowhere else.
class PALPATEIO_EXPORT DicomSource
{
public:
  struct Slice
  {
    std::string SopClass;
    std::string Instance;
    Vector3 PositionWorld; ///< as its file states it, mm
  };

  /// A folder with one series, or one of the files of a series. Throws InputError, also for texts
  /// that cannot be converted to UTF-8.
  explicit DicomSource(const std::filesystem::path& path);
  DicomSource(const DicomSource&) = delete;
  DicomSource& operator=(const DicomSource&) = delete;
  ~DicomSource();

  const std::filesystem::path& Path() const { return this->Source; }
  /// Of the stack of slices; sheared for a tilted gantry.
  const ImageGrid& Grid() const { return this->Stack; }
  /// In the order of the grid's third axis.
  const std::vector<Slice>& Slices() const { return this->All; }
  const std::string& SeriesUid() const { return this->Series; }
  const std::string& StudyUid() const { return this->Study; }
  const std::string& FrameOfReferenceUid() const { return this->Frame; }

  /// Fills an object with what all kinds share: patient, study and frame of reference of this
  /// series; a new series of the modality with one new instance; equipment, date and time.
  void Describe(DcmItem& object, const std::string& sopClass, const std::string& modality) const;
  /// References all slices from the object (common instance reference, PS3.3, C.12.2).
  void ReferenceAll(DcmItem& object) const;

private:
  std::filesystem::path Source;
  ImageGrid Stack;
  std::vector<Slice> All;
  std::string Series;
  std::string Study;
  std::string Frame;
  std::unique_ptr<DcmDataset> Kept; // patient, study and frame of reference
};
} // namespace palpate
