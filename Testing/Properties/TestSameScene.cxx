// Window, command line, trade and interactor style create the same scene from the same settings.
#include "InputError.h"
#include "ModelFile.h"
#include "ModelSurface.h"
#include "ProofCount.h"
#include "SceneContacts.h"
#include "SceneFile.h"
#include "SceneRepresentation.h"
#include "Servo.h"
#include "SimulatedDevice.h"
#include "StructureTrade.h"
#include "Study.h"
#include "StudyCases.h"
#include "StudyDrill.h"
#include "StudyPhantoms.h"
#include "SurfaceFile.h"
#include "TouchDoubles.h"
#include "TouchRun.h"
#include "WholeFile.h"
#include "WorkspaceFrame.h"
#include "vtkInteractorStyleHaptic.h"

#include "ManualClock.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

namespace palpate::same_scene_test
{
namespace
{
using test::Random;
using test::RandomChoice;
using test::RandomNumber;
using test::RandomWhole;

const int Cases = test::ProofCount(16, 40);

// A phantom with a source of each kind, and an image for textures.
struct Sources
{
  explicit Sources(Random& random)
  {
    const RadialModel sphere(0, {6.0 * std::sqrt(4.0 * M_PI)}, Vector3(10.0, 9.0, 0.0));
    WriteModel(this->Model, {sphere, {}});
    WriteSurface(this->Surface, DrawModel(sphere, 3));
    test::LabelGrid grid;
    grid.Size = {{56, 40, 28}};
    grid.CenterOnOrigin();
    const auto image = test::MakeLabelImage<short>(
        grid, [](double, double, double) { return false; }, 0);
    auto* voxels = static_cast<short*>(image->GetScalarPointer());
    std::generate_n(voxels, image->GetNumberOfPoints(),
                    [&random] { return static_cast<short>(RandomWhole(random, 0, 500)); });
    WriteImage(this->Texture, image);
  }

