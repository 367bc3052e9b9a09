#pragma once

#include "ContactForce.h"
#include "ContactModel.h"
#include "DeviceFrame.h"
#include "DrillForce.h"
#include "DrillLink.h"
#include "ForceEffect.h"
#include "ScanCut.h"
#include "Status.h"
#include "SurfaceFriction.h"
#include "ToolShape.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// One touchable structure.
struct TouchStructure
{
  std::string Name;
  std::shared_ptr<const ContactModel> Model;
  /// At the hand: N per mm of the hand's motion, whatever the scale of the device's frame.
  ContactLaw Law;
  SurfaceFriction Friction;
  /// Forces besides the contact's, which are added in this order.
  std::vector<std::shared_ptr<const ForceEffect>> Effects = {};
  /// Identifies it in a scene that continues this one; 0: none.
  int Id = 0;
  DrillLaw Drill = {}; ///< response while the scene's drill runs
  int Site = -1;       ///< in DrillVersions; -1: not drilled
  /// A tool that meets one of them passes, without force until it has left the structure.
  std::vector<ScanCut> Cuts = {};
};

/// The tool as a drill.
struct TouchDrill
{
  std::shared_ptr<DrillLink> Link; ///< null: nothing is drilled
  DrillMotion Motion;
  int Tool = 0; ///< number in the DrillEditor
  /// mm by which the scene's tool, which touches, is smaller than the cutting tool: a tenth of a
  /// voxel, lest the tool wedge in its own hole.
  double Clearance = 0.0;
};

/// Everything that a servo renders. Do not change it after it was published: publish another one.
struct TouchScene
{
  std::vector<TouchStructure> Structures;
  /// That act everywhere, whatever is touched.
  std::vector<std::shared_ptr<const ForceField>> Fields;
  ToolShape Tool = ToolShape::Sphere(1.0);
  DeviceFrame Frame;
  TouchDrill Drill;

  /// The balls of a tool that has one pose among all structures (SharedProxy); null for a tool with
  /// a place at each.
  const ToolSkeleton* SharedTool() const noexcept { return this->Tool.Skeleton(); }
  /// Fails, naming the structure, if the scene cannot be rendered.
  Status Check() const;
  /// Contains all structures, which must have models; empty without any.
  Eigen::AlignedBox3d BoundsWorld() const;
};
} // namespace palpate
