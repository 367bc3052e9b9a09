#pragma once

#include "DrillEditor.h"

#include <atomic>
#include <memory>
#include <thread>

namespace palpate
{
/// Executes the orders of a live servo on a thread of its own.
class DrillWorker
{
public:
  DrillWorker() = default;
  DrillWorker(const DrillWorker&) = delete;
  DrillWorker& operator=(const DrillWorker&) = delete;
  ~DrillWorker() { this->Stop(); }

  /// No effect without an editor. A previous run must be stopped.
  void Start(std::shared_ptr<DrillEditor> editor);
  /// Returns once all orders of the servo are done.
  void Stop();

private:
  void Run();

  std::shared_ptr<DrillEditor> Editor;
  std::atomic<bool> IsOver{false};
  std::thread Worker;
};
} // namespace palpate
