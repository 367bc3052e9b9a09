#pragma once

#include "ImageWriter.h"
#include "LabelImages.h"
#include "ModelFile.h"
#include "RadialModel.h"
#include "TaskConduct.h"
#include "TaskFile.h"
#include "TaskRun.h"
#include "TaskSettings.h"
#include "TemporaryFolder.h"
#include "TransformFile.h"

#include <cmath>
#include <filesystem>

namespace palpate::test
{
/// Radius of the ball of WriteBall, mm.
constexpr double BallRadius = 20.0;

/// A rigid ball around the origin, in a scene with a tool of 1 mm. Returns the scene's file.
inline std::filesystem::path WriteBall(const TemporaryFolder& folder)
{
  // The constant harmonic is 1 / sqrt(4 pi).
  WriteModel(folder / "ball.json",
             {RadialModel(0, {BallRadius * std::sqrt(4.0 * M_PI)}, Vector3::Zero()), {}});
  WriteAll(folder / "ball.scene.json",
           R"({"format": "palpate-scene",
               "structures": [{"file": "ball.json", "stiffness_n_per_mm": 1}],
               "tool": {"shape": "sphere", "radius_mm": 1}, "placement": {"scale": 1}})");
  return folder / "ball.scene.json";
}

/// A ball of 12 mm around the origin whose back (y above 7 mm) is missing, in a scene, and the
/// whole one: start.nii.gz, true.nii.gz. Returns the scene's file.
inline std::filesystem::path WriteWrongMask(const TemporaryFolder& folder)
{
  LabelGrid grid;
  grid.Size = {{40, 40, 40}};
  grid.CenterOnOrigin();
  const auto isInBall = [](double x, double y, double z) { return std::hypot(x, y, z) < 12.0; };
  WriteImage(folder / "true.nii.gz", MakeLabelImage(grid, isInBall));
  WriteImage(folder / "start.nii.gz", MakeLabelImage(grid, [&](double x, double y, double z)
                                                     { return isInBall(x, y, z) && y < 7.0; }));
  WriteAll(folder / "mask.scene.json",
           R"({"format": "palpate-scene",
               "structures": [{"file": "start.nii.gz", "label": 1}],
               "tool": {"shape": "sphere", "radius_mm": 1}, "placement": {"scale": 1}})");
  return folder / "mask.scene.json";
}

/// The ball of WriteBall, which has to be there, and one moved by `way` (mm), in a scene.
inline std::filesystem::path WriteTwoBalls(const TemporaryFolder& folder, const Vector3& way)
{
  WriteTransform(folder / "place.tfm", Eigen::Affine3d(Eigen::Translation3d(way)));
  WriteAll(folder / "dock.scene.json",
           R"({"format": "palpate-scene",
               "structures": [{"file": "ball.json"},
                              {"file": "ball.json", "transform": "place.tfm"}],
               "tool": {"shape": "sphere", "radius_mm": 1}, "placement": {"scale": 1}})");
  return folder / "dock.scene.json";
}

/// A target of every kind with an answer that everything is right in.
struct TargetCase
{
  TaskTarget Target;
  TaskAnswer Right;
};

inline TargetCase TargetOf(TaskKind kind)
{
  TargetCase made;
  made.Target.Id = "a";
  made.Target.Scene = "ball.scene.json";
  made.Target.Tolerance = 1.5;
  switch (kind)
  {
  case TaskKind::Nodule:
    made.Target.Points = {{"", {1.0, BallRadius, 2.0}}};
    made.Target.Diameter = 8.0;
    made.Right.Diameter = 8.0;
    break;
  case TaskKind::Landmarks:
    made.Target.Points = {{"left", {BallRadius, 0, 0}}, {"top", {0, 0, BallRadius}}};
    break;
  case TaskKind::Outline:
  case TaskKind::Path:
    for (int i = 0; i < 36; ++i)
    {
      const double angle = i * M_PI / 18.0;
      const double radius = BallRadius + (kind == TaskKind::Path ? 3.0 : 0.0);
      made.Target.Points.push_back({"", radius * Vector3(std::cos(angle), std::sin(angle), 0.0)});
    }
    made.Target.Tolerance = kind == TaskKind::Path ? 6.0 : 1.5; // more than from point to point
    break;
  case TaskKind::Mask:
    made.Target.Mask = "true.nii.gz";
    made.Right.Dice = 1.0;
    break;
  case TaskKind::Dock:
    made.Target.Points = {{"", {1.0, 2.0, 3.0}}};
    made.Target.Pose = {Vector3(4.0, 5.0, 6.0), Vector3(0.0, 0.0, 30.0)};
    made.Right.Shift = made.Target.Pose.Shift;
    made.Right.Turn = made.Target.Pose.Turn;
    break;
  }
  for (const TaskPoint& point : made.Target.Points)
  {
    made.Right.PointsWorld.push_back(point.PointWorld);
  }
  return made;
}

/// A task of two conditions and three targets, of which the last is for training: three trials of
/// each condition, the first of them training, and a pause after the third.
inline TaskSettings TaskOf(TaskKind kind)
{
  TaskSettings task;
  task.Id = "study";
  task.Kind = kind;
  task.Conditions = {{"force", true, {}}, {"sight", false, {}}};
  for (const char* id : {"a", "b", "training"})
  {
    task.Targets.push_back(TargetOf(kind).Target);
    task.Targets.back().Id = id;
  }
  task.Targets.back().IsTraining = true;
  task.Questions = {{"hand", "Which hand do you use?", {"left", "right"}, 0.0, 0.0},
                    {"years", "Years of experience", {}, 0.0, 60.0}};
  task.Trials = 2;
  task.TrainingTrials = 1;
  task.PauseAfter = 3;
  return task;
}

/// Does all that is left with right answers.
inline void Complete(TaskRun& run, TaskKind kind)
{
  TaskConduct conduct;
  conduct.Seconds = 2.5;
  while (run.State() != TaskState::Finished)
  {
    if (run.State() == TaskState::Paused)
    {
      run.Resume();
    }
    run.Start();
    run.End(TargetOf(kind).Right, conduct);
  }
}
} // namespace palpate::test
