#pragma once

#include "ComparedBody.h"
#include "OrganModel.h"
#include "PalpateComparisonModule.h"
#include "Segmentation.h"
#include "Volume.h"

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace palpate
{
/// A file's name without the ending of its format, a model's too.
PALPATECOMPARISON_EXPORT std::string NameOfCompared(const std::filesystem::path& file);

/// What stands for a mask's surface.
enum class MaskBody
{
  Boundary, ///< half way between voxels: for agreement
  Shape     ///< without their steps: for positions, which steps of thick slices would turn
};

/// A file whose bodies can be compared: a segmentation, a triangle surface or a model.
class PALPATECOMPARISON_EXPORT ComparedFile
{
public:
  /// `choice` is for DICOM series and axes of images. Throws InputError.
  static ComparedFile Read(const std::filesystem::path& path, const VolumeChoice& choice);

  const std::filesystem::path& Path() const { return this->Source; }
  /// "segmentation", "surface" or "model".
  const char* Kind() const;
  /// The segmentation; null of a surface or a model.
  const Segmentation* Labels() const { return std::get_if<Segmentation>(&this->Content); }
  /// The model; null of others.
  const OrganModel* Model() const { return std::get_if<OrganModel>(&this->Content); }
  /// Every structure of a segmentation; of a surface or a model, one with the label 0.
  std::vector<Segment> Structures() const;
  /// Changes made to the file's data.
  std::vector<std::string> Notes() const;

  /// Throws InputError if the structure has no surface that can be measured.
  ComparedBody Body(const Segment& structure, MaskBody ofMask = MaskBody::Boundary) const;

private:
  std::filesystem::path Source;
  std::variant<Segmentation, IndexedMesh, OrganModel> Content;
};
} // namespace palpate
