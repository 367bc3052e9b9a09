#include "NeutralInputs.h"

#include "CasePattern.h"
#include "FileFormat.h"
#include "ImageFormat.h"
#include "InputError.h"
#include "JsonText.h"
#include "ModelConvention.h"
#include "ModelFile.h"
#include "Refusal.h"
#include "SceneFile.h"
#include "SurfaceFile.h"
#include "WholeFile.h"

#include <algorithm>
#include <cerrno>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <vector>

namespace palpate::cli
{
namespace
{
constexpr std::uintmax_t LargestJson = 256U << 20U;

// Of data that a header names: they keep their names, under which it finds them.
const std::vector<std::string>& DataEndings()
{
  static const std::vector<std::string> endings{".raw", ".zraw", ".raw.gz", ".bin", ".mtl"};
  return endings;
}

std::string KnownEnding(const std::filesystem::path& file)
{
  if (IsSceneFile(file))
  {
    return ".scene.json";
  }
  std::string longest;
  for (const std::vector<std::string>& endings :
       {ReadableImageEndings(), SurfaceFormats().ReadEndings(), ReadableModelEndings(),
        DataEndings(),
        std::vector<std::string>{".csv", ".tsv", ".txt", ".lut", ".img", ".touch", ".state"}})
  {
    const std::string ending = EndingOf(file, endings);
    longest = ending.size() > longest.size() ? ending : longest;
  }
  return longest;
}

std::string StemOf(const std::filesystem::path& file)
{
  const std::string name = file.filename().string();
  return name.substr(0, name.size() - std::min(name.size(), KnownEnding(file).size()));
}

std::vector<std::filesystem::path> EntriesOf(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> entries;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
  {
    if (entry->path().filename().string().front() != '.')
    {
      entries.push_back(entry->path());
    }
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

void Link(const std::filesystem::path& target, const std::filesystem::path& link)
{
  std::error_code error;
  std::filesystem::create_symlink(target, link, error);
  if (error && error != std::errc::file_exists)
  {
    throw InputError("--anonymous: no link can be made in " + link.parent_path().string() + " (" +
                     error.message() + "); free disk space, or set TMPDIR to another folder");
  }
}

bool NamesImage(const std::string& text)
{
  const std::vector<std::string> endings = ReadableImageEndings();
  return std::any_of(endings.begin(), endings.end(),
                     [&text](const std::string& ending)
                     { return text.find(ending) != std::string::npos; });
}

// Null for what is no JSON, of which the command has its own message.
nlohmann::json DocumentIn(const std::filesystem::path& file)
{
  if (EndingOf(file, {".json"}).empty())
  {
    return {};
  }
  try
  {
    return ReadJson(file, LargestJson, "write it again");
  }
  catch (const InputError&)
  {
    return {};
  }
}

// Whether the document is a model. It loses the names of the mask that it was fitted to, and those
// of inclusions and neighbours if it yields.
bool ForgetOrigin(nlohmann::json& document)
{
  if (!document.is_object() || !document.contains("format") ||
      document["format"] != ModelConvention::Format || !document.contains("provenance") ||
      !document["provenance"].is_object())
  {
    return false;
  }
  nlohmann::json& provenance = document["provenance"];
  provenance.erase("input");
  if (provenance.contains("settings"))
  {
    nlohmann::json settings = nlohmann::json::object();
    for (const auto& [name, value] : provenance["settings"].items())
    {
      if (!value.is_string() || !NamesImage(value.get<std::string>()))
      {
        settings[name] = value;
      }
    }
    provenance["settings"] = settings;
  }
  return true;
}

// Private to the user, with a name that is mostly the same, so that results are, too.
std::filesystem::path NewFolder()
{
  constexpr int MostFolders = 10000;
  const std::filesystem::path parent = std::filesystem::temp_directory_path();
  for (int number = 1; number <= MostFolders; ++number)
  {
    const std::filesystem::path folder = parent / ("palpate-inputs-" + std::to_string(number));
    if (mkdir(folder.c_str(), S_IRWXU) == 0)
    {
      return folder;
    }
    if (errno != EEXIST)
    {
      break;
    }
  }
  throw InputError("--anonymous: no folder can be made in " + parent.string() +
                   "; set TMPDIR to a folder that can be written to");
}
} // namespace

NeutralInputs::NeutralInputs() : Root(NewFolder()) {}

NeutralInputs::~NeutralInputs()
{
  std::error_code ignored;
  std::filesystem::remove_all(this->Root, ignored);
}

std::filesystem::path NeutralInputs::Of(const std::filesystem::path& input)
{
  if (IsCasePattern(input.string()))
  {
    throw InputError("--anonymous numbers files and folders, not the cases of a pattern; name a "
                     "folder of masks");
  }
  const std::filesystem::path whole = std::filesystem::absolute(input).lexically_normal();
  const auto [entry, isNew] = this->Links.try_emplace(whole);
  if (isNew)
  {
    std::error_code ignored;
    const std::string name = "input-" + std::to_string(this->Links.size());
    const bool isFolder = std::filesystem::is_directory(whole, ignored);
    entry->second = this->Root / (isFolder ? name : name + KnownEnding(whole));
    if (isFolder)
    {
      this->LinkFolder(whole, entry->second);
    }
    else
    {
      this->LinkFile(whole, entry->second);
      this->LinkCompanions(whole, entry->second);
    }
  }
  return entry->second;
}

void NeutralInputs::LinkFile(const std::filesystem::path& file, const std::filesystem::path& link)
{
  nlohmann::json document = DocumentIn(file);
  if (IsSceneFile(file) && document.is_object())
  {
    this->ReplaceFiles(document, file.parent_path());
    WriteWholeFile(link, document.dump());
    return;
  }
  if (ForgetOrigin(document))
  {
    WriteWholeFile(link, document.dump());
    return;
  }
  Link(file, link);
  if (!EndingOf(file, DataEndings()).empty())
  {
    Link(file, link.parent_path() / file.filename());
  }
}

// Data beside a header, and tables of labels: found by the stem.
void NeutralInputs::LinkCompanions(const std::filesystem::path& file,
                                   const std::filesystem::path& link)
{
  const std::string stem = StemOf(file);
  for (const std::filesystem::path& other : EntriesOf(file.parent_path()))
  {
    if (other != file && StemOf(other) == stem)
    {
      this->LinkFile(other, link.parent_path() / (StemOf(link) + KnownEnding(other)));
    }
  }
}

void NeutralInputs::LinkFolder(const std::filesystem::path& folder,
                               const std::filesystem::path& link)
{
  std::filesystem::create_directory(link);
  for (const std::filesystem::path& entry : EntriesOf(folder))
  {
    std::error_code ignored;
    if (std::filesystem::is_directory(std::filesystem::symlink_status(entry, ignored)))
    {
      this->LinkFolder(entry, link / this->CaseOf(entry.filename().string()));
      continue;
    }
    if (entry.filename() == "cohort.csv")
    {
      Refuse(entry, "names the cases", "--anonymous takes folders of masks instead");
    }
    this->LinkFile(entry, link / (this->CaseOf(StemOf(entry)) + KnownEnding(entry)));
  }
}

std::string NeutralInputs::CaseOf(const std::string& stem)
{
  const std::string number = std::to_string(this->Cases.size() + 1);
  constexpr std::size_t Digits = 3;
  return this->Cases
      .try_emplace(stem,
                   "case-" + std::string(Digits - std::min(Digits, number.size()), '0') + number)
      .first->second;
}

void NeutralInputs::ReplaceFiles(nlohmann::json& part, const std::filesystem::path& folder)
{
  for (const auto& [key, value] : part.items())
  {
    if (value.is_structured())
    {
      this->ReplaceFiles(value, folder);
    }
    else if (value.is_string() && key != "name" && !value.get_ref<std::string&>().empty())
    {
      std::error_code ignored;
      const std::filesystem::path named = folder / value.get<std::string>();
      if (std::filesystem::exists(named, ignored))
      {
        value = this->Of(named).string();
      }
    }
  }
}
} // namespace palpate::cli
