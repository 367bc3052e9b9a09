#include "IgtlPoses.h"

#include "IgtlMessages.h"
#include "IgtlTransform.h"

#include <gtest/gtest.h>
#include <igtlSensorMessage.h>
#include <igtlStatusMessage.h>
#include <igtlStringMessage.h>
#include <igtl_header.h>
#include <igtl_util.h>
#include <limits>
#include <random>

namespace palpate::igtl_poses_test
{
namespace
{
using Bytes = std::vector<std::uint8_t>;

Bytes BytesOf(const igtl::MessageBase::Pointer& message)
{
  const auto* first = static_cast<const std::uint8_t*>(message->GetPackPointer());
  return {first, first + message->GetPackSize()};
}
Bytes Pose(const std::string& name, const Vector3& place, const Matrix3& turn = Matrix3::Identity())
{
  return BytesOf(test::IgtlTransform(name, place, turn).GetPointer());
}
Bytes Text(std::string text)
{
  igtl::StringMessage::Pointer message = igtl::StringMessage::New();
  message->SetDeviceName("Remark");
  message->SetString(text);
  message->Pack();
  return BytesOf(message.GetPointer());
}
// A message with another body, and the header's length and checksum of it.
Bytes WithBody(const Bytes& message, Bytes body)
{
  Bytes whole(message.begin(), message.begin() + IGTL_HEADER_SIZE);
  const std::uint64_t numbers[2] = {body.size(), crc64(body.data(), body.size(), 0)};
  for (int i = 0; i < 16; ++i)
  {
    whole[static_cast<std::size_t>(42 + i)] =
        static_cast<std::uint8_t>(numbers[i / 8] >> (8 * (7 - i % 8)));
  }
  whole.insert(whole.end(), body.begin(), body.end());
  return whole;
}
// Version 2 of the header, which newer programs send: bytes of the specification, since the library
// here has version 1 only. Metadata follow; their stated lengths are 4 and `stated`.
Bytes WithMetadata(const Bytes& message, std::uint8_t stated)
{
  Bytes body{0, 12, 0, 4, 0, 0, 0, stated, 0, 0, 0, 9}; // the extended header's length first
  body.insert(body.end(), message.begin() + IGTL_HEADER_SIZE, message.end());
  body.insert(body.end(), 10, std::uint8_t{'m'});
  Bytes newer = WithBody(message, body);
  newer[1] = 2;
  return newer;
}
bool Take(IgtlPoses& poses, const Bytes& bytes)
{
  return poses.Take(bytes.data(), bytes.size());
}

TEST(IgtlPoses, PlaceAndTurnAreThoseSentHoweverBytesArrive)
{
  std::mt19937_64 random(2);
  const Matrix3 turn =
      Eigen::AngleAxisd(0.7, Vector3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  Bytes stream = Text("before");
  const Bytes pose = Pose("Stylus", Vector3(1.5, -20.0, 300.25), turn);
  const Bytes after = Text(std::string(9000, 'x'));
  stream.insert(stream.end(), pose.begin(), pose.end());
  stream.insert(stream.end(), after.begin(), after.end());
  IgtlPoses poses;
  for (std::size_t place = 0; place < stream.size();)
  {
    const std::size_t count = std::min<std::size_t>(1 + random() % 90, stream.size() - place);
    ASSERT_TRUE(poses.Take(stream.data() + place, count));
    place += count;
  }
  const IgtlPose* found = poses.Newest();
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(Vector3(found->Position), Vector3(1.5, -20.0, 300.25));
  const Eigen::Quaterniond q(Eigen::Map<const Eigen::Vector4d>(found->Orientation.data()));
  EXPECT_LT(q.angularDistance(Eigen::Quaterniond(turn)), 1e-6); // single precision
  EXPECT_EQ(poses.Newest(), nullptr) << "each is told once";
}

TEST(IgtlPoses, OtherToolsAreLeftOut)
{
  IgtlPoses named("Stylus");
  ASSERT_TRUE(Take(named, Pose("Pointer", Vector3::Ones())));
  EXPECT_EQ(named.Newest(), nullptr);
  ASSERT_TRUE(Take(named, Pose("Stylus", Vector3::Zero())));
  EXPECT_NE(named.Newest(), nullptr);
  IgtlPoses first;
  ASSERT_TRUE(Take(first, Pose("Pointer", Vector3::Ones())));
  ASSERT_TRUE(Take(first, Pose("Stylus", Vector3::Zero())));
  EXPECT_EQ(Vector3(first.Newest()->Position), Vector3::Ones());
}

TEST(IgtlPoses, NearestRotationIsTakenOfAQuaternionOfAnotherLength)
{
  const Eigen::Quaterniond q(0.6, 0.0, 0.5, 0.4);
  IgtlPoses poses;
  ASSERT_TRUE(Take(poses, Pose("Tracker", Vector3::Zero(), q.toRotationMatrix())));
  const IgtlPose* found = poses.Newest();
  ASSERT_NE(found, nullptr);
  EXPECT_NEAR(Eigen::Map<const Eigen::Vector4d>(found->Orientation.data()).norm(), 1.0, 1e-12);
}

TEST(IgtlPoses, DamagedOnesAreCountedAndNotUsed)
{
  IgtlPoses poses;
  Bytes broken = Pose("Stylus", Vector3::Ones());
  broken.back() ^= 1; // the CRC no longer fits
  ASSERT_TRUE(Take(poses, broken));
  ASSERT_TRUE(Take(poses, Pose("Stylus", Vector3::Ones(), 2.5 * Matrix3::Identity())));
  ASSERT_TRUE(Take(poses, Pose("Stylus", Vector3::Ones(), -Matrix3::Identity())));
  ASSERT_TRUE(
      Take(poses, Pose("Stylus", Vector3::Constant(std::numeric_limits<double>::quiet_NaN()))));
  ASSERT_TRUE(Take(poses, Pose("Stylus", Vector3::Constant(1e30))));
  EXPECT_EQ(poses.Newest(), nullptr);
  EXPECT_EQ(poses.Refused(), 5U);
  ASSERT_TRUE(Take(poses, Pose("Stylus", Vector3::Zero())));
  EXPECT_NE(poses.Newest(), nullptr) << "the stream goes on";
}

TEST(IgtlParser, MessageAboveItsLimitIsLeftOut)
{
  const Bytes pose = Pose("Stylus", Vector3::Ones());
  const std::size_t body = pose.size() - IGTL_HEADER_SIZE;
  IgtlParser enough({{"TRANSFORM", body}});
  ASSERT_TRUE(enough.Take(pose.data(), pose.size()));
  EXPECT_TRUE(enough.Next().has_value());
  IgtlParser tooFew({{"TRANSFORM", body - 1}});
  ASSERT_TRUE(tooFew.Take(pose.data(), pose.size()));
  EXPECT_FALSE(tooFew.Next().has_value());
  EXPECT_EQ(tooFew.Damaged(), 0U);
}

TEST(IgtlPoses, LengthThatIsOnlyClaimedTakesNoMemory)
{
  Bytes huge = Pose("Stylus", Vector3::Ones());
  std::fill(huge.begin() + 42, huge.begin() + 50, std::uint8_t{0x7F}); // the body's size
  IgtlPoses poses;
  for (int i = 0; i < 1000; ++i)
  {
    ASSERT_TRUE(Take(poses, huge)); // all of it belongs to the first one's body
  }
  EXPECT_EQ(poses.Newest(), nullptr);
}

TEST(IgtlPoses, PoseOfAnotherLengthIsDamaged)
{
  const Bytes pose = Pose("Stylus", Vector3::Ones());
  const Bytes body(pose.begin() + IGTL_HEADER_SIZE, pose.end());
  Bytes longer = body;
  longer.resize(body.size() + 4);
  const Bytes shorter(body.begin(), body.end() - 4);
  IgtlPoses poses;
  ASSERT_TRUE(Take(poses, WithBody(pose, longer)));
  ASSERT_TRUE(Take(poses, WithBody(pose, shorter)));
  EXPECT_EQ(poses.Newest(), nullptr);
  EXPECT_EQ(poses.Refused(), 2U);
  ASSERT_TRUE(Take(poses, WithBody(pose, body)));
  EXPECT_NE(poses.Newest(), nullptr);
}

TEST(IgtlPoses, MetadataLongerThanTheirMessageAreDamaged)
{
  IgtlPoses poses;
  ASSERT_TRUE(Take(poses, WithMetadata(Pose("Stylus", Vector3::Ones()), 200)));
  EXPECT_EQ(poses.Newest(), nullptr);
  EXPECT_EQ(poses.Refused(), 1U);
}

TEST(IgtlPoses, NewerHeadersAndMetadataAreUnderstood)
{
  IgtlPoses poses;
  ASSERT_TRUE(Take(poses, WithMetadata(Pose("Stylus", Vector3(1.0, 2.0, 3.0)), 6)));
  const IgtlPose* found = poses.Newest();
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(Vector3(found->Position), Vector3(1.0, 2.0, 3.0));
}

TEST(IgtlPoses, OtherProtocolsAreRecognised)
{
  const std::string web = "GET / HTTP/1.1\r\nHost: localhost\r\nUser-Agent: a browser\r\n\r\n....";
  IgtlPoses poses;
  EXPECT_FALSE(poses.Take(reinterpret_cast<const std::uint8_t*>(web.data()), web.size()));
}

TEST(IgtlPoses, NoiseNeitherCrashesNorIsAPose)
{
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 2000; ++trial)
  {
    Bytes bytes = Pose("Stylus", Vector3::Ones());
    for (int i = 0; i < 4; ++i)
    {
      bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1 + random() % 255);
    }
    IgtlPoses poses("Stylus");
    if (Take(poses, bytes) && poses.Newest() != nullptr)
    {
      // Time stamps and bytes after the name are not covered by the CRC.
      EXPECT_EQ(poses.Refused(), 0U);
    }
  }
}

TEST(IgtlForceMessage, ProtocolsOwnLibraryReadsIt)
{
  const Bytes bytes = IgtlForceMessage("Force", Vector3(0.5, -1.25, 3.0));
  igtl::MessageHeader::Pointer header = igtl::MessageHeader::New();
  header->InitPack();
  std::copy_n(bytes.begin(), IGTL_HEADER_SIZE,
              static_cast<std::uint8_t*>(header->GetPackPointer()));
  header->Unpack();
  EXPECT_STREQ(header->GetDeviceName(), "Force");
  igtl::SensorMessage::Pointer sensor = igtl::SensorMessage::New();
  sensor->SetMessageHeader(header);
  sensor->AllocatePack();
  std::copy(bytes.begin() + IGTL_HEADER_SIZE, bytes.end(),
            static_cast<std::uint8_t*>(sensor->GetPackBodyPointer()));
  ASSERT_NE(sensor->Unpack(1) & igtl::MessageHeader::UNPACK_BODY, 0);
  ASSERT_EQ(sensor->GetLength(), 3U);
  EXPECT_EQ(sensor->GetValue(0), 0.5);
  EXPECT_EQ(sensor->GetValue(1), -1.25);
  EXPECT_EQ(sensor->GetValue(2), 3.0);
}

TEST(IgtlPoses, CountsForcesThatThePeerHasRead)
{
  IgtlPoses poses;
  for (const char* name : {"Force", "Tracker", "Force"})
  {
    const igtl::StatusMessage::Pointer message = igtl::StatusMessage::New();
    message->SetDeviceName(name);
    message->Pack();
    ASSERT_TRUE(Take(poses, BytesOf(message.GetPointer())));
  }
  EXPECT_EQ(poses.ForcesRead(), 2U);
  EXPECT_EQ(poses.Newest(), nullptr);
  EXPECT_EQ(poses.Refused(), 0U);
}
} // namespace
} // namespace palpate::igtl_poses_test
