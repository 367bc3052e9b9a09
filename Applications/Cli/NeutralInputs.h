#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace palpate::cli
{
/// Keeps the names of inputs, which may be patients', from a command: it gets links of the names
/// input-1, input-2, … in a private folder, which is removed with the object. Of a folder the files
/// are called case-001, case-002, … in the order of their names; those that differ in their endings
/// only, or lie in several folders, keep one name. Scenes and models that name further files are
/// copied without these names. Endings that no format has are dropped.
class NeutralInputs
{
public:
  /// Creates the folder. Throws InputError if that fails.
  NeutralInputs();
  NeutralInputs(const NeutralInputs&) = delete;
  NeutralInputs& operator=(const NeutralInputs&) = delete;
  ~NeutralInputs();

  /// The path that stands for a file or folder, the same one each time; a file that is missing is
  /// missing there too. Throws InputError for patterns and for folders of fitted cases, whose
  /// tables name the cases.
  std::filesystem::path Of(const std::filesystem::path& input);

private:
  void LinkFile(const std::filesystem::path& file, const std::filesystem::path& link);
  void LinkCompanions(const std::filesystem::path& file, const std::filesystem::path& link);
  void LinkFolder(const std::filesystem::path& folder, const std::filesystem::path& link);
  /// In a part of a scene in this folder, the texts that are paths of files.
  void ReplaceFiles(nlohmann::json& part, const std::filesystem::path& folder);
  std::string CaseOf(const std::string& stem);

  std::filesystem::path Root;
  std::map<std::filesystem::path, std::filesystem::path> Links; ///< by the inputs' absolute paths
  std::map<std::string, std::string> Cases;                     ///< by the stems of files' names
};
} // namespace palpate::cli
