#include "JsonFields.h"

#include "DecimalText.h"
#include "Refusal.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace palpate
{
namespace
{
std::string RangeText(double least, double most)
{
  return "from " + SignificantText(least) + " to " + SignificantText(most);
}
} // namespace

JsonFields::JsonFields(const nlohmann::json& object, std::filesystem::path file, std::string place)
    : Object(object), File(std::move(file)), Place(std::move(place))
{
  if (!object.is_object())
  {
    Refuse(this->File, "cannot be read: its " + this->Place + " is not an object",
           "write it as { \"name\": value, ... }");
  }
}

void JsonFields::RefuseEntry(const std::string& key, const std::string& what) const
{
  Refuse(this->File,
         "cannot be read: the entry \"" + key + "\" of its " + this->Place + " is not valid",
         "make it " + what);
}

const nlohmann::json* JsonFields::Find(const char* key)
{
  this->Known.insert(key);
  const auto found = this->Object.find(key);
  return found == this->Object.end() ? nullptr : &*found;
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

void JsonFields::Read(const char* key, double& value, double least, double most)
{
  if (const nlohmann::json* entry = this->Find(key))
  {
    value = this->NumberOf(*entry, key, least, most);
  }
}

void JsonFields::Read(const char* key, int& value, int least, int most)
{
  if (const nlohmann::json* entry = this->Find(key))
  {
    const double number = this->NumberOf(*entry, key, least, most);
    if (std::floor(number) != number)
    {
      this->RefuseEntry(key, "a whole number " + RangeText(least, most));
    }
    value = static_cast<int>(number);
  }
}

void JsonFields::Read(const char* key, bool& value)
{
  if (const nlohmann::json* entry = this->Find(key))
  {
    if (!entry->is_boolean())
    {
      this->RefuseEntry(key, "true or false");
    }
    value = entry->get<bool>();
  }
}

void JsonFields::Read(const char* key, std::string& value)
{
  if (const nlohmann::json* entry = this->Find(key))
  {
    if (!entry->is_string())
    {
      this->RefuseEntry(key, "a text");
    }
    value = entry->get<std::string>();
  }
}

void JsonFields::Read(const char* key, std::vector<std::string>& values)
{
  const nlohmann::json* entry = this->Find(key);
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

void JsonFields::Read(const char* key, Vector3& value, double least, double most)
{
  if (const nlohmann::json* entry = this->Find(key))
  {
    if (!entry->is_array() || entry->size() != 3)
    {
      this->RefuseEntry(key, "a list of three numbers " + RangeText(least, most));
    }
    for (Eigen::Index i = 0; i < 3; ++i)
    {
      value[i] = this->NumberOf((*entry)[static_cast<std::size_t>(i)], key, least, most);
    }
  }
}

void JsonFields::Read(const char* key, int& value, const std::vector<std::string>& words)
{
  const nlohmann::json* entry = this->Find(key);
  if (entry == nullptr)
  {
    return;
  }
  std::string list;
  int number = 0;
  for (const std::string& word : words)
  {
    if (entry->is_string() && entry->get<std::string>() == word)
    {
      value = number;
      return;
    }
    list += (number++ == 0 ? "\"" : ", \"") + word + "\"";
  }
  this->RefuseEntry(key, "one of " + list);
}

void JsonFields::RefuseOthers() const
{
  for (const auto& [key, value] : this->Object.items())
  {
    if (this->Known.count(key) == 0 && this->Skipped.count(key) == 0)
    {
      std::string list;
      for (const std::string& known : this->Known)
      {
        list += (list.empty() ? "" : ", ") + known;
      }
      Refuse(this->File,
             "cannot be read: its " + this->Place + " has an unknown entry \"" + key + "\"",
             "use one of " + list);
    }
  }
}
} // namespace palpate
