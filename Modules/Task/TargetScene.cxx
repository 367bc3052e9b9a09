#include "TargetScene.h"

#include "MaskTruth.h"
#include "Refusal.h"

namespace palpate
{
void CheckTarget(TaskKind kind, const TaskTarget& target, const SceneSettings& scene)
{
  if (kind == TaskKind::Mask)
  {
    static_cast<void>(ReadTrueMask(target, scene));
  }
  if (kind == TaskKind::Dock && scene.Structures.size() < 2)
  {
    Refuse(target.Scene, "has no two bodies",
           "list the body that is moved, and then the one that is where it belongs");
  }
}
} // namespace palpate
