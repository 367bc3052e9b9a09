#pragma once

#include "PalpateReportModule.h"
#include "Vector3.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace palpate
{
/// The entries of one object of a JSON file, to read or to write, so that keys and bounds are
/// listed once. Each Exchange reads an entry, or leaves the value unchanged if the entry is
/// missing; for an invalid entry it throws InputError with the file, the entry and the allowed
/// values. When writing, it appends the value unchecked.
class PALPATEREPORT_EXPORT JsonFields
{
public:
  /// Reads. `place` is the object's name in messages, such as "structures[2]"; paths are relative
  /// to `folder`. Throws InputError for anything but an object.
  JsonFields(const nlohmann::json& object, std::filesystem::path file, std::string place,
             std::filesystem::path folder = {});
  /// Writes into an empty object.
  explicit JsonFields(nlohmann::ordered_json& object, std::filesystem::path folder = {});

  bool IsReading() const { return this->Written == nullptr; }
  const std::string& Place() const { return this->Name; }

  void Exchange(const char* key, double& value, double least, double most);
  void Exchange(const char* key, int& value, int least, int most);
  void Exchange(const char* key, bool& value);
  void Exchange(const char* key, std::string& value);
  /// Structures: a label's number from 1, a name, or a list of these; numbers become their text.
  void Exchange(const char* key, std::vector<std::string>& values);
  /// Written relative to the folder, or unchanged if a relative path would lead elsewhere.
  void Exchange(const char* key, std::filesystem::path& value);
  /// One of these words.
  void Exchange(const char* key, std::string& value, const std::vector<std::string>& words);
  /// The word at the index of a choice.
  template <typename Choice>
  void Exchange(const char* key, Choice& choice, std::initializer_list<const char*> words)
  {
    std::string word = *(words.begin() + static_cast<int>(choice));
    this->Exchange(key, word, std::vector<std::string>(words.begin(), words.end()));
    choice = static_cast<Choice>(std::find(words.begin(), words.end(), word) - words.begin());
  }
  void Exchange(const char* key, Vector3& value, double least, double most)
  {
    this->ExchangeThree(key, value.data(), least, most);
  }
  void Exchange(const char* key, std::array<double, 3>& value, double least, double most)
  {
    this->ExchangeThree(key, value.data(), least, most);
  }
  template <typename T>
  void Exchange(const char* key, std::optional<T>& value, double least, double most)
  {
    if (!value && this->Has(key))
    {
      value.emplace();
    }
    if (value)
    {
      this->Exchange(key, *value, least, most);
    }
  }
  /// Does not write 0 or what is empty.
  template <typename T, typename... Bounds>
  void ExchangeIfSet(const char* key, T& value, Bounds... bounds)
  {
    if (this->IsReading() || !(value == T()))
    {
      this->Exchange(key, value, bounds...);
    }
  }

  /// An object within this one, by a function `exchange(fields, value)`.
  template <typename T, typename Function>
  void ExchangeObject(const char* key, T& value, const Function& exchange)
  {
    if (!this->IsReading() || this->Has(key))
    {
      JsonFields fields = this->Object(key);
      exchange(fields, value);
      fields.RefuseOthers();
    }
  }
  /// A list of objects, read into an empty one.
  template <typename T, typename Function>
  void ExchangeList(const char* key, std::vector<T>& values, const Function& exchange)
  {
    const std::size_t count = this->BeginList(key, values.size());
    for (std::size_t i = 0; i < count; ++i)
    {
      if (this->IsReading())
      {
        values.emplace_back();
      }
      JsonFields fields = this->Item(key, i);
      exchange(fields, values[i]);
      fields.RefuseOthers();
    }
  }
  /// A value as JSON by `write()`, or read by `read(entry, file)`, which checks it.
  template <typename Write, typename Read>
  void ExchangeJson(const char* key, const Write& write, const Read& read)
  {
    if (!this->IsReading())
    {
      (*this->Written)[key] = write();
    }
    else if (const nlohmann::json* entry = this->Find(key))
    {
      read(*entry, this->File);
    }
  }
  /// The entry "format". `name` is that of the kind of file in messages, such as "a scene".
  void ExchangeFormat(const std::string& format, const std::string& name);

  /// False when writing.
  bool Has(const char* key);
  /// Entries that are ignored, whatever their value (see RetiredKeys).
  void Skip(std::initializer_list<const char*> keys)
  {
    this->Skipped.insert(keys.begin(), keys.end());
  }
  /// Refuses a file that does not fulfil a condition (see Refuse). Does nothing when writing.
  void Require(bool isFulfilled, const std::string& fact, const std::string& remedy) const;
  /// Refuses entries that were not read or skipped, since they may be misspelt.
  void RefuseOthers() const;

private:
  const nlohmann::json* Find(const char* key);
  // The entry to read; null if it is missing, or if the value was written.
  template <typename T>
  const nlohmann::json* WriteOrFind(const char* key, const T& value);
  double NumberOf(const nlohmann::json& entry, const char* key, double least, double most) const;
  void ExchangeThree(const char* key, double* values, double least, double most);
  JsonFields Object(const char* key);
  // The number of objects to exchange.
  std::size_t BeginList(const char* key, std::size_t count);
  JsonFields Item(const char* key, std::size_t number);
  [[noreturn]] void RefuseEntry(const std::string& key, const std::string& what) const;

  const nlohmann::json* Source = nullptr;
  nlohmann::ordered_json* Written = nullptr;
  std::filesystem::path File;
  std::filesystem::path Folder;
  std::string Name;
  std::string Prefix; // of the names of objects within
  std::set<std::string> Known;
  std::set<std::string> Skipped;
};
} // namespace palpate
