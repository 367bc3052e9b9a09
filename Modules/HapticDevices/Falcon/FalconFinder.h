#pragma once

#include "FalconLink.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// A Falcon on the bus.
struct FalconListing
{
  std::string BusPath;  ///< where it is plugged in, "1-2.3"; the same as long as it stays there
  std::string Serial;   ///< empty where the device has none or it cannot be read
  std::string Obstacle; ///< why it cannot be used now, one sentence; empty where it can
};

/// Finds Falcons without claiming any. For the owner's thread.
class FalconFinder
{
public:
  FalconFinder() = default;
  FalconFinder(const FalconFinder&) = delete;
  FalconFinder& operator=(const FalconFinder&) = delete;
  virtual ~FalconFinder() = default;

  /// All that are plugged in, ordered by bus path.
  virtual Status List(std::vector<FalconListing>& listings) = 0;
  /// A closed link to the device with this bus path or serial; empty means the first usable one.
  /// The device is looked for at each Open, so it need not be plugged in yet.
  virtual Status MakeLink(const std::string& which, std::unique_ptr<FalconLink>& link) = 0;
};
} // namespace palpate
