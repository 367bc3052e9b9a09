// An organ that is held, let go and matched.
#include "HeldOrgan.h"
#include "ManualClock.h"
#include "MeshShapes.h"
#include "OpenBuiltInDevice.h"
#include "PacedClock.h"
#include "StudyMatch.h"
#include "StudyPhantoms.h"
#include "TouchRecording.h"
#include "TransformFile.h"

#include <gtest/gtest.h>
#include <thread>

namespace palpate::study_matching_test
{
namespace
{
using Phase = HeldOrgan::Phase;

IndexedMesh Ellipsoid(const Eigen::Affine3d& map)
{
  IndexedMesh mesh = test::Sphere(12);
  for (Vector3& point : mesh.Points)
  {
    point = map * point.cwiseProduct(Vector3(25.0, 20.0, 16.0));
  }
  return mesh;
}

// 7 mm and 9 degrees off.
Eigen::Affine3d Off()
{
  return Eigen::Translation3d(2.0, -6.0, 3.0) *
         Eigen::AngleAxisd(0.16, Vector3(1.0, -1.0, 2.0).normalized()) *
         Eigen::Affine3d::Identity();
}

class HeldOrganTest : public testing::Test
{
protected:
  void Take(const Eigen::Affine3d& off = Off())
  {
    const Status status = this->Organ.Take(Ellipsoid(off), Ellipsoid(Eigen::Affine3d::Identity()));
    ASSERT_TRUE(status.IsOk()) << status.Message();
  }
  void Arrive()
  {
    test::Settle(this->Jobs);
    for (int frame = 0; this->Organ.Is() == Phase::Moving; ++frame)
    {
      this->Organ.Advance(5.0 + frame / 60.0);
    }
  }
  // How far the organ's points are from where they belong, at most.
  double Error(const Eigen::Affine3d& off = Off()) const
  {
    double largest = 0.0;
    for (const Vector3& point : Ellipsoid(Eigen::Affine3d::Identity()).Points)
    {
      largest = std::max(largest, (this->Organ.Pose() * (off * point) - point).norm());
    }
    return largest;
  }

