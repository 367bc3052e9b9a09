#pragma once

#include "PalpateReportModule.h"
#include "Vector3.h"

#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace palpate
{
/// Reads the entries of one object of a JSON file. Each member reads an entry, or leaves the value
/// unchanged if the entry is missing; for an invalid entry it throws InputError with the file, the
/// entry and the allowed values.
class PALPATEREPORT_EXPORT JsonFields
{
public:
  /// `place` is the object's name in messages, such as "structures[2]". Throws InputError for
  /// anything but an object.
  JsonFields(const nlohmann::json& object, std::filesystem::path file, std::string place);

  void Read(const char* key, double& value, double least, double most);
  void Read(const char* key, int& value, int least, int most);
  void Read(const char* key, bool& value);
  void Read(const char* key, std::string& value);
  /// Structures: a label's number from 1, a name, or a list of these; numbers become their text.
  void Read(const char* key, std::vector<std::string>& values);
  void Read(const char* key, Vector3& value, double least, double most);
  /// One of these words; `value` becomes its index.
  void Read(const char* key, int& value, const std::vector<std::string>& words);
  template <typename Choice>
  void ReadChoice(const char* key, std::initializer_list<const char*> words, Choice& choice)
  {
    int number = static_cast<int>(choice);
    this->Read(key, number, std::vector<std::string>(words.begin(), words.end()));
    choice = static_cast<Choice>(number);
  }
  bool Has(const char* key);
  /// Entries that are ignored, whatever their value (see RetiredKeys).
  void Skip(std::initializer_list<const char*> keys)
  {
    this->Skipped.insert(keys.begin(), keys.end());
  }

  /// Refuses entries that were not read or skipped, since they may be misspelt.
  void RefuseOthers() const;

private:
  const nlohmann::json* Find(const char* key);
  double NumberOf(const nlohmann::json& entry, const char* key, double least, double most) const;
  [[noreturn]] void RefuseEntry(const std::string& key, const std::string& what) const;

  const nlohmann::json& Object;
  std::filesystem::path File;
  std::string Place;
  std::set<std::string> Known;
  std::set<std::string> Skipped;
};

/// The word for a choice, the inverse of ReadChoice.
template <typename Choice>
const char* WordOf(std::initializer_list<const char*> words, Choice choice)
{
  return *(words.begin() + static_cast<int>(choice));
}
} // namespace palpate
