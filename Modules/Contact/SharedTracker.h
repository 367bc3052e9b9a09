#pragma once

#include "ContactTracker.h"
#include "SharedProxy.h"

#include <memory>
#include <utility>

namespace palpate
{
/// One structure's view of a SharedProxy, which whoever owns the scene moves before: its poses
/// count, not those that are asked for here.
class SharedTracker final : public ContactTracker
{
public:
  SharedTracker(std::shared_ptr<SharedProxy> proxy, std::size_t structure)
      : Proxy(std::move(proxy)), Structure(structure)
  {
  }

  const Contact& Follow(const ToolPose&) noexcept override
  {
    return this->Proxy->ShareOf(this->Structure);
  }
  void Release() noexcept override {}
  bool IsFreeAt(const ToolPose&) noexcept override { return !this->Proxy->Passes(this->Structure); }
  bool CanBeDrilled() const noexcept override { return this->Proxy->CanBeDrilled(this->Structure); }
  void UseSolid(const FieldSolid& solid) noexcept override
  {
    this->Proxy->UseSolid(this->Structure, solid);
  }
  /// Of the whole tool, in the last tick.
  const ToolPose& ProxyPose() const noexcept { return this->Proxy->Pose(); }
  const Vector3& CutOffset() const noexcept { return this->Proxy->CutOffset(this->Structure); }

private:
  std::shared_ptr<SharedProxy> Proxy;
  std::size_t Structure;
};
} // namespace palpate
