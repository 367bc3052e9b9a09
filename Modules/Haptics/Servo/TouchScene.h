#pragma once

#include "ContactForce.h"
#include "ContactModel.h"
#include "DeviceFrame.h"
#include "DrillForce.h"
#include "DrillLink.h"
#include "ForceEffect.h"
#include "Status.h"
#include "SurfaceFriction.h"
#include "ToolShape.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// One thing to be touched.
struct TouchStructure
{
  std::string Name;
  std::shared_ptr<const ContactModel> Model;
  /// As the hand feels it: N per mm of the hand's way, whatever the scale of the device's frame.
  ContactLaw Law;
  SurfaceFriction Friction;
  /// Forces besides the contact's, which are added in this order.
  std::vector<std::shared_ptr<const ForceEffect>> Effects = {};
  /// By which it is known again in a scene that continues this one; 0: it is not.
  int Id = 0;
  DrillLaw Drill = {}; ///< how it gives way, while the scene's drill runs
  int Site = -1;       ///< of DrillVersions, which it is felt by; -1: it is not drilled
};

/// What acts without touch too, in the device's frame.
struct AmbientForce
{
  Vector3 Constant = Vector3::Zero(); ///< N, for instance against the mechanism's weight
  double Viscosity = 0.0;             ///< N s/mm
};

/// The tool as a drill.
struct TouchDrill
{
  std::shared_ptr<DrillLink> Link; ///< none: nothing is drilled
  DrillMotion Motion;
  int Tool = 0; ///< of the editor's
  /// mm that the scene's tool, which touches, is smaller than that one, which cuts: a tenth of a
  /// voxel, lest the tool wedge in its own hole.
  double Clearance = 0.0;
};

/// Everything that a hand is to feel, as it is handed to the servo. Not to be changed after that:
/// publish another one.
struct TouchScene
{
  std::vector<TouchStructure> Structures;
  ToolShape Tool = ToolShape::Sphere(1.0);
  DeviceFrame Frame;
  AmbientForce Ambient;
  TouchDrill Drill;

  /// Refuses, naming the structure, what could not be felt.
  Status Check() const;
  /// Holds all structures, which have models; empty without any.
  Eigen::AlignedBox3d BoundsWorld() const;
};
} // namespace palpate
