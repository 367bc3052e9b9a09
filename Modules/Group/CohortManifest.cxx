#include "CohortManifest.h"

#include "CsvText.h"
#include "ImageFormat.h"
#include "InputError.h"
#include "MaskFolder.h"
#include "OutputNames.h"
#include "SurfaceFile.h"
#include "TableEncoding.h"
#include "WholeFile.h"

#include <algorithm>
#include <set>
#include <system_error>

namespace palpate
{
namespace
{
constexpr std::uintmax_t LargestManifest = 64U << 20U;

bool HasEnding(const std::filesystem::path& file, const std::vector<std::string>& endings)
{
  std::error_code ignored;
  return !EndingOf(file, endings).empty() && std::filesystem::is_regular_file(file, ignored);
}

std::string Get(const CsvRecord& record, const char* column)
{
  const std::string* found = record.Find(column);
  return found == nullptr ? std::string() : *found;
}

// Checked for each row at once, before further rows fill the memory.
void CheckRow(const std::filesystem::path& file, const CohortCase& one)
{
  if (one.Name.empty() || one.Mask.empty())
  {
    throw InputError(file.string() + ": a row has no case or no mask; give every row both");
  }
}
} // namespace

void CheckCaseNames(const std::filesystem::path& source, const std::vector<CohortCase>& cases)
{
  std::set<std::string> taken;
  for (const CohortCase& one : cases)
  {
    if (one.Name.find_first_not_of('.') == std::string::npos ||
        !taken.insert(FoldedName(PlainName(one.Name))).second)
    {
      throw InputError(source.string() + ": case " + one.Name +
                       " cannot have its own folder; give every case a name that differs in its "
                       "first 48 letters and digits");
    }
  }
}

std::vector<CohortCase> ReadManifest(const std::filesystem::path& file,
                                     const std::filesystem::path& base)
{
  const std::filesystem::path folder = base.empty() ? file.parent_path() : base;
  std::vector<CohortCase> cases;
  const auto take = [&](const CsvRecord& record)
  {
    const std::string mask = Get(record, "mask");
    const std::string volume = Get(record, "volume");
    cases.push_back({Get(record, "case"), mask.empty() ? std::filesystem::path() : folder / mask,
                     Get(record, "label"),
                     volume.empty() ? std::filesystem::path() : folder / volume});
    CheckRow(file, cases.back());
  };
  std::string encoding;
  ForEachCsvRecord(TableAsUtf8(ReadWholeFile(file, LargestManifest), file.string(), encoding),
                   take);
  if (cases.empty())
  {
    throw InputError(
        file.string() +
        " lists no case; use a table with the header case,mask,label,volume and one row per case");
  }
  CheckCaseNames(file, cases);
  return cases;
}

std::vector<std::filesystem::path> FindMasks(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> masks = ImagesIn(folder);
  std::vector<std::filesystem::path> surfaces;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end;
       masks.empty() && !error && entry != end; entry.increment(error))
  {
    if (HasEnding(entry->path(), SurfaceFormats().ReadEndings()))
    {
      surfaces.push_back(entry->path());
    }
  }
  masks = masks.empty() ? surfaces : masks;
  if (masks.empty())
  {
    throw InputError(folder.string() +
                     " has no readable segmentation or surface; use a folder of NIfTI, NRRD, "
                     "MetaImage or DICOM files, or of STL, PLY, OBJ, VTP, VTK, GIfTI or glTF "
                     "files, or a --manifest");
  }
  std::sort(masks.begin(), masks.end());
  return masks;
}
} // namespace palpate
