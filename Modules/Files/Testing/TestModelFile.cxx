#include "FileSizeLimit.h"
#include "InputError.h"
#include "MessageOf.h"
#include "ModelFile.h"
#include "RandomModels.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

namespace palpate::model_file_test
{
namespace
{
using namespace palpate::test;

TEST(ModelFile, EndingSelectsFormat)
{
  const TemporaryFolder folder;
  std::mt19937_64 random(1);
  const ModelDocument document{RandomModel(random, 3), {}};
  for (const char* name : {"a.json", "a.JSON"})
  {
    WriteModel(folder / name, document);
    const ModelDocument back = ReadModel(folder / name);
    EXPECT_TRUE(std::holds_alternative<RadialModel>(back.Surface)) << name;
  }
  WriteModel(folder / "a.coef", document);
  const ModelDocument back = ReadModel(folder / "a.coef");
  EXPECT_TRUE(std::holds_alternative<SurfaceModel>(back.Surface));
}

TEST(ModelFile, TablesAreWriteOnly)
{
  const TemporaryFolder folder;
  std::mt19937_64 random(1);
  WriteModel(folder / "a.csv", {RandomModel(random, 3), {}});
  EXPECT_NE(ReadAll(folder / "a.csv").find("l,m,coefficient_mm"), std::string::npos);
  EXPECT_TRUE(Contains(MessageOf([&] { ReadModel(folder / "a.csv"); }),
                       "which Palpate writes but does not read; use the model.json"));
}

TEST(ModelFile, RejectsOtherEndings)
{
  const TemporaryFolder folder;
  std::mt19937_64 random(2);
  EXPECT_THROW(WriteModel(folder / "a.txt", {RandomModel(random, 1), {}}), InputError);
  EXPECT_THROW(ReadModel(folder / "a.txt"), InputError);
  EXPECT_THROW(ReadModel(folder / "missing.json"), InputError);
  EXPECT_EQ(folder.EntryCount(), 0u);
}

TEST(ModelFile, DoesNotWriteInputFolders)
{
  const TemporaryFolder folder;
  std::mt19937_64 random(3);
  WriteModel(folder / "a.json",
             {RandomModel(random, 1), {"", "/home/SMITH^JOHN/m.nii", "", "", {}}});
  EXPECT_EQ(ReadAll(folder / "a.json").find("SMITH"), std::string::npos);
  EXPECT_EQ(ReadModel(folder / "a.json").Provenance.Input, "m.nii");
}

TEST(ModelFile, UnwritableModelKeepsOldFile)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.json", "old");
  const RadialModel broken(0, {std::nan("")}, Vector3::Zero());
  EXPECT_THROW(WriteModel(folder / "a.json", {broken, {}}), InputError);
  std::mt19937_64 random(4);
  {
    const FileSizeLimit limit(1024);
    EXPECT_THROW(WriteModel(folder / "a.json", {RandomModel(random, 12), {}}), InputError);
  }
  EXPECT_EQ(ReadAll(folder / "a.json"), "old");
  EXPECT_EQ(folder.EntryCount(), 1u);
}
} // namespace
} // namespace palpate::model_file_test
