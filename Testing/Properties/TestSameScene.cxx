// Window and command line create the same scene from the same settings.
#include "InputError.h"
#include "SceneContacts.h"
#include "Servo.h"
#include "SimulatedDevice.h"
#include "StudyCases.h"
#include "StudyDrill.h"
#include "StudyPhantoms.h"
#include "TouchDoubles.h"
#include "TouchRun.h"
#include "WorkspaceFrame.h"

#include "ManualClock.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
using test::Random;
using test::RandomChoice;
using test::RandomNumber;
using test::RandomWhole;

constexpr int Cases = 24;

// One structure's settings for both.
struct Wanted
{
  SceneStructure Window;
  SceneStructure CommandLine;
};

std::string RandomRepresentation(Random& random, int label)
{
  // The second structure of the phantom is not star-shaped.
  const int most = label == 1 ? 3 : 2;
  constexpr std::array<const char*, 3> All{
      TouchRepresentation::SubVoxel, TouchRepresentation::Facets, TouchRepresentation::Harmonics};
  return All.at(static_cast<std::size_t>(RandomWhole(random, 0, most - 1)));
}

Wanted RandomWanted(Random& random, int label)
{
  Wanted both;
  SceneStructure& window = both.Window;
  window.Id = label;
  window.Labels = {std::to_string(label)};
  window.Name = "structure " + std::to_string(label);
  window.IsVisible = RandomChoice(random);
  window.IsTouchable = label == 1 || RandomChoice(random);
  window.Representation = RandomRepresentation(random, label);
  window.Degree = RandomWhole(random, 2, 9);
  window.Interpolation = static_cast<FieldInterpolation>(RandomWhole(random, 0, 1));
  window.Smoothing = RandomNumber(random, 0.0, 1.5);
  window.Mode = static_cast<HarmonicContactMode>(RandomWhole(random, 0, 1));
  window.Damping = RandomNumber(random, 0.0, 0.002);
  window.SetNumber("viscosity_ns_per_mm", RandomNumber(random, 0.0, 0.002));
  window.Stiffness = RandomNumber(random, 0.1, 1.5);
  const double friction = RandomNumber(random, 0.0, 0.5);
  window.Friction = {friction + RandomNumber(random, 0.0, 0.5), friction};
  window.IsForbidden = label == 2 && RandomWhole(random, 0, 3) == 0;
  if (window.Mode == HarmonicContactMode::Radial)
  {
    window.Friction = {}; // the radial method has none
  }
  window.AlarmDistance = RandomNumber(random, 0.5, 4.0);
  if (RandomWhole(random, 0, 2) == 0)
  {
    window.Drill = {RandomNumber(random, 0.01, 1.0), RandomNumber(random, 0.0, 0.001),
                    RandomNumber(random, 0.0, 0.3)};
  }
  both.CommandLine = window;
  both.CommandLine.Id = 0;
  return both;
}

// Harmonics and facets support spheres only.
TouchToolSettings RandomTool(Random& random, bool isSphere)
{
  TouchToolSettings tool;
  tool.Kind = static_cast<TouchToolSettings::Shape>(isSphere ? 0 : RandomWhole(random, 0, 2));
  tool.Radius = RandomNumber(random, 0.5, 3.0);
  tool.Length = RandomNumber(random, 2.0, 10.0);
  tool.SemiAxes = {RandomNumber(random, 1.0, 4.0), RandomNumber(random, 1.0, 4.0), 2.0};
  return tool;
}

// The settings of one case, for both.
struct SceneCase
{
  SceneCase(const test::StudyPhantom& phantom, Random& random)
  {
    this->Window = phantom.State();
    this->Window.Structures.clear();
    this->Window.Fit = {};
    this->CommandLine.Drill.Turns = this->Window.Drill.Turns = RandomNumber(random, 100.0, 900.0);
    for (const int label : {1, 2})
    {
      Wanted both = RandomWanted(random, label);
      both.CommandLine.File = this->Window.SegmentationFile;
      both.Window.File = both.CommandLine.File;
      this->Window.Structures.push_back(both.Window);
      this->CommandLine.Structures.push_back(both.CommandLine);
    }
    const auto& all = this->Window.Structures;
    const bool isSphere = std::any_of(
        all.begin(), all.end(),
        [](const SceneStructure& s) { return s.Representation != TouchRepresentation::SubVoxel; });
    this->CommandLine.Tool = this->Window.Tool = RandomTool(random, isSphere);
  }

  StudyState Window;
  SceneSettings CommandLine;
};

// Result for a case: a scene, or the reason why there is none.
struct Outcome
{
  std::shared_ptr<const TouchScene> Scene;
  std::string Refusal;
};

Outcome CommandLineScene(const SceneSettings& settings)
{
  try
  {
    TouchScript script;
    script.Path = HandPath({{0.0, Vector3::Zero()}, {1.0, Vector3::Zero()}});
    const PreparedTouch touch =
        PrepareTouch(settings, script, [](double, const std::string&) { return true; });
    return {touch.Scene, {}};
  }
  catch (const InputError& error)
  {
    return {nullptr, error.what()};
  }
}

