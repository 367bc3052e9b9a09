#pragma once

#include "FalconFinder.h"

namespace palpate
{
/// Finds real Falcons by libusb. Each query scans the bus.
class LibusbFalconFinder final : public FalconFinder
{
public:
  Status List(std::vector<FalconListing>& listings) override;
  Status MakeLink(const std::string& which, std::unique_ptr<FalconLink>& link) override;
};
} // namespace palpate
