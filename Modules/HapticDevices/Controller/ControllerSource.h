#pragma once

#include "ControllerRumble.h"
#include "LatestValue.h"
#include "SdlLibrary.h"
#include "SteeringSource.h"

#include <atomic>
#include <future>
#include <thread>

namespace palpate
{
/// A game controller by SDL 2. The left stick pushes to the sides and up and down, the triggers
/// away from the person (right) and towards (left); the right stick turns about the vertical and
/// the sideward axis, the shoulder buttons about the third. Its motors tell what is touched. A
/// thread of its own talks to SDL.
class ControllerSource final : public SteeringSource
{
public:
  /// From 1, in the order in which `palpate devices` lists them.
  explicit ControllerSource(int number) : Number(number) {}
  ~ControllerSource() override { this->ControllerSource::Close(); }

  std::string Name() const override { return "Game controller"; }
  int Buttons() const override { return SdlLibrary::ButtonCount; }
  std::string Problem() const override;
  Status Open() override;
  void Close() noexcept override;
  bool Read(SteeringInput& input) noexcept override;
  void Show(const TouchState& state) noexcept override;

private:
  void Run(std::promise<Status>& opened);
  void Poll(void* controller);
  SteeringInput Ask(void* controller) const noexcept;

  int Number;
  std::shared_ptr<const SdlLibrary> Sdl;
  std::atomic<bool> MustEnd{false};
  std::atomic<bool> IsThere{false};
  LatestValue<SteeringInput> Newest;    // to the servo
  LatestValue<ControllerRumble> Wanted; // from the servo
  TouchCues Cues;                       // servo thread
  std::thread Thread;
};
} // namespace palpate
