#pragma once

#include "OrganSoftening.h"
#include "PalpateFitModule.h"
#include "Segmentation.h"
#include "Volume.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// What a model is made of and lies on. Young's moduli in kPa.
struct SofteningSettings
{
  static constexpr double LeastSupport = 1e-3; ///< kPa/mm
  static constexpr double MostSupport = 1e5;
  /// Support times mean radius by modulus: beyond it the surface hardly gives way as a whole, so
  /// that maps of its compliance leave out 40 % and soon fail (at 215 to 280 on seven organs).
  static constexpr double MostRelativeSupport = 200.0;
  static constexpr double LeastFreeDegrees = 1.0;
  static constexpr double MostFreeDegrees = 170.0;
  static constexpr int FewestElements = 4;
  static constexpr int MostElements = 24;

  /// Structures of a segmentation with another modulus.
  struct Inclusion
  {
    std::shared_ptr<const Segmentation> Read;
    std::vector<Segment> Segments; ///< of `Read`
    double Kilopascal = 0.0;
  };

  /// Structures of a segmentation that hold the organ where they are next to it.
  struct Neighbour
  {
    static constexpr double Reach = 3.0;          ///< mm, between the organ's surface and them
    static constexpr double DefaultSupport = 1.0; ///< kPa/mm

    std::shared_ptr<const Segmentation> Read;
    std::vector<Segment> Segments;
    double KilopascalPerMillimeter = DefaultSupport;
  };

  double TissueKilopascal = 20.0;
  double PoissonRatio = 0.49;
  std::vector<Inclusion> Inclusions;          ///< later ones count where they overlap
  std::shared_ptr<const Volume> Elastography; ///< moduli in kPa; null: none

  /// Power to which contrasts with the tissue are raised, see TissueMap; 1: none.
  double Exaggeration = 1.0;

  double BedPerMillimeter = 1.0;     ///< of what the organ lies on, kPa/mm
  std::vector<Vector3> FreeSides;    ///< directions, patient LPS, in which it lies on nothing
  double FreeDegrees = 60.0;         ///< around each, half the cone's angle
  std::vector<Neighbour> Neighbours; ///< count instead of both where they are

  OrganSoftening Numbers;

  /// Fails for numbers outside the limits.
  PALPATEFIT_EXPORT Status Check() const;
  /// Fails for a support that is too stiff for the tissue of this organ; moduli of an image are not
  /// looked at.
  PALPATEFIT_EXPORT Status CheckSupportOf(const RadialModel& organ) const;
};

/// ", contrasts exaggerated to the power 2": to be said wherever the tissue is.
PALPATEFIT_EXPORT std::string ExaggerationText(double exaggeration);

/// The settings as entries of a model's provenance.
PALPATEFIT_EXPORT std::vector<std::pair<std::string, std::string>>
DescribeSettings(const SofteningSettings& settings);
} // namespace palpate
