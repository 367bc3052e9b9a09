#pragma once

#include "PalpateFiltersModule.h"
#include "RadialModel.h"
#include "Status.h"
#include "Vector3.h"

namespace palpate
{
/// A ball-shaped nodule in a phantom's body.
struct PhantomNodule
{
  Vector3 Offset = Vector3::Zero(); ///< of its centre from the body's, mm, patient LPS
  double Radius = 0.0;              ///< mm

  /// Whether a point, relative to the body's centre (mm), lies in the ball or on its surface.
  bool Contains(const Vector3& offset) const
  {
    return (offset - this->Offset).squaredNorm() <= this->Radius * this->Radius;
  }
  /// Distance (mm) of such a point from the ball's surface, negative inside.
  double SignedDistance(const Vector3& offset) const
  {
    return (offset - this->Offset).norm() - this->Radius;
  }

  /// Places a nodule of `diameter` mm under the posterior surface (+y, patient LPS), where a finger
  /// palpates a prostate: under the surface's point behind the body's centre, along the normal
  /// there, with its top `depth` mm below the surface. Fails, with the reason, if the diameter is
  /// not positive, the depth negative, or the ball not inside the body; allocates.
  PALPATEFILTERS_EXPORT static Status Place(const RadialModel& body, double diameter, double depth,
                                            PhantomNodule& nodule);
};
} // namespace palpate
