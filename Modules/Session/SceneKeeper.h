#pragma once

#include "Clock.h"
#include "OnDemandDegrees.h"
#include "OnDemandField.h"
#include "PalpateSessionModule.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace palpate
{
/// What of a scene is in memory only where the tool goes.
struct OnDemandParts
{
  std::vector<std::shared_ptr<OnDemandField>> Fields;
  std::shared_ptr<OnDemandDegrees> Degrees; ///< none where all harmonics stay

  bool IsEmpty() const { return this->Fields.empty() && this->Degrees == nullptr; }
};

/// Keeps at hand what the tool comes to, in a scene some of which is on demand: looks where the
/// probe is, at its own pace beside the servo or when it is asked.
class PALPATESESSION_EXPORT SceneKeeper
{
public:
  using Probe = std::shared_ptr<LatestValue<PlainVector3>>;

  /// `probe` is where the servo leaves its place (TouchScene::Probe). Harmonics begin with nothing
  /// at hand but what somebody holds.
  SceneKeeper(OnDemandParts parts, Probe probe);
  SceneKeeper(const SceneKeeper&) = delete;
  SceneKeeper& operator=(const SceneKeeper&) = delete;
  ~SceneKeeper() { this->Stop(); }

  /// One look, at a time (s) that does not pass while things are made.
  void Look(double time);
  /// The same where the tool is about to begin (mm, world).
  void LookAt(const Vector3& placeWorld, double time);

  /// Looks on a thread of its own until Stop; `clock` has to live as long.
  void Start(const Clock& clock);
  void Stop();

  /// Ticks since it was made that had to do with a coarse field or body.
  std::uint64_t CoarseTicks() const;
  /// Why something is missing; empty where nothing is.
  std::string Problem() const;

private:
  using PlaceNow = std::function<Vector3()>;
  using SecondsNow = std::function<double()>;
  std::uint64_t AllCoarseTicks() const;
  void Run(const Clock& clock);
  void LookAll(const PlaceNow& place, const SecondsNow& begun, const SecondsNow& made);

  OnDemandParts Parts;
  Probe Place;
  std::uint64_t CoarseBefore;
  std::atomic<bool> IsOver{false};
  std::thread Worker;
};
} // namespace palpate
