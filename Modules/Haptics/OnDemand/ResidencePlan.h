#pragma once

#include "FieldGrid.h"
#include "FieldSurvey.h"
#include "WayAhead.h"

#include <cstddef>
#include <memory>
#include <optional>

namespace palpate
{
/// What decides how much of a field is kept round a tool.
struct ResidenceSettings
{
  double AskedReach = 0.0;      ///< mm; how far from the tool's origin the field is asked
  double PromisedSpeed = 100.0; ///< mm/s in the world, at least, that the tool may have
  double LeastDelay = 0.02;     ///< s, from a pose until what is made for it is felt
  std::size_t Room = 0;         ///< bricks that one version may have
};

/// Decides from a tool's places which bricks of a field are to be at hand: those that probe and
/// proxy can reach within the time that a version takes to be made, at its speed. Another box is
/// wanted once the tool has left the middle half of the way that it may go. Knows no clock, thread
/// or field.
class ResidencePlan
{
public:
  ResidencePlan(const FieldGrid& grid, const std::shared_ptr<const FieldSurvey>& survey,
                const ResidenceSettings& settings);

  /// The next look at the tool. A box where another one is wanted than that of the last Made.
  std::optional<BrickBox> Look(const ToolPlace& place);
  /// The last box that was wanted is at hand, so long (s) after the look that wanted it.
  void Made(double delay) noexcept { this->Ahead.Made(delay); }
  /// It could not be made: the next look wants one again.
  void Failed() { this->Middle.reset(); }

  /// How fast (mm/s) the tool may be without leaving what is at hand; infinite where all of it is.
  double KeptSpeed() const noexcept { return this->Kept; }
  double Delay() const noexcept { return this->Ahead.Delay(); }

private:
  BrickBox BoxRound(const ToolPlace& place, double way) const;

  FieldGrid Grid;
  std::shared_ptr<const FieldSurvey> Survey;
  ResidenceSettings Settings;
  WayAhead Ahead;
  std::optional<ToolPlace> Middle; // of the box that was wanted last
  double Way = 0.0;                // mm that the tool may go from there
  double WishedWay = 0.0;          // mm that it was to be able to go
  double Kept = 0.0;
};
} // namespace palpate
