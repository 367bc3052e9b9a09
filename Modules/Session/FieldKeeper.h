#pragma once

#include "Clock.h"
#include "OnDemandField.h"
#include "PalpateSessionModule.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace palpate
{
/// Keeps at hand what the tool comes to, in a scene some of whose fields are on demand: looks where
/// the probe is, at its own pace beside the servo or when it is asked.
class PALPATESESSION_EXPORT FieldKeeper
{
public:
  using Probe = std::shared_ptr<LatestValue<PlainVector3>>;

  /// `probe` is where the servo leaves its place (TouchScene::Probe).
  FieldKeeper(std::vector<std::shared_ptr<OnDemandField>> fields, Probe probe);
  FieldKeeper(const FieldKeeper&) = delete;
  FieldKeeper& operator=(const FieldKeeper&) = delete;
  ~FieldKeeper() { this->Stop(); }

  /// One look, at a time (s) that does not pass while versions are made.
  void Look(double time);

  /// Looks on a thread of its own until Stop; `clock` has to live as long.
  void Start(const Clock& clock);
  void Stop();

  /// Ticks since it was made that had to do with a coarse field.
  std::uint64_t CoarseTicks() const;
  /// Why bricks are missing; empty where none are.
  std::string Problem() const;

private:
  std::uint64_t AllCoarseTicks() const;
  void Run(const Clock& clock);

  std::vector<std::shared_ptr<OnDemandField>> Fields;
  Probe Place;
  std::uint64_t CoarseBefore;
  std::atomic<bool> IsOver{false};
  std::thread Worker;
};
} // namespace palpate