  test::StudyPhantom Phantom;
  std::filesystem::path Model = this->Phantom.Folder / "ball.json";
  std::filesystem::path Surface = this->Phantom.Folder / "ball.stl";
  std::filesystem::path Texture = this->Phantom.Folder / "texture.nii.gz";
};

// The third structure may have any source.
void SetRandomSource(Random& random, const Sources& sources, SceneStructure& structure)
{
  const StudyState state = sources.Phantom.State();
  const int source = structure.Id < 3 ? 0 : RandomWhole(random, 1, 3);
  if (source == 0)
  {
    structure.File = state.SegmentationFile;
    structure.Labels = {std::to_string(structure.Id)};
  }
  else if (source == 1)
  {
    structure.File = state.VolumeFile;
    structure.Iso = RandomNumber(random, 100.0, 600.0);
  }
  else
  {
    structure.File = source == 2 ? sources.Model : sources.Surface;
  }
}

// One that its source has. No single harmonic surface fits the second label of the phantom.
std::string RandomRepresentation(Random& random, const SceneStructure& structure)
{
  std::vector<std::string> all;
  for (const SceneRepresentation& one : SceneRepresentations())
  {
    const auto& of = one.Sources;
    if (std::find(of.begin(), of.end(), structure.Source()) != of.end() &&
        (structure.Id != 2 || one.Name != TouchRepresentation::Harmonics))
    {
      all.push_back(one.Name);
    }
  }
  return all.at(static_cast<std::size_t>(RandomWhole(random, 0, static_cast<int>(all.size()) - 1)));
}

void SetRandomEffects(Random& random, const Sources& sources, SceneStructure& structure)
{
  if (RandomChoice(random))
  {
    structure.SetNumber("viscosity_ns_per_mm", RandomNumber(random, 0.0, 0.002));
  }
  if (RandomChoice(random))
  {
    structure.SetNumber("texture_n", RandomNumber(random, 0.1, 1.0));
    structure.SetImage("texture_image", sources.Texture);
  }
  Random own = random; // so that the other settings stay those of their seeds
  if (RandomChoice(own) && structure.Representation != TouchRepresentation::Elastic)
  {
    structure.SetNumber("stiffness_from_n_per_mm", RandomNumber(own, 0.1, 1.0));
    structure.SetNumber("stiffness_to_n_per_mm", RandomNumber(own, 0.0, 1.0));
    structure.SetNumber("stiffness_to_value", RandomNumber(own, -100.0, -10.0));
    structure.SetImage("stiffness_image", sources.Texture);
  }
  if (RandomChoice(own))
  {
    structure.SetNumber("gradient_n_mm", RandomNumber(own, 0.1, 1.0));
    structure.SetNumber("gradient_to_value", RandomNumber(own, 10.0, 100.0));
    structure.SetNumber("gradient_smoothing_mm", RandomNumber(own, 0.0, 2.0));
    structure.SetImage("gradient_image", sources.Texture);
  }
}

SceneStructure RandomStructure(Random& random, const Sources& sources, int id)
{
  SceneStructure structure;
  structure.Id = id;
  SetRandomSource(random, sources, structure);
  structure.Name = "structure " + std::to_string(id);
  structure.IsVisible = RandomChoice(random);
  structure.IsTouchable = id == 1 || RandomChoice(random);
  structure.Representation = RandomRepresentation(random, structure);
  if (structure.Representation == TouchRepresentation::Elastic)
  {
    structure.SetNumber("elements_across", 4.0); // in seconds; both sides use them
  }
  structure.Degree = RandomWhole(random, 2, 9);
  structure.Interpolation = static_cast<FieldInterpolation>(RandomWhole(random, 0, 1));
  structure.Smoothing = RandomNumber(random, 0.0, 1.5);
  structure.Mode = static_cast<RadialContactMode>(RandomWhole(random, 0, 1));
  structure.Damping = RandomNumber(random, 0.0, 0.002);
  SetRandomEffects(random, sources, structure);
  structure.Stiffness = RandomNumber(random, 0.1, 1.5);
  const double friction = RandomNumber(random, 0.0, 0.5);
  structure.Friction = {friction + RandomNumber(random, 0.0, 0.5), friction};
  structure.IsForbidden = id == 2 && RandomWhole(random, 0, 3) == 0;
  if (structure.Mode == RadialContactMode::Radial)
  {
    structure.Friction = {}; // the radial method has none
  }
  structure.AlarmDistance = RandomNumber(random, 0.5, 4.0);
  if (id < 3 && RandomWhole(random, 0, 2) == 0)
  {
    structure.Drill = {RandomNumber(random, 0.01, 1.0), RandomNumber(random, 0.0, 0.001),
                       RandomNumber(random, 0.0, 0.3)};
  }
  return structure;
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
  SceneCase(const Sources& sources, Random& random)
  {
    this->Window = sources.Phantom.State();
    this->Window.Structures.clear();
    this->Window.Fit = {};
    this->CommandLine.Drill.Turns = this->Window.Drill.Turns = RandomNumber(random, 100.0, 900.0);
    for (const int id : {1, 2, 3})
    {
      this->Window.Structures.push_back(RandomStructure(random, sources, id));
      this->CommandLine.Structures.push_back(this->Window.Structures.back());
      this->CommandLine.Structures.back().Id = 0;
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

std::vector<TouchState> TicksOf(const std::shared_ptr<const TouchScene>& scene, double reach)
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
    device.Next.Position = reach * HandAt(0.001 * static_cast<double>(n));
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

// Random touches around the structures of the phantom.
void ExpectSameEffect(const ForceEffect& a, const ForceEffect& b)
{
  ExpectSameBits(a.Damping(), b.Damping(), "damping of an effect");
  ASSERT_EQ(a.Field() != nullptr, b.Field() != nullptr);
  Random random(7);
  for (int n = 0; n < 100; ++n)
  {
    EffectTouch touch;
    touch.Contact.IsTouching = true;
    touch.Contact.Normal = test::RandomDirection(random);
    touch.Contact.Offset = RandomNumber(random, 0.0, 3.0) * touch.Contact.Normal;
    touch.ContactForce = 0.5 * touch.Contact.Offset;
    touch.HandVelocity = 50.0 * test::RandomDirection(random);
    touch.CenterDepth = RandomNumber(random, 0.0, 3.0);
    touch.SurfaceWorld = 15.0 * test::RandomDirection(random);
    const Vector3 one = a.Force(touch);
    const Vector3 other = b.Force(touch);
    for (int axis = 0; axis < 3; ++axis)
    {
      ExpectSameBits(one[axis], other[axis], "force of an effect");
    }
    for (int axis = 0; a.Field() != nullptr && axis < 3; ++axis)
    {
      ExpectSameBits(a.Field()->ForceWorld(touch.SurfaceWorld)[axis],
                     b.Field()->ForceWorld(touch.SurfaceWorld)[axis], "force of a field");
    }
  }
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
    ExpectSameEffect(*a.Effects[n], *b.Effects[n]);
  }
  ExpectSameBits(a.Drill.Wear, b.Drill.Wear, "wear");
  ExpectSameBits(a.Drill.Drag, b.Drill.Drag, "drag");
  ExpectSameBits(a.Drill.Vibration, b.Drill.Vibration, "vibration");
  EXPECT_EQ(a.Site, b.Site);
}

// Returns the number of ticks with contact. `reach` scales the path of the hand.
std::uint64_t ExpectSameTicks(const TouchScene& a, const TouchScene& b, double reach = 1.0)
{
  const std::vector<TouchState> one = TicksOf(std::make_shared<TouchScene>(a), reach);
  const std::vector<TouchState> other = TicksOf(std::make_shared<TouchScene>(b), reach);
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

// Returns the number of ticks with contact. `reach` scales the path of the hand.
std::uint64_t ExpectSameScene(const TouchScene& a, const TouchScene& b, double reach = 1.0)
{
  EXPECT_EQ(a.Structures.size(), b.Structures.size());
  for (std::size_t s = 0; s < std::min(a.Structures.size(), b.Structures.size()); ++s)
  {
    ExpectSameStructure(a.Structures[s], b.Structures[s]);
  }
  EXPECT_EQ(a.Drill.Link != nullptr, b.Drill.Link != nullptr);
  ExpectSameBits(a.Drill.Motion.Turns, b.Drill.Motion.Turns, "turns");
  ExpectSameBits(a.Drill.Motion.Radius, b.Drill.Motion.Radius, "radius");
  return ExpectSameTicks(a, b, reach);
}

// Expects equal scenes, or none from either. Returns the number of ticks with contact.
std::uint64_t ExpectSameOutcome(const Outcome& line, const Outcome& window)
{
  EXPECT_EQ(line.Scene != nullptr, window.Scene != nullptr)
      << line.Refusal << " | " << window.Refusal;
  return line.Scene != nullptr && window.Scene != nullptr
             ? ExpectSameScene(*line.Scene, *window.Scene)
             : 0;
}

std::size_t EffectsOf(const TouchScene& scene)
{
  return std::accumulate(scene.Structures.begin(), scene.Structures.end(), std::size_t{0},
                         [](std::size_t sum, const TouchStructure& structure)
                         { return sum + structure.Effects.size(); });
}

TEST(SameScene, WindowAndCommandLineGiveEqualBits)
{
  Random random(2026);
  const Sources sources(random);
  std::uint64_t touching = 0;
  int scenes = 0;
  std::size_t effects = 0;
  for (int n = 0; n < Cases; ++n)
  {
    SCOPED_TRACE("case " + std::to_string(n));
    const SceneCase both(sources, random);
    const Outcome line = CommandLineScene(both.CommandLine);
    touching += ExpectSameOutcome(line, WindowScene(both.Window));
    scenes += line.Scene != nullptr ? 1 : 0;
    effects += line.Scene != nullptr ? EffectsOf(*line.Scene) : 0;
  }
  EXPECT_GT(scenes, Cases / 2);
  EXPECT_GT(effects, static_cast<std::size_t>(scenes));
  EXPECT_GT(touching, 100U * static_cast<std::uint64_t>(scenes));
}

// A file that the command line reads and the window opens.
TEST(SameScene, WindowAndCommandLineFeelTheSameSceneFile)
{
  Random random(2029);
  const Sources sources(random);
  std::uint64_t touching = 0;
  for (int n = 0; n < Cases / 4; ++n)
  {
    SCOPED_TRACE("case " + std::to_string(n));
    SceneCase both(sources, random);
    for (SceneStructure& structure : both.CommandLine.Structures)
    {
      if (structure.IsDrilled()) // a scene file must not contradict itself
      {
        structure.Representation = TouchRepresentation::SubVoxel;
        structure.Interpolation = FieldInterpolation::Trilinear;
      }
    }
    const std::filesystem::path file = sources.Phantom.Folder / "case.scene.json";
    WriteWholeFile(file, SceneText(both.CommandLine, sources.Phantom.Folder.Path()));
    ManualClock clock;
    Study study(clock);
    study.OpenScene(file);
    touching += ExpectSameOutcome(CommandLineScene(ReadScene(file)), WindowScene(study.State()));
  }
  EXPECT_GT(touching, 1000U);
}

// The scene with the contact models that a trade measures for the scene's own settings.
TouchScene WithMeasuredContacts(const TouchScene& scene, const SceneSettings& settings)
{
  const auto goOn = [](double, const std::string&) { return true; };
  const ManualClock clock;
  TouchScene measured = scene;
  for (TouchStructure& structure : measured.Structures)
  {
    const SceneStructure& asked = *std::find_if(
        settings.Structures.begin(), settings.Structures.end(),
        [&structure](const SceneStructure& one) { return one.Name == structure.Name; });
    StructureTrade trade(settings, asked, {}, {}, clock);
    structure.Model = trade.ContactFor({asked, settings.Tool.Points}, goOn)->Model;
  }
  return measured;
}

TEST(SameScene, TradeMeasuresContactsOfTheScene)
{
  Random random(2027);
  const Sources sources(random);
  std::uint64_t touching = 0;
  for (int n = 0; n < Cases / 2; ++n)
  {
    SceneCase both(sources, random);
    for (SceneStructure& structure : both.Window.Structures)
    {
      structure.Drill = {}; // a trade does not drill
    }
    both.CommandLine.Structures = both.Window.Structures;
    const Outcome line = CommandLineScene(both.CommandLine);
    SCOPED_TRACE("case " + std::to_string(n) + " " + line.Refusal);
    if (line.Scene != nullptr)
    {
      touching += ExpectSameTicks(*line.Scene, WithMeasuredContacts(*line.Scene, both.Window));
    }
  }
  EXPECT_GT(touching, 1000U);
}

// Settings that an interactor style has: surfaces, their stiffness, and a spherical tool.
SceneSettings RandomSurfaceScene(Random& random, const Sources& sources)
{
  SceneSettings settings;
  settings.Tool = RandomTool(random, true);
  const int count = RandomWhole(random, 1, 2);
  for (int n = 0; n < count; ++n)
  {
    SceneStructure structure;
    structure.File = sources.Surface;
    structure.Name = "surface " + std::to_string(n);
    structure.Representation = TouchRepresentation::Facets;
    structure.Stiffness = RandomNumber(random, 0.1, 1.5);
    structure.Damping = 0.0;
    structure.Friction = {};
    settings.Structures.push_back(structure);
  }
  return settings;
}

TEST(SameScene, InteractorStyleGivesEqualBitsForSurfaces)
{
  constexpr double AcrossSphere = 0.4;
  Random random(2028);
  const Sources sources(random);
  std::uint64_t touching = 0;
  for (int n = 0; n < Cases / 4; ++n)
  {
    SCOPED_TRACE("case " + std::to_string(n));
    const SceneSettings settings = RandomSurfaceScene(random, sources);
    const Outcome line = CommandLineScene(settings);
    ASSERT_TRUE(line.Scene != nullptr) << line.Refusal;
    const vtkNew<vtkInteractorStyleHaptic> style;
    style->SetToolRadius(settings.Tool.Radius);
    for (const SceneStructure& structure : settings.Structures)
    {
      ASSERT_GE(style->AddSurface(ReadSurface(structure.File), structure.Stiffness), 0);
    }
    TouchScene shown = style->MakeScene();
    shown.Frame = line.Scene->Frame;
    touching += ExpectSameScene(*line.Scene, shown, AcrossSphere);
  }
  EXPECT_GT(touching, 1000U);
}
} // namespace
} // namespace palpate::same_scene_test
