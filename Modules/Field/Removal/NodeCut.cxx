#include "NodeCut.h"

namespace palpate
{
NodeCut::NodeCut(const FieldCondition& condition, double slope, double depth)
    : Iso(condition.Iso), Rise(condition.Sign() * slope), Depth(depth), Floor(Iso - Rise * depth),
      IsAtLeast(condition.Sense == FieldSense::AtLeast)
{
}
} // namespace palpate
