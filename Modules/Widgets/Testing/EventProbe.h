#pragma once

#include <QObject>
#include <QTimer>

#include <algorithm>
#include <ctime>

namespace palpate::test
{
/// Measures how long the event loop of this thread is kept: a timer of 20 ms notes the processor
/// time that the thread has used since it last fired. That is at least what any event in between
/// has used. Processor time, since other programs may keep a thread from running for long; waiting
/// for a lock or a disk is not seen.
class EventProbe : public QObject
{
public:
  /// Nobody should wait longer for an answer of the window.
  static constexpr double MostMilliseconds = 200.0;

  EventProbe()
  {
    constexpr int Period = 20; // ms
    this->Timer.setTimerType(Qt::PreciseTimer);
    connect(&this->Timer, &QTimer::timeout, this, [this] { this->Look(); });
    this->Timer.start(Period);
  }
  /// Until now.
  double WorstMilliseconds()
  {
    this->Look();
    return this->Worst;
  }

private:
  static double Used()
  {
    timespec used{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
    return 1e3 * static_cast<double>(used.tv_sec) + 1e-6 * static_cast<double>(used.tv_nsec);
  }
  void Look()
  {
    const double now = Used();
    this->Worst = std::max(this->Worst, now - this->Last);
    this->Last = now;
  }

  QTimer Timer;
  double Last = Used();
  double Worst = 0.0;
};
} // namespace palpate::test
