#pragma once

#include "ContactTracker.h"
#include "SharedProxy.h"

#include <cstdint>
#include <memory>
#include <utility>

namespace palpate
{
/// A tool of several balls at one structure alone. Each call follows the pose to the end, however
/// many steps that takes: not for a servo's thread.
class SoleTracker final : public ContactTracker
{
public:
  SoleTracker(const ToolSkeleton& tool, std::unique_ptr<ToolGaps> gaps)
      : Proxy(tool, tool.Gyration())
  {
    this->Proxy.Add(std::move(gaps));
  }

  const Contact& Follow(const ToolPose& pose) noexcept override
  {
    constexpr int MostTicks = 200;
    if (!this->IsKnown)
    {
      this->Proxy.Begin(pose, &Only, 1);
      this->IsKnown = true;
    }
    int ticks = 0;
    do
    {
      this->Proxy.Follow(pose, &Only, 1);
    } while (this->Proxy.ShareOf(Only).IsBehind && ++ticks < MostTicks);
    return this->Proxy.ShareOf(Only);
  }
  void Release() noexcept override { this->IsKnown = false; }
  bool IsFreeAt(const ToolPose& pose) noexcept override
  {
    this->Proxy.Begin(pose, &Only, 1);
    return !this->Proxy.Passes(Only);
  }
  bool CanBeDrilled() const noexcept override { return this->Proxy.CanBeDrilled(Only); }
  void UseSolid(const FieldSolid& solid) noexcept override { this->Proxy.UseSolid(Only, solid); }

private:
  static constexpr std::uint32_t Only = 0;

  SharedProxy Proxy;
  bool IsKnown = false;
};
} // namespace palpate
