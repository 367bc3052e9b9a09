#pragma once

#include "PalpateFitModule.h"
#include "Segmentation.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace palpate
{
/// Unique names of files and folders for the cases of one run, whatever the names and folders of
/// their masks. They depend on the command line and the masks alone, not on the outcome of the
/// cases.
class PALPATEFIT_EXPORT CaseNames
{
public:
  CaseNames() = default;
  explicit CaseNames(const std::vector<std::string>& inputs);

  /// The part of the names that identifies a mask.
  const std::string& OfInput(std::size_t input) const { return this->Inputs[input]; }
  /// The name of a structure of a mask. Call once per case, in order.
  std::string Take(std::size_t input, const Segment& structure);

private:
  std::vector<std::string> Inputs;
  std::set<std::string> Taken; ///< in lower case: some file systems ignore case
};
} // namespace palpate
