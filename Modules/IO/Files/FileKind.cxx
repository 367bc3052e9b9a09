#include "FileKind.h"

#include "FileFormat.h"
#include "Refusal.h"
#include "WholeFile.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <system_error>

namespace palpate
{
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
  InputFileSize(file);
  return HasDicomMark(file) || !EndingOf(file, {DicomEndings.begin(), DicomEndings.end()}).empty();
}
} // namespace palpate
