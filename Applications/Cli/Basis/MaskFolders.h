#pragma once

#include <string>
#include <vector>

namespace palpate::cli
{
/// The inputs of a command, with the masks of a folder (FindMasks) instead of the folder. A folder
/// with DICOM files stays, since it is one image or segmentation, as does one without masks, for
/// the command to refuse.
std::vector<std::string> WithMasksOfFolders(const std::vector<std::string>& inputs);
} // namespace palpate::cli