// With the initial frame of a session.
Outcome WindowScene(const StudyState& state)
{
  StudyJobs jobs;
  StudyPipeline pipeline(jobs);
  pipeline.Update(state);
  test::Settle(jobs);
  const std::vector<SceneContact> contacts = test::ContactsIn(state, pipeline);
  const auto touchable = std::count_if(state.Structures.begin(), state.Structures.end(),
                                       [](const SceneStructure& s) { return s.IsTouchable; });
  if (static_cast<std::ptrdiff_t>(contacts.size()) != touchable)
  {
    return {nullptr, "a structure has no contact"};
  }
  auto scene = std::make_shared<TouchScene>(MakeTouchScene(state, contacts, {}));
  StudyDrill drill;
  drill.Follow(state, contacts, ForbiddenOf(state, pipeline));
  drill.PutInto(*scene);
  ManualClock clock;
  const SimulatedDevice device(clock, {});
  scene->Frame = WorkspaceFrame::Around(*scene, device.Capabilities()).ForDevice();
  return {scene, {}};
}

// A hand that moves through the whole scene, from outside; mm in the device.
Vector3 HandAt(double time)
{
  return {24.0 * std::cos(7.0 * time), 18.0 * std::sin(5.0 * time + 0.3),
          10.0 * std::cos(3.0 * time)};
}

std::vector<TouchState> TicksOf(const std::shared_ptr<const TouchScene>& scene)
{
  test::ScriptedDevice device;
  Servo servo(device, ServoSettings());
  EXPECT_TRUE(servo.Publish(scene).IsOk());
  std::vector<TouchState> ticks;
  for (std::uint64_t n = 0; n < 2000; ++n)
  {
    TickInfo tick;
    tick.Number = n;
    tick.Started = static_cast<std::int64_t>(n) * 1'000'000;
    device.Next.Position = HandAt(0.001 * static_cast<double>(n));
    device.Next.Time = tick.Started;
    servo.Tick(tick);
    ticks.push_back(servo.Latest());
  }
  return ticks;
}

void ExpectSameBits(double a, double b, const char* what)
{
  EXPECT_EQ(std::memcmp(&a, &b, sizeof(a)), 0) << what << ": " << a << " and " << b;
}

void ExpectSameStructure(const TouchStructure& a, const TouchStructure& b)
{
  EXPECT_EQ(a.Name, b.Name);
  ExpectSameBits(a.Law.Stiffness, b.Law.Stiffness, "stiffness");
  ExpectSameBits(a.Law.Damping, b.Law.Damping, "damping");
  ExpectSameBits(a.Friction.Static, b.Friction.Static, "static friction");
  ExpectSameBits(a.Friction.Dynamic, b.Friction.Dynamic, "dynamic friction");
  ASSERT_EQ(a.Effects.size(), b.Effects.size());
  for (std::size_t n = 0; n < a.Effects.size(); ++n)
  {
    ExpectSameBits(a.Effects[n]->Damping(), b.Effects[n]->Damping(), "damping of an effect");
  }
  ExpectSameBits(a.Drill.Wear, b.Drill.Wear, "wear");
  ExpectSameBits(a.Drill.Drag, b.Drill.Drag, "drag");
  ExpectSameBits(a.Drill.Vibration, b.Drill.Vibration, "vibration");
  EXPECT_EQ(a.Site, b.Site);
}

// Expects equal forces, some of them not zero.
std::uint64_t ExpectSameTicks(const TouchScene& a, const TouchScene& b)
{
  const std::vector<TouchState> one = TicksOf(std::make_shared<TouchScene>(a));
  const std::vector<TouchState> other = TicksOf(std::make_shared<TouchScene>(b));
  std::uint64_t touching = 0;
  for (std::size_t n = 0; n < one.size(); ++n)
  {
    const bool isSame =
        std::memcmp(&one[n].ForceDevice, &other[n].ForceDevice, sizeof(PlainVector3)) == 0 &&
        std::memcmp(&one[n].ProxyWorld, &other[n].ProxyWorld, sizeof(PlainVector3)) == 0 &&
        one[n].Structure == other[n].Structure && one[n].Depth == other[n].Depth;
    EXPECT_TRUE(isSame) << "tick " << n << ": " << one[n].Depth << " and " << other[n].Depth;
    if (!isSame)
    {
      break;
    }
    touching += one[n].Structure >= 0 ? 1 : 0;
  }
  return touching;
}

TEST(SameScene, WindowAndCommandLineGiveEqualBits)
{
  const test::StudyPhantom phantom;
  Random random(2026);
  std::uint64_t touching = 0;
  int scenes = 0;
  for (int n = 0; n < Cases; ++n)
  {
    const SceneCase both(phantom, random);
    const Outcome line = CommandLineScene(both.CommandLine);
    const Outcome window = WindowScene(both.Window);
    SCOPED_TRACE("case " + std::to_string(n));
    ASSERT_EQ(line.Scene != nullptr, window.Scene != nullptr)
        << line.Refusal << " | " << window.Refusal;
    if (line.Scene == nullptr)
    {
      continue;
    }
    ++scenes;
    ASSERT_EQ(line.Scene->Structures.size(), window.Scene->Structures.size());
    for (std::size_t s = 0; s < line.Scene->Structures.size(); ++s)
    {
      ExpectSameStructure(line.Scene->Structures[s], window.Scene->Structures[s]);
    }
    EXPECT_EQ(line.Scene->Drill.Link != nullptr, window.Scene->Drill.Link != nullptr);
    ExpectSameBits(line.Scene->Drill.Motion.Turns, window.Scene->Drill.Motion.Turns, "turns");
    ExpectSameBits(line.Scene->Drill.Motion.Radius, window.Scene->Drill.Motion.Radius, "radius");
    touching += ExpectSameTicks(*line.Scene, *window.Scene);
  }
  EXPECT_GT(scenes, Cases / 2);
  EXPECT_GT(touching, 100U * static_cast<std::uint64_t>(scenes));
}
} // namespace
} // namespace palpate
