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
/// Takes one object of a JSON file apart. Each member reads an entry, or leaves the value as it is
/// where the entry is missing, and throws InputError with the file, the entry and what it may be
/// where it is something else.
class PALPATEREPORT_EXPORT JsonFields
{
public:
  /// `place` is how messages name the object, such as "structures[2]". Refuses what is no object.
  JsonFields(const nlohmann::json& object, std::filesystem::path file, std::string place);

  void Read(const char* key, double& value, double least, double most);
  void Read(const char* key, int& value, int least, int most);
  void Read(const char* key, bool& value);
  void Read(const char* key, std::string& value);
  /// Structures: a label's number from 1, a name, or a list of these; numbers become their text.
  void Read(const char* key, std::vector<std::string>& values);
  void Read(const char* key, Vector3& value, double least, double most);
  /// One of these words; `value` becomes its place among them.
  void Read(const char* key, int& value, std::initializer_list<const char*> words);
  template <typename Choice>
  void ReadChoice(const char* key, std::initializer_list<const char*> words, Choice& choice)
  {
    int number = static_cast<int>(choice);
    this->Read(key, number, words);
    choice = static_cast<Choice>(number);
  }
  bool Has(const char* key);
  /// Entries that are read and dropped, whatever they hold (see RetiredKeys).
  void Skip(std::initializer_list<const char*> keys)
  {
    this->Skipped.insert(keys.begin(), keys.end());
  }

  /// Refuses entries that nobody asked for, since they may be misspelt.
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

/// The word that ReadChoice takes for a choice.
template <typename Choice>
const char* WordOf(std::initializer_list<const char*> words, Choice choice)
{
  return *(words.begin() + static_cast<int>(choice));
}
} // namespace palpate
