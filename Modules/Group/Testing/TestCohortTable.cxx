#include "AddressSpaceLimit.h"
#include "CohortManifest.h"
#include "CohortTable.h"
#include "InputError.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

namespace palpate::cohort_table_test
{
namespace
{
using namespace palpate::test;

// Memory and time are bounded by the actual content of a table, not by its numbers.
constexpr rlim_t SomeMemory = rlim_t{256} << 20;

const std::string Head =
    "case,label,structure,outcome,sentence,degree,center_x_mm,center_y_mm,center_z_mm,mask_ml,"
    "model_ml,area_mm2,mean_mm,rms_mm,p95_mm,max_mm,dice,hidden_percent,seconds,mask,model,key\n";

std::string FittedRow(const std::string& name, const std::string& degree)
{
  return name + ",1,,fitted,," + degree + ",1,2,3,1,1,1,0,0,0,0,1,0,1,a.nii," + name +
         "/model.json,k\n";
}

template <typename Read>
std::string RefusalOf(const std::string& text, const Read& read)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.csv", text);
  const AddressSpaceLimit limit(SomeMemory);
  try
  {
    read(folder / "a.csv");
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "no error";
}

std::string TableRefusal(const std::string& text)
{
  return RefusalOf(text, [](const auto& file) { CohortTable::Read(file); });
}

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST(CohortTable, RowsOfHighestDegreeStoreNoCoefficients)
{
  const TemporaryFolder folder;
  std::string text = Head;
  for (int row = 0; row < 1000; ++row)
  {
    text += FittedRow(std::to_string(row), "1000");
  }
  WriteAll(folder / "cohort.csv", text);
  const AddressSpaceLimit limit(SomeMemory);
  const CohortTable table = CohortTable::Read(folder / "cohort.csv");
  ASSERT_EQ(table.Rows().size(), 1000U);
  EXPECT_EQ(table.Rows()[999].Degree, 1000);
  EXPECT_EQ(table.Rows()[999].CenterWorld, Vector3(1, 2, 3));
  table.Write(folder / "again.csv");
  EXPECT_EQ(CohortTable::Read(folder / "again.csv").Rows()[999].Degree, 1000);
}

TEST(CohortTable, RejectsImpossibleDegrees)
{
  for (const char* degree : {"10000", "1001", "-1", "2.5", "", "99999999999"})
  {
    const std::string refusal = TableRefusal(Head + FittedRow("a", degree));
    EXPECT_TRUE(Has(refusal, "degree of case a is not a whole number from 0 to 1000")) << refusal;
  }
}

TEST(CohortTable, ManyColumnsAndRowsDoNotMultiply)
{
  std::string head = Head;
  head.pop_back();
  for (int column = 0; column < 20000; ++column)
  {
    head += ",c" + std::to_string(column);
  }
  std::string text = head + "\n";
  for (int row = 0; row < 20000; ++row)
  {
    text += "a" + std::to_string(row) + ",1,,refused\n";
  }
  EXPECT_EQ(TableRefusal(text), "no error");
}

TEST(CohortTable, RejectsFirstEmptyRow)
{
  std::string text = Head;
  for (int row = 0; row < 2000000; ++row)
  {
    text += ",\n";
  }
  EXPECT_TRUE(Has(TableRefusal(text), "outcome"));
  text.replace(0, Head.size(), "case,mask\n");
  EXPECT_TRUE(Has(RefusalOf(text, [](const auto& file) { ReadManifest(file, {}); }),
                  "a row has no case or no mask"));
}

// The voxels of such a mask are in another file than its header.
TEST(CohortTable, KeyChangesWithDetachedVoxels)
{
  const TemporaryFolder folder;
  WriteAll(folder / "mask.mhd", "header");
  WriteAll(folder / "mask.raw", "voxels");
  const auto key = [&folder] { return CohortKey(folder / "mask.mhd", {}, {"1"}, {}, "program"); };
  const std::string before = key();
  EXPECT_EQ(key(), before);
  WriteAll(folder / "mask.raw", "other voxels");
  EXPECT_NE(key(), before);
}
} // namespace
} // namespace palpate::cohort_table_test
