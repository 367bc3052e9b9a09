#pragma once

#include "PalpateInteractionModule.h"

#include "vtkTextActor.h"

namespace palpate
{
/// Text with a rim, dark around light letters and light around dark ones, so that it can be read on
/// anything. At a position in the world, it may be faint while something is drawn in front of that.
class PALPATEINTERACTION_EXPORT HaloText : public vtkTextActor
{
public:
  static HaloText* New();
  vtkTypeMacro(HaloText, vtkTextActor);

  static constexpr double FaintOpacity = 0.3;

  /// Faint if something opaque is more than `reach` (mm) in front of the position. Below 0, the
  /// default: never.
  void SetReach(double reach) { this->Reach = reach; }
  int RenderOverlay(vtkViewport* viewport) override;

protected:
  HaloText() = default;
  ~HaloText() override = default;
  bool RenderImage(vtkTextProperty* style, vtkViewport* viewport) override;

private:
  HaloText(const HaloText&) = delete;
  void operator=(const HaloText&) = delete;

  bool IsHidden(vtkViewport* viewport);

  double Reach = -1.0;
};
} // namespace palpate
