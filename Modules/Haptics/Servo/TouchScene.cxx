#include "TouchScene.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
bool IsAmount(double number)
{
  return number >= 0.0 && std::isfinite(number);
}
Status CheckDrill(const TouchStructure& structure, const TouchDrill& drill)
{
  if (structure.Site >= 0 && drill.Link == nullptr)
  {
    return Status::Failure("The structure " + structure.Name +
                           " is to be drilled, but the scene has no drill.");
  }
  const DrillLaw& law = structure.Drill;
  if (!IsAmount(law.Wear) || !IsAmount(law.Drag) || !IsAmount(law.Vibration) || law.Vibration > 1.0)
  {
    return Status::Failure("Wear and drag of the structure " + structure.Name +
                           " must be finite and not negative, and its vibration 0 to 1.");
  }
  return Status::Success();
}
} // namespace

Status TouchScene::Check() const
{
  for (const Status& status : {this->Tool.Check(), this->Frame.Check()})
  {
    if (!status.IsOk())
    {
      return status;
    }
  }
  for (const TouchStructure& structure : this->Structures)
  {
    if (structure.Model == nullptr)
    {
      return Status::Failure("The structure " + structure.Name + " has no model to be touched.");
    }
    const ContactLaw& law = structure.Law;
    if (!IsAmount(law.Stiffness) || !IsAmount(law.Damping) || !IsAmount(law.Relaxation))
    {
      return Status::Failure("Stiffness, damping and relaxation of the structure " +
                             structure.Name + " must be finite and not negative.");
    }
    for (const auto& effect : structure.Effects)
    {
      const Status status =
          effect != nullptr ? effect->Check() : Status::Failure("a force effect is missing.");
      if (!status.IsOk())
      {
        return Status::Failure("The structure " + structure.Name +
                               " cannot be touched: " + status.Message());
      }
    }
    Status drill = CheckDrill(structure, this->Drill);
    if (!drill.IsOk())
    {
      return drill;
    }
  }
  if (std::find(this->Fields.begin(), this->Fields.end(), nullptr) != this->Fields.end())
  {
    return Status::Failure("A force field of the scene is missing.");
  }
  const DrillMotion& motion = this->Drill.Motion;
  if (!IsAmount(this->Drill.Clearance) || !IsAmount(motion.Radius) || !IsAmount(motion.Turns) ||
      !IsAmount(motion.VibrationFrequency))
  {
    return Status::Failure(
        "A drill's radius, clearance, turns and vibration must be finite and not "
        "negative.");
  }
  return Status::Success();
}

Eigen::AlignedBox3d TouchScene::BoundsWorld() const
{
  Eigen::AlignedBox3d bounds;
  for (const TouchStructure& structure : this->Structures)
  {
    bounds.extend(structure.Model->BoundsWorld());
  }
  return bounds;
}
} // namespace palpate
