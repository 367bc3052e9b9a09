#include "DrillKeeper.h"

#include <chrono>
#include <utility>

namespace palpate
{
namespace
{
// Orders come every fourth tick; so long a version may be late beside.
constexpr auto Period = std::chrono::milliseconds(1);
} // namespace

DrillKeeper::DrillKeeper(std::shared_ptr<DrillBench> bench) : Bench(std::move(bench)) {}

void DrillKeeper::Start()
{
  if (this->Bench != nullptr && !this->Worker.joinable())
  {
    this->IsOver = false;
    this->Worker = std::thread([this] { this->Run(); });
  }
}

void DrillKeeper::Run()
{
  while (!this->IsOver.load(std::memory_order_relaxed))
  {
    if (!this->Bench->Editor().Take())
    {
      std::this_thread::sleep_for(Period);
    }
  }
}

void DrillKeeper::Stop()
{
  this->IsOver = true;
  if (this->Worker.joinable())
  {
    this->Worker.join();
    this->Bench->Editor().Take();
  }
}
} // namespace palpate