  StudyJobs Jobs;
  HeldOrgan Organ{this->Jobs};
};

TEST_F(HeldOrganTest, ReleaseBringsItOntoTheOther)
{
  this->Take();
  EXPECT_GT(this->Error(), 5.0);
  this->Organ.Point();
  this->Organ.Move({-1.0, 3.0, -2.0});
  this->Organ.Release();
  EXPECT_EQ(this->Organ.Is(), Phase::Matching);
  this->Arrive();
  EXPECT_EQ(this->Organ.Is(), Phase::Lying);
  ASSERT_TRUE(this->Organ.Match());
  EXPECT_TRUE(this->Organ.Match()->HasConverged);
  EXPECT_LT(this->Error(), 0.1); // facets of 2 mm
  EXPECT_LT(this->Organ.Match()->Error.Shift, 0.1);
}

TEST_F(HeldOrganTest, SizeMayChangeToo)
{
  const Eigen::Affine3d larger = Off() * Eigen::Scaling(1.05);
  this->Take(larger);
  this->Organ.Point();
  this->Organ.SetRules({true, true, true});
  this->Organ.Release();
  this->Arrive();
  EXPECT_LT(this->Error(larger), 0.1);
  EXPECT_NEAR(std::cbrt(this->Organ.Pose().linear().determinant()), 1.0 / 1.05, 1e-3);
  this->Organ.PutBack();
  EXPECT_EQ(this->Organ.Pose().matrix(), Eigen::Matrix4d::Identity());
  EXPECT_FALSE(this->Organ.Match());
}

TEST_F(HeldOrganTest, GoesToItsMatchWithoutAJump)
{
  this->Take();
  this->Organ.Point();
  this->Organ.Release();
  test::Settle(this->Jobs);
  ASSERT_EQ(this->Organ.Is(), Phase::Moving);
  EXPECT_EQ(this->Organ.Pose().matrix(), Eigen::Matrix4d::Identity());
  Vector3 before = this->Organ.Middle();
  const double way = (this->Organ.Match()->Map * before - before).norm();
  this->Organ.Advance(100.0); // any time
  EXPECT_EQ(this->Organ.Middle(), before);
  for (int tick = 1; tick <= 700; ++tick)
  {
    this->Organ.Advance(100.0 + 0.001 * tick);
    const double step = (this->Organ.Middle() - before).norm();
    EXPECT_LE(step, 1.5 * way * 0.001 / HeldOrgan::RampTime + 1e-9);
    before = this->Organ.Middle();
  }
  EXPECT_EQ(this->Organ.Is(), Phase::Lying);
}

TEST_F(HeldOrganTest, PointedOrganStaysBehindTheHand)
{
  this->Take(Eigen::Affine3d::Identity());
  this->Organ.Point();
  this->Organ.Move({0.0, 0.0, 4.0});
  EXPECT_TRUE(this->Organ.Advance(0.0));
  const double way = this->Organ.Middle().z();
  EXPECT_GT(way, 0.5);
  EXPECT_LT(way, 3.5) << "it resists where it fits";
  this->Organ.Turn({0.0, 0.2, 0.0});
  EXPECT_NEAR(this->Organ.Middle().z(), way, 1e-9);
}

TEST_F(HeldOrganTest, ByItsRulesStaysWhereItIsLetGoAndIsNotFelt)
{
  this->Organ.SetRules({false, false, false});
  this->Take(Eigen::Affine3d::Identity());
  this->Organ.Point();
  this->Organ.Move({0.0, 0.0, 4.0});
  EXPECT_TRUE(this->Organ.Advance(0.0));
  EXPECT_EQ(this->Organ.Pose().translation(), Vector3(0.0, 0.0, 4.0)) << "nothing resists";
  this->Organ.Release();
  EXPECT_EQ(this->Organ.Is(), Phase::Lying);
  test::Settle(this->Jobs);
  EXPECT_FALSE(this->Organ.Match());
  EXPECT_EQ(this->Organ.Pose().translation(), Vector3(0.0, 0.0, 4.0));
}

TEST_F(HeldOrganTest, FieldIsWhatTheHeldOrganFeels)
{
  this->Take();
  const Vector3 tool(100.0, 5.0, -7.0); // anywhere
  this->Organ.Carry(tool);
  ASSERT_NE(this->Organ.Field(), nullptr);
  EXPECT_EQ(this->Organ.Field()->ForceWorld(tool), this->Organ.Felt().Force);
  const Vector3 motion(1.0, 2.0, -1.0);
  const Vector3 force = this->Organ.Field()->ForceWorld(tool + motion);
  this->Organ.FollowTool(tool + motion);
  EXPECT_EQ(this->Organ.Felt().Force, force);
  this->Organ.Turn({0.1, 0.0, 0.0});
  EXPECT_LT((this->Organ.Field()->ForceWorld(tool + motion) - this->Organ.Felt().Force).norm(),
            1e-12);
  const Eigen::AlignedBox3d box = this->Organ.Field()->BoundsWorld();
  for (int axis = 0; axis < 3; ++axis)
  {
    Vector3 outside = box.center();
    outside[axis] = box.max()[axis] + 1e-6;
    EXPECT_EQ(this->Organ.Field()->ForceWorld(outside), Vector3::Zero());
  }
}

TEST_F(HeldOrganTest, NothingIsHeldWithoutAnOrgan)
{
  this->Organ.Point();
  this->Organ.Carry(Vector3::Zero());
  this->Organ.Release();
  EXPECT_EQ(this->Organ.Is(), Phase::Absent);
  EXPECT_FALSE(this->Organ.Take({}, Ellipsoid(Eigen::Affine3d::Identity())).IsOk());
  EXPECT_EQ(this->Organ.Is(), Phase::Absent);
  this->Take();
  this->Organ.Point();
  this->Organ.Release(); // whose job is cancelled
  this->Organ.Leave();
  test::Settle(this->Jobs);
  EXPECT_EQ(this->Organ.Is(), Phase::Absent);
}

// What the hand of a device feels from the grasp to the match, tick by tick.
TEST(StudyHold, ForceOfAHeldOrganComesAndGoesWithoutAJump)
{
  test::PacedClock clock;
  RealtimeRequest ordinary;
  ordinary.Priority = 0;
  StudyTouch touch(clock, ordinary);
  StudyJobs jobs;
  HeldOrgan organ(jobs);
  ASSERT_TRUE(organ.Take(Ellipsoid(Off()), Ellipsoid(Eigen::Affine3d::Identity())).IsOk());
  StudyState state;
  state.Structures = {test::StudyPhantom::Structure(7, TouchRepresentation::Harmonics)};
  state.Tool.Radius = 0.0;
  const RadialModel ball(0, {20.0 * std::sqrt(4.0 * M_PI)}, Vector3(0.0, 0.0, 80.0));
  const std::vector<SceneContact> contacts{
      {7, std::make_shared<const TouchContact>(
              MakeModelContact(ball, RadialContactMode::Nearest, "ball"))}};
  std::unique_ptr<HapticDevice> device;
  ASSERT_TRUE(OpenBuiltInDevice("simulated", clock, device).IsOk());
  ASSERT_TRUE(touch.Start(std::move(device), state, contacts).IsOk());
  const test::TemporaryFolder folder;
  ASSERT_TRUE(touch.StartRecording(folder / "hold.touch").IsOk());
  const auto pass = [&](std::uint64_t ticks)
  {
    const std::uint64_t last = touch.Poll().Newest.Tick.Number + ticks;
    while (touch.Poll().Newest.Tick.Number < last)
    {
      std::this_thread::yield();
    }
  };
  pass(400);
  organ.Carry(Vector3(touch.Poll().Newest.ProbeWorld));
  touch.Hold(organ.Field());
  ASSERT_TRUE(touch.Update(state, contacts).IsOk());
  pass(500);
  const double held = Vector3(touch.Poll().Newest.ForceWorld).norm();
  EXPECT_GT(held, 0.2) << "it does not fit";
  touch.Hold(nullptr);
  ASSERT_TRUE(touch.Update(state, contacts).IsOk());
  pass(500);
  EXPECT_LT(Vector3(touch.Poll().Newest.ForceWorld).norm(), 0.05);
  touch.Stop();
  TouchRecording recording;
  ASSERT_TRUE(ReadTouchRecording((folder / "hold.touch").string(), recording).IsOk());
  double largest = 0.0;
  for (std::size_t tick = 1; tick < recording.Ticks.size(); ++tick)
  {
    largest = std::max(largest, (Vector3(recording.Ticks[tick].ForceDevice) -
                                 Vector3(recording.Ticks[tick - 1].ForceDevice))
                                    .norm());
  }
  EXPECT_LT(largest, 0.05); // N a tick; it fades within a tenth of a second
}

// The phantom's volume over itself, and two structures of the same files.
class StudyMatchTest : public testing::Test
{
protected:
  void SetUp() override
  {
    this->State.VolumeFile = this->Phantom.Folder / "volume.nii.gz";
    StudyVolume further;
    further.Id = 3;
    further.File = this->Phantom.Folder / "volume.nii.gz";
    this->State.Volumes = {further};
    for (int id = 1; id <= 3; ++id)
    {
      this->State.Structures.push_back(test::StudyPhantom::Structure(
          id, TouchRepresentation::Automatic,
          this->Phantom.Folder / (id == 3 ? "other.nii.gz" : "mask.nii.gz")));
    }
  }

