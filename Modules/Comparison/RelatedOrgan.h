#pragma once

#include "Calibre.h"
#include "ComparedFile.h"
#include "LocalThickness.h"
#include "PalpateComparisonModule.h"
#include "RelatedBody.h"
#include "Segmentation.h"
#include "ShapeFeatures.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// The surface of a mask that is measured. Surfaces and models are what they are.
enum class MaskMesh
{
  SubVoxel, ///< the shape that its voxels were drawn from (ComparedBody::OfMaskShape)
  Ibsi      ///< half way between voxel centres, as the Image Biomarker Standardisation Initiative
};

/// What is measured of each organ, and how.
struct OrganMeasures
{
  MaskMesh Mesh = MaskMesh::SubVoxel;
  ThicknessRule Thickness = ThicknessRule::Spheres;
  bool Calibre = false; ///< also along the axes of tubes
  /// Where the border of an image cuts an organ counts as its surface.
  bool KeepCuts = false;
};

/// One of several organs that are related, with what describes it alone.
struct RelatedOrgan
{
  struct Thickness
  {
    /// mm, over the area of its own surface where there is a thickness.
    double Mean = std::numeric_limits<double>::quiet_NaN();
    double Percentile5 = Mean;
    double Median = Mean;
    double Percentile95 = Mean;
  };

  /// Distances (mm, negative inside, NaN beyond the reach) of the points of Body from another
  /// organ.
  struct PairMap
  {
    std::size_t Other; ///< its number in the list of organs
    std::vector<float> Distances;
  };

  std::filesystem::path File;
  Segment Structure;              ///< label 0 of a surface or a model
  std::string Kind;               ///< of the file: "segmentation", "surface" or "model"
  std::string Name;               ///< for people; different for each organ
  std::string Message;            ///< why it is not measured; empty if it is
  std::vector<std::string> Notes; ///< what is not as the caller may think
  bool IsCut = false;             ///< its mask ends at the border of the image
  double CutArea = 0.0;           ///< mm^2 of its surface that is such an end
  double Milliliters = std::numeric_limits<double>::quiet_NaN(); ///< of a mask's voxels
  std::shared_ptr<const RelatedBody> Body;                       ///< null if it is not measured
  std::vector<ShapeFeature> Features;
  Thickness Thick;
  ///@{ At the points of Body: thickness; the least distance from any other organ (negative inside
  /// it), and its number in the list of organs, -1 beyond the reach.
  std::vector<double> ThicknessMap;
  std::vector<double> DistanceMap;
  std::vector<double> NeighbourMap;
  ///@}
  std::vector<PairMap> PairMaps; ///< of the organs within the reach
  Calibre Tube;                  ///< without sections if it is none, or not asked for
  std::string TubeMessage;       ///< why it is none

  bool IsMeasured() const { return this->Body != nullptr; }
};

/// A structure of a file, measured; problems of it are in Message and Notes.
PALPATECOMPARISON_EXPORT RelatedOrgan MeasureOrgan(const ComparedFile& file,
                                                   const Segment& structure,
                                                   const OrganMeasures& measures);

/// A surface without a file (world mm, patient LPS).
struct NamedSurface
{
  std::string Name;
  std::array<double, 3> Color{}; ///< red, green, blue in 0..1
  IndexedMesh Mesh;
};
PALPATECOMPARISON_EXPORT RelatedOrgan MeasureOrgan(const NamedSurface& surface,
                                                   const OrganMeasures& measures);
} // namespace palpate
