#include "ElasticForce.h"

#include "ElasticPatch.h"

namespace palpate
{
ElasticForce ElasticForce::Of(const ComplianceAtlas& atlas, const RadialModel& model,
                              const Vector3& direction, double depth, double ballRadius,
                              double start) noexcept
{
  if (!(depth > 0.0))
  {
    return ElasticForce();
  }
  ElasticPatch patch(atlas, model, direction, depth, ballRadius);
  patch.Press(depth, start);
  return patch.Force();
}
} // namespace palpate
