#pragma once

#include "ImageGrid.h"
#include "PalpateIOModule.h"
#include "Segmentation.h"
#include "Volume.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace palpate
{
/// The images of a folder, not of its subfolders, sorted by name; none if it cannot be opened.
PALPATEIO_EXPORT std::vector<std::filesystem::path> ImagesIn(const std::filesystem::path& folder);

/// Whether a path is a folder with images and without DICOM files.
PALPATEIO_EXPORT bool IsMaskFolder(const std::filesystem::path& path);

/// A folder with an image for each mask, as one segmentation whose structures are named after their
/// files; and whether its masks are structures of one patient, or cases of one structure.
///
/// On one grid, masks of which no two have a Dice coefficient of 0.1 or more are structures. If
/// half of the pairs or more have, or fewer than four fifths of the masks lie on one grid, they are
/// cases. Anything between is unclear. Masks that cannot be read, are empty, or lie on another grid
/// than most are left out and do not count.
class PALPATEIO_EXPORT MaskFolder
{
public:
  enum class Kind
  {
    Structures,
    Cases,
    Unclear
  };
  /// Called before each of so many masks is read; may throw, to cancel.
  using Progress = std::function<void(std::size_t done, std::size_t count)>;

  /// Reads one mask after the other. With `judges`, only until it is clear that they are cases.
  /// Throws InputError if none can be read.
  MaskFolder(const std::filesystem::path& folder, const VolumeChoice& choice, bool judges,
             const Progress& progress = {});

  Kind Is() const { return this->Found; }
  /// Why, as a phrase: "116 masks on one grid that hardly overlap".
  const std::string& Why() const { return this->Reason; }
  /// Throws InputError, which names the options for both ways, if it is unclear.
  void RequireClear() const;
  /// How it is taken, and the option for the other way, as a sentence.
  std::string TakenText() const;
  /// Several structures on one grid that hardly overlap.
  bool IsOneSegmentation() const { return this->Found == Kind::Structures && this->MaskCount > 1; }
  /// Masks that were read.
  std::size_t Count() const { return this->MaskCount; }
  /// All masks that were read, in layers if some overlap; with `judges`, not all if they are cases.
  const Segmentation& Structures() const { return this->All; }
  /// Masks that were left out.
  const std::vector<RefusedMask>& LeftOut() const { return this->Refused; }

private:
  struct OneGrid
  {
    ImageGrid Grid;
    std::vector<std::filesystem::path> Masks;
  };
  std::vector<OneGrid> SortByGrid(const VolumeChoice& choice);
  void RefuseGrid(const std::vector<std::filesystem::path>& masks);
  void Read(const std::vector<std::filesystem::path>& masks, const VolumeChoice& choice,
            bool judges, const Progress& progress);

  std::filesystem::path Folder;
  Kind Found = Kind::Unclear;
  std::size_t MaskCount = 0; // that were read
  std::string Reason;
  Segmentation All;
  std::vector<RefusedMask> Refused;
};
} // namespace palpate
