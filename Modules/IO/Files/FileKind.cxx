#include "FileKind.h"

#include "FileFormat.h"
#include "Refusal.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <system_error>

namespace palpate
{
namespace
{
void CheckReadable(const std::filesystem::path& file)
{
  std::error_code failure;
  if (!std::filesystem::exists(file, failure))
  {
    Refuse(file, "does not exist", "check the path");
  }
  if (!std::filesystem::is_regular_file(file, failure))
  {
    Refuse(file, "is not a file", "specify an image file");
  }
  if (!std::ifstream(file, std::ios::binary))
  {
    Refuse(file, "cannot be opened", "check its permissions");
  }
  if (std::filesystem::file_size(file, failure) == 0)
  {
    Refuse(file, "is empty", "copy or export it again");
  }
}
} // namespace

bool HasDicomMark(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string mark(4, '\0');
  return stream.seekg(128) && stream.read(mark.data(), 4) && mark == "DICM";
}

std::vector<std::filesystem::path> DicomFilesIn(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> files;
  std::error_code failure;
  for (std::filesystem::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure))
  {
    std::error_code ofEntry;
    if (entry->is_regular_file(ofEntry) && HasDicomMark(entry->path()))
    {
      files.push_back(entry->path());
    }
  }
  if (failure)
  {
    Refuse(folder, "cannot be opened", "check its permissions");
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool IsDicomFile(const std::filesystem::path& file)
{
  CheckReadable(file);
  return HasDicomMark(file) || !EndingOf(file, {DicomEndings.begin(), DicomEndings.end()}).empty();
}
} // namespace palpate
