#include "ContentDigest.h"

#include "InputError.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
std::string DigestOf(const std::vector<std::string>& pieces)
{
  ContentDigest digest;
  for (const std::string& piece : pieces)
  {
    digest.Add(piece);
  }
  return digest.Text();
}

std::string DigestOfContent(const std::filesystem::path& path)
{
  ContentDigest digest;
  digest.AddContent(path);
  return digest.Text();
}

TEST(ContentDigest, EqualOnlyForEqualContent)
{
  EXPECT_EQ(DigestOf({"a", "b"}), DigestOf({"a", "b"}));
  EXPECT_NE(DigestOf({"a", "b"}), DigestOf({"b", "a"}));
  EXPECT_NE(DigestOf({"ab", "c"}), DigestOf({"a", "bc"}));
  EXPECT_NE(DigestOf({"a"}), DigestOf({"a", ""}));
  EXPECT_EQ(DigestOf({}), "cbf29ce484222325") << "FNV-1a's own start";
}

TEST(ContentDigest, FileDigestDependsOnBytesOnly)
{
  const test::TemporaryFolder folder;
  test::WriteAll(folder / "a", std::string(100000, 'x'));
  test::WriteAll(folder / "b", std::string(100000, 'x'));
  EXPECT_EQ(DigestOfContent(folder / "a"), DigestOfContent(folder / "b"));
  test::WriteAll(folder / "b", std::string(99999, 'x') + "y");
  EXPECT_NE(DigestOfContent(folder / "a"), DigestOfContent(folder / "b"));
}

TEST(ContentDigest, FolderDigestDependsOnFiles)
{
  const test::TemporaryFolder folder;
  test::WriteAll(folder / "slice1", "one");
  const std::string before = DigestOfContent(folder.Path());
  test::WriteAll(folder / "slice2", "two");
  EXPECT_NE(DigestOfContent(folder.Path()), before);
}

TEST(ContentDigest, RejectsMissingFile)
{
  EXPECT_THROW(DigestOfContent("/nowhere/at/all"), InputError);
}
} // namespace
} // namespace palpate
