#include "SofteningCache.h"

#include "DecimalText.h"
#include "ModelJson.h"
#include "TemporaryFile.h"
#include "WholeFile.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <mutex>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
namespace fs = std::filesystem;

constexpr const char* Start = "softening-"; // of all files, temporary ones too
constexpr const char* KeyEntry = "key";
constexpr const char* UnknownsEntry = "unknowns";
constexpr const char* EdgeEntry = "element_edge_mm";

struct ProcessCache
{
  std::mutex Lock;
  std::shared_ptr<const SofteningCache> Cache;
};

ProcessCache& OfThisProcess()
{
  static ProcessCache cache;
  return cache;
}

// Whether only the user can have written the files of a folder.
bool IsOwn(const fs::path& folder)
{
  struct stat found = {};
  return stat(folder.c_str(), &found) == 0 && S_ISDIR(found.st_mode) && found.st_uid == geteuid() &&
         (found.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

void MakeFolder(const fs::path& folder)
{
  std::error_code error;
  if (fs::create_directories(folder, error))
  {
    fs::permissions(folder, fs::perms::owner_all, error);
  }
}

ModelDocument DocumentOf(const std::string& key, const RadialModel& model,
                         const SofteningCache::Entry& entry)
{
  constexpr int AllDigits = 17;
  ModelDocument document{model, {}, entry.Elasticity};
  document.Provenance.Settings = {
      {KeyEntry, key},
      {UnknownsEntry, std::to_string(entry.Account.Unknowns)},
      {EdgeEntry, SignificantText(entry.Account.ElementEdge, AllDigits)}};
  return document;
}

std::string SettingOf(const ModelDocument& document, const std::string& name)
{
  for (const auto& [key, value] : document.Provenance.Settings)
  {
    if (key == name)
    {
      return value;
    }
  }
  return {};
}

bool IsSame(const OrganModel& read, const RadialModel& model)
{
  const auto* radial = std::get_if<RadialModel>(&read);
  return radial != nullptr && radial->Coefficients() == model.Coefficients() &&
         radial->CenterWorld() == model.CenterWorld();
}

struct CachedFile
{
  fs::file_time_type Used;
  std::uintmax_t Bytes = 0;
  fs::path Path;
};

std::vector<CachedFile> FilesOf(const fs::path& folder)
{
  std::vector<CachedFile> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
  {
    std::error_code unreadable;
    const bool isCached = at->path().filename().string().rfind(Start, 0) == 0 &&
                          fs::is_regular_file(at->symlink_status(unreadable));
    const std::uintmax_t bytes = isCached ? at->file_size(unreadable) : 0;
    const fs::file_time_type used =
        isCached ? at->last_write_time(unreadable) : fs::file_time_type();
    if (isCached && !unreadable)
    {
      files.push_back({used, bytes, at->path()});
    }
  }
  return files;
}

fs::path FolderIn(const char* variable, const fs::path& below)
{
  const char* value = std::getenv(variable);
  const fs::path folder(value != nullptr ? value : "");
  return folder.is_absolute() ? folder / below : fs::path();
}
} // namespace

SofteningCache::SofteningCache(fs::path folder, std::uintmax_t mostBytes)
    : Folder(std::move(folder)), MostBytes(mostBytes)
{
}

fs::path SofteningCache::PathOf(const std::string& key) const
{
  return this->Folder / (Start + key + ".json");
}

std::optional<SofteningCache::Entry> SofteningCache::Find(const std::string& key,
                                                          const RadialModel& model) const
{
  constexpr std::uintmax_t MostFileBytes = 16'000'000; // twenty times a usual one
  const fs::path path = this->PathOf(key);
  std::error_code error;
  if (!IsOwn(this->Folder) || !fs::is_regular_file(fs::symlink_status(path, error)))
  {
    return std::nullopt;
  }
  try
  {
    const ModelDocument document = ModelFromJson(ReadWholeFile(path, MostFileBytes), path.string());
    const auto edge = ParseNumber(SettingOf(document, EdgeEntry));
    const auto unknowns = ParseNumber(SettingOf(document, UnknownsEntry));
    if (document.Elasticity == nullptr || SettingOf(document, KeyEntry) != key ||
        !IsSame(document.Surface, model) || !edge || !unknowns || !(*unknowns >= 0.0) ||
        !(*unknowns < 1e9))
    {
      return std::nullopt;
    }
    fs::last_write_time(path, fs::file_time_type::clock::now(), error);
    return Entry{document.Elasticity, {*edge, static_cast<std::size_t>(*unknowns)}};
  }
  catch (const std::exception&)
  {
    return std::nullopt; // made again, and then replaced
  }
}

void SofteningCache::Store(const std::string& key, const RadialModel& model,
                           const Entry& entry) const
{
  MakeFolder(this->Folder);
  if (!IsOwn(this->Folder))
  {
    return;
  }
  try
  {
    const fs::path path = this->PathOf(key);
    const std::string text = ModelToJson(DocumentOf(key, model, entry), path.string());
    TemporaryFile file;
    std::error_code error;
    fs::remove(path, error); // for a file of other permissions, or a link
    if (!file.Create(path, Start, ".part").IsOk() ||
        fchmod(file.Descriptor(), S_IRUSR | S_IWUSR) != 0)
    {
      return;
    }
    std::ofstream stream(file.Path(), std::ios::binary);
    stream << text;
    stream.close();
    if (stream && file.Publish().IsOk())
    {
      this->Trim();
    }
  }
  catch (const std::exception&)
  {
    return; // without a cache the next run takes longer
  }
}

// Removes the least recently used files beyond the limit.
void SofteningCache::Trim() const
{
  std::vector<CachedFile> files = FilesOf(this->Folder);
  std::sort(files.begin(), files.end(),
            [](const CachedFile& a, const CachedFile& b) { return a.Used > b.Used; });
  std::uintmax_t bytes = 0;
  for (const CachedFile& file : files)
  {
    bytes += file.Bytes;
    std::error_code error;
    if (bytes > this->MostBytes)
    {
      fs::remove(file.Path, error);
    }
  }
}

void SofteningCache::UseInProcess(const fs::path& folder)
{
  ProcessCache& process = OfThisProcess();
  const std::lock_guard<std::mutex> hold(process.Lock);
  process.Cache = folder.empty() ? nullptr : std::make_shared<const SofteningCache>(folder);
}

std::shared_ptr<const SofteningCache> SofteningCache::OfProcess()
{
  ProcessCache& process = OfThisProcess();
  const std::lock_guard<std::mutex> hold(process.Lock);
  return process.Cache;
}

fs::path SofteningCache::UserFolder()
{
  if (const char* chosen = std::getenv("PALPATE_CACHE_DIR"))
  {
    return chosen;
  }
  const fs::path folder = FolderIn("XDG_CACHE_HOME", "palpate");
  return folder.empty() ? FolderIn("HOME", fs::path(".cache") / "palpate") : folder;
}
} // namespace palpate
