#pragma once

#include "PalpateFitModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// Identifies everything that a result depends on: the files' paths, sizes and times (StampOf; an
/// empty path counts too), and words for settings and program. 16 hexadecimal digits. Files are not
/// read.
PALPATEFIT_EXPORT std::string KeyOfInputs(const std::vector<std::filesystem::path>& files,
                                          const std::vector<std::string>& words);
} // namespace palpate
