#pragma once

#include "ModelDocument.h"

#include <optional>
#include <string>
#include <vector>

namespace palpate::cli
{
/// What `palpate evaluate` prints about a model. Lengths mm, points patient LPS. Values that need a
/// centre are absent for a surface model.
struct ModelEvaluation
{
  struct DirectionSample
  {
    Vector3 Direction;               ///< unit vector; of a surface model, its parameter
    std::optional<double> Radius;    ///< mm
    std::optional<Vector3> Gradient; ///< of the radius on the unit sphere, mm/rad
    Vector3 PointWorld;              ///< mm
    Vector3 Normal;                  ///< unit, outward
  };
  struct PointSample
  {
    Vector3 PointWorld;           ///< mm
    bool Inside;                  ///< on the surface counts as inside
    double Distance;              ///< mm from the surface, negative inside; of a radial model along
                                  ///< the ray from the centre, else to the nearest point
    std::optional<double> Radius; ///< mm, of a radial model along that ray
  };

  std::string File;
  bool IsRadial = false;
  bool InsideOut = false; ///< a surface model whose parameter sphere is turned outside in
  int Degree = 0;
  std::optional<Vector3> CenterWorld;
  double Volume = 0.0;       ///< mm^3
  double Area = 0.0;         ///< mm^2
  std::vector<double> Power; ///< mm^2 of each degree; of the three coordinates together
  std::vector<DirectionSample> Directions;
  std::vector<PointSample> Points;
};

/// Evaluates a model along unit directions and at points (mm, patient LPS); a point at the centre
/// is evaluated along +z. Of a surface model, a point is inside where the winding number is
/// not 0. Throws InputError for points at a surface that encloses nothing.
ModelEvaluation EvaluateModel(const std::string& file, const OrganModel& surface,
                              const std::vector<Vector3>& directions,
                              const std::vector<Vector3>& pointsWorld);
} // namespace palpate::cli
