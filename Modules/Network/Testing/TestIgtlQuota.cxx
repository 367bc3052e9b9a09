#include "IgtlQuota.h"

#include <gtest/gtest.h>

namespace palpate::igtl_quota_test
{
namespace
{
TEST(IgtlQuota, UsualOneEndsAfterAThousandImages)
{
  IgtlQuota quota;
  for (int image = 0; image < 1000; ++image)
  {
    ASSERT_TRUE(quota.Check(100).IsOk()) << image;
    quota.Add(100);
  }
  EXPECT_EQ(quota.Images(), 1000);
  EXPECT_NE(quota.Check(100).Message().find("1000 images"), std::string::npos);
}

TEST(IgtlQuota, TotalMayBeReachedAndNotExceeded)
{
  IgtlQuota quota(5, 1e-6);
  quota.Add(900);
  EXPECT_TRUE(quota.Check(100).IsOk());
  const Status status = quota.Check(101);
  ASSERT_FALSE(status.IsOk());
  EXPECT_NE(status.Message().find("1e-06 GB"), std::string::npos) << status.Message();
}

TEST(IgtlQuota, HugeImagesDoNotOverflow)
{
  IgtlQuota quota;
  EXPECT_FALSE(quota.Check(UINT64_MAX).IsOk());
}
} // namespace
} // namespace palpate::igtl_quota_test
