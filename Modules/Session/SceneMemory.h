#pragma once

#include "OnDemandField.h"
#include "TouchContact.h"
#include "TouchStructures.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// A scene's fields within a budget: of those that are touched and not drawn, only what is round
/// the tool stays in memory.
class SceneMemory
{
public:
  /// Without a number nothing is bounded. Megabytes are a million bytes.
  SceneMemory(const std::optional<double>& megabytes, const ToolShape& tool);

  bool IsBounded() const { return this->Budget.has_value(); }
  /// A field that is only felt, to be felt on demand. What cannot be so is felt whole, and says
  /// why. Throws InputError and FilterError.
  TouchContact Take(const std::shared_ptr<const ScalarField>& field,
                    const std::filesystem::path& file);
  /// Once all are there: gives each as much of what the budget leaves as it is large, and says so
  /// in the account. Throws InputError where the budget is too small.
  void Share(TouchStructures& made) const;

private:
  void GivePools() const;

  std::optional<std::size_t> Budget; // bytes
  ToolShape Tool;
  std::vector<std::shared_ptr<OnDemandField>> Fields;
  std::size_t Kept = 0;  // bytes of what is there for all bricks
  std::size_t Pools = 0; // bytes of all bricks
};
} // namespace palpate
