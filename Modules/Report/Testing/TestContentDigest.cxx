#include "ContentDigest.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace palpate::content_digest_test
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

TEST(ContentDigest, EqualOnlyForEqualContent)
{
  EXPECT_EQ(DigestOf({"a", "b"}), DigestOf({"a", "b"}));
  EXPECT_NE(DigestOf({"a", "b"}), DigestOf({"b", "a"}));
  EXPECT_NE(DigestOf({"ab", "c"}), DigestOf({"a", "bc"}));
  EXPECT_NE(DigestOf({"a"}), DigestOf({"a", ""}));
  EXPECT_EQ(DigestOf({}), "cbf29ce484222325") << "FNV-1a's own start";
}
} // namespace
} // namespace palpate::content_digest_test
