#include "JsonFields.h"

#include "DecimalText.h"
#include "Refusal.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <system_error>
#include <utility>

namespace palpate
{
namespace
{
std::string RangeText(double least, double most)
{
  return "from " + SignificantText(least) + " to " + SignificantText(most);
}

// The path of a file as written in a file in `folder`. A link keeps its name.
std::string RelativeFile(const std::filesystem::path& file, const std::filesystem::path& folder)
{
  std::error_code failure;
  const std::filesystem::path parent = std::filesystem::absolute(file, failure).parent_path();
  std::filesystem::path relative =
      std::filesystem::proximate(parent, folder, failure) / file.filename();
  relative = failure ? file.lexically_proximate(folder) : relative.lexically_normal();
  // With symbolic links a relative path may lead elsewhere.
  const bool leadsElsewhere = file.is_absolute() && folder.is_absolute() &&
                              (folder / relative).lexically_normal() != file.lexically_normal();
  return (leadsElsewhere ? file : relative).generic_string();
}
} // namespace

JsonFields::JsonFields(const nlohmann::json& object, std::filesystem::path file, std::string place,
                       std::filesystem::path folder)
    : Source(&object), File(std::move(file)), Folder(std::move(folder)), Name(std::move(place))
{
  this->Require(object.is_object(), "cannot be read: its " + this->Name + " is not an object",
                "write it as { \"name\": value, ... }");
}

JsonFields::JsonFields(nlohmann::ordered_json& object, std::filesystem::path folder)
    : Written(&object), Folder(std::move(folder))
{
  object = nlohmann::ordered_json::object();
}

void JsonFields::RefuseEntry(const std::string& key, const std::string& what) const
{
  Refuse(this->File,
         "cannot be read: the entry \"" + key + "\" of its " + this->Name + " is not valid",
         "make it " + what);
}

void JsonFields::Require(bool isFulfilled, const std::string& fact, const std::string& remedy) const
{
  if (this->IsReading() && !isFulfilled)
  {
    Refuse(this->File, fact, remedy);
  }
}

const nlohmann::json* JsonFields::Find(const char* key)
{
  if (!this->IsReading())
  {
    return nullptr;
  }
  this->Known.insert(key);
  const auto found = this->Source->find(key);
  return found == this->Source->end() ? nullptr : &*found;
}

template <typename T>
const nlohmann::json* JsonFields::WriteOrFind(const char* key, const T& value)
{
  if (!this->IsReading())
  {
    (*this->Written)[key] = value;
  }
  return this->Find(key);
}

bool JsonFields::Has(const char* key)
{
  return this->Find(key) != nullptr;
}

double JsonFields::NumberOf(const nlohmann::json& entry, const char* key, double least,
                            double most) const
{
  const double value = entry.is_number() ? entry.get<double>() : std::nan("");
  if (!(value >= least && value <= most))
  {
    this->RefuseEntry(key, "a number " + RangeText(least, most));
  }
  return value;
}

void JsonFields::Exchange(const char* key, double& value, double least, double most)
{
  if (const nlohmann::json* entry = this->WriteOrFind(key, value))
  {
    value = this->NumberOf(*entry, key, least, most);
  }
}

void JsonFields::Exchange(const char* key, int& value, int least, int most)
{
  if (const nlohmann::json* entry = this->WriteOrFind(key, value))
  {
    const double number = this->NumberOf(*entry, key, least, most);
    if (std::floor(number) != number)
    {
      this->RefuseEntry(key, "a whole number " + RangeText(least, most));
    }
    value = static_cast<int>(number);
  }
}

void JsonFields::Exchange(const char* key, bool& value)
{
  if (const nlohmann::json* entry = this->WriteOrFind(key, value))
  {
    if (!entry->is_boolean())
    {
      this->RefuseEntry(key, "true or false");
    }
    value = entry->get<bool>();
  }
}

void JsonFields::Exchange(const char* key, std::string& value)
{
  if (const nlohmann::json* entry = this->WriteOrFind(key, value))
  {
    if (!entry->is_string())
    {
      this->RefuseEntry(key, "a text");
    }
    value = entry->get<std::string>();
  }
}

void JsonFields::Exchange(const char* key, std::vector<std::string>& values)
{
  const nlohmann::json* entry = this->WriteOrFind(key, values);
  if (entry == nullptr)
  {
    return;
  }
  const nlohmann::json list = entry->is_array() ? *entry : nlohmann::json::array({*entry});
  values.clear();
  for (const nlohmann::json& word : list)
  {
    const bool isLabel = word.is_number_unsigned() && word.get<std::uint64_t>() >= 1 &&
                         word.get<std::uint64_t>() <= std::numeric_limits<int>::max();
    if (!word.is_string() && !isLabel)
    {
      this->RefuseEntry(key, "a label's number from 1, a structure's name, or a list of these");
    }
    values.push_back(isLabel ? std::to_string(word.get<int>()) : word.get<std::string>());
  }
}

void JsonFields::Exchange(const char* key, std::filesystem::path& value)
{
  std::string text = this->IsReading() ? std::string() : RelativeFile(value, this->Folder);
  this->Exchange(key, text);
  if (this->Has(key))
  {
    value = text.empty() ? std::filesystem::path()
                         : (this->Folder / std::filesystem::u8path(text)).lexically_normal();
  }
}

void JsonFields::Exchange(const char* key, std::string& value,
                          const std::vector<std::string>& words)
{
  const nlohmann::json* entry = this->WriteOrFind(key, value);
  if (entry == nullptr)
  {
    return;
  }
  std::string list;
  for (const std::string& word : words)
  {
    if (entry->is_string() && entry->get<std::string>() == word)
    {
      value = word;
      return;
    }
    list += (list.empty() ? "\"" : ", \"") + word + "\"";
  }
  this->RefuseEntry(key, "one of " + list);
}

void JsonFields::ExchangeThree(const char* key, double* values, double least, double most)
{
  if (!this->IsReading())
  {
    (*this->Written)[key] = {values[0], values[1], values[2]};
  }
  else if (const nlohmann::json* entry = this->Find(key))
  {
    if (!entry->is_array() || entry->size() != 3)
    {
      this->RefuseEntry(key, "a list of three numbers " + RangeText(least, most));
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      values[i] = this->NumberOf((*entry)[i], key, least, most);
    }
  }
}

void JsonFields::ExchangeFormat(const std::string& format, const std::string& name)
{
  std::string given = this->IsReading() ? std::string() : format;
  this->Exchange("format", given);
  this->Require(given == format, "is not marked as " + name,
                "begin it with \"format\": \"" + format + "\"");
}

JsonFields JsonFields::Object(const char* key)
{
  if (!this->IsReading())
  {
    return JsonFields((*this->Written)[key], this->Folder);
  }
  return {*this->Find(key), this->File, this->Prefix + key, this->Folder};
}

std::size_t JsonFields::BeginList(const char* key, std::size_t count)
{
  if (!this->IsReading())
  {
    (*this->Written)[key] = nlohmann::ordered_json::array();
    return count;
  }
  const nlohmann::json* list = this->Find(key);
  this->Require(list == nullptr || list->is_array(),
                "cannot be read: its \"" + this->Prefix + key + "\" is not a list",
                "write it as [ { ... }, ... ]");
  return list == nullptr ? 0 : list->size();
}

JsonFields JsonFields::Item(const char* key, std::size_t number)
{
  if (!this->IsReading())
  {
    return JsonFields((*this->Written)[key].emplace_back(), this->Folder);
  }
  const std::string name = this->Prefix + key + "[" + std::to_string(number) + "]";
  JsonFields fields((*this->Find(key))[number], this->File, name, this->Folder);
  fields.Prefix = name + ".";
  return fields;
}

void JsonFields::RefuseOthers() const
{
  if (!this->IsReading())
  {
    return;
  }
  for (const auto& [key, value] : this->Source->items())
  {
    if (this->Known.count(key) == 0 && this->Skipped.count(key) == 0)
    {
      std::string list;
      for (const std::string& known : this->Known)
      {
        list += (list.empty() ? "" : ", ") + known;
      }
      Refuse(this->File,
             "cannot be read: its " + this->Name + " has an unknown entry \"" + key + "\"",
             "use one of " + list);
    }
  }
}
} // namespace palpate
