#pragma once

#include "DeviceRegistry.h"

namespace palpate
{
/// Adds "controller" and "controller:NUMBER": a computed hand that a game controller steers, and
/// whose motors tell what is touched.
Status RegisterControllerDevices(DeviceRegistry& registry);
} // namespace palpate
