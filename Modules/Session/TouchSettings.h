#pragma once

#include "DrillForce.h"
#include "FieldBuilder.h"
#include "HarmonicContactModel.h"
#include "SurfaceFriction.h"
#include "ToolShape.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
class SurfaceTool;

/// By what a structure is touched.
enum class TouchRepresentation
{
  Automatic, ///< a model by harmonics, a surface by facets, voxels by the sub-voxel field
  Harmonics,
  Facets,
  SubVoxel
};

/// Whether a drill removes anything of a structure.
inline bool GivesWayToDrill(bool isTouched, bool isForbidden, const DrillLaw& law) noexcept
{
  return isTouched && !isForbidden && law.Wear > 0.0;
}

/// One file's share in a scene to touch. Every structure that the file and the labels name becomes
/// one of its own.
struct TouchStructureSettings
{
  std::string Name;                ///< empty: the file's and the label's
  std::filesystem::path File;      ///< a model, a surface, a segmentation, or an image with `Iso`
  std::vector<std::string> Labels; ///< of a segmentation, numbers or names; none for all
  std::optional<double> Iso;       ///< of an image: what has at least this value
  TouchRepresentation Representation = TouchRepresentation::Automatic;
  /// What a scene does not ask for is not made, and a file that nothing else is made of not opened.
  bool IsSeen = true;    ///< drawn, where anybody looks
  bool IsTouched = true; ///< felt

  int Degree = 12; ///< of the harmonics that a segmentation is fitted with
  HarmonicContactMode Mode = HarmonicContactMode::Nearest;
  EvaluationPrecision Precision = EvaluationPrecision::Double; ///< of harmonics
  FieldInterpolation Interpolation = FieldInterpolation::Trilinear;
  BrickSize Bricks = BrickSize::Cells8; ///< of a field: changes memory and time, and no force
  double Smoothing = 1.0;               ///< of a segmentation's field, in voxels

  double Stiffness = 0.5; ///< N/mm
  double Damping = 0.0;   ///< N s/mm
  SurfaceFriction Friction;
  double Viscosity = 0.0;             ///< N s/mm, while the tool's centre is inside
  double Texture = 0.0;               ///< N, at most, by the intensities of `TextureImage`
  std::filesystem::path TextureImage; ///< empty without texture

  DrillLaw Drill;             ///< how it gives way to the tool as a drill; without wear it does not
  bool IsForbidden = false;   ///< no drill removes any of it, whatever else it is part of
  double AlarmDistance = 2.0; ///< mm from the tool to what is forbidden

  bool IsDrilled() const noexcept
  {
    return GivesWayToDrill(this->IsTouched, this->IsForbidden, this->Drill);
  }
};

/// How a scene's tool runs as a drill.
struct TouchDrillSettings
{
  double Turns = 1000.0;             ///< a second
  double VibrationFrequency = 120.0; ///< Hz
};

struct TouchToolSettings
{
  enum class Shape
  {
    Sphere,
    Capsule,
    Ellipsoid,
    Cylinder,
    Surface
  };
  Shape Kind = Shape::Sphere;
  double Radius = 2.0;                       ///< mm; of sphere, capsule and cylinder
  double Length = 10.0;                      ///< mm, of a capsule's axis, and of a cylinder
  Vector3 SemiAxes = Vector3(4.0, 2.0, 2.0); ///< mm, of an ellipsoid
  std::filesystem::path File;                ///< of a closed surface, mm in the tool's frame
  int Points = 26;                           ///< of the shell that touches fields
  /// What File holds, once it was read (see SurfaceOf); none: whoever needs the tool reads File.
  std::shared_ptr<const SurfaceTool> Surface = nullptr;
};

inline bool operator==(const TouchToolSettings& a, const TouchToolSettings& b)
{
  return a.Kind == b.Kind && a.Radius == b.Radius && a.Length == b.Length &&
         a.SemiAxes == b.SemiAxes && a.File == b.File && a.Points == b.Points &&
         a.Surface == b.Surface;
}

/// What is touched, with what, and by which device.
struct TouchSettings
{
  std::vector<TouchStructureSettings> Structures;
  TouchToolSettings Tool;
  TouchDrillSettings Drill;
  /// MB for what is touched by harmonics, and by fields that are not drawn: what does not fit is in
  /// memory only where the tool is near. None: all of it is.
  std::optional<double> MemoryMegabytes;
  std::string Device = "simulated"; ///< as DeviceRegistry::Make takes it
  double Rate = 1000.0;             ///< Hz, of the servo
  int ModelInterval = 1;            ///< ticks from one question to the models to the next
  /// mm of the scene for one of the device; none: so that the whole scene is in reach.
  std::optional<double> Scale;
};
} // namespace palpate
