#include "FalconRegistration.h"

#include "FalconKind.h"
#include "LibusbFalconFinder.h"

#include <memory>

namespace palpate
{
Status RegisterFalconDevices(DeviceRegistry& registry)
{
  return AddFalconKind(registry, std::make_shared<LibusbFalconFinder>());
}
} // namespace palpate
