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

/// Title of a structure in progress lines: its name, or "label 1".
std::string ShortTitle(const Segment& structure);

/// A mask or a closed surface (SurfaceFormats) whose structures are fitted, written and reported.
struct MaskToFit
{
  std::filesystem::path Mask;
  const Segmentation* Read = nullptr; ///< its content if it was read before
  std::string Name;                   ///< in notes about the whole file
  std::vector<std::string> Labels;    ///< empty for all structures
  FitSettings Settings;
  bool KeepsLargestPart = false; ///< of a surface file (FitOptions::NamesLargest)
  /// The image for the report's slices: already read, or a file to read, or none.
  const Volume* Slices = nullptr;
  std::filesystem::path SlicesFile;

  std::filesystem::path Output; ///< empty to write nothing
  /// A structure's folder, relative to Output. Called once per structure, in order.
  std::function<std::filesystem::path(const Segment&)> PlaceOf;
  /// The only mask of the run: the files of a single structure lie in Output itself, and a refused
  /// Output is bad input.
  bool IsAlone = false;
  bool Json = false;    ///< on standard output, instead of a line
  unsigned AtATime = 1; ///< structures that are fitted at a time

  ///@{ This mask's part of the whole run, and the title of its progress for a structure, its number
  /// from 1, and their count.
  double From = 0.0;
  double To = 1.0;
  std::function<std::string(std::size_t, std::size_t, const Segment&)> TitleOf;
  ///@}
};

/// Takes a structure's result, or that of a missing mask or label. `place` is its folder relative
/// to the output, if `isWritten`.
using TakeResult =
    std::function<void(FitResult&& result, const std::filesystem::path& place, bool isWritten)>;

/// Passes errors of the mask, its structures or its volume to `take` as a result instead of
/// throwing. Throws Cancelled.
void FitMask(const MaskToFit& mask, const ImageOptions& images, Console& console,
             const TakeResult& take);
} // namespace palpate::cli
