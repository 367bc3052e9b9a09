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
/// How harmonics are felt.
struct HarmonicForm
{
  HarmonicContactMode Mode = HarmonicContactMode::Nearest;
  EvaluationPrecision Precision = EvaluationPrecision::Double;
};

/// What a scene is felt by within a budget: of fields that are touched and not drawn only the
/// bricks round the tool stay in memory, of harmonics the models near it.
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
  /// The same of harmonics, drawn or not.
  TouchContact Take(const SphericalHarmonicModel& model, const HarmonicForm& form,
                    const std::filesystem::path& file);
  /// Once all are there: gives each kind as much of what the budget leaves as it is large, and says
  /// so in the account. Throws InputError where the budget is too small.
  void Share(TouchStructures& made) const;

private:
  std::size_t RoomOfHarmonics() const;
  void GivePools(std::size_t bytes) const;
  void SayWhatIsInMemory(TouchStructures& made) const;

  std::optional<std::size_t> Budget; // bytes
  ToolShape Tool;
  std::vector<std::shared_ptr<OnDemandField>> Fields;
  std::vector<std::shared_ptr<OnDemandHarmonics>> Harmonics;
  std::size_t Kept = 0;    // bytes of what is there for all bricks and degrees
  std::size_t Pools = 0;   // bytes of all bricks
  std::size_t AtHand = 0;  // bytes of all harmonics at once
  std::size_t Largest = 0; // of one of them
};
} // namespace palpate
