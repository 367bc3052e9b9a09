#pragma once

#include "Segmentation.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace palpate::cli
{
/// Names of files and folders for the cases of one run, no two alike, however their masks are
/// called and wherever they lie. The names follow from the command line and the masks alone, not
/// from what becomes of the cases.
class CaseNames
{
public:
  CaseNames() = default;
  explicit CaseNames(const std::vector<std::string>& inputs);

  /// The part of the names that stands for a mask.
  const std::string& OfInput(std::size_t input) const { return this->Inputs[input]; }
  /// The name of a structure of a mask. To be asked for every case, once and in their order.
  std::string Take(std::size_t input, const Segment& structure);

private:
  std::vector<std::string> Inputs;
  std::set<std::string> Taken; ///< in small letters: some file systems do not tell them apart
};
} // namespace palpate::cli
