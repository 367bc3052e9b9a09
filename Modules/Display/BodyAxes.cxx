#include "BodyAxes.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
BodyAxes::BodyAxes(const ImageAxes& image)
{
  std::array<int, 3> order{{0, 1, 2}};
  double bestSum = -1.0;
  do
  {
    double sum = 0.0;
    for (int part = 0; part < 3; ++part)
    {
      sum += std::abs(image.UnitWorld[order[part]][part]);
    }
    if (sum > bestSum)
    {
      bestSum = sum;
      this->Axis = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  for (int part = 0; part < 3; ++part)
  {
    this->Sign[part] = image.UnitWorld[this->Axis[part]][part] < 0.0 ? -1.0 : 1.0;
  }
}

Vector3 BodyAxes::NearestWorld(const ImageAxes& image, const Vector3& bodyDirectionWorld) const
{
  int part = 0;
  bodyDirectionWorld.cwiseAbs().maxCoeff(&part);
  const double side = bodyDirectionWorld[part] < 0.0 ? -1.0 : 1.0;
  return side * this->Sign[part] * image.UnitWorld[this->Axis[part]];
}
} // namespace palpate
