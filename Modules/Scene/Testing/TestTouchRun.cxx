#include "TouchRun.h"

#include "CommaLocale.h"
#include "DeviceList.h"
#include "FileSizeLimit.h"
#include "ImageWriter.h"
#include "InputError.h"
#include "LabelImages.h"
#include "ModelFile.h"
#include "PacedClock.h"
#include "SceneFile.h"
#include "TemporaryFolder.h"
#include "TouchReport.h"
#include "WholeFile.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace palpate::touch_run_test
{
namespace
{
bool GoOn(double, const std::string&)
{
  return true;
}

// A stretch of one tick.
const TouchStretch& LastOf(const TouchResult& result)
{
  return result.Trace.Stretches().back();
}

constexpr double Radius = 15.0;

// Voxels of 1 mm around the origin whose value is their x, mm.
vtkSmartPointer<vtkImageData> RampAlongX(int size)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, size);
  image->SetOrigin(-0.5 * (size - 1), -0.5 * (size - 1), -0.5 * (size - 1));
  image->AllocateScalars(VTK_FLOAT, 1);
  for (int n = 0; n < size * size * size; ++n)
  {
    image->SetScalarComponentFromDouble(n % size, n / size % size, n / size / size, 0,
                                        n % size - 0.5 * (size - 1));
  }
  return image;
}

// A sphere, as a model, and as a mask on 1 mm voxels.
class TouchRun : public testing::Test
{
protected:
  void SetUp() override
  {
    WriteModel(this->ModelPath,
               {RadialModel(0, {Radius * std::sqrt(4.0 * M_PI)}, Vector3::Zero()), {}});
    test::LabelGrid grid;
    grid.Size = {{40, 40, 40}};
    grid.CenterOnOrigin();
    WriteImage(this->MaskPath, test::MakeLabelImage(grid, [](double x, double y, double z)
                                                    { return std::hypot(x, y, z) < Radius; }));
  }

  SceneSettings SettingsOf(const std::filesystem::path& file, const std::string& representation)
  {
    SceneSettings settings;
    SceneStructure structure;
    structure.File = file;
    structure.Representation = representation;
    structure.Degree = 2;
    settings.Structures = {structure};
    return settings;
  }
  // The recording is session.touch.
  TouchResult RunAndReplay(const SceneSettings& settings, const TouchScript& script)
  {
    const PreparedTouch touch = PrepareTouch(settings, script, GoOn);
    const auto file = this->Folder / "session.touch";
    const TouchResult result = RunTouch(touch, {true, file, {}, {}}, GoOn);
    EXPECT_EQ(CompareTouch(touch, file).DifferentTicks, 0U);
    return result;
  }
  // Straight to a point on the x axis, and rest.
  static TouchScript PressTo(double x)
  {
    TouchScript script;
    script.Path = HandPath(
        {{0.0, Vector3(40.0, 0.0, 0.0)}, {1.0, Vector3(x, 0.0, 0.0)}, {2.0, Vector3(x, 0.0, 0.0)}});
    return script;
  }

  test::TemporaryFolder Folder;
  std::filesystem::path ModelPath = Folder / "ball.json";
  std::filesystem::path MaskPath = Folder / "ball.nii.gz";
};

// At rest the springs of hand and structure, both 0.5 N/mm, share the distance: half of 4 mm each.
// The mechanism's friction (0.2 N) may hold 0.2 mm of it.
TEST_F(TouchRun, EveryRepresentationOfASphereGivesTheSameForce)
{
  for (const char* const representation :
       {TouchRepresentation::Automatic, TouchRepresentation::SubVoxel,
        TouchRepresentation::Harmonics, TouchRepresentation::Facets})
  {
    const bool isModel = representation == TouchRepresentation::Automatic;
    const SceneSettings settings =
        this->SettingsOf(isModel ? this->ModelPath : this->MaskPath, representation);
    const double end = Radius + settings.Tool.Radius - 4.0;
    const PreparedTouch touch = PrepareTouch(settings, PressTo(end), GoOn);
    const TouchResult result = RunTouch(touch, {}, GoOn);
    EXPECT_EQ(result.Ticks, 2000U);
    EXPECT_EQ(result.Fault, SafetyFault::None);
    EXPECT_EQ(result.LostTicks, 0U);
    // The voxel sphere may be half a voxel larger or smaller.
    const double voxels = isModel ? 0.0 : 0.5;
    EXPECT_NEAR(LastOf(result).Depth.Most, 2.0, 0.25 + 0.5 * voxels)
        << touch.Structures[0].Represented;
    EXPECT_NEAR(LastOf(result).Force.Most, 0.5 * LastOf(result).Depth.Most, 1e-2)
        << touch.Structures[0].Represented;
    EXPECT_GT(result.TouchedSeconds[0], 1.0);
  }
}

