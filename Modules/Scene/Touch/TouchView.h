#pragma once

#include "PalpateSceneModule.h"
#include "SceneRenderer.h"
#include "TouchRun.h"

namespace palpate
{
/// What a touch looks like while it goes on, off screen: the structures as they are touched,
/// turning round the patient's long axis, drilled as they are just then, and the tool at its proxy.
class PALPATESCENE_EXPORT TouchView
{
public:
  static constexpr int Width = 640; ///< pixels
  static constexpr int Height = 480;

  /// Throws FilterError, and std::runtime_error where nothing can be drawn.
  explicit TouchView(const PreparedTouch& touch);

  /// `time` in s turns the scene, 30 degrees a second. The picture is the view's own, until the
  /// next is drawn.
  const Picture& Draw(double time, const Vector3& proxyWorld);

private:
  void Add(const BuiltStructure& structure);
  void AddTool(const ToolShape& tool);

  SceneRenderer Renderer;
  Picture Drawn{Width, Height};
  std::size_t Tool = 0; // its surface
  std::shared_ptr<DrillBench> Drill;
  std::vector<std::size_t> DrilledFields; // their numbers, by the bench's sites
  Vector3 Middle = Vector3::Zero();
};
} // namespace palpate
