#include "PalpatingHand.h"

#include "ForcePerception.h"

namespace palpate::test
{
PalpatingHand::PalpatingHand(const ElasticPhantom& phantom, std::uint64_t seed)
    : Phantom(&phantom), Random(seed)
{
}

double PalpatingHand::Press(const FreePlace& place)
{
  // One after the other: the order in which arguments are evaluated is not defined.
  const double across = this->Error(PlaceDeviation);
  const double along = this->Error(PlaceDeviation);
  const double deeper = this->Error(DepthDeviation);
  const double force = this->Phantom->Force(place + FreePlace(across, along), Depth + deeper);
  return force + this->Error(PerceptDeviation * ForcePerception::JustNoticeable(force));
}
} // namespace palpate::test
