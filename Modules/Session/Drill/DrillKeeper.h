#pragma once

#include "DrillBench.h"
#include "PalpateSessionModule.h"

#include <atomic>
#include <memory>
#include <thread>

namespace palpate
{
/// Lets a bench's editor do what a live servo orders, on a thread of its own.
class PALPATESESSION_EXPORT DrillKeeper
{
public:
  /// Nothing where there is no bench.
  explicit DrillKeeper(std::shared_ptr<DrillBench> bench);
  DrillKeeper(const DrillKeeper&) = delete;
  DrillKeeper& operator=(const DrillKeeper&) = delete;
  ~DrillKeeper() { this->Stop(); }

  void Start();
  /// Returns once all orders are done that the servo has given.
  void Stop();

private:
  void Run();

  std::shared_ptr<DrillBench> Bench;
  std::atomic<bool> IsOver{false};
  std::thread Worker;
};
} // namespace palpate
