#pragma once

#include "FalconFinder.h"
#include "VirtualFalconLink.h"

#include <string>
#include <vector>

namespace palpate::test
{
/// Finds one virtual Falcon, and records which was requested.
class VirtualFinder final : public FalconFinder
{
public:
  explicit VirtualFinder(const Clock& clock) : Time(clock) {}
  Status List(std::vector<FalconListing>& listings) override
  {
    listings = this->Listings;
    return Status::Success();
  }
  Status MakeLink(const std::string& which, std::unique_ptr<FalconLink>& link) override
  {
    this->Asked = which;
    link = std::make_unique<VirtualFalconLink>(this->Falcon, this->Time);
    return Status::Success();
  }

  VirtualFalcon Falcon;
  std::vector<FalconListing> Listings{{"1-2", "", ""}};
  std::string Asked;

private:
  const Clock& Time;
};
} // namespace palpate::test
