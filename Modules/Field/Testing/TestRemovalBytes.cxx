#include "FieldCases.h"
#include "RemovalBytes.h"
#include "RemovalStroke.h"

#include <cstring>

namespace palpate::removal_bytes_test
{
namespace
{
using Removed = std::shared_ptr<const RemovedDistances>;

class RemovalBytesTest : public testing::Test
{
protected:
  Removed Some() const
  {
    RemovalStroke stroke(this->None);
    const CutPose from{this->Grid.PointWorld({10.0, 12.0, 8.0}), {}};
    const CutPose to{this->Grid.PointWorld({40.0, 20.0, 14.0}), {}};
    std::vector<NodeBox> changed;
    stroke.Cut({CutTool::Sphere(4.0), from, to, 0.1}, changed);
    return stroke.Finish();
  }
  std::string Refusal(const std::vector<std::byte>& bytes, const Removed& like) const
  {
    Removed removed;
    const Status status = RemovedFromBytes(bytes, *like, removed);
    EXPECT_EQ(status.IsOk(), removed != nullptr);
    return status.Message();
  }

  std::mt19937_64 Random{61};
  FieldGrid Grid = test::ObliqueGrid({50, 40, 20}, Random);
  Removed None = RemovedDistances::None(Grid, 1.5);
};

TEST_F(RemovalBytesTest, RestoreAllDistances)
{
  const Removed some = this->Some();
  Removed back;
  ASSERT_TRUE(RemovedFromBytes(BytesOf(*some), *this->None, back).IsOk());
  for (std::size_t n = 0; n < this->Grid.NodeCount(); ++n)
  {
    const Vector3 p = test::NodeIndex(this->Grid.Size(), n);
    const auto at = [&p](const Removed& removed)
    { return removed->At(static_cast<int>(p[0]), static_cast<int>(p[1]), static_cast<int>(p[2])); };
    ASSERT_EQ(at(back), at(some));
  }
}

TEST_F(RemovalBytesTest, NothingRemovedTakesFewBytes)
{
  EXPECT_LT(BytesOf(*this->None).size(), std::size_t{300});
  EXPECT_EQ(this->Refusal(BytesOf(*this->None), this->None), "");
}

TEST_F(RemovalBytesTest, RejectAnotherVolume)
{
  const std::vector<std::byte> bytes = BytesOf(*this->Some());
  const Removed wider = RemovedDistances::None(this->Grid, 1.6);
  EXPECT_NE(this->Refusal(bytes, wider).find("another volume"), std::string::npos);
  const Removed elsewhere = RemovedDistances::None(test::PlainGrid({50, 40, 20}), 1.5);
  EXPECT_NE(this->Refusal(bytes, elsewhere).find("another volume"), std::string::npos);
}

TEST_F(RemovalBytesTest, RejectTruncatedOrTrailingBytes)
{
  std::vector<std::byte> bytes = BytesOf(*this->Some());
  bytes.push_back(std::byte{0});
  EXPECT_NE(this->Refusal(bytes, this->None), "");
  for (std::size_t size = 0; size + 1 < bytes.size(); size += 97)
  {
    EXPECT_NE(this->Refusal({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)},
                            this->None),
              "");
  }
}

// However a byte is changed, the result is rejected or a usable state.
TEST_F(RemovalBytesTest, DamageIsRejectedOrHarmless)
{
  const std::vector<std::byte> bytes = BytesOf(*this->Some());
  for (int trial = 0; trial < 2000; ++trial)
  {
    std::vector<std::byte> damaged = bytes;
    const std::size_t head = 600; // contains most of the critical data
    const std::size_t at = this->Random() % (trial % 2 == 0 ? head : bytes.size());
    damaged[at] ^= static_cast<std::byte>(1 + this->Random() % 255);
    Removed removed;
    if (RemovedFromBytes(damaged, *this->None, removed).IsOk())
    {
      for (const RemovedDistances::Corner& corner : removed->Corners())
      {
        const float* block = removed->BlockAt(corner);
        for (int n = 0; n < RemovedDistances::NodesOfBlock; ++n)
        {
          ASSERT_LE(std::abs(block[n]), 1.5f);
        }
      }
    }
  }
}
} // namespace
} // namespace palpate::removal_bytes_test
