#pragma once

#include "StripChart.h"
#include "StudyController.h"

#include <QWidget>

namespace palpate
{
/// Force, penetration, and the time and period of the servo's ticks, over the last seconds and with
/// their limits.
class PlotsPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the address.
  explicit PlotsPanel(StudyController& study, QWidget* parent = nullptr);

  const StripChart& Force() const { return *this->ForceChart; }
  const StripChart& Period() const { return *this->PeriodChart; }

private:
  void Begin();
  void BeginReplay();
  void Clear();
  void SetLimits(double force, double rate);
  void TakeTicks();
  void AddDuration(const PeriodStatistics& durations);

  StudyController& Study;
  StripChart* ForceChart;
  StripChart* DepthChart;
  StripChart* DurationChart;
  StripChart* PeriodChart;
  double LastStarted = -1.0;    ///< s, of the previous tick
  std::uint64_t LastNumber = 0; ///< its number
  std::filesystem::path Replayed;
  struct
  {
    double Count = 0.0;
    double Sum = 0.0; ///< ns
  } LastDurations;    ///< of the reading before
};
} // namespace palpate
