#pragma once

#include "CasePairs.h"
#include "ImageOptions.h"
#include "PairComparison.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::cli
{
class Console;

/// What `palpate compare` is asked for.
struct CompareSettings
{
  std::string Label;          ///< by number or name; empty for all
  std::string ReferenceLabel; ///< of the reference, if it is another one
  PairSettings Pair;
  ImageOptions Images;
  std::filesystem::path Output; ///< empty to write nothing
  bool Json = false;
};

/// A pair of files' part of the whole run.
struct ComparisonPart
{
  double From = 0.0;
  double To = 1.0;
  std::string Title;
};

/// Compares the structures of two files that belong together, writes and prints each result, and
/// returns them without their surfaces; the first one has the structures without a partner. Of
/// several cases (`isOfMany`) each structure has a folder of its own, and prints a line. Throws
/// InputError and Cancelled.
std::vector<PairComparison> CompareFiles(const CasePairs::Pair& files,
                                         const CompareSettings& settings, bool isOfMany,
                                         const ComparisonPart& part, Console& console);

/// Prints a pair: its result, notes and why it was not compared.
void PrintPair(const PairComparison& pair, const CompareSettings& settings, bool isOfMany,
               const std::filesystem::path& folder, Console& console);
} // namespace palpate::cli
