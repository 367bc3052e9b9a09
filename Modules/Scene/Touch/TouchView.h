#pragma once

#include "PalpateSceneModule.h"
#include "SceneRenderer.h"
#include "TouchRun.h"

namespace palpate
{
/// Draws a running touch off screen: the touched structures in their current drilled state, turning
/// about the patient's long axis, and the tool at its proxy.
class PALPATESCENE_EXPORT TouchView
{
public:
  static constexpr int Width = 640; ///< pixels
  static constexpr int Height = 480;

  /// Throws FilterError, and std::runtime_error if nothing can be drawn.
  explicit TouchView(const PreparedTouch& touch);

  /// `time` (s) turns the scene by 30 degrees per second. The image belongs to the view and is
  /// valid until the next call.
  const RasterImage& Draw(double time, const Vector3& proxyWorld);

private:
  void Add(const BuiltStructure& structure);
  void AddTool(const ToolShape& tool);

  SceneRenderer Renderer;
  RasterImage Drawn{Width, Height};
  std::size_t Tool = 0; // number of its surface
  std::shared_ptr<DrillContext> Drill;
  std::vector<std::size_t> DrilledFields; // field numbers, by drill site
  Vector3 Center = Vector3::Zero();
};
} // namespace palpate
