#include "LibusbFalconFinder.h"

#include "FalconDevice.h"
#include "FalconKind.h"
#include "LibusbFalconLink.h"
#include "LibusbFalcons.h"

namespace palpate
{
Status LibusbFalconFinder::List(std::vector<FalconListing>& listings)
{
  listings.clear();
  LibusbContext context;
  const Status status = MakeLibusbContext(context);
  return status.IsOk() ? ListFalcons(*context, listings) : status;
}

Status LibusbFalconFinder::MakeLink(const std::string& which, std::unique_ptr<FalconLink>& link)
{
  link = std::make_unique<LibusbFalconLink>(which);
  return Status::Success();
}

Status RegisterFalconDevices(DeviceRegistry& registry)
{
  return AddFalconKind(registry, std::make_shared<LibusbFalconFinder>());
}
} // namespace palpate
