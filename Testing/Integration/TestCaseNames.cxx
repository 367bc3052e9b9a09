#include "CaseNames.h"
#include "OutputNames.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace palpate::case_names_test
{
namespace
{
// Conversion of hostile names of files and structures to folder names.

using palpate::CaseNames;

const std::vector<std::string> HostilePieces{
    ".",      "..",         "...",  "/",      "\\",
    "-",      "_",          " ",    "\n",     "\t",
    "\x1b",   "\x7f",       "\xff", "\u202e", "\u00e9",
    "\u00c9", "a",          "A",    "CON",    "nul",
    "com1",   "LPT9",       ".nii", ".gz",    ".nii.gz",
    ".csv",   "cohort.csv", "=1",   ":",      "report",
    ".html",  ".json",      "~",    "$(x)",   "*",
    ".part",  "|",          "%2e",  ".nrrd",  "sub-01",
    "mask",   "\u2028\n",   "-2",   "aux",    std::string(90, 'x')};

class HostileNames
{
public:
  std::string Next()
  {
    std::string name;
    for (std::size_t pieces = this->Random() % 5; pieces > 0; --pieces)
    {
      name += HostilePieces[this->Random() % HostilePieces.size()];
    }
    return name;
  }
  /// A valid file name: no separators, at least one character.
  std::string NextFile()
  {
    std::string name = this->Next();
    name.erase(std::remove(name.begin(), name.end(), '/'), name.end());
    return "in/" + (this->Random() % 2 == 0 ? "f/" + name : name) + ".nii.gz";
  }

private:
  std::mt19937 Random{20261121};
};

bool IsSafe(const std::string& name, std::size_t longest)
{
  const std::string folded = FoldedName(name);
  const std::string stem = folded.substr(0, folded.find('.'));
  const std::set<std::string> devices{"con", "prn", "aux", "nul", "com1", "lpt9"};
  return !name.empty() && name.size() <= longest && name.front() != '.' && name.back() != '.' &&
         devices.count(stem) == 0 &&
         std::all_of(name.begin(), name.end(),
                     [](char letter)
                     {
                       const auto byte = static_cast<unsigned char>(letter);
                       return byte > 0x20 && byte < 0x7f &&
                              std::string("/\\:*?\"<>|").find(letter) == std::string::npos;
                     });
}

bool IsInside(const std::filesystem::path& path, const std::filesystem::path& folder)
{
  const std::filesystem::path relative = path.lexically_normal().lexically_relative(folder);
  return !relative.empty() && *relative.begin() != ".." && *relative.begin() != ".";
}

TEST(OutputNames, PlainNamesAreSafeAndUnchanged)
{
  HostileNames names;
  for (int n = 0; n < 20000; ++n)
  {
    const std::string text = names.Next();
    const std::string plain = PlainName(text);
    ASSERT_TRUE(IsSafe(plain, 48)) << text << " -> " << plain;
    ASSERT_EQ(PlainName(plain), plain) << text;
  }
}

TEST(OutputNames, KeepsOrdinaryNames)
{
  for (const char* name : {"sub-01", "case.1", "Prostate_2", "a", "console", "com", "lpt10"})
  {
    EXPECT_EQ(PlainName(name), name);
  }
}

TEST(OutputNames, FolderNamesDifferFromOutputFiles)
{
  for (const char* name : {"cohort.csv", "report.html", "mean.json", "mean.VTP"})
  {
    EXPECT_EQ(PlainName(name).find('.'), std::string::npos) << PlainName(name);
  }
}

TEST(OutputNames, StructureFoldersStayInside)
{
  HostileNames names;
  for (int n = 0; n < 20000; ++n)
  {
    Segment structure;
    structure.Label = n % 7;
    structure.Name = names.Next();
    const std::string text = names.Next();
    ASSERT_TRUE(IsSafe(CaseFolderName(text, structure), 80)) << text << '|' << structure.Name;
    ASSERT_TRUE(IsSafe(StructureFolderName(structure), 60)) << structure.Name;
    ASSERT_TRUE(IsInside("out/" + PlainName(text) + "/" + StructureFolderName(structure), "out"));
  }
}

TEST(CaseNames, DistinctCasesHaveDistinctFoldersIgnoringCase)
{
  HostileNames names;
  for (int run = 0; run < 200; ++run)
  {
    std::vector<std::string> inputs(40);
    std::generate(inputs.begin(), inputs.end(), [&names] { return names.NextFile(); });
    CaseNames cases(inputs);
    std::set<std::string> ofInputs;
    std::set<std::string> ofCases;
    for (std::size_t i = 0; i < inputs.size(); ++i)
    {
      const std::string& name = cases.OfInput(i);
      // A case's folder in a cohort is the PlainName of its name.
      ASSERT_EQ(PlainName(name), name) << inputs[i];
      ASSERT_TRUE(IsSafe(name, 48)) << inputs[i] << " -> " << name;
      ASSERT_TRUE(ofInputs.insert(FoldedName(name)).second) << inputs[i] << " -> " << name;
      Segment structure;
      structure.Label = 1;
      structure.Name = names.Next();
      const std::string folder = cases.Take(i, structure);
      ASSERT_TRUE(IsSafe(folder, 80)) << inputs[i] << " -> " << folder;
      ASSERT_TRUE(ofCases.insert(FoldedName(folder)).second) << inputs[i] << " -> " << folder;
    }
  }
}
} // namespace
} // namespace palpate::case_names_test