TEST_F(TouchRun, FullDiskEndsTheRecordingAndNotTheTouch)
{
  const SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  const PreparedTouch touch = PrepareTouch(settings, PressTo(10.0), GoOn);
  const auto file = this->Folder / "session.touch";
  std::string reported;
  TouchRunSettings run;
  run.Recording = file;
  run.Guide = [&reported](const std::string& message) { reported = message; };
  TouchResult result;
  {
    const test::FileSizeLimit full(300'000); // within tick 749
    result = RunTouch(touch, run, GoOn);
  }
  EXPECT_EQ(result.Ticks, 2000U);
  EXPECT_NE(result.RecordingProblem.find("0.749 s"), std::string::npos) << result.RecordingProblem;
  EXPECT_EQ(reported, result.RecordingProblem);
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(this->Folder.EntryCount(), 3U) << "model, mask and recording";
}

TEST_F(TouchRun, SessionReplaysBitForBit)
{
  SceneSettings settings = this->SettingsOf(this->MaskPath, TouchRepresentation::SubVoxel);
  settings.Structures[0].Friction = {0.4, 0.3};
  const PreparedTouch touch = PrepareTouch(settings, PressTo(10.0), GoOn);
  const auto file = this->Folder / "session.touch";
  const TouchResult result = RunTouch(touch, {true, file, {}, {}}, GoOn);
  const TouchComparison same = CompareTouch(touch, file);
  EXPECT_EQ(same.Ticks, result.Ticks);
  EXPECT_EQ(same.DifferentTicks, 0U);
  settings.Structures[0].Stiffness *= 1.5;
  const PreparedTouch stiffer = PrepareTouch(settings, PressTo(10.0), GoOn);
  EXPECT_GT(CompareTouch(stiffer, file).DifferentTicks, 500U);
  EXPECT_THROW(CompareTouch(touch, this->ModelPath), InputError);
}

// Scene, model and recording were written by version 0.1.0, with keys that are now retired.
TEST(TouchRunOfVersion010, RecordingReplaysBitForBit)
{
  const std::filesystem::path folder = std::filesystem::path(PALPATE_BASELINES) / "0.1.0" / "felt";
  const PreparedTouch touch = PrepareTouch(ReadScene(folder / "scene.json"), {}, GoOn);
  const TouchComparison same = CompareTouch(touch, folder / "session.touch");
  EXPECT_EQ(same.Ticks, 120U);
#ifdef __x86_64__ // where it was recorded; other processors may round otherwise
  EXPECT_EQ(same.DifferentTicks, 0U);
#endif
  EXPECT_LT(same.LargestDifference, 1e-9); // N
}

// The image is brighter where x is larger, and the hand presses there.
TEST_F(TouchRun, RarelyQueriedModelLagsAndEqualsAtRest)
{
  SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  const auto touch = [&](int interval)
  {
    settings.ModelInterval = interval;
    return RunTouch(PrepareTouch(settings, PressTo(Radius - 2.0), GoOn), {}, GoOn);
  };
  const TouchResult always = touch(1);
  const TouchResult seldom = touch(10);
  // The interpolation has converged to the model's own answer by then, in floats.
  EXPECT_NEAR(LastOf(seldom).Force.Most, LastOf(always).Force.Most, 1e-4);
  EXPECT_LT(seldom.TouchedSeconds[0], always.TouchedSeconds[0]);
  EXPECT_GT(seldom.TouchedSeconds[0], always.TouchedSeconds[0] - 0.010) << "less than an interval";
}

TEST_F(TouchRun, TextureForceIncreasesWithIntensity)
{
  const auto image = this->Folder / "image.nrrd";
  test::LabelGrid grid;
  grid.Size = {{40, 40, 40}};
  grid.CenterOnOrigin();
  WriteImage(image, test::MakeLabelImage(grid, [](double x, double, double) { return x > 10.0; }));
  SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  const auto ratio = [&]
  {
    const TouchResult result = RunTouch(PrepareTouch(settings, PressTo(13.0), GoOn), {}, GoOn);
    return LastOf(result).Force.Most / LastOf(result).Depth.Most;
  };
  EXPECT_NEAR(ratio(), 0.5, 1e-6); // single precision
  settings.Structures[0].SetNumber("texture_n", 0.3);
  settings.Structures[0].SetImage("texture_image", image);
  EXPECT_GT(ratio(), 0.55);
  settings.Structures[0].SetImage("texture_image", this->Folder / "missing.nrrd");
  EXPECT_THROW(PrepareTouch(settings, PressTo(13.0), GoOn), InputError);
}

// The image is x in mm, and the hand presses at the sphere's 15 mm: half-way between two values.
TEST_F(TouchRun, StiffnessFollowsAnImageAndReplaysBitForBit)
{
  const auto image = this->Folder / "image.nrrd";
  WriteImage(image, RampAlongX(40));
  SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  settings.Structures[0].SetNumber("stiffness_from_n_per_mm", 0.4);
  settings.Structures[0].SetNumber("stiffness_from_value", 20.0);
  settings.Structures[0].SetNumber("stiffness_to_n_per_mm", 1.2);
  settings.Structures[0].SetNumber("stiffness_to_value", 10.0);
  settings.Structures[0].SetImage("stiffness_image", image);
  const TouchResult result = this->RunAndReplay(settings, PressTo(13.0));
  EXPECT_NEAR(LastOf(result).Force.Most / LastOf(result).Depth.Most, 0.8, 1e-6); // floats
  settings.Structures[0].SetNumber("stiffness_to_value", 5.0);
  const PreparedTouch changed = PrepareTouch(settings, PressTo(13.0), GoOn);
  EXPECT_GT(CompareTouch(changed, this->Folder / "session.touch").DifferentTicks, 500U);
}

// The hand holds still beside the sphere, without contact, where the image rises along x.
TEST_F(TouchRun, GradientGuidesInFreeSpaceAndReplaysBitForBit)
{
  const auto image = this->Folder / "image.nrrd";
  WriteImage(image, RampAlongX(80));
  SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  SceneStructure& ball = settings.Structures[0];
  ball.SetNumber("gradient_n_mm", 1.0);
  ball.SetNumber("gradient_from_value", 13.0);
  ball.SetNumber("gradient_to_value", 23.0);
  ball.SetNumber("gradient_smoothing_mm", 1.5);
  ball.SetImage("gradient_image", image);
  TouchScript script;
  script.Path = HandPath({{0.0, Vector3(18.0, 3.0, 0.0)}, {2.0, Vector3(18.0, 3.0, 0.0)}});
  const TouchResult result = this->RunAndReplay(settings, script);
  EXPECT_EQ(result.TouchedSeconds[0], 0.0);
  EXPECT_NEAR(LastOf(result).Force.Most, 0.15, 0.01); // 1.5 N mm / 10 mm; the hand yields a little
  ball.SetNumber("gradient_largest_n", 0.05);
  const TouchResult weaker = RunTouch(PrepareTouch(settings, script, GoOn), {}, GoOn);
  EXPECT_LT(LastOf(weaker).Force.Most, 0.05);
  ball.SetNumber("gradient_to_value", 13.0);
  EXPECT_THROW(PrepareTouch(settings, script, GoOn), InputError);
}

// The hand holds still 2 mm from a path that passes beside the sphere.
TEST_F(TouchRun, GuideActsInFreeSpaceAndReplaysBitForBit)
{
  SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  settings.Guides = {{GuideShape::Path, {{30.0, -40.0, 0.0}, {30.0, 40.0, 0.0}}}};
  TouchScript script;
  script.Path = HandPath({{0.0, Vector3(28.0, 3.0, 0.0)}, {2.0, Vector3(28.0, 3.0, 0.0)}});
  const TouchResult result = this->RunAndReplay(settings, script);
  EXPECT_EQ(result.TouchedSeconds[0], 0.0);
  const double left = 1.0 - 2.0 * 2.0 / 100.0;
  EXPECT_NEAR(LastOf(result).Force.Most, 0.5 / 2.862 * 2.0 * left * left, 0.08); // the hand yields
  settings.Guides[0].LargestForce = 0.1;
  const TouchResult weaker = RunTouch(PrepareTouch(settings, script, GoOn), {}, GoOn);
  EXPECT_LT(LastOf(weaker).Force.Most, 0.1);
}

// The hand holds still beside the sphere, in a larger one that is not touched.
TEST_F(TouchRun, StructureThatIsNotTouchedGuidesAndReplaysBitForBit)
{
  const auto large = this->Folder / "large.json";
  WriteModel(large, {RadialModel(0, {24.0 * std::sqrt(4.0 * M_PI)}, Vector3::Zero()), {}});
  SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  settings.Structures.push_back(settings.Structures.front());
  settings.Structures[1].File = large;
  settings.Structures[1].Id = 5;
  settings.Structures[1].IsTouchable = false;
  GuideSettings guide;
  guide.Shape = GuideShape::Inside;
  guide.Structure = 5;
  guide.Distance = -2.0;
  settings.Guides = {guide};
  TouchScript script;
  script.Path = HandPath({{0.0, Vector3(25.0, 0.0, 0.0)}, {2.0, Vector3(25.0, 0.0, 0.0)}});
  const TouchResult result = this->RunAndReplay(settings, script);
  EXPECT_EQ(result.TouchedSeconds.size(), 1U) << "of the touched one";
  EXPECT_EQ(result.TouchedSeconds[0], 0.0);
  const double left = 1.0 - 3.0 * 3.0 / 100.0; // 3 mm beyond the level
  EXPECT_NEAR(LastOf(result).Force.Most, 0.5 / 2.862 * 3.0 * left * left, 0.08); // the hand yields
  settings.Guides[0].Distance = 4.0;
  const TouchResult free = RunTouch(PrepareTouch(settings, script, GoOn), {}, GoOn);
  EXPECT_EQ(LastOf(free).Force.Most, 0.0);
}

TEST_F(TouchRun, RejectsGuidesOfMissingStructures)
{
  SceneSettings settings = this->SettingsOf(this->MaskPath, TouchRepresentation::Facets);
  GuideSettings guide;
  guide.Shape = GuideShape::Inside;
  guide.Structure = 1;
  settings.Guides = {guide};
  EXPECT_NO_THROW(PrepareTouch(settings, PressTo(13.0), GoOn)) << "the label's number is its id";
  settings.Guides[0].Structure = 2;
  EXPECT_THROW(PrepareTouch(settings, PressTo(13.0), GoOn), InputError);
}

TEST_F(TouchRun, RejectsStiffnessImagesThatCannotBeFelt)
{
  const auto image = this->Folder / "image.nrrd";
  WriteImage(image, RampAlongX(40));
  SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  SceneStructure& ball = settings.Structures[0];
  ball.SetNumber("stiffness_from_n_per_mm", 0.4);
  ball.SetImage("stiffness_image", image);
  const auto refusal = [&]
  {
    try
    {
      PrepareTouch(settings, PressTo(13.0), GoOn);
    }
    catch (const InputError& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal().find("choose two different"), std::string::npos) << refusal();
  ball.SetNumber("stiffness_to_value", 10.0);
  EXPECT_EQ(refusal(), "");
  vtkSmartPointer<vtkImageData> far = RampAlongX(40);
  far->SetOrigin(500.0, 0.0, 0.0);
  WriteImage(image, far);
  EXPECT_NE(refusal().find("does not reach"), std::string::npos) << refusal();
  vtkSmartPointer<vtkImageData> broken = RampAlongX(40);
  broken->SetScalarComponentFromDouble(20, 20, 20, 0, std::nan(""));
  WriteImage(image, broken);
  EXPECT_NE(refusal().find("NaN or infinite"), std::string::npos) << refusal();
  EXPECT_NE(refusal().find("image.nrrd"), std::string::npos) << refusal();
}

TEST_F(TouchRun, RejectsStiffnessImagesOfStructuresThatYield)
{
  const auto image = this->Folder / "image.nrrd";
  WriteImage(image, RampAlongX(40));
  SceneSettings settings = this->SettingsOf(this->MaskPath, TouchRepresentation::Elastic);
  SceneStructure& ball = settings.Structures[0];
  ball.SetNumber("elements_across", 4.0);
  ball.SetNumber("stiffness_from_n_per_mm", 0.4);
  ball.SetNumber("stiffness_to_value", 10.0);
  ball.SetImage("stiffness_image", image);
  EXPECT_THROW(PrepareTouch(settings, PressTo(13.0), GoOn), InputError);
  ball.SetNumber("stiffness_from_n_per_mm", 0.0);
  EXPECT_NO_THROW(PrepareTouch(settings, PressTo(13.0), GoOn));
}

TEST_F(TouchRun, SweepIsMostlyInContact)
{
  const SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  const PreparedTouch touch = PrepareTouch(settings, {}, GoOn);
  EXPECT_EQ(touch.Duration, touch.Path.Duration());
  const TouchResult result = RunTouch(touch, {}, GoOn);
  EXPECT_GT(result.TouchedSeconds[0], 0.8 * touch.Duration);
}

TEST_F(TouchRun, SaysThatASweepRanDeep)
{
  const SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  EXPECT_EQ(RunTouch(PrepareTouch(settings, {}, GoOn), {}, GoOn).SweepNote, "");
  // As if the hand had meant to go less deep than it went.
  TouchScript script;
  script.SweepDepth = 14.0;
  PreparedTouch touch = PrepareTouch(settings, script, GoOn);
  touch.SweepDepth = 1.0;
  const std::string note = RunTouch(touch, {}, GoOn).SweepNote;
  EXPECT_NE(note.find("mm deep instead of 1 mm"), std::string::npos) << note;
}

// A touch three times as long as the sweep is in contact for the same part of the time.
TEST_F(TouchRun, SweepRepeatsForTheWholeTouch)
{
  const SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  TouchScript script;
  script.SweepSpeed = 200.0;
  script.Duration = 3.0 * PrepareTouch(settings, script, GoOn).Duration;
  const PreparedTouch touch = PrepareTouch(settings, script, GoOn);
  const TouchResult result = RunTouch(touch, {}, GoOn);
  EXPECT_EQ(result.Fault, SafetyFault::None);
  EXPECT_GT(result.TouchedSeconds[0], 0.8 * touch.Duration);
}

TEST_F(TouchRun, HandReachesAllOfALargeScene)
{
  SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  WriteModel(this->ModelPath,
             {RadialModel(0, {100.0 * std::sqrt(4.0 * M_PI)}, Vector3::Zero()), {}});
  EXPECT_GT(PrepareTouch(settings, {}, GoOn).Frame.Scale, 100.0 / 40.0);
  settings.Placement.Scale = 1.5;
  EXPECT_EQ(PrepareTouch(settings, {}, GoOn).Frame.Scale, 1.5);
}

TEST_F(TouchRun, WarnsOfMoreStiffnessThanTheDeviceAllows)
{
  SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  EXPECT_TRUE(PrepareTouch(settings, PressTo(10.0), GoOn).Warnings.empty());
  settings.Structures[0].Stiffness = 50.0;
  EXPECT_EQ(PrepareTouch(settings, PressTo(10.0), GoOn).Warnings.size(), 1U);
}

TEST_F(TouchRun, CanBeEndedEarly)
{
  const SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  const PreparedTouch touch = PrepareTouch(settings, PressTo(10.0), GoOn);
  const auto half = [](double part, const std::string&) { return part < 0.5; };
  const TouchResult result = RunTouch(touch, {}, half);
  EXPECT_GT(result.Ticks, 900U);
  EXPECT_LT(result.Ticks, 2000U);
}

// On a thread, for the given duration: with a clock that waits for a busy machine, no tick is late.
TEST_F(TouchRun, RunsInRealTimeOnAThread)
{
  SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  settings.Rate = 200.0;
  TouchScript script = PressTo(10.0);
  script.Duration = 1.5;
  const PreparedTouch touch = PrepareTouch(settings, script, GoOn);
  test::PacedClock clock;
  TouchRunSettings run;
  run.IsVirtual = false;
  run.Time = &clock;
  const TouchResult result = RunTouch(touch, run, GoOn);
  EXPECT_EQ(result.Fault, SafetyFault::None);
  // Ticks at 0, 5, ... 1495 ms, and those until the end was noticed.
  EXPECT_GE(result.Ticks, 300U);
  EXPECT_EQ(result.LostTicks, 0U);
  EXPECT_EQ(result.Trace.Stretches().size(), result.Ticks);
  for (std::size_t n = 1; n < result.Trace.Stretches().size(); ++n)
  {
    ASSERT_EQ(result.Trace.Stretches()[n].Period.Least, 5000.0F); // us
  }
  EXPECT_EQ(result.Periods.Misses(), 0U);
  EXPECT_EQ(result.Durations.Misses(), 0U);
  EXPECT_GT(result.TouchedSeconds[0], 0.5);
  EXPECT_EQ(result.Trace.Whole().Computation.Most, 0.0F);
}

// A machine that is busy for 30 ms, once, after 0.3 s.
class BusyOnceClock final : public Clock
{
public:
  std::int64_t Now() const noexcept override { return this->Paced.Now() + this->Busy; }
  void WaitUntil(std::int64_t time) noexcept override
  {
    this->Paced.WaitUntil(time - this->Busy);
    if (time >= 300'000'000)
    {
      this->Busy = 30'000'000;
    }
  }

private:
  test::PacedClock Paced;
  std::atomic<std::int64_t> Busy{0}; // ns
};

TEST_F(TouchRun, DelayedServoInterruptsForcesOfTheSimulatedHand)
{
  SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  settings.Rate = 200.0;
  TouchScript script = PressTo(10.0);
  script.Duration = 1.5;
  const PreparedTouch touch = PrepareTouch(settings, script, GoOn);
  BusyOnceClock clock;
  TouchRunSettings run;
  run.IsVirtual = false;
  run.Time = &clock;
  const TouchResult result = RunTouch(touch, run, GoOn);
  EXPECT_EQ(result.Fault, SafetyFault::StalledTick);
  EXPECT_TRUE(result.HasResumed);
  EXPECT_GT(LastOf(result).Force.Most, 0.1F);
}

TEST_F(TouchRun, RejectsScenesThatCannotBeTouched)
{
  SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::SubVoxel);
  EXPECT_THROW(PrepareTouch(settings, {}, GoOn), InputError);
  settings = this->SettingsOf(this->Folder / "missing.json", TouchRepresentation::Automatic);
  EXPECT_THROW(PrepareTouch(settings, {}, GoOn), InputError);
  settings = this->SettingsOf(this->MaskPath, TouchRepresentation::Automatic);
  settings.Structures[0].Labels = {"7"};
  EXPECT_THROW(PrepareTouch(settings, {}, GoOn), InputError);
  settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  settings.Device = "phantom";
  EXPECT_THROW(PrepareTouch(settings, {}, GoOn), InputError);
  settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  settings.Tool.Kind = TouchToolSettings::Shape::Ellipsoid;
  EXPECT_NO_THROW(PrepareTouch(settings, {}, GoOn));
}

TEST_F(TouchRun, FilesAreTheSameUnderADecimalComma)
{
  const SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  const PreparedTouch touch = PrepareTouch(settings, PressTo(10.0), GoOn);
  const TouchResult result = RunTouch(touch, {}, GoOn);
  const test::TemporaryFolder expected;
  WriteTouchFiles(expected.Path(), touch, result);
  const test::CommaLocale comma(test::CommaLocale::Scope::Streams);
  const test::TemporaryFolder written;
  WriteTouchFiles(written.Path(), touch, result);
  for (const char* name : {"scene.json", "summary.json", "report.html"})
  {
    EXPECT_EQ(test::ReadAll(written / name), test::ReadAll(expected / name)) << name;
  }
  const SceneSettings read = ReadScene(written / "scene.json");
  EXPECT_EQ(read.Structures.front().Stiffness, settings.Structures.front().Stiffness);
}

TEST_F(TouchRun, FilesDescribeTheTouch)
{
  const SceneSettings settings = this->SettingsOf(this->ModelPath, TouchRepresentation::Automatic);
  const PreparedTouch touch = PrepareTouch(settings, PressTo(10.0), GoOn);
  const TouchResult result = RunTouch(touch, {}, GoOn);
  WriteTouchFiles(this->Folder.Path(), touch, result);
  const auto read = [this](const char* name)
  { return ReadWholeFile(this->Folder / name, std::uintmax_t{1} << 30); };
  const nlohmann::json summary = nlohmann::json::parse(read("summary.json"));
  EXPECT_EQ(summary["ticks"], 2000);
  EXPECT_EQ(summary["fault"], "");
  EXPECT_GT(summary["force_max_n"].get<double>(), 1.0);
  EXPECT_GT(summary["tick"]["median_us"].get<double>(), 0.0);
  EXPECT_NE(read("report.html").find("force, N"), std::string::npos);
  EXPECT_NE(read("scene.json").find("ball.json"), std::string::npos);
}

TEST(DeviceList, HasTheSimulatedDeviceAndObstaclesOfOthers)
{
  const std::vector<DeviceReport> reports = ListDevices();
  const auto named = [&](const std::string& name)
  {
    return *std::find_if(reports.begin(), reports.end(),
                         [&](const DeviceReport& report) { return report.Name == name; });
  };
  EXPECT_TRUE(named("simulated").IsThere);
  EXPECT_EQ(named("simulated").Details, "ready");
  EXPECT_FALSE(named("replay").IsThere);
  EXPECT_NE(named("replay").Details.find("file"), std::string::npos);
}
} // namespace
} // namespace palpate::touch_run_test
