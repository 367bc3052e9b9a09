#pragma once

#include "ContactModel.h"

#include <memory>

namespace palpate
{
class RadialModel;
class SurfaceModel;

/// How a tool's proxy is placed on a radial model.
enum class RadialContactMode
{
  Nearest, ///< at the nearest point, coherent from tick to tick, with friction
  Radial   ///< on the probe's own radius: the published method, without friction
};

/// Contact of spherical tools with a radial model. Fails as TouchableRadialModel::Make.
Status MakeOrganContact(std::shared_ptr<const RadialModel> model, RadialContactMode mode,
                        std::shared_ptr<const ContactModel>& contact);
/// The same with a surface model, with friction. Fails as TouchableSurfaceModel::Make.
Status MakeOrganContact(const SurfaceModel& model, std::shared_ptr<const ContactModel>& contact);
} // namespace palpate
