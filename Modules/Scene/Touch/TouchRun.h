#pragma once

#include "Clock.h"
#include "DrillContext.h"
#include "DrillScript.h"
#include "DrillWatch.h"
#include "HandPath.h"
#include "PalpateSceneModule.h"
#include "PeriodStatistics.h"
#include "Progress.h"
#include "SafetyReport.h"
#include "SceneBuilder.h"
#include "TouchState.h"
#include "TouchTrace.h"
#include "WorkspaceFrame.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// Path of a simulated device's hand, duration of the touch, and scripted drill actions.
struct TouchScript
{
  HandPath Path;                    ///< empty: a sweep round the scene, back and forth
  double SweepDepth = 3.0;          ///< mm, of the hand's target below the first contact
  double SweepSpeed = 50.0;         ///< mm/s
  std::optional<double> Duration;   ///< s; none: as long as the path
  std::vector<DrillAction> Actions; ///< scripted drill actions, sorted by time
};

/// A scene prepared for touch, the device's placement in it, and warnings to show before forces
/// start.
struct PreparedTouch
{
  SceneSettings Settings;                 ///< with resolved labels
  std::vector<BuiltStructure> Structures; ///< touched ones, in the scene's order
  std::shared_ptr<const TouchScene> Scene;
  std::shared_ptr<DrillContext> Drill; ///< null: nothing is drilled
  std::vector<DrillAction> Actions;    ///< scripted drill actions
  HandPath Path;                       ///< empty for a device with its own hand
  bool IsSweep = false;                ///< the path is followed back and forth until Duration
  double SweepDepth = 0.0;             ///< mm, as in the script
  double Duration = 0.0;               ///< s
  bool IsRealTimeOnly = false;         ///< hardware cannot run in virtual time
  WorkspaceFrame Frame;                ///< placement of the device in the scene
  std::vector<std::string> Warnings;
  std::vector<std::string> LeftOut; ///< see BuiltScene
};

/// Removed volumes at a time.
struct DrillMoment
{
  double Time = 0.0;           ///< s
  std::vector<double> Volumes; ///< mm^3, of each drill site
};

struct TouchResult
{
  TouchTrace Trace;
  PeriodStatistics Durations; ///< of ticks; its misses are late ticks
  PeriodStatistics Periods;   ///< from tick to tick; its misses are skipped ticks
  std::uint64_t Ticks = 0;
  std::uint64_t BehindTicks = 0;         ///< their work ended before a proxy reached its place
  std::uint64_t LostTicks = 0;           ///< executed but missing in the trace
  std::vector<double> TouchedSeconds;    ///< by structure, the one touched most deeply
  double BeyondLinearSeconds = 0.0;      ///< of them, beyond linear elasticity
  double LeastEnergy = 0.0;              ///< N mm, smallest energy absorbed by contacts so far
  SafetyFault Fault = SafetyFault::None; ///< the first one; rather one that lasts
  bool HasResumed = false;               ///< the fault ended by itself (SafetyReport::WillResume)
  std::vector<double> RemovedVolumes;    ///< mm^3, of each drill site
  std::vector<DrillMoment> Removal;      ///< over time, a few hundred samples
  std::uint64_t DrillOrders = 0;         ///< cuts and commands
  std::vector<DrillApproach> Approaches; ///< to forbidden structures
  std::string DrillProblem;              ///< why drilling is incomplete; may be empty
  std::string DeviceProblem;             ///< may be empty
  std::string RecordingProblem; ///< why the recording is incomplete, and what is kept; may be empty
  std::string SweepNote;        ///< on a sweep that ran much deeper than it should; may be empty
  std::string ThreadAdvice; ///< why the requested priority was not granted; empty in virtual time
};

/// Reads and makes everything that a touch needs. Throws InputError, FilterError, Cancelled.
PALPATESCENE_EXPORT PreparedTouch PrepareTouch(const SceneSettings& settings,
                                               const TouchScript& script,
                                               const ProgressFunction& progress,
                                               BadMasks badMasks = BadMasks::Refuse);

/// Tells the user what to do now, such as during homing.
using TouchGuide = std::function<void(const std::string& message)>;

/// Looks at the newest tick of a touch that runs.
using TouchWatcher = std::function<void(const TouchState& newest)>;

/// Settings of a run.
struct TouchRunSettings
{
  bool IsVirtual = true; ///< if the device allows it: as fast as ticks are computed; else at the
                         ///< rate, on a thread
  std::filesystem::path Recording; ///< of the session; empty: none
  TouchGuide Guide;                ///< may be empty
  TouchWatcher Watcher;            ///< in real time, 50 times a second; may be empty
  Clock* Time = nullptr;           ///< in real time; null: the machine's clock
};

/// Runs a touch for `touch.Duration`, starting when the device is homed. Ends early, with the
/// result so far, if `progress` returns false. A recording that ends early because a disk is full
/// or stalls does not end the touch. Throws std::runtime_error if the device cannot be opened, and
/// InputError if the recording cannot be started. Memory does not depend on the duration.
PALPATESCENE_EXPORT TouchResult RunTouch(const PreparedTouch& touch,
                                         const TouchRunSettings& settings,
                                         const ProgressFunction& progress);

/// Comparison of a replayed session with its recording.
struct TouchComparison
{
  std::uint64_t Ticks = 0;
  std::uint64_t DifferentTicks = 0; ///< in any bit
  double LargestDifference = 0.0;   ///< N, between forces
};

/// Replays a recorded session, including its drilling. Throws InputError if the file is not a
/// recording.
PALPATESCENE_EXPORT TouchComparison CompareTouch(const PreparedTouch& touch,
                                                 const std::filesystem::path& recording);
} // namespace palpate
