#include "BrickFile.h"

#include "FieldBuilder.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <random>

namespace palpate
{
namespace
{
std::shared_ptr<const ScalarField> RandomField()
{
  const FieldGrid grid({40, 33, 37}, Vector3::Zero(), Vector3::Ones(), Matrix3::Identity());
  std::mt19937_64 random(91);
  std::vector<std::int16_t> samples(grid.NodeCount());
  for (std::int16_t& sample : samples)
  {
    sample = static_cast<std::int16_t>(random() % 1000);
  }
  FieldBuilder builder(grid);
  builder.AddMaterial({builder.AddChannel(SamplesOfGrid(samples.data(), grid)), 500.5});
  std::shared_ptr<const ScalarField> field;
  EXPECT_TRUE(builder.Build(field).IsOk());
  return field;
}

TEST(BrickFile, GivesEveryRecordBackInItsBits)
{
  const test::TemporaryFolder folder;
  const auto field = RandomField();
  std::unique_ptr<BrickSource> file;
  const Status status = BrickFile::Make(*field, folder.Path(), file);
  ASSERT_TRUE(status.IsOk()) << status.Message();
  RecordsInMemory memory(*field);
  const std::size_t bytes = RecordLayout(*field).Bytes();
  std::vector<std::byte> read(bytes);
  std::vector<std::byte> expected(bytes);
  const auto count = static_cast<std::uint32_t>(memory.Bytes() / bytes);
  ASSERT_GT(count, 50u);
  for (std::uint32_t n = count; n-- > 0;)
  {
    ASSERT_TRUE(file->Read(n, read.data()).IsOk());
    ASSERT_TRUE(memory.Read(n, expected.data()).IsOk());
    ASSERT_EQ(read, expected) << n;
  }
  EXPECT_FALSE(file->Read(count, read.data()).IsOk());
  EXPECT_EQ(file->Bytes(), 0u);
}

TEST(BrickFile, LeavesNothingBehind)
{
  const test::TemporaryFolder folder;
  std::unique_ptr<BrickSource> file;
  ASSERT_TRUE(BrickFile::Make(*RandomField(), folder.Path(), file).IsOk());
  EXPECT_EQ(folder.EntryCount(), 0u) << "not even while it is used";
}

TEST(BrickFile, AFolderThatCannotBeWrittenIsNamed)
{
  const test::TemporaryFolder folder;
  std::unique_ptr<BrickSource> file;
  const Status status = BrickFile::Make(*RandomField(), folder / "missing", file);
  EXPECT_NE(status.Message().find("missing"), std::string::npos) << status.Message();
  EXPECT_EQ(file, nullptr);
}
} // namespace
} // namespace palpate
