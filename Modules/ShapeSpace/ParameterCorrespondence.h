#pragma once

#include "KernelProgress.h"
#include "OrganModel.h"
#include "ShapeSuperposition.h"
#include "Status.h"

#include <vector>

namespace palpate
{
/// A shape is flipped if another orientation is closer by this factor. Of whole prostates, which
/// are nearly round, none of 162 reaches 1.8 by chance; half a turn of the parameters of a longish
/// surface exceeds 3.
constexpr double FlippedRatio = 2.0;

/// How well the same parameter is the same place in one shape and in the others, and whether it
/// would be so in another orientation.
struct ParameterCorrespondence
{
  double Distance = 0.0; ///< from the mean of the others, RMS at equal parameters, mm
  ///@{ Orientations at least 45 degrees away from that of the shape: the closest to the others. Of
  /// surface models the parameters turn, or body and parameters do.
  SphereRotation Turn;
  bool TurnsBody = false;
  double TurnedDistance = 0.0; ///< at its optimum and best size, in degrees up to 6, mm
  double OwnDistance = 0.0;    ///< the same of the optimum at the shape's own orientation, mm
  ///@}

  /// OwnDistance over TurnedDistance: far below 1 if the orientation is sure, above 1 if another
  /// one is closer.
  double TurnRatio() const;
  /// Whether another orientation is clearly closer: TurnRatio above FlippedRatio.
  bool IsFlipped() const;
  /// The angle of Turn, rad.
  double TurnAngle() const;
};

/// Compares each of `shapes` (about the origin, of one kind and degree) with the mean of all
/// others, which are weighted as in their geometric median (Weiszfeld, Tohoku Math. J. 43, 1937),
/// so that flipped ones hardly move it. Other orientations are the optima (ShapeSuperposition) that
/// are reached from the closest of the 23 turns of a cube and of the polar factor, and of surface
/// models from half turns of the body about the frame's axes; they are looked for and compared in
/// the harmonics up to degree 6, which know a body's orientation. Fails for fewer than three
/// shapes, since one of two cannot be the turned one, and if `progress` cancels. Allocates.
Status CompareParameters(const std::vector<OrganModel>& shapes, const KernelProgress& progress,
                         std::vector<ParameterCorrespondence>& cases);

/// The upper fence of positive numbers on a logarithmic scale: the third quartile plus 1.5 times
/// the distance of the quartiles (Tukey, Exploratory Data Analysis, 1977), beyond which one of 290
/// log-normal numbers lies. Infinite for fewer than eight numbers, whose quartiles mean little.
double UpperLogFence(std::vector<double> values);
} // namespace palpate
