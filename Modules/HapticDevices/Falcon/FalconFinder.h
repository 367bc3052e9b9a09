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
  std::string BusPath;  ///< USB port, "1-2.3"; unchanged while it stays plugged in
  std::string Serial;   ///< empty if the device has none or it cannot be read
  std::string Obstacle; ///< error message if it cannot be used now; otherwise empty
};

/// Finds Falcons without claiming any. Owner thread only.
class FalconFinder
{
public:
  FalconFinder() = default;
  FalconFinder(const FalconFinder&) = delete;
  FalconFinder& operator=(const FalconFinder&) = delete;
  virtual ~FalconFinder() = default;

  /// All Falcons that are plugged in, ordered by bus path.
  virtual Status List(std::vector<FalconListing>& listings) = 0;
  /// A closed link to the device with this bus path or serial; empty means the first usable one.
  /// The device is looked up at each Open, so it need not be plugged in yet.
  virtual Status MakeLink(const std::string& which, std::unique_ptr<FalconLink>& link) = 0;
};
} // namespace palpate
