#pragma once

#include "PalpateTaskModule.h"
#include "Vector3.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// What is done in a task.
enum class TaskKind
{
  Nodule,    ///< find a nodule by palpation and say how large it is
  Landmarks, ///< mark named points
  Outline,   ///< draw an outline in a plane
  Mask,      ///< correct a mask
  Dock,      ///< move a body to its place
  Path       ///< follow a path without touching a wall
};

/// "nodule", "landmarks", "outline", "mask", "dock", "path".
PALPATETASK_EXPORT const std::vector<std::string>& TaskKindNames();
PALPATETASK_EXPORT const std::string& NameOf(TaskKind kind);

struct TaskPoint
{
  std::string Name;                     ///< of a landmark; else empty
  Vector3 PointWorld = Vector3::Zero(); ///< mm
};

/// How a body is moved: turned about its centre, then shifted.
struct TaskPose
{
  Vector3 Shift = Vector3::Zero(); ///< mm
  Vector3 Turn = Vector3::Zero();  ///< degrees, along the axis
};

/// One thing to be done, and its true answer.
struct TaskTarget
{
  std::string Id;
  std::filesystem::path Scene;
  bool IsTraining = false; ///< for training trials only
  /// Nodule: the point of the surface above it, none without a nodule. Landmarks: each. Outline: a
  /// closed contour in a plane. Path: from its start to its end. Dock: the body's centre; it is the
  /// scene's first structure, and the second one is where it is to be.
  std::vector<TaskPoint> Points;
  double Diameter = 0.0;  ///< mm, of the nodule
  double Tolerance = 1.0; ///< mm, of a success
  /// Nodule: the side that is palpated, and how far around its middle.
  Vector3 Side = Vector3::UnitY();
  double Reach = 15.0;         ///< mm
  std::filesystem::path Mask;  ///< the true one
  std::filesystem::path Image; ///< that slices show; empty: none
  TaskPose Pose;               ///< the true one
  double AngleTolerance = 5.0; ///< degrees, of a success
};

/// What is varied between trials.
struct TaskCondition
{
  std::string Id;
  bool HasForce = true;        ///< otherwise the device is switched off, but tracked
  std::filesystem::path Patch; ///< JSON Patch (RFC 6902) of every scene; empty: none
};

/// What is asked about a participant: one of some words, or a number. Free text is not possible.
struct TaskQuestion
{
  std::string Key;
  std::string Text;
  std::vector<std::string> Choices; ///< empty: a number
  double Least = 0.0;
  double Most = 100.0;
};

/// A task as a value. Without limits that are 0.
struct TaskSettings
{
  std::string Id;
  std::string Title;
  TaskKind Kind = TaskKind::Landmarks;
  std::string Instructions;
  std::vector<TaskCondition> Conditions;
  std::vector<TaskTarget> Targets;
  std::vector<TaskQuestion> Questions;
  int Trials = 1;            ///< of each condition
  int TrainingTrials = 0;    ///< before those of each condition
  double MostSeconds = 0.0;  ///< of a trial
  double MostForce = 0.0;    ///< N; a larger one ends a trial
  int PauseAfter = 0;        ///< trials
  double PauseSeconds = 0.0; ///< least duration of a pause
  int Seed = 1;              ///< of the order of targets
  bool IsRecorded = true;    ///< the hand, in a recording of each trial
};
} // namespace palpate
