// Structures that guide the tool, in a study: distances, touch, session and undo.
#include "ManualClock.h"
#include "Study.h"
#include "StudyPhantoms.h"
#include "StudyStructures.h"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace palpate::study_guide_test
{
namespace
{
using Kind = StudyStepState::Kind;

RealtimeRequest Ordinary()
{
  RealtimeRequest request;
  request.Priority = 0;
  return request;
}

// The sphere of label 1 is touched; label 2 is neither seen nor touched.
class StudyGuide : public testing::Test
{
protected:
  void SetUp() override
  {
    StudyState state = this->Phantom.State();
    SceneStructure bow =
        this->Phantom.Structure(2, TouchRepresentation::Automatic, state.SegmentationFile);
    bow.IsVisible = bow.IsTouchable = false;
    state.Structures.push_back(bow);
    state.Structures.front().Representation = TouchRepresentation::Facets;
    this->Open.Change("start", state);
    this->Settle();
  }
  void Settle()
  {
    while (this->Open.Jobs().WaitForResult())
    {
      this->Open.Deliver();
    }
  }
  void GuideBy(int id, double distance = 0.0)
  {
    StudyState next = this->Open.State();
    GuideSettings guide;
    guide.Shape = GuideShape::Surface;
    guide.Structure = id;
    guide.Distance = distance;
    next.Guides = {guide};
    this->Open.Change("guide", next);
    this->Settle();
  }
  std::size_t PublishedFields() { return this->Published().size(); }
  std::vector<std::shared_ptr<const ForceField>> Published()
  {
    const auto products = [this](SceneStep step, int id)
    { return this->Open.Pipeline().NewestProduct(step, id); };
    return MakeTouchScene(this->Open.State(), this->Open.Contacts(), {},
                          GuideDistancesOf(this->Open.State(), products))
        .Fields;
  }

  test::StudyPhantom Phantom;
  ManualClock Time;
  Study Open{this->Time, Ordinary()};
};

TEST_F(StudyGuide, DistancesAreMadeThoughNeitherVisibleNorTouchable)
{
  EXPECT_EQ(this->Open.Pipeline().StateOf(SceneStep::Guide, 2).Is, Kind::NotWanted);
  this->GuideBy(2);
  const StudyStepState state = this->Open.Pipeline().StateOf(SceneStep::Guide, 2);
  EXPECT_EQ(state.Is, Kind::UpToDate) << state.Message;
  ASSERT_EQ(this->PublishedFields(), 1U);
  // Beside the ring, whose surface is 3 mm from its centre line.
  const Vector3 force = this->Published().front()->ForceWorld({5.0, 0.0, 6.0});
  EXPECT_LT(force.z(), -0.2);
  EXPECT_NEAR(force.x(), 0.0, 0.05);
  this->Open.Undo();
  EXPECT_EQ(this->PublishedFields(), 0U);
}

TEST_F(StudyGuide, OtherStiffnessNeedsNoNewDistances)
{
  this->GuideBy(1, 2.0);
  const auto before = this->Open.Pipeline().Newest<StructureDistance>(SceneStep::Guide, 1);
  ASSERT_NE(before, nullptr);
  StudyState next = this->Open.State();
  next.Guides[0].Stiffness = 0.7;
  next.Guides[0].Distance = 1.0;
  next.Guides[0].Range = 13.0;
  this->Open.Change("guide", next);
  this->Settle();
  EXPECT_EQ(this->Open.Pipeline().Newest<StructureDistance>(SceneStep::Guide, 1), before);
  EXPECT_EQ(this->PublishedFields(), 1U);
}

TEST_F(StudyGuide, FormerDistancesAreNotUsedBeyondTheirReach)
{
  this->GuideBy(1);
  StudyState next = this->Open.State();
  next.Guides[0].Distance = 30.0;
  this->Open.Change("guide", next);
  EXPECT_EQ(this->PublishedFields(), 0U) << "while the new ones are made";
  this->Settle();
  EXPECT_EQ(this->PublishedFields(), 1U);
}

// The hand floats in free space, 2 mm outside of the sphere, while the guide comes and goes.
TEST_F(StudyGuide, GuideComesAndGoesWhileTouching)
{
  this->Open.StartTouch();
  this->Settle();
  ASSERT_TRUE(this->Open.Touch().IsRunning()) << this->Open.TouchProblem();
  const auto waitForForce = [this](bool isGuided)
  {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    bool isThere = false;
    while (!isThere && std::chrono::steady_clock::now() < end)
    {
      this->Open.Touch().MoveHand(Vector3(-15.0, 0.0, 14.0));
      const TouchState& now = this->Open.Touch().Poll().Newest;
      const double height = now.ProbeWorld.Z;
      const PlainVector3& force = now.ForceDevice;
      const double size = std::hypot(force.X, force.Y, force.Z);
      isThere = height > 11.0 && (isGuided ? size > 0.1 : size == 0.0);
      std::this_thread::yield();
    }
    EXPECT_TRUE(isThere) << (isGuided ? "with" : "without") << " guide";
  };
  waitForForce(false);
  this->GuideBy(1);
  waitForForce(true);
  this->Open.Undo();
  waitForForce(false);
  EXPECT_TRUE(this->Open.Touch().IsRunning());
}

TEST_F(StudyGuide, SessionsKeepGuidesByStructures)
{
  this->GuideBy(2, -1.5);
  const auto file = this->Phantom.Folder / "guided.palpate.json";
  this->Open.Save(file);
  const StudyState saved = this->Open.State();
  Study again(this->Time, Ordinary());
  again.Open(file);
  while (again.Jobs().WaitForResult())
  {
    again.Deliver();
  }
  EXPECT_EQ(again.State().Guides, saved.Guides);
  EXPECT_NE(again.Pipeline().Newest<StructureDistance>(SceneStep::Guide, 2), nullptr);
}

// A scene is added to a study in which its ids are taken.
TEST_F(StudyGuide, AddedScenesKeepTheirGuides)
{
  SceneSettings scene;
  SceneStructure other =
      this->Phantom.Structure(3, TouchRepresentation::Facets, this->Open.State().SegmentationFile);
  other.Id = 1;
  scene.Structures = {other};
  GuideSettings guide;
  guide.Shape = GuideShape::Inside;
  guide.Structure = 1;
  scene.Guides = {guide};
  const StudyState joined = WithScene(this->Open.State(), scene);
  ASSERT_EQ(joined.Structures.size(), 3U);
  EXPECT_NE(joined.Structures.back().Id, 1);
  EXPECT_EQ(joined.Guides.at(0).Structure, joined.Structures.back().Id);
  guide.Structure = 77;
  scene.Guides = {guide};
  EXPECT_TRUE(WithScene(this->Open.State(), scene).Guides.empty()) << "of no structure";
}
} // namespace
} // namespace palpate::study_guide_test
