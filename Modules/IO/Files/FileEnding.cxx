#include "FileEnding.h"

#include <algorithm>
#include <cctype>

namespace palpate
{
std::string FileEnding(const std::filesystem::path& path)
{
  std::string name = path.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const std::string compound : {".nii.gz", ".seg.nrrd"})
  {
    const bool has = name.size() > compound.size() &&
                     name.compare(name.size() - compound.size(), compound.size(), compound) == 0;
    if (has)
    {
      return compound;
    }
  }
  return std::filesystem::path(name).extension().string();
}
} // namespace palpate
