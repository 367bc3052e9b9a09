#include "DrillWorker.h"

#include <chrono>
#include <utility>

namespace palpate
{
namespace
{
// Orders come every fourth tick; this is the largest delay of a version.
constexpr auto Period = std::chrono::milliseconds(1);
} // namespace

void DrillWorker::Start(std::shared_ptr<DrillEditor> editor)
{
  this->Editor = std::move(editor);
  if (this->Editor != nullptr)
  {
    this->IsOver = false;
    this->Worker = std::thread([this] { this->Run(); });
  }
}

void DrillWorker::Run()
{
  while (!this->IsOver.load(std::memory_order_relaxed))
  {
    if (!this->Editor->Take())
    {
      std::this_thread::sleep_for(Period);
    }
  }
}

void DrillWorker::Stop()
{
  this->IsOver = true;
  if (this->Worker.joinable())
  {
    this->Worker.join();
    this->Editor->Take();
  }
  this->Editor.reset();
}
} // namespace palpate
