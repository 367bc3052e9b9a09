#include "NiftiAlias.h"

#include "FileEnding.h"

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>

namespace palpate
{
NiftiAlias::NiftiAlias(const std::filesystem::path& file) : Name(file)
{
  std::filesystem::path uncompressed = file;
  uncompressed.replace_extension();
  if (FileEnding(file) != ".nii.gz" || !std::filesystem::exists(uncompressed))
  {
    return;
  }
  std::string pattern = (std::filesystem::temp_directory_path() / "palpate-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr)
  {
    throw std::runtime_error("no temporary folder can be made");
  }
  this->Folder = pattern;
  this->Name = this->Folder / "image.nii.gz";
  std::filesystem::create_symlink(std::filesystem::absolute(file), this->Name);
}

NiftiAlias::~NiftiAlias()
{
  if (!this->Folder.empty())
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Folder, ignored);
  }
}
} // namespace palpate
