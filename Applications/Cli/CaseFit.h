#pragma once

#include "FitResult.h"

#include <string>

namespace palpate::cli
{
class Console;

/// What the progress shows while a case is fitted.
struct CaseShare
{
  double From = 0.0; ///< the part of the whole run that the case is
  double To = 1.0;
  std::string Title; ///< "case 3 of 28: 10015"
};

/// How progress names a structure: its name, or "label 1".
std::string ShortTitle(const Segment& structure);

/// One structure of a segmentation, with progress and Ctrl-C. What a structure is, and what the
/// options ask of it, counts as bad input. Throws Cancelled.
FitResult FitCase(const Segmentation& segmentation, const Segment& structure,
                  const FitSettings& settings, double readSeconds, const CaseShare& share,
                  Console& console);

/// A case of which nothing is known but why it could not be begun.
FitResult UnreadCase(const std::string& input, const Segment& structure, const std::string& message,
                     const FitSettings& settings);

/// Says in a note where the structure reaches beyond the volume of the slices.
void RemarkOnVolume(const Volume& volume, FitResult& result);

/// The sum of all stages, as the last one.
void AddTotalSeconds(FitResult& result);

/// A fitted case in a line, or any in JSON, then its notes; the first `fileNotes` of them were told
/// before. `folder` is where its files are; empty for none.
void TellCase(const FitResult& result, bool json, const std::string& folder, std::size_t fileNotes,
              Console& console);
} // namespace palpate::cli
