#include "DicomFolders.h"

#include "DicomSeries.h"
#include "InputError.h"
#include "Refusal.h"

#include <algorithm>
#include <system_error>

namespace palpate
{
namespace
{
constexpr std::size_t MostFolders = 10'000; // against a disk opened by mistake

std::vector<std::filesystem::path> FoldersBelow(const std::filesystem::path& top)
{
  using Walk = std::filesystem::recursive_directory_iterator;
  std::vector<std::filesystem::path> folders;
  std::error_code failure;
  for (Walk entry(top, std::filesystem::directory_options::skip_permission_denied, failure), end;
       !failure && entry != end; entry.increment(failure))
  {
    std::error_code ofEntry;
    if (entry->is_symlink(ofEntry) || !entry->is_directory(ofEntry))
    {
      continue;
    }
    folders.push_back(entry->path());
    if (folders.size() > MostFolders)
    {
      Refuse(top, "has more than " + std::to_string(MostFolders) + " subfolders",
             "specify the folder of a patient or a series");
    }
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

void AddSeries(const std::filesystem::path& folder, const std::filesystem::path& top,
               std::vector<DicomSeriesChoice>& choices)
{
  const std::vector<DicomSeries> all = FindDicomSeries(folder);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    DicomSeriesChoice choice;
    choice.Folder = folder;
    choice.Series = all.size() > 1 ? std::to_string(i + 1) : std::string();
    choice.Slices = all[i];
    choice.Subfolder = folder == top ? "" : folder.lexically_relative(top).string();
    choices.push_back(std::move(choice));
  }
}
} // namespace

std::string DicomSeriesChoice::Text() const
{
  return this->Slices.Summary() + (this->Slices.Date.empty() ? "" : ", " + this->Slices.Date) +
         (this->Subfolder.empty() ? "" : ", in " + this->Subfolder);
}

std::vector<DicomSeriesChoice> FindDicomSeriesBelow(const std::filesystem::path& folder)
{
  std::vector<DicomSeriesChoice> choices;
  for (const std::filesystem::path& below : FoldersBelow(folder))
  {
    try
    {
      AddSeries(below, folder, choices);
    }
    catch (const InputError&)
    {
      continue; // it has no series
    }
  }
  try
  {
    std::vector<DicomSeriesChoice> own;
    AddSeries(folder, folder, own);
    choices.insert(choices.begin(), own.begin(), own.end());
  }
  catch (const InputError&)
  {
    if (choices.empty())
    {
      throw;
    }
  }
  return choices;
}
} // namespace palpate
