#include "ShapeMirror.h"

#include <cstddef>
#include <vector>

namespace palpate
{
namespace
{
std::vector<double> Mirrored(std::vector<double> coefficients, int degree, double sign)
{
  std::size_t k = 0;
  for (int l = 0; l <= degree; ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      coefficients[k++] *= sign * MirrorSign(m);
    }
  }
  return coefficients;
}
} // namespace

OrganModel MirrorShape(const OrganModel& shape)
{
  const int degree = DegreeOf(shape);
  if (const auto* radial = std::get_if<RadialModel>(&shape))
  {
    const Vector3& center = radial->CenterWorld();
    return RadialModel(degree, Mirrored(radial->Coefficients(), degree, 1.0),
                       Vector3(-center[0], center[1], center[2]));
  }
  const auto& surface = std::get<SurfaceModel>(shape);
  return SurfaceModel(degree, {Mirrored(surface.Coefficients(0), degree, -1.0),
                               Mirrored(surface.Coefficients(1), degree, 1.0),
                               Mirrored(surface.Coefficients(2), degree, 1.0)});
}
} // namespace palpate
