#include "CasePairs.h"

#include "CohortManifest.h"
#include "CohortTable.h"
#include "ComparedFile.h"
#include "CsvText.h"
#include "DecimalText.h"
#include "FileFormat.h"
#include "ImageFormat.h"
#include "InputError.h"
#include "ModelFile.h"
#include "OutputNames.h"
#include "Refusal.h"
#include "TableEncoding.h"
#include "WholeFile.h"

#include <algorithm>
#include <map>
#include <set>
#include <system_error>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::uintmax_t LargestTable = 64U << 20U;

// A case's file, with its label if it is one structure of several.
struct CaseFile
{
  std::filesystem::path File;
  std::string Label;
};
// A case may have several, one for each structure.
using CaseFiles = std::multimap<std::string, CaseFile>;

CaseFiles ModelsOfCohort(const std::filesystem::path& folder)
{
  CaseFiles files;
  const CohortTable table = CohortTable::Read(folder / "cohort.csv");
  for (const CohortRow& row : table.Rows())
  {
    if (!row.Model.empty())
    {
      const int label = row.Result.Structure.Label;
      files.emplace(row.Case,
                    CaseFile{folder / row.Model, label == 0 ? "" : std::to_string(label)});
    }
  }
  return files;
}

CaseFiles ModelsIn(const std::filesystem::path& folder)
{
  CaseFiles files;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
  {
    if (!EndingOf(entry->path(), ReadableModelEndings()).empty())
    {
      files.emplace(NameOfCompared(entry->path()), CaseFile{entry->path(), {}});
    }
  }
  return files;
}

CaseFiles FilesOf(const std::filesystem::path& folder)
{
  std::error_code ignored;
  if (std::filesystem::is_regular_file(folder / "cohort.csv", ignored))
  {
    return ModelsOfCohort(folder);
  }
  CaseFiles files;
  try
  {
    for (const std::filesystem::path& mask : FindMasks(folder))
    {
      files.emplace(NameOfCompared(mask), CaseFile{mask, {}});
    }
  }
  catch (const InputError&)
  {
    files = ModelsIn(folder);
    if (files.empty())
    {
      throw;
    }
  }
  return files;
}

std::string NoPartner(const std::filesystem::path& file, const std::filesystem::path& folder)
{
  return file.filename().string() + " has no partner in " + folder.string();
}

// Of one case: each structure's file of one side with that of the other, or a file of all
// structures with each.
void PairCase(const std::string& name, const CaseFiles& first, const CaseFiles& second,
              CasePairs& pairs)
{
  const auto [oneBegin, oneEnd] = first.equal_range(name);
  const auto [otherBegin, otherEnd] = second.equal_range(name);
  for (auto one = oneBegin; one != oneEnd; ++one)
  {
    for (auto other = otherBegin; other != otherEnd; ++other)
    {
      const std::string& label = one->second.Label;
      const std::string& otherLabel = other->second.Label;
      if (label.empty() || otherLabel.empty() || label == otherLabel)
      {
        pairs.Pairs.push_back({name, one->second.File, other->second.File,
                               label == otherLabel ? "" : label + otherLabel});
      }
    }
  }
}

void AddUnpaired(const CaseFiles& files, const CaseFiles& others,
                 const std::filesystem::path& folder, CasePairs& pairs)
{
  for (const auto& [name, file] : files)
  {
    if (others.count(name) == 0)
    {
      pairs.Unpaired.push_back(NoPartner(file.File, folder));
    }
  }
}

std::string Field(const CsvRecord& record, const char* column)
{
  const std::string* found = record.Find(column);
  return found == nullptr ? std::string() : *found;
}

// Cases of a list get folders, whose names have to differ.
void CheckCases(const std::filesystem::path& file, const CasePairs& pairs)
{
  std::set<std::string> taken;
  for (const CasePairs::Pair& pair : pairs.Pairs)
  {
    if (!taken.insert(FoldedName(PlainName(pair.Case)) + "/" + pair.Label).second)
    {
      Refuse(file, "lists the case " + pair.Case + " twice",
             "give every row a `case` that differs in its first 48 letters and digits");
    }
  }
}
} // namespace

CasePairs CasePairs::OfFolders(const std::filesystem::path& one, const std::filesystem::path& other)
{
  const CaseFiles first = FilesOf(one);
  const CaseFiles second = FilesOf(other);
  std::set<std::string> names;
  for (const auto& [name, file] : first)
  {
    names.insert(name);
  }
  CasePairs pairs;
  for (const std::string& name : names)
  {
    PairCase(name, first, second, pairs);
  }
  AddUnpaired(first, second, other, pairs);
  AddUnpaired(second, first, one, pairs);
  if (pairs.Pairs.empty())
  {
    Refuse(one, "and " + other.string() + " have no two files of one name",
           "name partners alike, or list them in a table for --pairs");
  }
  return pairs;
}

CasePairs CasePairs::OfTimes(const std::filesystem::path& file, const std::vector<double>& times)
{
  const auto count = static_cast<std::size_t>(OpenImage(file)->VolumeCount());
  if (count < 2)
  {
    Refuse(file, "has one volume", "leave out --time, or give an image over time");
  }
  if (times.size() != 1 && times.size() != count)
  {
    Refuse(file, "has " + std::to_string(count) + " volumes",
           "give one time for each, or the step from one to the next");
  }
  CasePairs pairs;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double time = times.size() == 1 ? times[0] * static_cast<double>(i) : times[i];
    std::string number = std::to_string(i + 1);
    number.insert(0, std::to_string(count).size() - number.size(), '0');
    pairs.Pairs.push_back({"volume " + number + " at " + SignificantText(time, 6), file, file, "",
                           std::to_string(i + 1), "1", time});
  }
  return pairs;
}

CasePairs CasePairs::OfTable(const std::filesystem::path& file)
{
  const std::filesystem::path folder = file.parent_path();
  CasePairs pairs;
  std::string encoding;
  ForEachCsvRecord(TableAsUtf8(ReadWholeFile(file, LargestTable), file.string(), encoding),
                   [&](const CsvRecord& record)
                   {
                     const std::string first = Field(record, "first");
                     const std::string reference = Field(record, "reference");
                     if (first.empty() || reference.empty())
                     {
                       Refuse(file, "has a row without first or reference",
                              "use a table with the header case,first,reference,label");
                     }
                     const std::string name = Field(record, "case");
                     pairs.Pairs.push_back({name.empty() ? NameOfCompared(first) : name,
                                            folder / first, folder / reference,
                                            Field(record, "label")});
                   });
  if (pairs.Pairs.empty())
  {
    Refuse(file, "lists no pair", "use a table with the header case,first,reference,label");
  }
  CheckCases(file, pairs);
  return pairs;
}
} // namespace palpate
