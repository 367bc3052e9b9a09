#pragma once

#include "FitResult.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace palpate::cli
{
class Console;
class ImageOptions;

/// How progress names a structure: its name, or "label 1".
std::string ShortTitle(const Segment& structure);

/// A mask whose structures are fitted, written and told of.
struct MaskToFit
{
  std::filesystem::path Mask;
  std::string Name;                ///< in notes about the whole file
  std::vector<std::string> Labels; ///< all structures for none
  FitSettings Settings;
  /// The image for the report's slices: one that was read before, or one to read; or none.
  const Volume* Slices = nullptr;
  std::filesystem::path SlicesFile;

  std::filesystem::path Output; ///< nothing is written where it is empty
  /// A structure's folder, relative to Output. Asked for each structure once, in their order.
  std::function<std::filesystem::path(const Segment&)> PlaceOf;
  /// The only mask of the run: the files of an only structure lie in Output itself, and an Output
  /// that is refused is bad input then.
  bool IsAlone = false;
  bool Json = false; ///< on standard output, instead of a line

  ///@{ The part of the whole run that this mask is, and what progress says: of a structure, its
  /// number from 1, and how many there are.
  double From = 0.0;
  double To = 1.0;
  std::function<std::string(std::size_t, std::size_t, const Segment&)> TitleOf;
  ///@}
};

/// Takes a structure's result, or that of a mask or a label that is not there. `place` is its
/// folder relative to the output, if `isWritten`.
using TakeResult =
    std::function<void(FitResult&& result, const std::filesystem::path& place, bool isWritten)>;

/// Never throws for what is wrong with the mask, its structures or its volume: `take` gets that as
/// a result. Throws Cancelled.
void FitMask(const MaskToFit& mask, const ImageOptions& images, Console& console,
             const TakeResult& take);
} // namespace palpate::cli