  const Eigen::Affine3d Map = Off();
  test::StudyPhantom Phantom;
  StudyState State;
  const MatchChoice Choice{1, 3, 3};
};

TEST_F(StudyMatchTest, MovesTheOrganItsFilesStructuresAndTheVolume)
{
  for (const char* name : {"a.tfm", "a.lta", "a.xfm", "a.mat"})
  {
    const auto file = this->Phantom.Folder / name;
    const StudyState next = WriteMatch(this->State, this->Choice, this->Map, file);
    EXPECT_EQ(next.Volumes[0].Transform, file);
    EXPECT_EQ(next.Structures[0].Move.File, file);
    EXPECT_EQ(next.Structures[1].Move.File, file) << "of the same segmentation";
    EXPECT_FALSE(next.Structures[2].Move.IsSet());
    EXPECT_TRUE(
        ReadMove(next.Structures[0].Move, next.Structures[0].File).isApprox(this->Map, 1e-5))
        << name;
    const StudyState back = WithTransform(next, this->Choice.VolumeId, {});
    EXPECT_EQ(back, this->State) << "the organ returns with the volume";
  }
}

TEST_F(StudyMatchTest, SecondMatchContinuesTheFirst)
{
  const auto first = this->Phantom.Folder / "first.tfm";
  const auto second = this->Phantom.Folder / "second.tfm";
  StudyState next = WriteMatch(this->State, this->Choice, this->Map, first);
  next = WriteMatch(next, this->Choice, this->Map, second);
  EXPECT_TRUE(ReadTransform(second).isApprox(this->Map * this->Map, 1e-6));
  next.Volumes[0].Transform.clear();
  EXPECT_THROW(WriteMatch(next, this->Choice, this->Map, this->Phantom.Folder / "third.tfm"),
               InputError);
}

TEST_F(StudyMatchTest, RefusesWhatItCannotWrite)
{
  EXPECT_THROW(WriteMatch(this->State, {9, 3, 0}, this->Map, this->Phantom.Folder / "a.tfm"),
               InputError);
  EXPECT_THROW(WriteMatch(this->State, this->Choice, this->Map, this->Phantom.Folder / "a.json"),
               InputError);
  this->State.Structures[0].File = this->Phantom.Folder / "organ.json";
  EXPECT_THROW(WriteMatch(this->State, this->Choice, this->Map, this->Phantom.Folder / "a.mat"),
               InputError);
  EXPECT_NO_THROW(WriteMatch(this->State, this->Choice, this->Map, this->Phantom.Folder / "a.tfm"));
}
} // namespace
} // namespace palpate::study_matching_test
