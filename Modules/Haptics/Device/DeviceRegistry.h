#pragma once

#include "Clock.h"
#include "HapticDevice.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// One of several devices of a kind, as it was found.
struct FoundDevice
{
  std::string Argument;  ///< by which the kind makes it
  bool IsUsable = false; ///< it can be opened as it stands
  std::string Says;      ///< how it is, or what stands in the way
};

/// The kinds of devices that a program knows, by name. An ordinary object: whoever composes the
/// program fills it and hands it on.
class DeviceRegistry
{
public:
  /// Makes a closed device. `argument` says which one where a kind needs telling (a file, a serial
  /// number); the clock outlives the device.
  using Factory = std::function<Status(Clock& clock, const std::string& argument,
                                       std::unique_ptr<HapticDevice>& device)>;

  /// Looks for the devices of a kind that are plugged in, without changing how they are. For kinds
  /// that take a while to open.
  using Search = std::function<Status(Clock& clock, std::vector<FoundDevice>& found)>;

  /// Refuses an empty name, one that is taken, and an empty factory.
  Status Add(const std::string& name, const std::string& description, Factory factory,
             Search search = nullptr);

  /// In the order of their being added.
  std::vector<std::string> Names() const;
  /// Empty for a name that is not known.
  std::string Description(const std::string& name) const;
  /// Whether devices of this kind can be looked for.
  bool CanBeFound(const std::string& name) const;
  /// Fails where they cannot be looked for, here or at all.
  Status FindDevices(const std::string& name, Clock& clock, std::vector<FoundDevice>& found) const;
  /// `text` is "name" or "name:argument". Fails, naming what there is, for a name that is not
  /// known.
  Status Make(const std::string& text, Clock& clock, std::unique_ptr<HapticDevice>& device) const;

private:
  struct Kind
  {
    std::string Name;
    std::string Description;
    Factory MakeDevice;
    Search FindDevices;
  };
  const Kind* Find(const std::string& name) const;

  std::vector<Kind> Kinds;
};
} // namespace palpate
