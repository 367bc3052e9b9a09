#pragma once

#include "MainWindow.h"
#include "PeriodStatistics.h"
#include "SteadyClock.h"
#include "TemporaryFolder.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace palpate::bench
{
/// Statistics of servo and views for some seconds of one window activity.
struct WindowStretch
{
  std::string Name;
  double Seconds = 0.0;
  PeriodStatistics Periods;   ///< ns from tick to tick
  PeriodStatistics Durations; ///< ns that ticks took
  std::uint64_t Ticks = 0;
  std::uint64_t Touching = 0; ///< number of them in contact
  std::uint64_t Missed = 0;   ///< ticks skipped
  std::uint64_t Faults = 0;   ///< times the safety chain switched forces off
  std::vector<int> Images;    ///< frames of each view: axial, coronal, sagittal, 3D
  int Events = 0;             ///< number of times that the window performed the activity
};

/// Time to close during some activity.
struct WindowClosing
{
  std::string While;
  double Milliseconds = 0.0;
  bool HasEnded = false; ///< no work was left running
};

/// A window of 1280 x 800 on the Colin 27 head, a simulated hand that strokes one of its
/// structures, in real time. Needs an application and a display.
class WindowMeasures
{
public:
  /// Each stretch lasts `seconds`. Throws std::runtime_error if the head is not installed.
  explicit WindowMeasures(double seconds);
  ~WindowMeasures();
  WindowMeasures(const WindowMeasures&) = delete;
  WindowMeasures& operator=(const WindowMeasures&) = delete;

  /// The servo while the window is hidden, draws, is resized, loads a volume, and refits.
  std::vector<WindowStretch> Stretches();
  /// Four views in contact, with one volume and with a second one blended over it, in turns, so
  /// that both are measured under the same load: two stretches. Throws std::runtime_error if the
  /// second volume is not shown.
  std::vector<WindowStretch> Blending();
  /// Each with a separate window.
  static std::vector<WindowClosing> Closings();

private:
  using Act = std::function<void(WindowStretch&, double seconds)>;

  void Settle();
  void MakePath();
  void StartTouch();
  void TakeTicks();
  void ShowSecondVolume(bool isShown);
  std::filesystem::path NewCopy(int number) const;
  WindowStretch Measure(const std::string& name, const Act& act);
  WindowStretch Measure(const std::string& name, const Act& act, double seconds);

  double Length;
  test::TemporaryFolder Copies;
  SteadyClock Time;
  std::unique_ptr<StudyController> Study;
  std::unique_ptr<MainWindow> Window;
  std::vector<Vector3> Path; ///< mm, a little inside the structure
  WindowStretch* Taking = nullptr;
  std::int64_t LastTick = -1; ///< ns
  bool WasFaulty = false;
};
} // namespace palpate::bench
