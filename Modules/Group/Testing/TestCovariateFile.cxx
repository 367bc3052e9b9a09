#include "CovariateFile.h"
#include "InputError.h"
#include "MessageOf.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

#include <array>

namespace palpate::covariate_file_test
{
namespace
{
using namespace palpate::test;

const std::vector<std::string> Cases{"10005_1000005", "10015_1000015", "100050_7"};

CovariateTable Read(const std::string& text, std::vector<std::string>& notes,
                    const std::string& id = {}, const std::vector<std::string>& cases = Cases)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.csv", text);
  return ReadCovariates(folder / "a.csv", id, cases, notes);
}

std::string RefusalOf(const std::string& text, const std::string& id = {})
{
  std::vector<std::string> notes;
  try
  {
    Read(text, notes, id);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return {};
}

TEST(CovariateFile, FindsRowsByWholePartsOfNames)
{
  std::vector<std::string> notes;
  const CovariateTable table = Read("age,patient_id\n64,10005\n37,10015\n70,100050\n50,1\n", notes);
  ASSERT_NE(table.Find("age"), nullptr);
  EXPECT_EQ(table.Find("age")->Texts(), (std::vector<std::string>{"64", "37", "70"}));
  EXPECT_TRUE(notes.empty());
}

TEST(CovariateFile, SemicolonsAndTabsSeparateAsSpreadsheetsWriteThem)
{
  for (const std::string& text :
       {std::string("id;age;group\n10005;62,5;\"a,b\"\n10015;-7,25;1,2,3\n"),
        std::string("id\tage\tgroup\n10005\t62.5\ta,b\n10015\t-7.25\t1,2,3\n")})
  {
    std::vector<std::string> notes;
    const CovariateTable table = Read(text, notes);
    ASSERT_NE(table.Find("age"), nullptr) << text;
    EXPECT_EQ(table.Find("age")->Texts(), (std::vector<std::string>{"62.5", "-7.25", ""}));
    EXPECT_EQ(table.Find("group")->Texts(), (std::vector<std::string>{"a,b", "1,2,3", ""}));
  }
}

TEST(CovariateFile, CommasInQuotesOfTheHeadSeparateNothing)
{
  std::vector<std::string> notes;
  const CovariateTable table = Read("id;\"a, b, c, d\"\n10005;1\n", notes);
  EXPECT_NE(table.Find("a, b, c, d"), nullptr);
}

// "Zürich" in both encodings.
TEST(CovariateFile, ReadsEncodingsOfSpreadsheetsAndSaysSo)
{
  std::string wide = "\xff\xfe";
  for (const char letter : std::string("id,site\n10005,Z\xfcrich\n"))
  {
    wide += letter;
    wide += '\0';
  }
  for (const std::string& text : {std::string("id,site\n10005,Z\xfcrich\n"), wide})
  {
    std::vector<std::string> notes;
    const CovariateTable table = Read(text, notes);
    EXPECT_EQ(table.Find("site")->Texts()[0], "Z\xc3\xbcrich");
    ASSERT_FALSE(notes.empty());
    EXPECT_NE(notes[0].find("was read as "), std::string::npos);
  }
  std::vector<std::string> notes;
  EXPECT_EQ(Read("id,euro\n10005,\x80\n", notes).Find("euro")->Texts()[0], "\xe2\x82\xac");
}

TEST(CovariateFile, RefusesWhatIsNoText)
{
  const std::string unpaired("\xff\xfei\0d\0\n\0\0\xd8\n\0", 12);
  for (const std::string& text :
       {std::string("i\0d\0", 4), unpaired, std::string("id,a\x01\n10005,1\n"),
        std::string("id,\xef\xbf\xbf\n10005,1\n"), std::string("id,\xfc\x81\n10005,1\n")})
  {
    EXPECT_NE(RefusalOf(text).find("save it as CSV in UTF-8"), std::string::npos) << text;
  }
}

TEST(CovariateFile, LineEndsAndFirstLineOfSpreadsheets)
{
  for (const std::string& text : {std::string("id,age\r10005,62\r10015,63\r"),
                                  std::string("sep=|\r\nid|age\n10005|62\n10015|63"),
                                  std::string("\xef\xbb\xbfsep=;\nid;age\n10005;62,0\n10015;63\n"),
                                  std::string("id , age\r\n 10005 ,\xc2\xa0"
                                              "62\r\n10015, 63\r\n")})
  {
    std::vector<std::string> notes;
    const CovariateTable table = Read(text, notes);
    ASSERT_NE(table.Find("age"), nullptr) << text;
    EXPECT_TRUE(table.Find("age")->IsNumeric()) << text;
    EXPECT_EQ(table.Find("age")->Number(0), 62.0) << text;
    EXPECT_EQ(table.Find("age")->Number(1), 63.0) << text;
  }
}

TEST(CovariateFile, ErrorsOfSpreadsheetsAreMissing)
{
  std::vector<std::string> notes;
  const CovariateTable table = Read("id,age\n10005,#N/A\n10015,#VALUE!\n100050,3\n", notes);
  EXPECT_TRUE(table.Find("age")->IsMissing(0));
  EXPECT_TRUE(table.Find("age")->IsMissing(1));
  EXPECT_TRUE(table.Find("age")->IsNumeric());
}

TEST(CovariateFile, FindsIdsThatSpreadsheetsHaveChanged)
{
  const std::vector<std::string> padded{"001", "002", "010"};
  for (const std::array<std::string, 3>& ids :
       {std::array<std::string, 3>{"1", "2", "10"},
        {"1.0", "2.0", "10.0"},
        {"001.nii.gz", "002.nii.gz", "010.nii.gz"},
        {"masks/001.nrrd", "C:\\masks\\002.nrrd", "010.nrrd"}})
  {
    const std::string text = "id,age\n" + ids[0] + ",5\n" + ids[1] + ",6\n" + ids[2] + ",7\n";
    std::vector<std::string> notes;
    const CovariateTable table = Read(text, notes, {}, padded);
    EXPECT_EQ(table.Find("age")->Texts(), (std::vector<std::string>{"5", "6", "7"})) << text;
    ASSERT_EQ(notes.size(), 1U) << text;
    EXPECT_NE(notes[0].find("3 cases were found by an id that is written differently"),
              std::string::npos);
    EXPECT_NE(notes[0].find("is taken for 010"), std::string::npos);
  }
}

// A session's number is not the subject's, and 1 stands for neither of 01 and 001.
TEST(CovariateFile, TakesNoAmbiguousNumber)
{
  std::vector<std::string> notes;
  const CovariateTable table =
      Read("id,age\n1,5\n3,6\n3.0,7\n002,8\n", notes, {}, {"sub-002_ses-01", "003", "01", "001"});
  EXPECT_EQ(table.Find("age")->Texts(), (std::vector<std::string>{"8", "", "", ""}));
}

TEST(CovariateFile, PrefersTheLongestId)
{
  std::vector<std::string> notes;
  const CovariateTable table = Read("case,age\n10005,1\n10005_1000005,2\n10015,3\n", notes);
  EXPECT_EQ(table.Find("age")->Texts()[0], "2");
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0], "1 cases have no row in the covariates, the first is 100050_7");
  EXPECT_TRUE(table.Find("age")->IsMissing(2));
}

