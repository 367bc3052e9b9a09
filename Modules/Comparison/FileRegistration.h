#pragma once

#include "ComparedFile.h"
#include "ImageRegistration.h"
#include "LandmarkRegistration.h"
#include "PalpateComparisonModule.h"
#include "Progress.h"
#include "SurfaceRegistration.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// Points (mm, patient LPS) with names, which may be empty: landmarks, or places that were touched.
struct NamedPoints
{
  std::vector<std::string> Names;
  std::vector<Vector3> Points;
};

/// One of two that are registered: points, or else a file with bodies.
struct RegisteredSide
{
  std::filesystem::path File;
  std::optional<NamedPoints> Points;
};

struct FileRegistrationSettings
{
  bool IsOfImages = false; ///< both sides are images, which are matched by their values
  RegistrationKind Kind = RegistrationKind::Rigid;
  double Noise = 0.0;                   ///< of points, mm; 0: judged by what remains
  std::optional<Eigen::Affine3d> Start; ///< of the moving side (mm); else one of:
  bool StartsAtCentroids = true;        ///< of bodies and of images' boxes; false: as they lie
  std::string Label;                    ///< of a segmentation; empty if it has one structure
  std::string FixedLabel;               ///< of the fixed one, if it is another
  VolumeChoice Images;
  ///@{ Pairs of landmarks to start from, besides bodies; both or none.
  std::optional<NamedPoints> MovingLandmarks;
  std::optional<NamedPoints> FixedLandmarks;
  ///@}
};

/// Where a moving side belongs.
struct FileRegistration
{
  Eigen::Affine3d Map = Eigen::Affine3d::Identity(); ///< of the moving side (mm)
  double Turn = 0.0;                                 ///< rad
  Vector3 Shift = Vector3::Zero();                   ///< of the moving side's middle, mm
  double Size = 1.0;                                 ///< cube root of the determinant
  PredictedPoseError Error;                          ///< but of affine maps
  std::optional<LandmarkRegistration> Landmarks;
  std::vector<std::string> LandmarkNames; ///< of the pairs
  std::optional<SurfaceRegistration> Surface;
  std::optional<ImageRegistration> Images;
  std::size_t PointCount = 0; ///< that were brought onto the surface
  std::vector<std::string> Notes;
};

/// Two lists of points by the names of their pairs, if all of the first have different names that
/// the second has, else by the order. Throws InputError for lists of different lengths then.
void PairPoints(const NamedPoints& moving, const NamedPoints& fixed, NamedPoints& pairedMoving,
                NamedPoints& pairedFixed);

/// Brings points onto their partners, points onto a body, or a body onto another one (by points of
/// its surface); of a body and points, the points onto the body, whose inverse it is; or an image
/// onto another one. Landmarks onto landmarks need no start. Throws InputError and Cancelled.
PALPATECOMPARISON_EXPORT FileRegistration RegisterFiles(const RegisteredSide& moving,
                                                        const RegisteredSide& fixed,
                                                        const FileRegistrationSettings& settings,
                                                        const ProgressFunction& progress);
} // namespace palpate
