#include "TouchCues.h"

#include <gtest/gtest.h>

#include <cmath>

namespace palpate::touch_cues_test
{
namespace
{
class TouchCuesTest : public testing::Test
{
protected:
  /// Ticks of 1 ms while the tool moves along x with a speed (mm/s), with a force (N) at each.
  template <typename Force>
  const TouchCue& Feel(int count, double speed, const Force& force)
  {
    for (int n = 0; n < count; ++n)
    {
      this->State.Tick.Started += 1'000'000;
      this->State.ProbeWorld.X += 0.001 * speed;
      const double now = force(0.001 * n);
      this->State.ForceDevice = Vector3(0.0, 0.0, now);
      this->State.Structure = now > 0.0 ? 0 : -1;
      this->State.Depth = now > 0.0 ? 0.5 * now : 0.0;
      this->Cues.Update(this->State);
    }
    return this->Cues.Newest();
  }

  TouchCues Cues;
  TouchState State;
};

TEST_F(TouchCuesTest, FreeToolTellsNothing)
{
  const TouchCue& cue = this->Feel(500, 100.0, [](double) { return 0.0; });
  EXPECT_EQ(cue.Push, 0.0);
  EXPECT_EQ(cue.Texture, 0.0);
  EXPECT_EQ(cue.Knock, 0.0);
}

TEST_F(TouchCuesTest, SteadyForceIsPushAloneAndItsHardness)
{
  const TouchCue& cue = this->Feel(1000, 20.0, [](double) { return 2.5; });
  EXPECT_NEAR(cue.Push, 0.5, 1e-12);
  EXPECT_LT(cue.Texture, 1e-6);
  EXPECT_LT(cue.Knock, 1e-6);
  EXPECT_NEAR(cue.Hardness, 1.0, 1e-12) << "2 N/mm";
}

TEST_F(TouchCuesTest, TremblingForceIsTexture)
{
  const auto trembling = [](double amplitude)
  {
    return [amplitude](double time)
    { return 2.0 + amplitude * std::sin(2.0 * EIGEN_PI * 60.0 * time); };
  };
  const double little = this->Feel(1000, 20.0, trembling(0.05)).Texture;
  const double more = this->Feel(1000, 20.0, trembling(0.2)).Texture;
  // The mean of |sin| is 2 / pi; a filter of 20 ms passes it as it is.
  EXPECT_NEAR(little, 0.05 * 2.0 / EIGEN_PI / TouchCues::FullTremble, 0.02);
  EXPECT_NEAR(more, 4.0 * little, 0.1);
}

TEST_F(TouchCuesTest, FasterContactsKnockHarderAndFade)
{
  const auto knockAt = [&](double speed)
  {
    this->Feel(100, speed, [](double) { return 0.0; });
    return this->Feel(1, speed, [](double) { return 0.1; }).Knock;
  };
  EXPECT_NEAR(knockAt(30.0), 0.2, 1e-9);
  EXPECT_NEAR(knockAt(300.0), 1.0, 1e-9);
  EXPECT_LT(this->Feel(200, 0.0, [](double) { return 0.1; }).Knock, 0.01);
}

TEST_F(TouchCuesTest, NoForceAtTheDeviceIsSilenceAtOnce)
{
  this->Feel(300, 20.0, [](double time) { return 2.0 + std::sin(400.0 * time); });
  this->State.Tick.Started += 1'000'000;
  this->State.ForceDevice = {};
  const TouchCue& cue = this->Cues.Update(this->State); // still inside, after a fault
  EXPECT_EQ(cue.Push + cue.Texture + cue.Knock + cue.Hardness, 0.0);
}
} // namespace
} // namespace palpate::touch_cues_test