TEST(CovariateFile, ReadsParticipantsOfBids)
{
  const TemporaryFolder folder;
  WriteAll(folder / "participants.tsv",
           "participant_id\tage\tnote\r\nsub-01\t64\ta, \"b\"\r\nsub-02\tn/a\t=x\r\n");
  std::vector<std::string> notes;
  const CovariateTable table =
      ReadCovariates(folder / "participants.tsv", {}, {"02", "01", "sub-01_dseg"}, notes);
  EXPECT_EQ(table.Find("age")->Texts(), (std::vector<std::string>{"n/a", "64", "64"}));
  EXPECT_EQ(table.Find("note")->Texts(), (std::vector<std::string>{"=x", "a, \"b\"", "a, \"b\""}));
  EXPECT_TRUE(table.Find("age")->IsMissing(0));
}

TEST(CovariateFile, TakesTheNamedColumn)
{
  std::vector<std::string> notes;
  const CovariateTable table = Read("case,scan,age\nx,7,1\ny,1000005,2\n", notes, "scan");
  EXPECT_EQ(table.Find("age")->Texts(), (std::vector<std::string>{"2", "", "1"}));
}

TEST(CovariateFile, RefusesWhatNamesNoCaseOrOneTwice)
{
  EXPECT_NE(RefusalOf("case,age\nx,1\ny,2\n").find("no case (such as x) is the name of a case"),
            std::string::npos);
  EXPECT_NE(RefusalOf("case,age\n10005,1\n10005,2\n").find("several rows have the case 10005"),
            std::string::npos);
  EXPECT_NE(RefusalOf("case,age\n10005,1\n", "scan").find("no column scan"), std::string::npos);
  EXPECT_NE(RefusalOf("case,age\n").find("has no rows"), std::string::npos);
  EXPECT_NE(RefusalOf("").find("is empty"), std::string::npos);
  EXPECT_NE(RefusalOf("case,age\n,1\n").find("name the column by --id"), std::string::npos);
}

TEST(CovariateFile, RefusesTablesOfColumnsOnly)
{
  std::string head = "case";
  for (int i = 0; i < 5000; ++i)
  {
    head += ",c" + std::to_string(i);
  }
  EXPECT_NE(RefusalOf(head + "\n10005\n").find("more than 4096 columns"), std::string::npos);
}
} // namespace
} // namespace palpate::covariate_file_test
