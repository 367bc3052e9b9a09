#pragma once

#include "Clock.h"
#include "DrillBench.h"
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
/// How the hand of a simulated device moves, for how long a scene is touched, and whether somebody
/// looks.
struct TouchScript
{
  HandPath Path;                    ///< empty: a sweep round the scene, to and fro
  double SweepDepth = 3.0;          ///< mm, of the hand's target below the first touch
  double SweepSpeed = 50.0;         ///< mm/s
  std::optional<double> Duration;   ///< s; none: as long as the path
  std::vector<DrillAction> Actions; ///< of who drills, in the order of time
  bool IsSeen = false;              ///< then what the scene has to be seen is made too
};

/// A scene, a device's place in it, and what a person should know before forces start.
struct PreparedTouch
{
  SceneSettings Settings;                 ///< with its labels resolved
  std::vector<BuiltStructure> Structures; ///< to be touched, as in the scene
  std::vector<BuiltStructure> OnlyDisplayed;
  std::shared_ptr<const TouchScene> Scene;
  std::shared_ptr<DrillBench> Drill; ///< none: nothing is drilled
  std::vector<DrillAction> Actions;  ///< of who drills
  HandPath Path;                     ///< empty for a device with a hand of its own
  bool IsSweep = false;              ///< then the path is gone to and fro, for as long as it takes
  double Duration = 0.0;             ///< s
  bool IsRealTimeOnly = false;       ///< the device is plugged in and has no other time
  WorkspaceFrame Frame;              ///< the device's place in the scene
  std::vector<std::string> Warnings;
};

/// What was gone at a time.
struct DrillMoment
{
  double Time = 0.0;           ///< s
  std::vector<double> Volumes; ///< mm^3, of each of the bench's sites
};

struct TouchResult
{
  TouchTrace Trace;
  PeriodStatistics Durations; ///< of ticks; its misses are late ones
  PeriodStatistics Periods;   ///< from tick to tick; its misses are those that were left out
  PeriodStatistics Frames;    ///< that each picture of a view took
  double FramesPerSecond = 0.0;
  double MebibytesAtStart = 0.0; ///< resident, a second after the first tick (a shorter touch: at
                                 ///< its end); 0 where not known
  double MebibytesAtEnd = 0.0;
  std::uint64_t Ticks = 0;
  std::uint64_t LostTicks = 0;        ///< that the trace has not, though they ran
  std::vector<double> TouchedSeconds; ///< by structure, the one touched most deeply
  double LeastEnergy = 0.0;           ///< N mm that contacts had taken in, at the lowest
  SafetyFault Fault = SafetyFault::None;
  std::vector<double> RemovedVolumes;    ///< mm^3, of each of the bench's sites
  std::vector<DrillMoment> Removal;      ///< over time, some hundred moments
  std::uint64_t DrillOrders = 0;         ///< cuts and commands
  std::vector<DrillApproach> Approaches; ///< to what is forbidden
  std::string DrillProblem;              ///< why not all was removed; empty without
  std::string DeviceProblem;             ///< empty without
  std::string RecordingProblem;          ///< why not all was recorded, and what is; empty without
  std::string ThreadAdvice; ///< why the thread has not what it asked for; empty in virtual time
};

/// Reads and makes everything, so that forces could start. Throws InputError, FilterError,
/// Cancelled.
PALPATESCENE_EXPORT PreparedTouch PrepareTouch(const SceneSettings& settings,
                                               const TouchScript& script,
                                               const ProgressFunction& progress);

/// Draws a picture of the newest tick, `time` (s) after the first.
using TouchViewer = std::function<void(double time, const TouchState& newest)>;

/// Tells the person at the device what to do now, as while it is homed.
using TouchGuide = std::function<void(const std::string& sentence)>;

/// How a scene is touched.
struct TouchRunSettings
{
  bool IsVirtual = true; ///< where the device allows it; as fast as ticks are computed; else at the
                         ///< rate, on a thread
  std::filesystem::path Recording; ///< of the session; empty for none
  TouchViewer View;                ///< drawn again and again beside the servo; not in virtual time
  TouchGuide Guide;                ///< none: nobody is told
  Clock* Time = nullptr;           ///< of a touch that is not virtual; none: the machine's
};

/// Touches, for `touch.Duration` from when the device is homed. Ends early, with what there is
/// until then, where `progress` answers false. A recording that ends before the touch, since a disk
/// is full or stalls, does not end the touch. Throws std::runtime_error where the device does not
/// open, and InputError where the recording cannot begin. The memory it takes does not depend on
/// the duration.
PALPATESCENE_EXPORT TouchResult RunTouch(const PreparedTouch& touch,
                                         const TouchRunSettings& settings,
                                         const ProgressFunction& progress);

/// How what is felt again compares with what was recorded.
struct TouchComparison
{
  std::uint64_t Ticks = 0;
  std::uint64_t DifferentTicks = 0; ///< in any bit
  double LargestDifference = 0.0;   ///< N, of the forces
};

/// Feels a recorded session again, and drills again what it drilled. Throws InputError where it is
/// none.
PALPATESCENE_EXPORT TouchComparison CompareTouch(const PreparedTouch& touch,
                                                 const std::filesystem::path& recording);
} // namespace palpate
